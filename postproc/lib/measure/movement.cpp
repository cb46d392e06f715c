// SPDX-License-Identifier: GPL-2.0-or-later
// Where the parts of a bench went.
// Scope: see the header.
#include "measure/movement.h"

#include <cmath>

namespace muckpile {
namespace {

// Number of the part of a block, levels outside; -1 outside of all.
int part_of(const StartBlock& block, const BenchParts& parts) {
  const Vec3& c = block.centroid;
  if (!(c.z() > 0.0 && c.z() < parts.height && c.x() < 0.0 && c.x() > -parts.depth)) return -1;
  const int level = static_cast<int>(c.z() / parts.height * parts.levels);
  const int distance = static_cast<int>(-c.x() / parts.depth * parts.distances);
  return level * parts.distances + distance;
}

PartMovement empty_part(int number, const BenchParts& parts) {
  const double thick = parts.height / parts.levels, deep = parts.depth / parts.distances;
  PartMovement part{};
  part.level = number / parts.distances;
  part.distance = number % parts.distances;
  part.level_low = thick * part.level;
  part.level_high = thick * (part.level + 1);
  part.near = deep * part.distance;
  part.far = deep * (part.distance + 1);
  return part;
}

}  // namespace

std::vector<int> levels_of(const std::vector<StartBlock>& blocks, const BenchParts& parts) {
  std::vector<int> levels;
  for (const StartBlock& block : blocks) {
    const int part = part_of(block, parts);
    levels.push_back(part < 0 ? -1 : part / parts.distances);
  }
  return levels;
}

std::vector<PartMovement> movement_of(const std::vector<StartBlock>& blocks, const Snapshot& last,
                                      const std::vector<char>& moved, const BenchParts& parts) {
  std::vector<PartMovement> all;
  for (int k = 0; k < parts.levels * parts.distances; ++k) all.push_back(empty_part(k, parts));
  const auto each = [&](auto&& visit) {
    for (size_t b = 0; b < blocks.size(); ++b) {
      const int number = part_of(blocks[b], parts);
      if (number >= 0) visit(all[static_cast<size_t>(number)], b, blocks[b].mass);
    }
  };
  each([&](PartMovement& part, size_t b, double mass) {
    ++part.blocks;
    part.mass += mass;
    part.moved += moved[b] != 0 ? mass : 0.0;
    part.start += mass * blocks[b].centroid;
    part.end += mass * last.states[b].centre;
  });
  for (PartMovement& part : all) {
    part.moved /= part.mass;
    part.start /= part.mass;
    part.end /= part.mass;
  }
  each([&](PartMovement& part, size_t b, double mass) {
    const Vec3 own = last.states[b].centre - blocks[b].centroid;
    part.spread += mass / part.mass * (own - part.displacement()).squaredNorm();
  });
  for (PartMovement& part : all) part.spread = std::sqrt(part.spread);
  std::erase_if(all, [](const PartMovement& part) { return part.blocks == 0; });
  return all;
}

}  // namespace muckpile
