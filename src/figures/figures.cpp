// SPDX-License-Identifier: GPL-2.0-or-later
// Figures of a run, by name.
// Scope: see the header.
#include "figures/figures.h"

#include <charconv>
#include <cmath>
#include <fstream>

#include "args/input_error.h"

namespace muckpile::check {
namespace {

std::variant<Json, CsvTable> read(const std::filesystem::path& path) {
  if (path.extension() == ".json") return read_json_object(path);
  if (path.extension() == ".csv") return CsvTable::read(path);
  refuse(path.string(), "must be a .json or a .csv file");
}

double finite(const Json& value, const std::string& where) {
  // A writer of JSON makes null of a number that is none.
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw InputError(where + " must be a finite number, got " + value.dump());
  return value.get<double>();
}

/// Of a key, or KEY.INNER of an object in it; nullptr if there is none.
const Json* value_of(const Json& object, const std::string& key) {
  if (const auto found = object.find(key); found != object.end()) return &*found;
  const size_t dot = key.find('.');
  if (dot == std::string::npos) return nullptr;
  const auto outer = object.find(key.substr(0, dot));
  return outer != object.end() && outer->is_object() ? value_of(*outer, key.substr(dot + 1))
                                                     : nullptr;
}

void require_no_null(const Json& value, const std::string& where) {
  if (value.is_null()) throw InputError(where + " must have a value, got null");
  if (!value.is_structured()) return;
  for (const auto& [key, inner] : value.items()) {
    std::string inside = where;
    inside += ": ";
    inside += key;
    require_no_null(inner, inside);
  }
}

/// nan and inf are numbers here, as `number` is to refuse them.
bool spells_number(std::string_view text) {
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size();
}

void require_numbers(const CsvTable& table) {
  for (size_t column = 0; column < table.header().size(); ++column) {
    const std::string_view first = table.word(0, column);
    if (!first.empty() && !spells_number(first)) continue;  // a column of words
    for (size_t row = 0; row < table.rows(); ++row) (void)table.number(row, column);
  }
}

/// NAME of mean(NAME), else nothing.
std::optional<std::string> averaged(const std::string& quantity) {
  if (!quantity.starts_with("mean(") || !quantity.ends_with(")")) return std::nullopt;
  return quantity.substr(5, quantity.size() - 6);
}

}  // namespace

Json read_json_object(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) refuse(path.string(), "cannot be opened");
  Json object;
  try {
    object = Json::parse(in);
  } catch (const Json::exception& error) {
    refuse(path.string(), error.what());
  }
  if (!object.is_object()) refuse(path.string(), "must hold one JSON object");
  return object;
}

FigureFile::FigureFile(const std::filesystem::path& path)
    : name_(path.string()), content_(read(path)) {}

double FigureFile::mean(size_t column) const {
  const auto& table = std::get<CsvTable>(content_);
  double sum = 0.0;
  for (size_t row = 0; row < table.rows(); ++row) sum += table.number(row, column);
  return sum / static_cast<double>(table.rows());
}

std::optional<double> FigureFile::find(const std::string& quantity) const {
  if (const auto* object = std::get_if<Json>(&content_)) {
    const Json* found = value_of(*object, quantity);
    if (found == nullptr) return std::nullopt;
    return finite(*found, name_ + ": " + quantity);
  }
  const auto& table = std::get<CsvTable>(content_);
  const auto column_averaged = averaged(quantity);
  const auto column = table.find_column(column_averaged.value_or(quantity));
  if (!column) return std::nullopt;
  if (table.rows() == 0) refuse(name_, "has no row");
  return column_averaged ? mean(*column) : table.number(table.rows() - 1, *column);
}

bool FigureFile::is_null(const std::string& quantity) const {
  const auto* object = std::get_if<Json>(&content_);
  const Json* found = object != nullptr ? value_of(*object, quantity) : nullptr;
  return found != nullptr && found->is_null();
}

double FigureFile::get(const std::string& quantity) const {
  if (const auto found = find(quantity)) return *found;
  refuse(name_, "has no '" + quantity + "'");
}

void FigureFile::require_finite() const {
  if (const auto* object = std::get_if<Json>(&content_)) {
    require_no_null(*object, name_);
    return;
  }
  const auto& table = std::get<CsvTable>(content_);
  if (table.rows() == 0) refuse(name_, "has no row");
  require_numbers(table);
}

double figure(const std::string& words) {
  const size_t colon = words.rfind(':');
  if (colon == std::string::npos)
    return parse_number(words, "a figure (a number or FILE:QUANTITY)");
  return FigureFile(words.substr(0, colon)).get(words.substr(colon + 1));
}

std::string text_of(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace muckpile::check
