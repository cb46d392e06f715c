// SPDX-License-Identifier: GPL-2.0-or-later
// Outlines of pieces of a plan: sides that two pieces share, once in each direction, cancel; what
// is left is walked along.
// Scope: see the header.
#include "measure/outlines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace muckpile {
namespace {

constexpr double kSame = 1e-6;   // [m]
constexpr double kLeast = 1e-9;  // area of a piece that counts [m2]

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

class Corners {
 public:
  size_t number(const Vec2& p) {
    const auto same =
        std::ranges::find_if(places_, [&](const Vec2& q) { return (p - q).norm() < kSame; });
    if (same == places_.end()) {
      places_.push_back(p);
      return places_.size() - 1;
    }
    return static_cast<size_t>(same - places_.begin());
  }
  [[nodiscard]] const Vec2& place(size_t corner) const { return places_[corner]; }
  // From a to b by way of all corners between them.
  [[nodiscard]] std::vector<size_t> along(size_t a, size_t b) const {
    const Vec2 way = places_[b] - places_[a];
    std::vector<std::pair<double, size_t>> passed;
    for (size_t c = 0; c < places_.size(); ++c) {
      const Vec2 there = places_[c] - places_[a];
      const double share = there.dot(way) / way.squaredNorm();
      if (c != a && c != b && share > 0.0 && share < 1.0 && (there - share * way).norm() < kSame)
        passed.emplace_back(share, c);
    }
    std::ranges::sort(passed);
    std::vector<size_t> corners{a};
    for (const auto& [share, c] : passed) corners.push_back(c);
    corners.push_back(b);
    return corners;
  }

 private:
  std::vector<Vec2> places_;
};

// From each corner, where sides lead that one piece alone has.
using Sides = std::map<size_t, std::set<size_t>>;

void toggle(Sides& sides, size_t from, size_t to) {
  const auto back = sides.find(to);
  if (back == sides.end() || back->second.erase(from) == 0)
    sides[from].insert(to);
  else if (back->second.empty())
    sides.erase(back);
}

Sides sides_of(const std::vector<Polygon>& pieces, Corners& corners) {
  std::vector<std::vector<size_t>> rings;
  for (const Polygon& piece : pieces) {
    if (area_of(piece) < kLeast) continue;
    rings.emplace_back();
    for (const Vec2& p : piece) rings.back().push_back(corners.number(p));
  }
  Sides sides;
  for (const auto& ring : rings) {
    for (size_t k = 0; k < ring.size(); ++k) {
      const size_t from = ring[k], to = ring[(k + 1) % ring.size()];
      if (from == to) continue;
      const std::vector<size_t> steps = corners.along(from, to);
      for (size_t s = 0; s + 1 < steps.size(); ++s) toggle(sides, steps[s], steps[s + 1]);
    }
  }
  return sides;
}

// The way on that keeps to the same covered corner: farthest to the left.
size_t next_of(const std::set<size_t>& ways, const Corners& corners, size_t before, size_t here) {
  const Vec2 in = corners.place(here) - corners.place(before);
  const auto turn = [&](size_t next) {
    const Vec2 out = corners.place(next) - corners.place(here);
    return std::atan2(cross(in, out), in.dot(out));
  };
  return *std::ranges::max_element(ways, {}, turn);
}

// Takes its sides away.
std::vector<size_t> ring_from(size_t start, Sides& sides, const Corners& corners) {
  std::vector<size_t> ring{start};
  size_t before = start, here = start;
  do {
    const auto ways = sides.find(here);
    if (ways == sides.end()) return {};  // corners of rounding's size
    const size_t next =
        ring.size() == 1 ? *ways->second.begin() : next_of(ways->second, corners, before, here);
    ways->second.erase(next);
    if (ways->second.empty()) sides.erase(ways);
    before = here;
    here = next;
    ring.push_back(here);
  } while (here != start);
  ring.pop_back();
  return ring;
}

// Without corners on straight sides.
Polygon turns_of(const std::vector<size_t>& ring, const Corners& corners) {
  Polygon turns;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Vec2 &before = corners.place(ring[(k + ring.size() - 1) % ring.size()]),
               &here = corners.place(ring[k]), &after = corners.place(ring[(k + 1) % ring.size()]);
    const Vec2 way = after - before;
    if (std::abs(cross(way, here - before)) > kSame * way.norm()) turns.push_back(here);
  }
  return turns;
}

}  // namespace

std::vector<Polygon> outlines_of(const std::vector<Polygon>& pieces) {
  Corners corners;
  Sides sides = sides_of(pieces, corners);
  std::vector<Polygon> outlines;
  while (!sides.empty()) {
    Polygon ring = turns_of(ring_from(sides.begin()->first, sides, corners), corners);
    if (std::abs(area_of(ring)) >= kLeast) outlines.push_back(std::move(ring));
  }
  return outlines;
}

}  // namespace muckpile
