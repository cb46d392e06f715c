// SPDX-License-Identifier: GPL-2.0-or-later
// Eight bytes at once, such as a state of each facet of a group: which of them are something.
// Scope: bit k of what comes out is of byte k.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace muckpile {

inline constexpr std::size_t kByteLanes = 8;
static_assert(std::endian::native == std::endian::little);

/// Usually `Usual` bytes from `first` on, sometimes less: `count`; the others are `rest`.
template <std::size_t Usual>
[[nodiscard, gnu::always_inline]] inline std::uint64_t load_bytes(const void* first,
                                                                  std::size_t count,
                                                                  std::uint8_t rest) {
  static_assert(Usual <= kByteLanes);
  std::uint64_t bytes = 0x0101010101010101 * std::uint64_t{rest};
  if (count == Usual)
    std::memcpy(&bytes, first, Usual);
  else
    std::memcpy(&bytes, first, count);
  return bytes;
}
/// Those in which that bit is set. The product brings bit 8 k to 56 + k.
[[nodiscard]] inline unsigned lanes_with_bit(std::uint64_t bytes, std::size_t bit) {
  constexpr std::uint64_t kFirstOfEach = 0x0101010101010101, kToTop = 0x0102040810204080;
  return static_cast<unsigned>((bytes >> bit & kFirstOfEach) * kToTop >> 56);
}
/// Those that have this value.
[[nodiscard]] inline unsigned lanes_equal(std::uint64_t bytes, std::uint8_t value) {
  constexpr std::uint64_t kLow = 0x7f7f7f7f7f7f7f7f;
  const std::uint64_t differ = bytes ^ 0x0101010101010101 * std::uint64_t{value};
  return lanes_with_bit(~(((differ & kLow) + kLow) | differ), 7);
}

}  // namespace muckpile
