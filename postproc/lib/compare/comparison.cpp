// SPDX-License-Identifier: GPL-2.0-or-later
// Whether two runs have the same figures within tolerances.
// Scope: see the header.
#include "compare/comparison.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/suggestion.h"
#include "figures/expected.h"

namespace muckpile {
namespace {

constexpr const char* kMissing = "missing";

std::string shown(const check::Json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.is_number() ? check::text_of(value.get<double>()) : value.dump();
}

// The part before the colon of TABLE:COLUMN; the name itself where there is none.
std::string table_of(const std::string& name) { return name.substr(0, name.find(':')); }

bool names(const std::vector<std::string>& list, const std::string& name) {
  return std::ranges::find(list, name) != list.end() ||
         std::ranges::find(list, table_of(name)) != list.end();
}

std::optional<Tolerance> tolerance_of(const std::string& name, const CompareOptions& options) {
  for (const auto* own : {&options.named, &options.of_the_case}) {
    for (const std::string& word : {name, table_of(name)}) {
      if (const auto found = own->find(word); found != own->end()) return found->second;
    }
  }
  return std::nullopt;
}

bool counts(const std::string& name, const CompareOptions& options) {
  if (names(options.ignored, name)) return false;
  return !names(keys_of_the_computation(), name) || tolerance_of(name, options).has_value();
}

ComparedQuantity compare_values(const std::string& name, const check::Json& a, const check::Json& b,
                                const Tolerance& tolerance) {
  ComparedQuantity compared{name, shown(a), shown(b), {}, {}, {}, a == b};
  if (!a.is_number() || !b.is_number()) return compared;
  const double reference = a.get<double>();
  compared.difference = b.get<double>() - reference;
  compared.allowed = tolerance.allowed(reference);
  compared.same = std::abs(*compared.difference) <= *compared.allowed;
  return compared;
}

ComparedQuantity compare_columns(const std::string& name, const std::string& over,
                                 const std::vector<Vec2>& a, const std::vector<Vec2>& b,
                                 const Tolerance& tolerance) {
  if (a.empty() || b.empty()) {
    return {name, a.empty() ? "empty" : "filled", b.empty() ? "empty" : "filled", {}, {},
            {},   a.empty() == b.empty()};
  }
  double largest = 0.0;
  for (const Vec2& point : a) largest = std::max(largest, std::abs(point.y()));
  const FarthestApart apart = farthest_apart(a, b);
  ComparedQuantity compared{name, check::text_of(apart.a), check::text_of(apart.b), {}, {}, {},
                            false};
  compared.difference = apart.b - apart.a;
  compared.allowed = tolerance.allowed(largest);
  compared.place = over + " = " + check::text_of(apart.x);
  compared.same = std::abs(*compared.difference) <= *compared.allowed;
  return compared;
}

// Every name of either run, once.
template <class Map>
std::set<std::string> names_in(const Map& a, const Map& b) {
  std::set<std::string> all;
  for (const auto* map : {&a, &b}) {
    for (const auto& [name, value] : *map) all.insert(name);
  }
  return all;
}

// What one run lacks, or nothing where both have it.
template <class Map>
std::optional<ComparedQuantity> lacking(const Map& a, const Map& b, const std::string& word,
                                        const std::string& name) {
  if (a.contains(word) && b.contains(word)) return std::nullopt;
  return ComparedQuantity{name,
                          a.contains(word) ? "there" : kMissing,
                          b.contains(word) ? "there" : kMissing,
                          {},
                          {},
                          {},
                          false};
}

void compare_tables(const std::string& table, const TableCurves& a, const TableCurves& b,
                    const CompareOptions& options, std::vector<ComparedQuantity>& compared) {
  for (const std::string& column : names_in(a.of_column, b.of_column)) {
    const std::string name = table + ":" + column;
    if (!counts(name, options)) continue;
    if (const auto missing = lacking(a.of_column, b.of_column, column, name)) {
      compared.push_back(*missing);
    } else {
      compared.push_back(compare_columns(name, a.over, a.of_column.at(column),
                                         b.of_column.at(column),
                                         tolerance_of(name, options).value_or(options.general)));
    }
  }
}

void refuse_unknown_names(const RunFigures& a, const RunFigures& b, const CompareOptions& options) {
  std::set<std::string> known = names_in(a.values, b.values);
  for (const auto* run : {&a, &b}) {
    for (const auto& [table, curves] : run->tables) {
      known.insert(table);
      for (const auto& [column, curve] : curves.of_column) known.insert(table + ":" + column);
    }
  }
  std::vector<std::string> given = options.ignored;
  for (const auto& [name, tolerance] : options.named) given.push_back(name);
  for (const std::string& name : given) {
    if (!known.contains(name))
      refuse("compare",
             "neither run has '" + name + "'" +
                 did_you_mean(name, std::vector<std::string>(known.begin(), known.end())));
  }
}

}  // namespace

double Tolerance::allowed(double reference) const {
  return std::max(absolute, relative * std::abs(reference));
}

std::pair<std::string, Tolerance> parse_tolerance(const std::string& words) {
  const std::string context = "compare: --tolerance '" + words + "'";
  const size_t equals = words.find('=');
  if (equals == 0 || equals == std::string::npos)
    refuse(context, "must be KEY=RELATIVE or KEY=RELATIVE,ABSOLUTE");
  const std::string numbers = words.substr(equals + 1);
  const size_t comma = numbers.find(',');
  Tolerance tolerance;
  tolerance.relative = parse_number(numbers.substr(0, comma), context + ": RELATIVE");
  if (comma != std::string::npos)
    tolerance.absolute = parse_number(numbers.substr(comma + 1), context + ": ABSOLUTE");
  if (tolerance.relative < 0.0 || tolerance.absolute < 0.0) refuse(context, "must be >= 0");
  return {words.substr(0, equals), tolerance};
}

std::map<std::string, Tolerance> tolerances_of_case(const std::filesystem::path& expected) {
  std::map<std::string, Tolerance> tolerances;
  for (const check::ExpectedRow& row : check::read_expected(expected).rows)
    tolerances[row.quantity] = {0.0, row.tolerance};
  return tolerances;
}

const std::vector<std::string>& keys_of_the_computation() {
  static const std::vector<std::string> keys{"run_id",
                                             "wall_time_s",
                                             "steps",
                                             "ranks",
                                             "vtk_snapshots",
                                             "still_note",
                                             "energy_balance_error",
                                             "energy_balance_error_worst",
                                             "energy_audit_error",
                                             "energy_audit_error_worst_hole"};
  return keys;
}

std::vector<ComparedQuantity> compare_runs(const RunFigures& a, const RunFigures& b,
                                           const CompareOptions& options) {
  refuse_unknown_names(a, b, options);
  std::vector<ComparedQuantity> compared;
  for (const std::string& key : names_in(a.values, b.values)) {
    if (!counts(key, options)) continue;
    if (const auto missing = lacking(a.values, b.values, key, key)) {
      compared.push_back(*missing);
    } else {
      compared.push_back(compare_values(key, a.values.at(key), b.values.at(key),
                                        tolerance_of(key, options).value_or(options.general)));
    }
  }
  for (const std::string& table : names_in(a.tables, b.tables)) {
    if (names(options.ignored, table)) continue;
    if (const auto missing = lacking(a.tables, b.tables, table, table)) {
      compared.push_back(*missing);
    } else {
      compare_tables(table, a.tables.at(table), b.tables.at(table), options, compared);
    }
  }
  return compared;
}

}  // namespace muckpile
