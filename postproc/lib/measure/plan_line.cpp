// SPDX-License-Identifier: GPL-2.0-or-later
// A straight line drawn in plan.
// Scope: see the header.
#include "measure/plan_line.h"

#include <algorithm>

namespace muckpile {

std::vector<BlockState> seen_along(const PlanLine& line, const std::vector<BlockState>& states) {
  const Vec2 way = line.to - line.from;
  const Quat turn(Eigen::AngleAxisd(-std::atan2(way.y(), way.x()), Vec3::UnitZ()));
  const Vec3 origin(line.from.x(), line.from.y(), 0.0);
  std::vector<BlockState> seen(states);
  for (BlockState& state : seen) {
    state.centre = turn * (state.centre - origin);
    state.rotation = turn * state.rotation;
    state.velocity = turn * state.velocity;
    state.spin = turn * state.spin;
  }
  return seen;
}

OverLine over_line(const PlanLine& line, const std::vector<StartBlock>& blocks,
                   const Snapshot& last, const std::vector<char>& lies) {
  const auto left_of = [&](const Vec3& p) { return line.along_and_left(p.head<2>()).y(); };
  double balance = 0.0;  // mass to the left less mass to the right
  for (const StartBlock& block : blocks)
    balance += left_of(block.centroid) > 0.0 ? block.mass : -block.mass;
  OverLine over;
  over.sign = balance > 0.0 ? -1.0 : 1.0;
  for (size_t b = 0; b < blocks.size(); ++b) {
    const double before = over.sign * left_of(blocks[b].centroid),
                 after = over.sign * left_of(last.states[b].centre);
    if (lies[b] == 0 || !(before <= 0.0 && after > 0.0)) continue;
    over.pieces.push_back({after, blocks[b].volume, blocks[b].mass, last.states[b].centre});
    over.volume += blocks[b].volume;
    over.mass += blocks[b].mass;
  }
  std::ranges::sort(over.pieces, std::ranges::greater{}, &OverLine::Piece::distance);
  return over;
}

}  // namespace muckpile
