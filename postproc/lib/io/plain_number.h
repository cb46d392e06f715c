// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of large files with nothing but one character between them.
// Scope: what std::from_chars reads.
#pragma once

#include <charconv>
#include <cmath>
#include <system_error>

namespace muckpile {

// Reads the number at `at` and goes behind what stands behind it. False where it is none, is not
// finite, or something else stands there.
template <class Number>
bool read_number(const char*& at, const char* end, Number& value, char behind) {
  const auto [stop, error] = std::from_chars(at, end, value);
  if (error != std::errc() || stop == end || *stop != behind) return false;
  at = stop + 1;
  return std::isfinite(static_cast<double>(value));
}

}  // namespace muckpile
