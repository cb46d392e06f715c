// SPDX-License-Identifier: GPL-2.0-or-later
// Some digits of a number.
// Scope: see the header.
#include "args/rounded_text.h"

#include <array>
#include <charconv>

namespace muckpile {

std::string rounded_text(double value, int digits) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::general, digits);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

}  // namespace muckpile
