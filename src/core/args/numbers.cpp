// SPDX-License-Identifier: GPL-2.0-or-later
// Strict reading of one number from one word of an input script, and the shortest exact text back.
// Scope: see numbers.h.
#include "args/numbers.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "args/input_error.h"

namespace muckpile {
namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& keyword,
                         const std::string& rule, const std::string& text) {
  throw InputError(where + ": " + keyword + " must be " + rule + ", got '" + text + "'");
}

/// "a number in Pa"; a pure number has no unit.
std::string in_unit(const std::string& noun, const std::string& unit) {
  return unit.empty() ? noun : noun + " in " + unit;
}

std::string with_unit(const std::string& rule, const std::string& unit) {
  return unit.empty() ? rule : rule + " " + unit;
}

/// std::from_chars over the whole word; a leading '+' is allowed, as engine formats may print it.
template <class Number>
std::errc read_whole(const std::string& text, Number& value) {
  std::string_view digits = text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end) return std::errc::invalid_argument;
  return error;
}

}  // namespace

double parse_real(const std::string& where, const std::string& keyword, const std::string& text,
                  const std::string& unit, Range range) {
  double value = 0.0;
  const std::errc error = read_whole(text, value);
  if (error == std::errc::invalid_argument) refuse(where, keyword, in_unit("a number", unit), text);
  if (error != std::errc{} || !std::isfinite(value))
    refuse(where, keyword, in_unit("a finite number", unit), text);
  if (!range.contains(value)) refuse(where, keyword, with_unit(range.text(), unit), text);
  return value;
}

long parse_integer(const std::string& where, const std::string& keyword, const std::string& text,
                   const std::string& unit, Range range) {
  long value = 0;
  const std::errc error = read_whole(text, value);
  if (error == std::errc::invalid_argument)
    refuse(where, keyword, in_unit("a whole number", unit), text);
  if (error != std::errc{})
    refuse(where, keyword, in_unit("a whole number of at most 18 digits", unit), text);
  if (!range.contains(static_cast<double>(value)))
    refuse(where, keyword, with_unit(range.text(), unit), text);
  return value;
}

std::string number_text(double value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

}  // namespace muckpile
