// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks that hang together with a hole.
// Scope: see the header.
#include "measure/cracks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "geometry/index/axis_index.h"
#include "geometry/index/box_tree.h"
#include "geometry/shape/shared_edge.h"
#include "math/union_find.h"

namespace muckpile {
namespace {

Axis axis_of(const Charge& charge) { return {charge.toe, charge.collar}; }

Vec3 nearest_on_axis(const Charge& charge, const Vec3& point) {
  const Vec3 along = charge.collar - charge.toe;
  const double share = along.dot(point - charge.toe) / along.squaredNorm();
  return charge.toe + std::clamp(share, 0.0, 1.0) * along;
}

std::optional<size_t> nearest_hole(const Vec3& point, const std::vector<Charge>& charges) {
  std::optional<size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (size_t h = 0; h < charges.size(); ++h) {
    const double away = axis_of(charges[h]).distance(point);
    if (away < least) nearest = h;
    least = std::min(least, away);
  }
  return nearest;
}

// The hole on whose crushed zone a bare face lies: it looks at the axis from within four radii, as
// faces of a void of blocks do, the coarsest, too.
std::optional<size_t> hole_at_wall(const RockFace& face, const std::vector<Charge>& charges) {
  constexpr double kFar = 4.0;   // [radii]
  constexpr double kLook = 0.5;  // cosine
  if (face.other) return std::nullopt;
  const std::optional<size_t> hole = nearest_hole(face.centroid, charges);
  if (!hole) return std::nullopt;
  const Vec3 inward = nearest_on_axis(charges[*hole], face.centroid) - face.centroid;
  const bool near = inward.norm() < kFar * charges[*hole].radius;
  return near && face.normal.dot(inward) > kLook * inward.norm() ? hole : std::nullopt;
}

struct Box {
  Vec3 lo, hi;  // [m]
  [[nodiscard]] bool touches(const Vec3& low, const Vec3& high) const {
    return (lo.array() <= high.array()).all() && (low.array() <= hi.array()).all();
  }
};

Box box_of(const RockFace& face) {
  constexpr double kAround = 1e-3;  // of the face's size
  Box box{face.corners.front(), face.corners.front()};
  for (const Vec3& corner : face.corners) {
    box.lo = box.lo.cwiseMin(corner);
    box.hi = box.hi.cwiseMax(corner);
  }
  const Vec3 around = Vec3::Constant(kAround * std::sqrt(face.area));
  return {box.lo - around, box.hi + around};
}

// Calls meet(a, b) for each two of the chosen faces that meet along an edge, a < b.
template <class Meet>
void each_meeting(const std::vector<RockFace>& faces, const std::vector<size_t>& chosen,
                  const Meet& meet) {
  constexpr int kInALeaf = 8;
  std::vector<BoxTree::Item> items;
  for (const size_t f : chosen) {
    const Box box = box_of(faces[f]);
    items.push_back({box.lo, box.hi, faces[f].centroid});
  }
  const BoxTree tree(items, kInALeaf);
  for (size_t k = 0; k < chosen.size(); ++k) {
    const Box mine{items[k].lo, items[k].hi};
    const RockFace& face = faces[chosen[k]];
    tree.any([&](const BoxTree::Node& node) { return mine.touches(node.lo, node.hi); },
             [&](size_t m) {
               const RockFace& other = faces[chosen[m]];
               if (m > k && mine.touches(items[m].lo, items[m].hi) &&
                   share_an_edge(face.corners, other.corners,
                                 std::sqrt(std::min(face.area, other.area))))
                 meet(chosen[k], chosen[m]);
               return false;
             });
  }
}

// Of the chosen holes.
std::optional<size_t> nearest_of(const std::set<size_t>& holes, const Vec3& point,
                                 const std::vector<Charge>& charges) {
  const auto nearest = std::ranges::min_element(
      holes, {}, [&](size_t h) { return axis_of(charges[h]).distance(point); });
  return nearest == holes.end() ? std::nullopt : std::optional(*nearest);
}

// A charge's axis with the two directions across it from which angles count.
struct AxisFrame {
  explicit AxisFrame(const Charge& charge)
      : toe(charge.toe),
        along((charge.collar - charge.toe).normalized()),
        length((charge.collar - charge.toe).norm()) {
    constexpr double kAlongX = 0.99;
    const Vec3 start = std::abs(along.x()) < kAlongX ? Vec3::UnitX() : Vec3::UnitY();
    first = (start - start.dot(along) * along).normalized();
    second = (along.z() < 0.0 ? -along : along).cross(first);
  }
  [[nodiscard]] size_t direction_of(const Vec3& point) const {
    const Vec3 out = point - toe;
    const double turn = std::atan2(second.dot(out), first.dot(out)) / (2.0 * std::numbers::pi);
    const double place = (turn - std::floor(turn)) * kDirections;
    return static_cast<size_t>(place) % kDirections;
  }
  [[nodiscard]] double from_axis(const Vec3& point) const {
    return along.cross(point - toe).norm();
  }
  Vec3 toe, along, first = Vec3::Zero(), second = Vec3::Zero();
  double length;
};

// Points along a line, close enough not to miss a direction at its end.
template <class Visit>
void each_point(const std::pair<Vec3, Vec3>& line, const Visit& visit) {
  constexpr int kParts = 8;
  for (int part = 0; part <= kParts; ++part)
    visit(line.first + part * (line.second - line.first) / kParts);
}

// Calls visit(section, line) for the sections that cut a face.
template <class Visit>
void each_section(const AxisFrame& axis, const RockFace& face, const Visit& visit) {
  const auto up = [&](const Vec3& p) { return axis.along.dot(p - axis.toe); };
  const auto [low, high] = std::ranges::minmax(face.corners, {}, up);
  for (size_t section = 0; section < kSections; ++section) {
    const double at = (static_cast<double>(section) + 0.5) / kSections * axis.length;
    if (at < up(low) || at > up(high)) continue;
    if (const auto line = cut_of(face, axis.along, axis.along.dot(axis.toe) + at))
      visit(section, *line);
  }
}

std::vector<double> in_order(const std::vector<Reaches>& holes) {
  std::vector<double> all;
  for (const Reaches& reaches : holes)
    std::ranges::copy_if(reaches, std::back_inserter(all), [](double r) { return !std::isnan(r); });
  std::ranges::sort(all);
  return all;
}

}  // namespace

std::vector<std::optional<size_t>> crack_holes(const std::vector<RockFace>& faces,
                                               const std::vector<char>& broken,
                                               const std::vector<Charge>& charges) {
  std::vector<std::optional<size_t>> walls(faces.size());
  std::vector<size_t> chosen;  // walls and broken joints
  for (size_t f = 0; f < faces.size(); ++f) {
    walls[f] = hole_at_wall(faces[f], charges);
    if (walls[f] || (faces[f].other && broken[f] != 0)) chosen.push_back(f);
  }
  UnionFind cracks(faces.size());
  std::vector<std::pair<size_t, size_t>> begins;  // joint, hole
  each_meeting(faces, chosen, [&](size_t a, size_t b) {
    if (!walls[a] && !walls[b]) cracks.join(a, b);
    if (walls[a] && !walls[b]) begins.emplace_back(b, *walls[a]);
    if (walls[b] && !walls[a]) begins.emplace_back(a, *walls[b]);
  });
  std::map<size_t, std::set<size_t>> holes_of;  // by the root of the crack
  for (const auto& [face, hole] : begins) holes_of[cracks.root(face)].insert(hole);
  std::vector<std::optional<size_t>> result(faces.size());
  for (const size_t f : chosen) {
    const auto found = walls[f] ? holes_of.end() : holes_of.find(cracks.root(f));
    if (found != holes_of.end()) result[f] = nearest_of(found->second, faces[f].centroid, charges);
  }
  return result;
}

Reaches crack_reaches(const std::vector<RockFace>& faces,
                      const std::vector<std::optional<size_t>>& crack_holes, const Charge& charge,
                      size_t hole) {
  const AxisFrame axis(charge);
  Reaches reaches;
  reaches.fill(std::numeric_limits<double>::quiet_NaN());
  for (size_t f = 0; f < faces.size(); ++f) {
    if (!faces[f].other) continue;
    each_section(axis, faces[f], [&](size_t section, const std::pair<Vec3, Vec3>& line) {
      each_point(line, [&](const Vec3& point) {
        double& reach = reaches[section * kDirections + axis.direction_of(point)];
        if (std::isnan(reach)) reach = charge.radius;
        if (crack_holes[f] == hole) reach = std::max(reach, axis.from_axis(point));
      });
    });
  }
  return reaches;
}

double reach_exceeded(const std::vector<Reaches>& holes, double share) {
  const std::vector<double> all = in_order(holes);
  if (all.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = (1.0 - share) * static_cast<double>(all.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, all.size() - 1);
  return std::lerp(all[below], all[above], place - static_cast<double>(below));
}

double directions_beyond(const std::vector<Reaches>& holes, double distance) {
  const std::vector<double> all = in_order(holes);
  if (all.empty() || std::isnan(distance)) return std::numeric_limits<double>::quiet_NaN();
  const auto beyond = std::ranges::count_if(all, [&](double r) { return r > distance; });
  return static_cast<double>(beyond) / static_cast<double>(all.size());
}

}  // namespace muckpile
