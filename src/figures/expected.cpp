// SPDX-License-Identifier: GPL-2.0-or-later
// What a case is expected to give.
// Scope: see the header.
#include "figures/expected.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "args/input_error.h"
#include "args/suggestion.h"

namespace muckpile::check {
namespace {

void require_keys(const Json& object, const std::vector<std::string>& needed,
                  const std::vector<std::string>& optional, const std::string& where) {
  if (!object.is_object()) refuse(where, "must be an object, got " + object.dump());
  std::vector<std::string> known = needed;
  known.insert(known.end(), optional.begin(), optional.end());
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse(where, "unknown key '" + key + "'" + did_you_mean(key, known));
  }
  for (const std::string& key : needed) {
    if (!object.contains(key)) refuse(where, "has no key '" + key + "'");
  }
}

std::string text_at(const Json& object, const std::string& key, const std::string& where) {
  const Json& value = object.at(key);
  if (!value.is_string()) refuse(where, key + " must be a text, got " + value.dump());
  return value.get<std::string>();
}

double number_at(const Json& object, const std::string& key, const std::string& where) {
  const Json& value = object.at(key);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    refuse(where, key + " must be a finite number, got " + value.dump());
  return value.get<double>();
}

ExpectedRow read_row(const Json& row, const std::string& where) {
  require_keys(row, {"quantity", "value", "tolerance", "why"}, {}, where);
  ExpectedRow read{text_at(row, "quantity", where), number_at(row, "value", where),
                   number_at(row, "tolerance", where)};
  if (read.quantity.empty()) refuse(where, "quantity must not be empty");
  if (text_at(row, "why", where).empty()) refuse(where, "why must not be empty");
  if (read.tolerance < 0.0)
    refuse(where, "tolerance must be >= 0, got " + row.at("tolerance").dump());
  return read;
}

/// What is wrong with it, or nothing; `found` is what the files have.
std::string fault_of(const ExpectedRow& row, const std::vector<FigureFile>& files,
                     std::string& found) {
  try {
    for (const FigureFile& file : files) {
      const auto value = file.find(row.quantity);
      if (!value) continue;
      found = text_of(*value);
      return std::abs(*value - row.value) <= row.tolerance ? "" : "WRONG";
    }
  } catch (const InputError& error) {
    return std::string("WRONG: ") + error.what();
  }
  return "WRONG: no file has it";
}

}  // namespace

Expected read_expected(const std::filesystem::path& path) {
  const std::string name = path.string();
  const Json file = read_json_object(path);
  require_keys(file, {"case", "expected"}, {"vars"}, name);
  (void)text_at(file, "case", name);
  Expected expected;
  if (file.contains("vars")) expected.vars = text_at(file, "vars", name);
  const Json& rows = file.at("expected");
  if (!rows.is_array() || rows.empty())
    refuse(name, "expected must be a list with one row at least, got " + rows.dump());
  std::set<std::string> quantities;
  for (size_t k = 0; k < rows.size(); ++k) {
    const std::string where = name + ": row " + std::to_string(k + 1) + " of expected";
    expected.rows.push_back(read_row(rows[k], where));
    const std::string& quantity = expected.rows.back().quantity;
    if (!quantities.insert(quantity).second)
      refuse(where, "quantity '" + quantity + "' is there twice");
  }
  return expected;
}

bool compare(const Expected& expected, const std::vector<FigureFile>& files) {
  bool all = true;
  for (const ExpectedRow& row : expected.rows) {
    std::string found = "missing";
    const std::string fault = fault_of(row, files, found);
    std::printf("%-28s %14s  expected %s +- %s  %s\n", row.quantity.c_str(), found.c_str(),
                text_of(row.value).c_str(), text_of(row.tolerance).c_str(),
                fault.empty() ? "ok" : fault.c_str());
    all = all && fault.empty();
  }
  return all;
}

}  // namespace muckpile::check
