// SPDX-License-Identifier: GPL-2.0-or-later
// Points of a surveyed surface from a text file.
// Scope: see the header.
#include "geometry/files/point_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/small_letters.h"
#include "args/suggestion.h"

namespace muckpile {
namespace {

constexpr size_t kAxes = 3;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

const std::array<std::vector<std::string>, kAxes>& column_names() {
  static const std::array<std::vector<std::string>, kAxes> names{
      {{"x", "x_m", "east", "easting"},
       {"y", "y_m", "north", "northing"},
       {"z", "z_m", "elevation", "height", "height_m"}}};
  return names;
}

char separator_of(const std::string& line) {
  for (const char each : {';', ','})
    if (line.find(each) != std::string::npos) return each;
  return ' ';
}

std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

// A run of blanks is one separator; a semicolon or a comma is one each.
std::vector<std::string> fields_of(const std::string& line, char separator) {
  std::vector<std::string> fields;
  const std::string between = separator == ' ' ? " \t\r" : std::string(1, separator);
  for (size_t begin = 0; begin <= line.size();) {
    const size_t end = std::min(line.find_first_of(between, begin), line.size());
    const std::string field = trimmed(line.substr(begin, end - begin));
    if (separator != ' ' || !field.empty()) fields.push_back(field);
    begin = end + 1;
  }
  return fields;
}

bool begins_a_number(const std::string& word) {
  return !word.empty() && (std::isdigit(static_cast<unsigned char>(word[0])) != 0 ||
                           std::string("+-.").find(word[0]) != std::string::npos);
}

std::array<size_t, kAxes> columns_of_header(std::vector<std::string> header,
                                            const std::string& where) {
  for (std::string& name : header) name = in_small_letters(name);
  std::array<size_t, kAxes> columns{};
  for (size_t axis = 0; axis < kAxes; ++axis) {
    const auto& names = column_names()[axis];
    const auto found = std::ranges::find_first_of(header, names);
    if (found == header.end())
      throw InputError(where + "a header must name one of " + joined(names) +
                       ", all in metres, got '" + joined(header) + "'");
    columns[axis] = static_cast<size_t>(found - header.begin());
  }
  return columns;
}

class PointReader {
 public:
  explicit PointReader(const std::filesystem::path& path) : path_(path.string()) {}

  void add(const std::string& line) {
    ++number_;
    const std::string words =
        number_ == 1 && line.starts_with(kByteOrderMark) ? line.substr(3) : line;
    if (trimmed(words).empty() || trimmed(words).front() == '#') return;
    if (count_ == 0) {
      separator_ = separator_of(words);
      const std::vector<std::string> first = fields_of(words, separator_);
      count_ = first.size();
      if (!begins_a_number(first.front())) {
        columns_ = columns_of_header(first, where());
        return;
      }
    }
    add_point(fields_of(words, separator_));
  }

  [[nodiscard]] std::vector<Vec3> points() {
    if (points_.size() < 3)
      refuse(path_, "must have three points at least, got " + std::to_string(points_.size()));
    return std::move(points_);
  }

 private:
  [[nodiscard]] std::string where() const { return path_ + ":" + std::to_string(number_) + ": "; }

  void add_point(const std::vector<std::string>& fields) {
    if (fields.size() < kAxes || fields.size() != count_)
      throw InputError(where() + "expected " + std::to_string(std::max(count_, kAxes)) +
                       " fields as in the lines before, got " + std::to_string(fields.size()));
    Vec3 point;
    for (size_t axis = 0; axis < kAxes; ++axis)
      point[static_cast<Eigen::Index>(axis)] =
          parse_number(fields[columns_[axis]], where() + column_names()[axis].front());
    points_.push_back(point);
  }

  std::string path_;
  size_t number_ = 0;  // of the line
  size_t count_ = 0;   // fields in a line; 0 before the first
  char separator_ = ' ';
  std::array<size_t, kAxes> columns_{0, 1, 2};
  std::vector<Vec3> points_;
};

}  // namespace

std::vector<Vec3> read_points(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse(path.string(), "cannot be opened");
  PointReader reader(path);
  for (std::string line; std::getline(in, line);) reader.add(line);
  return reader.points();
}

}  // namespace muckpile
