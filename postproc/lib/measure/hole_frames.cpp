// SPDX-License-Identifier: GPL-2.0-or-later
// Directions of holes, and what they make of places.
// Scope: see the header.
#include "measure/hole_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "args/input_error.h"

namespace muckpile {
namespace {

// (along the direction, to its left).
Vec2 turned(const Vec2& way, const Vec2& direction) {
  return {direction.dot(way), direction.x() * way.y() - direction.y() * way.x()};
}

bool within(const ThreeSides& sides, const Vec2& p) {
  return std::ranges::all_of(sides, [&p](const HalfPlane& side) { return side.beyond(p) <= 0.0; });
}

Vec2 left_of(const Vec2& way) { return {-way.y(), way.x()}; }

HalfPlane side_through(const Vec2& normal, const Vec2& point) {
  return {normal, normal.dot(point)};
}

// Least squares of the face's places over height; 0 for a single one.
double rise_of(const std::vector<Vec2>& face) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : face) mean += p / static_cast<double>(face.size());
  double zz = 0.0, zs = 0.0;
  for (const Vec2& p : face) {
    zz += (p.x() - mean.x()) * (p.x() - mean.x());
    zs += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  return zz > 0.0 ? zs / zz : 0.0;
}

}  // namespace

HoleFrames::HoleFrames(std::vector<HoleFrame> holes, HolePlan plan)
    : holes_(std::move(holes)), plan_(plan) {
  for (const HoleFrame& hole : holes_) {
    if (hole.face.empty()) throw InputError("hole " + hole.name + " has no free face beside it");
    rise_.push_back(rise_of(hole.face));
    rows_ = std::max(rows_, hole.row + 1);
  }
  depth_ = rows_ * plan_.burden;
  for (size_t h = 0; h < holes_.size(); ++h) {
    bool last = true;
    for (size_t g = 0; g < holes_.size(); ++g) last = last && (g == h || !stands_behind(g, h));
    last_.push_back(last ? 1 : 0);
  }
  find_pairs();
}

// No other hole stands between them, in the circle that has them at its ends; a little wider, so
// that the two holes next to one at a right corner are none.
bool HoleFrames::are_neighbours(size_t one, size_t other) const {
  constexpr double kWider = 1.05;
  const Vec2 half = 0.5 * (holes_[other].foot - holes_[one].foot);
  const Vec2 middle = holes_[one].foot + half;
  if (2.0 * half.norm() > kNeighbours * plan_.spacing) return false;
  for (size_t h = 0; h < holes_.size(); ++h) {
    const double away = (holes_[h].foot - middle).norm();
    if (h != one && h != other && away <= kWider * half.norm()) return false;
  }
  return true;
}

// Holes behind one another that throw the same way have nothing between them. At a corner one hole
// throws along the line between both.
void HoleFrames::find_pairs() {
  constexpr double kAcross = 0.1, kBack = -0.5;  // cosines, against the normal of the line
  for (size_t left = 0; left < holes_.size(); ++left) {
    for (size_t right = 0; right < holes_.size(); ++right) {
      const Vec2 way = holes_[right].foot - holes_[left].foot;
      if (left == right || !are_neighbours(left, right)) continue;
      const Vec2 normal = left_of(way.normalized());
      const double one = normal.dot(holes_[left].direction),
                   other = normal.dot(holes_[right].direction);
      if (std::min(one, other) > kBack && one + other > kAcross) pairs_.push_back({left, right});
    }
  }
}

Vec2 HoleFrames::axis_at(size_t hole, double height) const {
  return holes_[hole].foot + height * holes_[hole].lean;
}

ThreeSides HoleFrames::strip(size_t hole, double height) const {
  const Vec2 axis = axis_at(hole, height), along = holes_[hole].direction, left = left_of(along);
  ThreeSides sides{side_through(-along, axis), side_through(left, axis), side_through(-left, axis)};
  sides[1].bound += 0.5 * plan_.spacing;
  sides[2].bound += 0.5 * plan_.spacing;
  return sides;
}

ThreeSides HoleFrames::between(const HolePair& pair, double height) const {
  const Vec2 from = axis_at(pair.left, height), to = axis_at(pair.right, height);
  return {side_through(-left_of(to - from), from),
          side_through(left_of(holes_[pair.left].direction), from),
          side_through(-left_of(holes_[pair.right].direction), to)};
}

Vec2 HoleFrames::from_axis(const Vec3& p, size_t hole) const {
  return turned(p.head<2>() - axis_at(hole, p.z()), holes_[hole].direction);
}

bool HoleFrames::stands_behind(size_t other, size_t hole) const {
  const HoleFrame& h = holes_[hole];
  const Vec2 place = turned(holes_[other].foot - h.foot, h.direction);
  return place.x() < -0.25 * plan_.burden && place.x() > -1.75 * plan_.burden &&
         std::abs(place.y()) <= 0.75 * plan_.spacing;
}

size_t HoleFrames::hole_at(const Vec3& p) const {
  size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (size_t h = 0; h < holes_.size(); ++h) {
    const double distance = (p.head<2>() - axis_at(h, p.z())).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    nearest = h;
  }
  return nearest;
}

std::optional<size_t> HoleFrames::hole_of(const Vec3& p) const {
  std::optional<size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (size_t h = 0; h < holes_.size(); ++h) {
    const Vec2 place = from_axis(p, h);
    if (place.x() < 0.0 || std::abs(place.y()) > 0.5 * plan_.spacing) continue;
    if (place.squaredNorm() >= least) continue;
    least = place.squaredNorm();
    nearest = h;
  }
  return nearest ? nearest : hole_between(p);
}

std::optional<size_t> HoleFrames::hole_between(const Vec3& p) const {
  std::optional<size_t> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const HolePair& pair : pairs_) {
    if (!within(between(pair, p.z()), p.head<2>())) continue;
    for (const size_t h : {pair.left, pair.right}) {
      const double distance = (p.head<2>() - axis_at(h, p.z())).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = h;
    }
  }
  return nearest;
}

double HoleFrames::largest_turn() const {
  double turn = 0.0;
  for (const HoleFrame& hole : holes_)
    turn = std::max(turn, std::acos(std::clamp(hole.direction.x(), -1.0, 1.0)));
  return turn;
}

// Straight on above and below what is known.
double HoleFrames::face_at(size_t hole, double height) const {
  const std::vector<Vec2>& face = holes_[hole].face;
  const auto above = std::ranges::find_if(face, [&](const Vec2& p) { return p.x() >= height; });
  if (above == face.begin() || above == face.end()) {
    const Vec2& end = above == face.end() ? face.back() : face.front();
    return end.y() + rise_[hole] * (height - end.x());
  }
  const Vec2 &low = *(above - 1), &high = *above;
  const double way = high.x() - low.x();
  return way > 0.0 ? low.y() + (height - low.x()) / way * (high.y() - low.y()) : low.y();
}

double HoleFrames::burden_at_floor(size_t hole) const {
  return face_at(hole, 0.0) - holes_[hole].direction.dot(holes_[hole].foot);
}

double HoleFrames::behind_face(const Vec3& p) const {
  const size_t hole = hole_at(p);
  return face_at(hole, std::max(p.z(), 0.0)) - holes_[hole].direction.dot(p.head<2>());
}

double HoleFrames::depth_of_row(size_t hole) const {
  return last_[hole] != 0 ? depth_ : (holes_[hole].row + 1) * plan_.burden;
}

// Of rock of a hole. A hole alone, of the first row and of the last, has the planes of both at its
// axis. Between two holes rock may lie farther back than the one whose it is.
double HoleFrames::depth_in_front(size_t hole, double before) const {
  if (holes_[hole].row == 0) return plan_.burden - std::max(before, 1e-9 * plan_.burden);
  return std::max(depth_of_row(hole) - std::max(before, 1e-9 * plan_.burden),
                  std::nextafter(plan_.burden, depth_ + 1.0));
}

double HoleFrames::row_depth(const Vec3& p) const {
  if (const auto owner = hole_of(p)) return depth_in_front(*owner, from_axis(p, *owner).x());
  const size_t hole = hole_at(p);
  const double before = from_axis(p, hole).x();
  return before < 0.0 ? depth_of_row(hole) - before : depth_in_front(hole, before);
}

bool HoleFrames::abreast(const Vec3& p) const {
  constexpr double kFarBehind = 2.0;  // burdens: from there on other rock stands behind a hole
  for (size_t h = 0; h < holes_.size(); ++h) {
    const Vec2 place = from_axis(p, h);
    if (std::abs(place.y()) <= 0.5 * plan_.spacing && place.x() >= -kFarBehind * plan_.burden)
      return true;
  }
  return hole_between(p).has_value();
}

Vec3 HoleFrames::outward(const Vec3& start) const {
  const Vec2& direction = holes_[hole_of(start).value_or(hole_at(start))].direction;
  return {direction.x(), direction.y(), 0.0};
}

bool HoleFrames::beyond_toe(const Vec3& start, const Vec3& end) const {
  const size_t hole = hole_at(start);
  return holes_[hole].direction.dot(end.head<2>()) > face_at(hole, 0.0);
}

}  // namespace muckpile
