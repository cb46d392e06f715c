// SPDX-License-Identifier: GPL-2.0-or-later
// The same table of several runs, one over the other.
// Scope: see the header.
#include "sweep/overlay.h"

#include <algorithm>
#include <map>
#include <set>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/suggestion.h"

namespace muckpile {
namespace {

bool names_rows(std::string_view column) {
  constexpr std::string_view kNaming[] = {
      "polygon", "hole", "row", "gauge", "level_low_m", "level_high_m", "from_face_m", "to_face_m"};
  return std::ranges::find(kNaming, column) != std::end(kNaming);
}

std::vector<std::string> naming_columns(const CsvTable& table) {
  std::vector<std::string> naming;
  for (const std::string_view column : table.header()) {
    if (!names_rows(column)) break;
    naming.emplace_back(column);
  }
  return naming;
}

// Those that hold a value in every table, or those asked for.
std::vector<std::string> shown_columns(const std::vector<std::filesystem::path>& paths,
                                       const std::vector<TableCurves>& tables,
                                       const std::vector<std::string>& asked) {
  std::vector<std::string> known;
  for (const auto& [name, curve] : tables.front().of_column) known.push_back(name);
  for (const std::string& column : asked) {
    for (size_t k = 0; k < tables.size(); ++k) {
      const auto found = tables[k].of_column.find(column);
      if (found == tables[k].of_column.end() || found->second.empty())
        refuse(paths[k].string(),
               "has no value in a column '" + column + "'" +
                   (std::ranges::find(known, column) == known.end() ? did_you_mean(column, known)
                                                                    : ""));
    }
  }
  if (!asked.empty()) return asked;
  std::erase_if(known, [&](const std::string& name) {
    return std::ranges::any_of(tables, [&](const TableCurves& table) {
      const auto found = table.of_column.find(name);
      return found == table.of_column.end() || found->second.empty();
    });
  });
  if (known.empty()) refuse(paths.front().string(), "shares no column of numbers with the others");
  return known;
}

OverlaidCurve overlaid(const std::vector<TableCurves>& tables, const std::string& column) {
  OverlaidCurve all{column, {}, {}, {}};
  std::set<double> places;
  for (const TableCurves& table : tables) {
    all.runs.push_back(table.of_column.at(column));
    for (const Vec2& point : all.runs.back()) places.insert(point.x());
  }
  all.x.assign(places.begin(), places.end());
  for (const double x : all.x) {
    std::vector<double> values;
    for (const auto& run : all.runs) values.push_back(value_at(run, x));
    all.spread.push_back(spread_of(values));
  }
  return all;
}

}  // namespace

OverlaidCurves overlaid_curves(const std::vector<std::filesystem::path>& tables,
                               const std::vector<std::string>& columns) {
  std::vector<TableCurves> all;
  for (const auto& path : tables) {
    all.push_back(read_curves(path));
    if (all.back().over != all.front().over)
      refuse(path.string(), "is a table over '" + all.back().over + "', the first one over '" +
                                all.front().over + "'");
  }
  OverlaidCurves curves{all.front().over, {}};
  for (const std::string& column : shown_columns(tables, all, columns))
    curves.curves.push_back(overlaid(all, column));
  return curves;
}

OverlaidRows overlaid_rows(const std::vector<std::filesystem::path>& tables,
                           const std::vector<std::string>& columns) {
  OverlaidRows all;
  std::vector<std::string> header;  // of the first table
  std::vector<std::vector<std::string>> order;
  std::map<std::vector<std::string>, std::map<std::string, std::vector<double>>> values;
  for (const auto& path : tables) {
    const CsvTable table = CsvTable::read(path);
    if (header.empty()) {
      all.over = naming_columns(table);
      header.assign(table.header().begin(), table.header().end());
    }
    if (naming_columns(table) != all.over)
      refuse(path.string(), "must name its rows by " + joined(all.over) + " as the first table");
    for (size_t row = 0; row < table.rows(); ++row) {
      std::vector<std::string> names;
      for (size_t k = 0; k < all.over.size(); ++k) names.emplace_back(table.word(row, k));
      if (!values.contains(names)) order.push_back(names);
      auto& of_row = values[names];
      for (size_t k = all.over.size(); k < table.header().size(); ++k)
        if (!table.word(row, k).empty())
          of_row[std::string(table.header()[k])].push_back(table.number(row, k));
    }
  }
  const std::vector<std::string> known(
      header.begin() + static_cast<std::ptrdiff_t>(all.over.size()), header.end());
  for (const std::string& column : columns)
    if (std::ranges::find(known, column) == known.end())
      refuse(tables.front().string(),
             "has no column '" + column + "'" + did_you_mean(column, known));
  for (const auto& names : order)
    for (const std::string& column : columns.empty() ? known : columns)
      if (const auto found = values[names].find(column); found != values[names].end())
        all.rows.push_back({names, column, spread_of(found->second)});
  return all;
}

bool has_named_rows(const std::filesystem::path& table) {
  return !naming_columns(CsvTable::read(table)).empty();
}

}  // namespace muckpile
