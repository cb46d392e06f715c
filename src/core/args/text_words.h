// SPDX-License-Identifier: GPL-2.0-or-later
// The words of a text between blanks and line ends, in order.
// Scope: for files of some 100 MB, which streams read ten times as slowly.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace muckpile {

class TextWords {
 public:
  explicit TextWords(std::string text) : text_(std::move(text)) {}
  TextWords(const TextWords&) = delete;  // words are views into the text
  TextWords& operator=(const TextWords&) = delete;

  /// The next word; empty at the end.
  std::string_view word() {
    const char* const end = text_.data() + text_.size();
    const char* from = text_.data() + at_;
    while (from != end && is_blank(*from)) ++from;
    const char* to = from;
    while (to != end && !is_blank(*to)) ++to;
    at_ = static_cast<std::size_t>(to - text_.data());
    return {from, static_cast<std::size_t>(to - from)};
  }

  /// Whether the next word is a finite number; `value` is then that.
  template <class Number>
  bool number(Number& value) {
    const std::string_view text = word();
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return !text.empty() && error == std::errc() && stop == end &&
           std::isfinite(static_cast<double>(value));
  }

  /// What is left of the present line, which is then read.
  std::string_view line() {
    const std::size_t from = at_;
    const std::size_t end = text_.find('\n', from);
    at_ = end == std::string::npos ? text_.size() : end + 1;
    const std::string_view rest = std::string_view(text_).substr(from);
    return rest.substr(0, end == std::string::npos ? end : end - from);
  }

  /// Of the last word, from 1.
  [[nodiscard]] std::size_t line_number() const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(at_);
    return 1 + static_cast<std::size_t>(std::count(text_.begin(), end, '\n'));
  }
  /// Only blanks are left, or nothing.
  [[nodiscard]] bool at_end() const {
    return std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.end(), is_blank);
  }

 private:
  static bool is_blank(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace muckpile
