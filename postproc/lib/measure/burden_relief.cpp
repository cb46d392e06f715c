// SPDX-License-Identifier: GPL-2.0-or-later
// Burden relief of a plan.
// Scope: see the header.
#include "measure/burden_relief.h"

#include <algorithm>
#include <limits>

namespace muckpile {
namespace {

constexpr double kSameTime = 1e-7;  // delays that differ by less are equal [s]
constexpr double kCosine = 0.5;     // of 60 degrees
constexpr double kReach = 2.0;      // ways to the nearest neighbour

double to_nearest(const std::vector<ReliefHole>& holes, std::size_t hole) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < holes.size(); ++k) {
    if (k != hole) nearest = std::min(nearest, (holes[k].place - holes[hole].place).norm());
  }
  return nearest;
}

Relief towards(const std::vector<ReliefHole>& holes, std::size_t hole) {
  const ReliefHole& own = holes[hole];
  const double face = own.face.value_or(std::numeric_limits<double>::infinity());
  const double reach = std::min(kReach * to_nearest(holes, hole), face);
  struct Candidate {
    bool late;  // it has not fired before
    double way;
    std::size_t hole;
    bool operator<(const Candidate& other) const {
      return late != other.late ? !late : way < other.way;
    }
  };
  std::optional<Candidate> best;
  for (std::size_t k = 0; k < holes.size(); ++k) {
    const Vec2 there = holes[k].place - own.place;
    const double way = there.norm();
    if (k == hole || !(there.x() > kCosine * way) || way >= reach) continue;
    const Candidate candidate{holes[k].time > own.time - kSameTime, way, k};
    if (!best || candidate < *best) best = candidate;
  }
  if (!best) return {std::nullopt, own.face, std::nullopt};
  return {best->hole, best->way, (own.time - holes[best->hole].time) / best->way};
}

}  // namespace

std::vector<Relief> burden_relief(const std::vector<ReliefHole>& holes) {
  std::vector<Relief> reliefs;
  for (std::size_t k = 0; k < holes.size(); ++k) reliefs.push_back(towards(holes, k));
  return reliefs;
}

}  // namespace muckpile
