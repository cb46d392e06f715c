// SPDX-License-Identifier: GPL-2.0-or-later
// Checks of surfaces that shall bound rock.
// Scope: see the header.
#include "geometry/surface/surface_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "args/input_error.h"
#include "args/rounded_text.h"

namespace muckpile {
namespace {

/// To a millimetre, and all digits of mine coordinates.
std::string place_text(const Vec3& p) {
  std::string text;
  for (const double value : p) {
    if (!text.empty()) text += ' ';
    text += rounded_text(std::round(1e3 * value) / 1e3 + 0.0, 10);
  }
  return text;
}

/// Corners that are one to rounding have one number.
class Corners {
 public:
  explicit Corners(double rounding) : rounding_(rounding) {}
  std::array<int, 3> numbers(const StlTriangle& t) {
    return {number(t[0]), number(t[1]), number(t[2])};
  }

 private:
  int number(const Vec3& p) {
    const std::array<long long, 3> key{std::llround(p.x() / rounding_),
                                       std::llround(p.y() / rounding_),
                                       std::llround(p.z() / rounding_)};
    return known_.try_emplace(key, static_cast<int>(known_.size())).first->second;
  }

  double rounding_;
  std::map<std::array<long long, 3>, int> known_;
};

Corners corners_of(const std::vector<StlTriangle>& triangles) {
  constexpr double kRounding = 1e-7;  // of the extent
  Vec3 lo = triangles.front()[0], hi = lo;
  for (const StlTriangle& t : triangles)
    for (const Vec3& c : t) lo = lo.cwiseMin(c), hi = hi.cwiseMax(c);
  return Corners(kRounding * (hi - lo).maxCoeff());
}

struct EdgeUse {
  int forward = 0, backward = 0;
  Vec3 from, to;
};

std::vector<EdgeUse> edges_of(const std::vector<StlTriangle>& triangles) {
  Corners corners = corners_of(triangles);
  std::map<std::pair<int, int>, EdgeUse> edges;
  for (const StlTriangle& t : triangles) {
    const std::array<int, 3> c = corners.numbers(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (c[k] == c[next]) continue;  // no edge: a sliver, its corners are one
      EdgeUse& use = edges[std::minmax(c[k], c[next])];
      ++(c[k] < c[next] ? use.forward : use.backward);
      use.from = t[k];
      use.to = t[next];
    }
  }
  std::vector<EdgeUse> all;
  for (const auto& [corners_of, use] : edges) all.push_back(use);
  return all;
}

template <class Wrong>
void refuse_edges(const std::vector<EdgeUse>& edges, const Wrong& wrong, const std::string& where,
                  const std::string& what, const std::string& remedy) {
  const auto first = std::ranges::find_if(edges, wrong);
  if (first == edges.end()) return;
  refuse(where, what + " at " + std::to_string(std::ranges::count_if(edges, wrong)) +
                    " edges, one of them from " + place_text(first->from) + " to " +
                    place_text(first->to) + " m; " + remedy);
}

std::string both_text(const Vec3& surface_lo, const Vec3& surface_hi, const Vec3& lo,
                      const Vec3& hi, const std::string& box) {
  return "got one " + extent_text(surface_lo, surface_hi) + " beside a " + box + ' ' +
         extent_text(lo, hi);
}

void refuse_turned(const std::vector<EdgeUse>& edges, const std::string& where,
                   const std::string& solid) {
  refuse_edges(
      edges,
      [](const EdgeUse& e) { return e.forward + e.backward == 2 && e.forward != e.backward; },
      where, "has triangles that are turned against each other",
      "turn them so that all normals look out of the " + solid +
          ", or take out one of them where they lie on each other");
}

constexpr int kColumns = 40;  // to each side, to look at a surface

/// Middles of columns over a box in plan.
template <class Visit>
void for_columns(const Vec3& lo, const Vec3& hi, const Visit& visit) {
  for (int k = 0; k < kColumns * kColumns; ++k) {
    const double u = (k % kColumns + 0.5) / kColumns, v = (k / kColumns + 0.5) / kColumns;
    visit(lo.x() + u * (hi.x() - lo.x()), lo.y() + v * (hi.y() - lo.y()));
  }
}

/// The unit that makes the surface as large as the box, if it is clearly another than the metre.
std::optional<std::pair<std::string, double>> other_unit(const Vec3& extent, const Vec3& box,
                                                         bool as_large) {
  constexpr double kFeet = 1.0 / 0.3048, kSame = 0.12;
  constexpr double kWidest = 5.0;  // [km] of what is surveyed; what is wider is in metres
  Eigen::Vector2d plan = (extent.array() / box.array()).head<2>();
  const double width = extent.head<2>().maxCoeff();
  if (plan.maxCoeff() < 0.02 && width < kWidest) return std::pair("kilometres", 1000.0);
  if (plan.minCoeff() > 200.0) return std::pair("millimetres", 0.001);
  const Vec3 ratio = extent.cwiseQuotient(box);
  if (as_large && ((ratio / kFeet).array() - 1.0).abs().maxCoeff() < kSame)
    return std::pair("feet", 0.3048);
  return std::nullopt;
}

}  // namespace

std::string extent_text(const Vec3& lo, const Vec3& hi) {
  return "from " + place_text(lo) + " to " + place_text(hi) + " m";
}

void require_closed(const std::vector<StlTriangle>& triangles, const std::string& where) {
  const std::vector<EdgeUse> edges = edges_of(triangles);
  refuse_edges(
      edges, [](const EdgeUse& e) { return e.forward + e.backward == 1; }, where,
      "must be a closed surface, has a triangle on one side only",
      "close it in the program that made it, or give an open ground surface as terrain");
  refuse_edges(
      edges, [](const EdgeUse& e) { return e.forward + e.backward > 2; }, where,
      "has more than two triangles", "take out those inside of the body, or what is there twice");
  refuse_turned(edges, where, "rock");
}

void require_turned_alike(const std::vector<StlTriangle>& triangles, const std::string& where,
                          const std::string& solid) {
  refuse_turned(edges_of(triangles), where, solid);
}

std::size_t leave_out_doubled(std::vector<StlTriangle>& triangles, const std::string& where) {
  Corners corners = corners_of(triangles);
  std::set<std::array<int, 3>> known;
  const std::size_t before = triangles.size();
  std::erase_if(triangles, [&](const StlTriangle& t) {
    std::array<int, 3> c = corners.numbers(t);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) return false;  // a sliver
    std::ranges::rotate(c, std::ranges::min_element(c));
    if (known.contains({c[0], c[2], c[1]}))
      refuse(where,
             "has two triangles on each other that look to opposite sides, with a corner at " +
                 place_text(t[0]) +
                 " m; a wall has ground behind it: take out that which looks into it");
    return !known.insert(c).second;
  });
  return before - triangles.size();
}

double enclosed_volume(const std::vector<StlTriangle>& triangles) {
  const Vec3 from = triangles.front()[0];
  double volume = 0.0;
  for (const StlTriangle& t : triangles)
    volume += (t[0] - from).dot((t[1] - from).cross(t[2] - from)) / 6.0;
  return volume;
}

void require_outward(const SurfaceIndex& surface, const std::string& where) {
  const double volume = enclosed_volume(surface.triangles());
  if (volume < 0.0)
    refuse(where,
           "must have triangles that look out of the rock, got all of them turned inward "
           "(volume " +
               rounded_text(volume) + " m3); turn its normals");
  std::vector<SurfaceIndex::Crossing> met;
  for_columns(surface.lo(), surface.hi(), [&](double x, double y) {
    surface.crossings_at(x, y, met);
    for (std::size_t k = 0; k < met.size(); ++k) {
      if (met[k].up == (k % 2 == 1)) continue;
      refuse(where, "must not overlap itself, got two bodies in one another at " +
                        place_text({x, y, met[k].height}) +
                        " m; join them in the program that made them");
    }
  });
}

void require_one_height(const SurfaceIndex& ground, const Vec3& lo, const Vec3& hi, double apart,
                        double share, const std::string& where, const std::string& so) {
  std::vector<SurfaceIndex::Crossing> met;
  int covered = 0, twice = 0;
  std::string first;
  for_columns(lo, hi, [&](double x, double y) {
    ground.crossings_at(x, y, met);
    covered += met.empty() ? 0 : 1;
    if (met.size() < 2 || !(met.back().height - met.front().height > apart)) return;
    if (twice++ == 0)
      first = rounded_text(met.front().height) + " and " + rounded_text(met.back().height) +
              " m at x y " + rounded_text(x) + ' ' + rounded_text(y) + " m";
  });
  if (twice > share * covered)
    refuse(where, "must have one height everywhere, got heights of " + first + "; " + so);
}

void require_height_field(const SurfaceIndex& surface, const Vec3& lo, const Vec3& hi,
                          const std::string& where) {
  constexpr double kAny = -1.0;  // heights may even be the same
  require_one_height(surface, lo, hi, kAny, 0.0, where,
                     "give overhanging rock as a closed surface with the keyword surface");
  std::vector<SurfaceIndex::Crossing> met;
  int bare = 0;
  Vec3 first_bare = Vec3::Zero();
  for_columns(lo, hi, [&](double x, double y) {
    surface.crossings_at(x, y, met);
    if (met.empty() && bare++ == 0) first_bare = {x, y, 0.0};
  });
  if (bare == 0) return;
  refuse(where, "must cover the region's box in plan, leaves " +
                    rounded_text(100.0 * bare / (kColumns * kColumns), 3) +
                    " % of it bare, as at x y " + rounded_text(first_bare.x()) + ' ' +
                    rounded_text(first_bare.y()) + " m; it reaches from " +
                    rounded_text(surface.lo().x()) + ' ' + rounded_text(surface.lo().y()) + " to " +
                    rounded_text(surface.hi().x()) + ' ' + rounded_text(surface.hi().y()) +
                    " m; shrink the region or survey more");
}

void require_likely_unit(const Vec3& surface_lo, const Vec3& surface_hi, bool as_large,
                         const Vec3& lo, const Vec3& hi, const std::string& where,
                         const std::string& box, const std::string& knob) {
  const auto unit = other_unit(surface_hi - surface_lo, hi - lo, as_large);
  if (!unit) return;
  refuse(where, "must be in metres, " + both_text(surface_lo, surface_hi, lo, hi, box) +
                    "; it looks like " + unit->first + ": give unit " + rounded_text(unit->second) +
                    ", or unit 1 if it is in metres" +
                    (knob.empty() ? "" : " (inputs/quarry: -var " + knob + ")"));
}

void require_at_box(const Vec3& surface_lo, const Vec3& surface_hi, const Vec3& lo, const Vec3& hi,
                    const std::string& where, const std::string& so, const std::string& box) {
  constexpr double kFar = 3.0;  // diagonals of the box
  const Vec3 gap = (surface_lo - hi).cwiseMax(lo - surface_hi).cwiseMax(0.0);
  if (gap.norm() == 0.0) return;
  const std::string got =
      "must be where the " + box + " is, " + both_text(surface_lo, surface_hi, lo, hi, box);
  if (gap.norm() > kFar * (hi - lo).norm()) {
    const Vec3 middle = 0.5 * (surface_lo + surface_hi);
    refuse(where, got +
                      "; these look like mine coordinates: give origin E N Z, the place of the "
                      "mine that is 0 0 0 of the run, such as origin " +
                      place_text(Vec3(std::round(middle.x()), std::round(middle.y()),
                                      std::round(surface_lo.z()))));
  }
  refuse(where, got + "; " + so);
}

}  // namespace muckpile
