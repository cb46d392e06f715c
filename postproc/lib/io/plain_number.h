// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of large files with nothing but one character between them.
// Scope: what std::from_chars reads, to the last bit; plain decimals, as nearly all are, in less of
// its time.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <system_error>

namespace muckpile {

// Digits with a point among or behind them.
struct Decimal {
  const char* stop;             // behind them
  std::uint64_t digits = 0;     // without the point; wrong if there are more than kMostDigits
  std::ptrdiff_t count = 0;     // of all of them, zeros in front, too
  std::ptrdiff_t decimals = 0;  // of those behind the point
};
inline constexpr std::ptrdiff_t kMostDigits = 19;

// Whether eight bytes are digits, and the number that they make: D. Lemire, "Quickly parsing eight
// digits" (2018); the first digit in the lowest byte.
inline bool are_digits(std::uint64_t bytes) {
  constexpr std::uint64_t kHigh = 0xF0F0F0F0F0F0F0F0, kSix = 0x0606060606060606;
  return ((bytes & kHigh) | (((bytes + kSix) & kHigh) >> 4)) == 0x3333333333333333;
}
inline std::uint64_t number_of_digits(std::uint64_t bytes) {
  constexpr std::uint64_t kPairs = 0x000000FF000000FF;
  bytes -= 0x3030303030303030;
  bytes = 10 * bytes + (bytes >> 8);
  return ((bytes & kPairs) * 0x000F424000000064 + ((bytes >> 16) & kPairs) * 0x0000271000000001) >>
         32;
}

inline void take_digits(const char* end, Decimal& number) {
  const char* const begin = number.stop;
  if constexpr (std::endian::native == std::endian::little) {
    for (std::uint64_t bytes = 0; end - number.stop >= 8; number.stop += 8) {
      std::memcpy(&bytes, number.stop, 8);
      if (!are_digits(bytes)) break;
      number.digits = 100000000 * number.digits + number_of_digits(bytes);
    }
  }
  for (; number.stop != end; ++number.stop) {
    const auto digit = static_cast<unsigned>(*number.stop - '0');
    if (digit > 9) break;
    number.digits = 10 * number.digits + digit;
  }
  number.count += number.stop - begin;
}

inline Decimal decimal_at(const char* at, const char* end) {
  Decimal number{at};
  take_digits(end, number);
  if (number.stop == end || *number.stop != '.') return number;
  ++number.stop;
  const std::ptrdiff_t whole = number.count;
  take_digits(end, number);
  number.decimals = number.count - whole;
  return number;
}

// digits / 10^decimals, rounded as std::from_chars does. False where that is not certain.
inline bool quotient(const Decimal& number, double& value) {
  static constexpr double kTens[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
                                     1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};
  const double tens = kTens[number.decimals];  // exact, as those up to 1e22 are
  if (number.digits <= std::uint64_t{1} << std::numeric_limits<double>::digits) {
    value = static_cast<double>(number.digits) / tens;
    return true;
  }
  using Wide = long double;
  if constexpr (std::numeric_limits<Wide>::digits < 64) return false;
  // What the first rounding may have left out decides the second one only beside a tie.
  constexpr Wide kOff = std::numeric_limits<Wide>::epsilon();
  const Wide wide = static_cast<Wide>(number.digits) / static_cast<Wide>(tens);
  value = static_cast<double>(wide * (1 + kOff));
  return value == static_cast<double>(wide * (1 - kOff));
}

inline bool read_decimal(const char*& at, const char* end, double& value, char behind) {
  const bool negative = at != end && *at == '-';
  const Decimal number = decimal_at(at + (negative ? 1 : 0), end);
  if (number.count == 0 || number.count > kMostDigits) return false;
  if (number.stop == end || *number.stop != behind || !quotient(number, value)) return false;
  if (negative) value = -value;
  at = number.stop + 1;
  return true;
}

template <std::integral Number>
bool read_decimal(const char*& at, const char* end, Number& value, char behind) {
  const char* stop = at;
  Number number = 0;
  for (unsigned digit = 0; stop != end; ++stop) {
    if ((digit = static_cast<unsigned>(*stop - '0')) > 9) break;
    if (stop - at == std::numeric_limits<Number>::digits10) return false;
    number = 10 * number + static_cast<Number>(digit);
  }
  if (stop == at || stop == end || *stop != behind) return false;
  value = number;
  at = stop + 1;
  return true;
}

// Reads the number at `at` and goes behind what stands behind it. False where it is none, is not
// finite, or something else stands there.
template <class Number>
bool read_number(const char*& at, const char* end, Number& value, char behind) {
  if (read_decimal(at, end, value, behind)) return true;
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error != std::errc() || stop == end || *stop != behind) return false;
  at = stop + 1;
  return std::isfinite(static_cast<double>(value));
}

}  // namespace muckpile
