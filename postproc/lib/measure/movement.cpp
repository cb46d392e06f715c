// SPDX-License-Identifier: GPL-2.0-or-later
// Where the parts of a bench went.
// Scope: see the header.
#include "measure/movement.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace muckpile {
namespace {

// Number of the part of a block, levels outside; -1 outside of all.
int part_of(const StartBlock& block, const BenchParts& parts) {
  const Vec3& c = block.centroid;
  const double behind = parts.planes.behind_face(c);
  // Behind a face that bulges out, rock in front of the holes lies farther back than they stand.
  const bool within =
      behind < parts.depth || parts.planes.face != nullptr || parts.planes.frames != nullptr;
  if (!(c.z() < parts.height && within && parts.planes.in_front_of(parts.depth, c))) return -1;
  const int level = static_cast<int>(c.z() / parts.height * parts.levels);
  const int distance =
      std::clamp(static_cast<int>(behind / parts.depth * parts.distances), 0, parts.distances - 1);
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

RockMovement movement_of(const std::vector<size_t>& chosen, const std::vector<StartBlock>& blocks,
                         const Snapshot& last, const std::vector<char>& moved) {
  RockMovement rock;
  for (const size_t b : chosen) {
    const double mass = blocks[b].mass;
    ++rock.blocks;
    rock.mass += mass;
    rock.moved += moved[b] != 0 ? mass : 0.0;
    rock.start += mass * blocks[b].centroid;
    rock.end += mass * last.states[b].centre;
  }
  rock.moved /= rock.mass;
  rock.start /= rock.mass;
  rock.end /= rock.mass;
  for (const size_t b : chosen) {
    const Vec3 own = last.states[b].centre - blocks[b].centroid;
    rock.spread += blocks[b].mass / rock.mass * (own - rock.displacement()).squaredNorm();
  }
  rock.spread = std::sqrt(rock.spread);
  return rock;
}

std::vector<PartMovement> movement_of_parts(const std::vector<StartBlock>& blocks,
                                            const Snapshot& last, const std::vector<char>& moved,
                                            const BenchParts& parts) {
  std::map<int, std::vector<size_t>> members;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (const int number = part_of(blocks[b], parts); number >= 0) members[number].push_back(b);
  }
  std::vector<PartMovement> all;
  for (const auto& [number, chosen] : members) {
    all.push_back(empty_part(number, parts));
    all.back().rock = movement_of(chosen, blocks, last, moved);
  }
  return all;
}

}  // namespace muckpile
