// SPDX-License-Identifier: GPL-2.0-or-later
// Writes a table of numbers with a header line.
// Scope: six significant digits, which is finer than any measure of a pile; NaN becomes an empty
// field.
#pragma once

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
    out_ << joined(words, ",");
    write(",", values);
  }

 private:
  void write(const char* separator, const std::vector<double>& values) {
    for (const double value : values) {
      out_ << separator;
      if (!std::isnan(value)) out_ << value;
      separator = ",";
    }
    out_ << '\n';
  }

  std::ofstream out_;
};

}  // namespace muckpile
