// SPDX-License-Identifier: GPL-2.0-or-later
// Strict reader for comma-separated tables: what a run writes, and what a user hands in.
// Scope: one header line, then rows of numbers or words, in double quotes or not; blanks around a
// field do not count; `#` lines are kept as remarks.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "args/range.h"

namespace muckpile {

// A whole file, split into fields. Every row has as many fields as the header has names.
class CsvTable {
 public:
  // Throws InputError, naming the file and the line, if it is absent, not in UTF-8, has no header,
  // a ragged row, or a field in quotes that needs them.
  static CsvTable read(const std::filesystem::path& path);
  // The same from a text; `name` stands for the file in messages. A text without a header line has
  // the names of `header`, which must outlive the table.
  static CsvTable parse(std::string text, const std::string& name, std::string_view header = {});

  // The file's, for messages.
  [[nodiscard]] const std::string& name() const { return name_; }
  // All that was read, its lines ended by LF or CR LF.
  [[nodiscard]] const std::string& text() const { return *text_; }
  [[nodiscard]] const std::vector<std::string_view>& header() const { return header_; }
  [[nodiscard]] size_t rows() const { return lines_.size(); }
  [[nodiscard]] const std::vector<std::string_view>& remarks() const { return remarks_; }

  // Position of a named column, in capital or small letters; the same ones win. Throws InputError
  // if the header lacks it.
  [[nodiscard]] size_t column(std::string_view name) const;
  // The same, nothing if the header lacks it.
  [[nodiscard]] std::optional<size_t> find_column(std::string_view name) const;
  // Throws InputError if the header has a name that is not known, naming the nearest of `known`, or
  // one of them twice. Capital and small letters are the same.
  void require_known_columns(const std::vector<std::string>& known) const;

  // One field as a finite number. Throws InputError, naming file, line and column, otherwise.
  [[nodiscard]] double number(size_t row, size_t column) const;
  // One field as a whole number. Same errors.
  [[nodiscard]] int whole(size_t row, size_t column) const;
  [[nodiscard]] std::string_view word(size_t row, size_t column) const;
  // One field as a real number [unit] in `range`, as strict as parse_real(). Same errors.
  [[nodiscard]] double real(size_t row, size_t column, const std::string& unit,
                            const Range& range) const;

  // "<file>:<line>: ", for a caller's own message about a row.
  [[nodiscard]] std::string where(size_t row) const;

 private:
  [[nodiscard]] std::string place(size_t row) const;  // "<file>:<line>"
  template <class Number>
  Number parsed(size_t row, size_t column, const char* kind) const;

  std::string name_;
  std::shared_ptr<const std::string> text_;  // the views below look into it
  std::vector<std::string_view> remarks_, header_, fields_;
  std::vector<size_t> lines_;  // line number of each row, from 1
};

// Whether two names of columns are the same but for capital letters.
[[nodiscard]] bool is_same_column(std::string_view a, std::string_view b);

// A file as one text. Throws InputError if it cannot be opened.
[[nodiscard]] std::string whole_file(const std::filesystem::path& path);

// The finite number that the whole of `text` spells. Throws InputError with `context` before it.
double parse_number(std::string_view text, const std::string& context);

}  // namespace muckpile
