// SPDX-License-Identifier: GPL-2.0-or-later
// Random numbers that are the same on every platform, library and number of ranks.
// Scope: splitmix64 (Steele, Lea, Flood 2014); good enough for seeds, not for cryptography.
#pragma once

#include <cstdint>

namespace muckpile {

/// Number `index` (from 0) of the sequence that starts at state `seed`, 64 random bits. By index a
/// block has its number without those before it, whichever rank owns it.
[[nodiscard]] constexpr std::uint64_t random_bits(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed + (index + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// The sequence of one seed, number by number.
class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed) {}

  // Uniform in [0, 1), 53 bits.
  [[nodiscard]] double uniform() {
    return static_cast<double>(random_bits(seed_, index_++) >> 11) * 0x1.0p-53;
  }

 private:
  std::uint64_t seed_, index_ = 0;
};

}  // namespace muckpile
