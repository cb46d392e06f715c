// SPDX-License-Identifier: GPL-2.0-or-later
// Figures of a run, by name: numbers of a JSON object, or of the last row of a CSV table.
// Scope: finite numbers only; everything else throws InputError, which names the file and the
// quantity.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "args/csv_table.h"

namespace muckpile::check {

using Json = nlohmann::ordered_json;

/// Throws InputError, naming the file and the place, if it is absent or malformed.
[[nodiscard]] Json read_json_object(const std::filesystem::path& path);

class FigureFile {
 public:
  /// By its name a JSON object (.json) or a table (.csv).
  explicit FigureFile(const std::filesystem::path& path);

  /// Nothing if the file does not have the quantity. mean(NAME) is the mean over a table's column.
  [[nodiscard]] std::optional<double> find(const std::string& quantity) const;
  /// The file of JSON has the quantity as null: it does not apply. For find() that is an error.
  [[nodiscard]] bool is_null(const std::string& quantity) const;
  /// As find(), but the quantity must be there.
  [[nodiscard]] double get(const std::string& quantity) const;
  /// Throws unless every number in it is finite and no value is null or empty. A column that begins
  /// with a word is one of words.
  void require_finite() const;

 private:
  [[nodiscard]] double mean(size_t column) const;

  std::string name_;
  std::variant<Json, CsvTable> content_;
};

/// FILE:QUANTITY, or a number.
[[nodiscard]] double figure(const std::string& words);

/// The shortest text that reads back as the same number.
[[nodiscard]] std::string text_of(double value);

}  // namespace muckpile::check
