// SPDX-License-Identifier: GPL-2.0-or-later
// What gave parts of the rock their speed.
// Scope: see the header.
#include "measure/momentum.h"

#include "io/images.h"
#include "measure/launch.h"

namespace muckpile {
namespace {

Vec3 away_from_axis(const Vec3& place) {
  const Vec3 level(place.x(), place.y(), 0.0);
  return level.norm() > 0.0 ? Vec3(level.normalized()) : Vec3(Vec3::Zero());
}

RockPart part_of(const std::string& name, const std::vector<StartBlock>& blocks,
                 std::vector<size_t> those) {
  RockPart part{name};
  for (const size_t b : those) {
    part.mass += blocks[b].mass;
    part.radius += blocks[b].mass * blocks[b].centroid.head<2>().norm();
    part.outward.push_back(away_from_axis(blocks[b].centroid));
  }
  part.radius /= part.mass;
  part.blocks = std::move(those);
  return part;
}

void add(Budget& budget, double share, const Vec3& direction, const StartBlock& block,
         const Vec3& velocity, const ByPart& impulse) {
  budget.speed += share * direction.dot(velocity);
  for (size_t k = 0; k < kImpulseParts; ++k)
    budget.by_cause[k] += share * direction.dot(impulse.parts[k]) / block.mass;
}

}  // namespace

std::vector<RockPart> crater_parts(const std::vector<StartBlock>& blocks, double depth,
                                   double width) {
  std::vector<size_t> cone;
  for (size_t b = 0; b < modelled(blocks); ++b) {
    const Vec3& start = blocks[b].centroid;
    if (start.head<2>().norm() < start.z() + depth) cone.push_back(b);
  }
  std::vector<RockPart> parts;
  if (!cone.empty()) parts.push_back(part_of("cone", blocks, std::move(cone)));
  for (const SurfaceRing& ring : surface_rings(blocks, width)) {
    std::vector<size_t> own;
    for (const size_t b : ring.blocks)
      if (b < modelled(blocks)) own.push_back(b);
    parts.push_back(part_of("surface", blocks, std::move(own)));
  }
  return parts;
}

double Budget::left() const {
  double left = speed;
  for (const double given : by_cause) left -= given;
  return left;
}

PartBudget budget_of(const RockPart& part, const std::vector<StartBlock>& blocks,
                     const Snapshot& snapshot, const std::vector<ByPart>& impulses) {
  PartBudget budget;
  for (size_t k = 0; k < part.blocks.size(); ++k) {
    const size_t b = part.blocks[k];
    const double share = blocks[b].mass / part.mass;
    const Vec3& velocity = snapshot.states[b].velocity;
    add(budget.outward, share, part.outward[k], blocks[b], velocity, impulses[b]);
    add(budget.upward, share, Vec3::UnitZ(), blocks[b], velocity, impulses[b]);
  }
  return budget;
}

}  // namespace muckpile
