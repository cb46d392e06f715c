// SPDX-License-Identifier: GPL-2.0-or-later
// From words to a floor of surveyed ground.
// Scope: see the header.
#include "geometry/surface/ground_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/surface/mine_words.h"
#include "geometry/surface/surface_checks.h"

namespace muckpile {
namespace {

constexpr std::size_t kWords = 7;
constexpr double kSame = 1e-9;  // [m], between places: nothing fits in

/// The six numbers behind the file.
struct GroundWords {
  FloorExtent extent;
  double bottom;  // [m]
};

GroundWords ground_words(const std::vector<std::string>& words, const std::string& where) {
  constexpr double kFar = 1e7;
  std::array<double, kWords - 1> value{};
  for (std::size_t k = 0; k < value.size(); ++k)
    value[k] = parse_real(where, "ground", words[k + 1], "m", Range::closed(-kFar, kFar));
  const auto [x_lo, x_hi, y_lo, y_hi, bottom, cell] = value;
  if (!(x_lo < x_hi && y_lo < y_hi))
    refuse(where, "ground needs x and y that rise, got x from '" + words[1] + "' to '" + words[2] +
                      "' and y from '" + words[3] + "' to '" + words[4] + "'");
  if (!(cell > 0.0)) refuse(where, "ground needs panels wider than 0 m, got '" + words[6] + "'");
  return {{x_lo, x_hi, y_lo, y_hi, cell}, bottom};
}

/// Where the rock stands that the ground surrounds on three sides [m].
struct RockSides {
  double back, y_lo, y_hi;
};

RockSides sides_of(const std::vector<std::string>& words, const FloorExtent& extent,
                   const std::string& where) {
  const auto real = [&](std::size_t k) {
    return parse_real(where, "beside", words[k], "m", Range::closed(-1e7, 1e7));
  };
  const RockSides sides{real(0), real(1), real(2)};
  const bool within = sides.back < extent.x_lo && sides.y_lo < sides.y_hi &&
                      sides.y_lo > extent.y_lo && sides.y_hi < extent.y_hi;
  if (!within)
    refuse(where,
           "beside must be a place behind x_lo of ground and two within its y that rise, got '" +
               words[0] + " " + words[1] + " " + words[2] + "'");
  return sides;
}

/// What of a triangle lies where sign (y - end) >= 0.
std::vector<Vec3> beyond(StlTriangle triangle, double end, double sign) {
  std::vector<Vec3> kept;
  for (Vec3& corner : triangle)
    if (std::abs(corner.y() - end) < kSame) corner.y() = end;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = triangle[k], &b = triangle[(k + 1) % 3];
    const double here = sign * (a.y() - end), there = sign * (b.y() - end);
    if (here >= 0.0) kept.push_back(a);
    if (here * there >= 0.0) continue;
    kept.push_back(a + here / (here - there) * (b - a));
    kept.back().y() = end;  // to the last digit, as the neighbour has it
  }
  return kept;
}

/// Ground beside the rock, and walls between it and what the rock stands on.
void add_beside(SurveyedFloor& floor, const SurveyedFloor& beside, const RockSides& sides,
                double bottom) {
  floor.lowest = std::min(floor.lowest, beside.lowest);
  floor.highest = std::max(floor.highest, beside.highest);
  for (const StlTriangle& triangle : beside.triangles) {
    for (const auto& [end, sign] : {std::pair{sides.y_hi, 1.0}, std::pair{sides.y_lo, -1.0}}) {
      const std::vector<Vec3> part = beyond(triangle, end, sign);
      for (std::size_t k = 1; k + 1 < part.size(); ++k)
        floor.triangles.push_back({part[0], part[k], part[k + 1]});
      for (std::size_t k = 0; part.size() > 2 && k < part.size(); ++k) {
        const Vec3 &a = part[k], &b = part[(k + 1) % part.size()];
        if (a.y() == end && b.y() == end) add_wall(floor.triangles, a, b, bottom);
      }
    }
  }
}

/// The wall below the ground's edge at x_lo, between y_lo and y_hi.
void add_step(SurveyedFloor& floor, double y_lo, double y_hi, double foot) {
  for (std::size_t k = 0; k + 1 < floor.edge.size(); ++k) {
    const Vec3 &low = floor.edge[k], &high = floor.edge[k + 1];
    const double from = std::max(y_lo, low.y()), to = std::min(y_hi, high.y());
    if (!(from + kSame < to)) continue;
    const auto at = [&](double y) -> Vec3 {
      if (y == low.y() || y == high.y()) return y == low.y() ? low : high;
      const double height = low.z() + (y - low.y()) / (high.y() - low.y()) * (high.z() - low.z());
      return {low.x(), y, height};
    };
    add_wall(floor.triangles, at(to), at(from), foot);
  }
}

/// Mean height of the ground's edge at x_lo, between y_lo and y_hi [m].
double height_of_edge(const SurveyedFloor& floor, double y_lo, double y_hi) {
  double area = 0.0, width = 0.0;
  for (std::size_t k = 0; k + 1 < floor.edge.size(); ++k) {
    const Vec3 &low = floor.edge[k], &high = floor.edge[k + 1];
    const double part = std::min(y_hi, high.y()) - std::max(y_lo, low.y());
    if (part <= 0.0) continue;
    area += 0.5 * (low.z() + high.z()) * part;
    width += part;
  }
  return width > 0.0 ? area / width : 0.0;
}

/// The ground in front, or around the place of the rock.
void add_ground(GroundPanels& made, const GroundHeights& ground, const GroundWords& words,
                const std::optional<RockSides>& sides) {
  FloorExtent front = words.extent;
  if (!sides) {
    made.floor = surveyed_floor(ground, front);
    made.front = height_of_edge(made.floor, front.y_lo, front.y_hi);
    const double foot = std::min(words.bottom, made.floor.lowest - made.floor.cell);
    return add_step(made.floor, front.y_lo, front.y_hi, foot);
  }
  FloorExtent beside = front;
  beside.x_lo = sides->back;
  beside.x_hi = front.x_lo;
  front.cell = beside.cell = std::max(panel_width(ground, front), panel_width(ground, beside));
  made.floor = surveyed_floor(ground, front);
  made.front = height_of_edge(made.floor, sides->y_lo, sides->y_hi);
  add_step(made.floor, sides->y_lo, sides->y_hi, words.bottom);
  add_beside(made.floor, surveyed_floor(ground, beside), *sides, words.bottom);
  const auto corner = [&](double x, double y) { return Vec3(x, y, words.bottom); };
  const Vec3 a = corner(sides->back, sides->y_lo), b = corner(front.x_lo, sides->y_lo),
             c = corner(front.x_lo, sides->y_hi), d = corner(sides->back, sides->y_hi);
  made.under_rock = {{a, b, c}, {a, c, d}};
}

std::string reach_text(double x_lo, double x_hi, double y_lo, double y_hi) {
  return "x = " + rounded_text(x_lo) + " to " + rounded_text(x_hi) +
         " and y = " + rounded_text(y_lo) + " to " + rounded_text(y_hi) + " m";
}

/// A survey of another place would give a floor at the height of its nearest point.
void require_survey_there(const GroundHeights& ground, const FloorExtent& extent, double x_back,
                          const std::string& where) {
  const Vec3 &lo = ground.lo(), &hi = ground.hi();
  if (lo.x() < extent.x_hi && hi.x() > x_back && lo.y() < extent.y_hi && hi.y() > extent.y_lo)
    return;
  refuse(where, "must have points of the floor, " +
                    reach_text(x_back, extent.x_hi, extent.y_lo, extent.y_hi) +
                    " of the run; they lie at " + reach_text(lo.x(), hi.x(), lo.y(), hi.y()) +
                    ": give the place of 0 0 0 of the run in the file's coordinates by origin");
}

/// Of two layers of triangles a panel would have either; of a face that hangs over somewhat some
/// panels have its foot or its crest.
void require_one_layer(const std::vector<StlTriangle>& survey, const FloorExtent& extent,
                       double x_back, double panel, const std::string& where) {
  const SurfaceIndex ground(survey);
  const Vec3 lo = ground.lo().cwiseMax(Vec3(x_back, extent.y_lo, -HUGE_VAL)),
             hi = ground.hi().cwiseMin(Vec3(extent.x_hi, extent.y_hi, HUGE_VAL));
  constexpr double kLayers = 0.1;  // of the columns
  require_one_height(ground, lo, hi, panel, kLayers, where,
                     "take out one of the two, or the lower side of a closed body");
}

/// A survey that begins in front of the rock; "" for one that reaches it.
std::string told_of_edge(const GroundHeights& ground, const SurveyedFloor& floor, double x_lo,
                         const std::string& where) {
  const double begins = ground.lo().x();
  if (begins <= x_lo + floor.cell) return "";
  return where + ": WARNING: the survey begins at x = " + rounded_text(begins) +
         " m, the floor at x = " + rounded_text(x_lo) +
         " m; between them the floor is as high as the survey's edge\n";
}

}  // namespace

ArgTable& add_ground_words(ArgTable& table) {
  return add_mine_words(
      table
          .group("ground", kWords, kWords, false,
                 "FILE x_lo x_hi y_lo y_hi bottom width: a floor at the heights of surveyed "
                 "ground (files as of `terrain` of create_blocks), with a step at x_lo down to "
                 "bottom, in panels of about that width where there is a survey [m]")
          .group("beside", 3, 3, false,
                 "x_back y_lo y_hi: that ground lies beside the rock, too, from x_back to x_lo "
                 "beyond y_lo and y_hi; the rock stands between on a level floor at bottom, with "
                 "walls up or down to the ground on three sides [m]"),
      "the files of `ground`");
}

GroundPanels ground_panels(const ArgValues& words, const std::string& where) {
  GroundPanels made;
  const auto groups = words.groups("ground");
  for (const char* word : {"origin", "x_bearing", "unit", "beside"})
    if (groups.empty() && words.given(word)) refuse(where, std::string(word) + " needs ground");
  if (groups.empty()) return made;
  const std::vector<std::string>& given = groups.front();
  const GroundWords numbers = ground_words(given, where);
  const MineWords mine = read_mine_words(words, where);
  const std::vector<StlTriangle> survey =
      terrain_triangles(read_placed(given[0], mine.frame, mine.unit));
  const GroundHeights ground(survey, where + ": ground " + given[0]);
  std::optional<RockSides> sides;
  for (const std::vector<std::string>& group : words.groups("beside"))
    sides = sides_of(group, numbers.extent, where);
  const double x_back = sides ? sides->back : numbers.extent.x_lo;
  if (!mine.unit_given) {
    const FloorExtent& floor = numbers.extent;
    require_likely_unit(ground.lo(), ground.hi(), false, {floor.x_lo, floor.y_lo, 0.0},
                        {floor.x_hi, floor.y_hi, 1.0}, where + ": ground " + given[0], "floor",
                        kUnitKnob);
  }
  require_survey_there(ground, numbers.extent, x_back, where + ": ground " + given[0]);
  add_ground(made, ground, numbers, sides);
  require_one_layer(survey, numbers.extent, x_back, made.floor.cell,
                    where + ": ground " + given[0]);
  made.told = where + ": ground of " + given[0] + " from x = " + number_text(numbers.extent.x_lo) +
              " m on: " + std::to_string(made.floor.triangles.size()) +
              " triangles between z = " + rounded_text(made.floor.lowest) + " and " +
              rounded_text(made.floor.highest) + " m, in panels of " +
              rounded_text(made.floor.cell) + " m\n" +
              told_of_edge(ground, made.floor, numbers.extent.x_lo, where);
  return made;
}

}  // namespace muckpile
