// SPDX-License-Identifier: GPL-2.0-or-later
// Polygons in plan.
// Scope: see the header.
#include "io/ore_polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

double area_of(const std::vector<Vec2>& corners) {
  double twice = 0.0;
  for (size_t k = 0; k < corners.size(); ++k) {
    const Vec2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * std::abs(twice);
}

// On which side of the line through two points another lies: 1 or -1, 0 on it, as is what lies
// within the centimetre of surveys.
int side_of(const Vec2& a, const Vec2& b, const Vec2& point) {
  constexpr double kSurvey = 0.01;  // [m]
  const Vec2 along = b - a, to = point - a;
  const double one = along.x() * to.y(), other = along.y() * to.x();
  if (std::abs(one - other) <= kSurvey * along.norm()) return 0;
  return one > other ? 1 : -1;
}

// Whether each of two edges has the ends of the other on both sides of it. Edges that touch or lie
// on each other, as around an island, do not.
bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

void require_no_crossing(const OrePolygon& polygon, const std::string& where) {
  const std::vector<Vec2>& corners = polygon.corners;
  const auto corner = [&](size_t k) -> const Vec2& { return corners[k % corners.size()]; };
  for (size_t j = 0; j < corners.size(); ++j) {
    for (size_t k = j + 2; k < corners.size(); ++k) {
      if (!cross(corner(j), corner(j + 1), corner(k), corner(k + 1))) continue;
      const auto named = [&](size_t edge) {
        return std::to_string(edge + 1) + " to " + std::to_string((edge + 1) % corners.size() + 1);
      };
      throw InputError(where + "polygon '" + polygon.name +
                       "' crosses itself: its edge from corner " + named(j) +
                       " and that from corner " + named(k) + "; give the corners in order");
    }
  }
}

void require_area(const OrePolygon& polygon, const std::string& where) {
  const std::string name = "polygon '" + polygon.name + "'";
  if (polygon.corners.size() < 3)
    throw InputError(where + name + " must have three corners at least, got " +
                     std::to_string(polygon.corners.size()));
  require_no_crossing(polygon, where);
  if (!(area_of(polygon.corners) > 0.0)) throw InputError(where + name + " has no area");
}

// The heights of a row, which must be those of the polygon so far.
void add_heights(const CsvTable& table, size_t row, OrePolygon& polygon) {
  const auto low = table.find_column("z_low_m"), high = table.find_column("z_high_m");
  if (low.has_value() != high.has_value())
    throw InputError(table.where(row) + "z_low_m and z_high_m must both be there, or neither");
  if (!low) return;
  const double from = table.number(row, *low), to = table.number(row, *high);
  if (!(from < to)) throw InputError(table.where(row) + "z_high_m must be > z_low_m");
  if (polygon.corners.size() > 1 && (from != polygon.low || to != polygon.high))
    throw InputError(table.where(row) + "the heights of polygon '" + polygon.name +
                     "' must be the same in all its rows");
  polygon.low = from;
  polygon.high = to;
}

}  // namespace

bool OrePolygon::contains(const Vec2& point) const {
  bool inside = false;
  for (size_t k = 0; k < corners.size(); ++k) {
    const Vec2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > point.x()) inside = !inside;
  }
  return inside;
}

std::vector<OrePolygon> read_ore_polygons(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  table.require_known_columns({"polygon", "x_m", "y_m", "z_low_m", "z_high_m"});
  const size_t name = table.column("polygon"), x = table.column("x_m"), y = table.column("y_m");
  if (table.rows() == 0) refuse(path.string(), "has no row");
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<OrePolygon> polygons;
  for (size_t row = 0; row < table.rows(); ++row) {
    const std::string word(table.word(row, name));
    if (polygons.empty() || polygons.back().name != word) {
      if (!polygons.empty()) require_area(polygons.back(), table.where(row - 1));
      if (word.empty()) throw InputError(table.where(row) + "polygon must have a name");
      if (std::ranges::find(polygons, word, &OrePolygon::name) != polygons.end())
        throw InputError(table.where(row) + "the rows of polygon '" + word +
                         "' must follow each other");
      polygons.push_back({word, {}, -kFar, kFar});
    }
    polygons.back().corners.emplace_back(table.number(row, x), table.number(row, y));
    add_heights(table, row, polygons.back());
  }
  require_area(polygons.back(), table.where(table.rows() - 1));
  return polygons;
}

}  // namespace muckpile
