// SPDX-License-Identifier: GPL-2.0-or-later
// Strict reader for comma-separated tables; see the header.
// Scope: the whole file is one text, fields are views into it.
#include "args/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/small_letters.h"
#include "args/suggestion.h"

namespace muckpile {
namespace {

std::string_view next_line(std::string_view& rest) {
  const size_t end = rest.find('\n');
  std::string_view line = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string_view trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// What a field in quotes holds. InputError, which begins with `where`, unless it would be the same
/// field without them, as tables are written: a line that begins with # is a remark.
std::string_view unquoted(std::string_view field, bool first, const std::string& where) {
  const std::string_view inside = field.size() < 2 ? field : field.substr(1, field.size() - 2);
  if (!field.ends_with('"') || inside.find('"') != std::string_view::npos ||
      (first && inside.starts_with('#')))
    throw InputError(
        where + "a field in quotes must hold no comma or quote, nor begin a line with #, got " +
        std::string(field));
  return trimmed(inside);
}

size_t split(std::string_view line, const std::string& name, size_t number,
             std::vector<std::string_view>& out) {
  size_t count = 0;
  for (size_t begin = 0; begin <= line.size(); ++count) {
    const size_t end = std::min(line.find(',', begin), line.size());
    std::string_view field = trimmed(line.substr(begin, end - begin));
    if (field.starts_with('"'))
      field = unquoted(field, count == 0, name + ":" + std::to_string(number) + ": ");
    out.push_back(field);
    begin = end + 1;
  }
  return count;
}

/// Spreadsheets write a row of commas for an empty one, and may begin with the separator's name.
bool is_empty(std::string_view line) {
  return line.find_first_not_of(" \t,") == std::string_view::npos || line == "sep=,";
}

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // spreadsheets begin a file with it

/// Bytes of the character that begins at `at`; 0: of none in UTF-8, by the bits that say so.
size_t length_of_character(std::string_view text, size_t at) {
  const auto byte = [&](size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(at);
  const size_t length = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first >= 0xF8 || (first >= 0x80 && first < 0xC2) || at + length > text.size()) return 0;
  for (size_t k = at + 1; k < at + length; ++k)
    if (byte(k) >> 6 != 2) return 0;
  return length;
}

void require_utf8(std::string_view text, const std::string& name) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw InputError(name + ": must be in UTF-8, got UTF-16");
  if (std::ranges::none_of(text, [](char c) { return (c & 0x80) != 0; })) return;
  for (size_t at = 0; at < text.size();) {
    const size_t length = length_of_character(text, at);
    if (length == 0)
      throw InputError(name + ":" +
                       std::to_string(1 + std::ranges::count(text.substr(0, at), '\n')) +
                       ": must be in UTF-8, got a byte that is not; save it as CSV in UTF-8");
    at += length;
  }
}

/// Its lines end with LF from here on, of an old spreadsheet's too.
std::string readable(std::string text, const std::string& name) {
  require_utf8(text, name);
  if (text.find('\n') == std::string::npos) std::ranges::replace(text, '\r', '\n');
  return text;
}

void refuse_other_separators(std::string_view line, const std::string& name) {
  if (trimmed(line).find_first_of(";\t") != std::string_view::npos)
    throw InputError(name + ": fields must stand between commas, got '" + std::string(line) + "'");
}

void refuse_twice(std::vector<std::string_view> columns, const std::string& name) {
  std::sort(columns.begin(), columns.end());
  const auto twice = std::adjacent_find(columns.begin(), columns.end());
  if (twice != columns.end() && twice->empty())
    throw InputError(name + ": the first line must name every column");
  if (twice != columns.end())
    throw InputError(name + ": column '" + std::string(*twice) + "' is there twice");
}

template <class Number>
bool parse_all(std::string_view text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

}  // namespace

std::string whole_file(const std::filesystem::path& path) {
  std::error_code no_size;  // of a pipe, say
  if (std::filesystem::is_directory(path, no_size))
    throw InputError(path.string() + ": is a folder, must be a file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string() + ": cannot be opened");
  const std::uintmax_t size = std::filesystem::file_size(path, no_size);
  std::string text(no_size ? 0 : static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (in) text.append(std::istreambuf_iterator<char>(in), {});
  return text;
}

CsvTable CsvTable::read(const std::filesystem::path& path) {
  return parse(whole_file(path), path.string());
}

CsvTable CsvTable::parse(std::string text, const std::string& name, std::string_view header) {
  CsvTable table;
  table.name_ = name;
  if (!header.empty()) split(header, name, 0, table.header_);
  table.text_ = std::make_shared<const std::string>(readable(std::move(text), name));
  std::string_view rest = *table.text_;
  if (rest.substr(0, kByteOrderMark.size()) == kByteOrderMark)
    rest.remove_prefix(kByteOrderMark.size());
  for (size_t number = 1; !rest.empty(); ++number) {
    const std::string_view line = next_line(rest);
    if (is_empty(line)) continue;
    if (line.front() == '#') {
      table.remarks_.push_back(line.substr(1));
    } else if (table.header_.empty()) {
      split(line, name, number, table.header_);
      refuse_twice(table.header_, name);
      if (table.header_.size() == 1) refuse_other_separators(line, name);
    } else {
      const size_t count = split(line, name, number, table.fields_);
      table.lines_.push_back(number);
      if (count != table.header_.size()) {
        throw InputError(table.where(table.rows() - 1) + "expected " +
                         std::to_string(table.header_.size()) + " fields, got " +
                         std::to_string(count));
      }
    }
  }
  if (table.header_.empty()) throw InputError(table.name_ + ": has no header line");
  return table;
}

bool is_same_column(std::string_view a, std::string_view b) {
  return in_small_letters(a) == in_small_letters(b);
}

std::optional<size_t> CsvTable::find_column(std::string_view name) const {
  auto found = std::ranges::find(header_, name);
  if (found == header_.end())
    found = std::ranges::find_if(
        header_, [name](std::string_view column) { return is_same_column(column, name); });
  if (found == header_.end()) return std::nullopt;
  return static_cast<size_t>(found - header_.begin());
}

void CsvTable::require_known_columns(const std::vector<std::string>& known) const {
  std::set<std::string> there;
  for (const std::string_view name : header_) {
    const auto same = std::ranges::find_if(
        known, [name](const std::string& column) { return is_same_column(column, name); });
    if (same == known.end())
      throw InputError(name_ + ": unknown column '" + std::string(name) + "'" +
                       did_you_mean(in_small_letters(name), known) + " (known: " + joined(known) +
                       ")");
    if (!there.insert(*same).second)
      throw InputError(name_ + ": column '" + *same + "' is there twice, once as '" +
                       std::string(name) + "'");
  }
}

size_t CsvTable::column(std::string_view name) const {
  if (const auto found = find_column(name)) return *found;
  throw InputError(name_ + ": has no column '" + std::string(name) + "'");
}

std::string_view CsvTable::word(size_t row, size_t column) const {
  return fields_.at(row * header_.size() + column);
}

std::string CsvTable::place(size_t row) const {
  return name_ + ":" + std::to_string(lines_.at(row));
}

std::string CsvTable::where(size_t row) const { return place(row) + ": "; }

double CsvTable::real(size_t row, size_t column, const std::string& unit,
                      const Range& range) const {
  return parse_real(place(row), std::string(header_[column]), std::string(word(row, column)), unit,
                    range);
}

template <class Number>
Number CsvTable::parsed(size_t row, size_t column, const char* kind) const {
  Number value{};
  const std::string_view text = word(row, column);
  if (!parse_all(text, value) || !std::isfinite(static_cast<double>(value))) {
    throw InputError(where(row) + std::string(header_[column]) + " must be a " + kind + ", got '" +
                     std::string(text) + "'");
  }
  return value;
}

double CsvTable::number(size_t row, size_t column) const {
  return parsed<double>(row, column, "finite number");
}

int CsvTable::whole(size_t row, size_t column) const {
  return parsed<int>(row, column, "whole number");
}

double parse_number(std::string_view text, const std::string& context) {
  double value = 0.0;
  if (!parse_all(text, value) || !std::isfinite(value)) {
    throw InputError(context + " must be a finite number, got '" + std::string(text) + "'");
  }
  return value;
}

}  // namespace muckpile
