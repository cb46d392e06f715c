// SPDX-License-Identifier: GPL-2.0-or-later
// A table of a run as curves over its first column.
// Scope: see the header.
#include "compare/table_curves.h"

#include <algorithm>
#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {

TableCurves read_curves(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  TableCurves curves{std::string(table.header().front()), {}};
  for (size_t row = 1; row < table.rows(); ++row) {
    if (table.number(row, 0) < table.number(row - 1, 0))
      throw InputError(table.where(row) + curves.over + " must not fall");
  }
  for (size_t column = 1; column < table.header().size(); ++column) {
    std::vector<Vec2>& curve = curves.of_column[std::string(table.header()[column])];
    for (size_t row = 0; row < table.rows(); ++row) {
      // An empty field is a measure without meaning.
      if (!table.word(row, column).empty())
        curve.emplace_back(table.number(row, 0), table.number(row, column));
    }
  }
  return curves;
}

double value_at(const std::vector<Vec2>& curve, double x) {
  const auto above = std::ranges::upper_bound(curve, x, {}, [](const Vec2& p) { return p.x(); });
  if (above == curve.begin()) return above->y();
  const Vec2& below = *std::prev(above);
  if (above == curve.end()) return below.y();
  return below.y() + (x - below.x()) / (above->x() - below.x()) * (above->y() - below.y());
}

FarthestApart farthest_apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  std::vector<double> places;
  for (const auto* curve : {&a, &b}) {
    for (const Vec2& point : *curve) places.push_back(point.x());
  }
  std::ranges::sort(places);
  FarthestApart farthest{places.front(), value_at(a, places.front()), value_at(b, places.front())};
  for (const double x : places) {
    const FarthestApart here{x, value_at(a, x), value_at(b, x)};
    if (std::abs(here.a - here.b) > std::abs(farthest.a - farthest.b)) farthest = here;
  }
  return farthest;
}

}  // namespace muckpile
