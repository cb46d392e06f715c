// SPDX-License-Identifier: GPL-2.0-or-later
// Writes a table of numbers with a header line.
// Scope: six significant digits, which is finer than any measure of a pile; NaN becomes an empty
// field.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "args/suggestion.h"

namespace muckpile {

// A place of a mine grid [m] to the millimetre, for which six digits are too few.
inline std::string place_text(double value) {
  if (std::isnan(value)) return {};
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

class CsvWriter {
 public:
  // Throws InputError, naming the file, if it cannot be written.
  CsvWriter(const std::filesystem::path& path, const std::string& header) : out_(path) {
    out_ << header << '\n';
    if (!out_) throw InputError(path.string() + ": cannot be written");
  }

  void row(std::initializer_list<double> values) { row(std::vector<double>(values)); }
  void row(const std::vector<double>& values) { write("", values); }
  // A word first, without a comma in it.
  void row(const std::string& word, const std::vector<double>& values) {
    row(std::vector<std::string>{word}, values);
  }
  // Words first, one at least, without commas in them.
  void row(const std::vector<std::string>& words, const std::vector<double>& values) {
    line_ = joined(words, ",");
    write(",", values);
  }
  // Places of a mine grid [m] behind the numbers, to the millimetre; none is well.
  void row_at(const std::vector<double>& values, const std::vector<double>& places) {
    append(values, "");
    end_line(places);
  }
  void row_at(const std::string& word, const std::vector<double>& values,
              const std::vector<double>& places) {
    line_ = word;
    append(values, ",");
    end_line(places);
  }
  // The same with one more value behind the others or, where it has one, its name.
  void row_named(const std::string& word, const std::vector<double>& values, double value,
                 const std::string& name, const std::vector<double>& places) {
    line_ = word;
    append(values, ",");
    if (name.empty()) append({value}, ",");
    if (!name.empty()) line_.append(1, ',').append(name);
    end_line(places);
  }

 private:
  void write(const char* separator, const std::vector<double>& values) {
    append(values, separator);
    end_line();
  }
  void append(const std::vector<double>& values, const char* separator) {
    for (const double value : values) {
      line_ += separator;
      if (!std::isnan(value)) append(value);
      separator = ",";
    }
  }
  void end_line(const std::vector<double>& places = {}) {
    for (const double place : places) line_.append(1, ',').append(place_text(place));
    line_ += '\n';
    out_ << line_;
    line_.clear();
  }
  // As printf's %g, but faster.
  void append(double value) {
    constexpr int kDigits = 6;
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, kDigits);
    line_.append(text, end.ptr);
  }

  std::ofstream out_;
  std::string line_;  // being written
};

}  // namespace muckpile
