// SPDX-License-Identifier: GPL-2.0-or-later
// Heights over the plan, backbreak, toe left.
// Scope: see the header.
#include "measure/height_map.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

std::vector<double> above(const std::vector<double>& floor, std::vector<double> tops) {
  for (size_t k = 0; k < tops.size(); ++k) tops[k] = std::max(tops[k], floor[k]);
  return tops;
}

}  // namespace

ColumnGrid plan_grid(const std::vector<StartBlock>& blocks, const Snapshot& last,
                     const std::vector<char>& lies, double cell) {
  const std::vector<BlockState> start = start_snapshot(blocks).states;
  // Blocks that still fly are in none of the heights.
  std::vector<BlockState> resting = last.states;
  for (size_t b = 0; b < blocks.size(); ++b)
    if (lies[b] == 0) resting[b] = start[b];
  const Extent before = extent_of(blocks, start), after = extent_of(blocks, resting);
  return column_grid(
      std::min(before.low.x(), after.low.x()), std::max(before.high.x(), after.high.x()),
      std::min(before.low.y(), after.low.y()), std::max(before.high.y(), after.high.y()), cell);
}

HeightMap height_map(const std::vector<StartBlock>& blocks, const Snapshot& last,
                     const std::vector<char>& moved, const std::vector<char>& lies, double cell,
                     const PitFloor& floor) {
  const std::vector<BlockState> start = start_snapshot(blocks).states;
  HeightMap map;
  map.grid = plan_grid(blocks, last, lies, cell);
  map.floor = floor.under(map.grid);
  const std::vector<char> all(blocks.size(), 1);
  std::vector<char> stayed(moved);
  for (size_t b = 0; b < moved.size(); ++b) {
    stayed[b] = moved[b] == 0 && lies[b] != 0;
    const Vec3& end = last.states[b].centre;
    if (moved[b] != 0 && lies[b] != 0 && end.z() > floor.at(end.x(), end.y()))
      map.solid_volume += blocks[b].volume;
  }
  map.before = above(map.floor, tops_through(map.grid, blocks, start, all).top);
  map.after = above(map.floor, tops_through(map.grid, blocks, last.states, lies).top);
  map.in_place = above(map.floor, tops_through(map.grid, blocks, last.states, stayed).top);
  for (size_t k = 0; k < map.grid.cells(); ++k)
    map.pile_volume += (map.after[k] - map.in_place[k]) * map.grid.dx * map.grid.dy;
  return map;
}

Reach backbreak(const std::vector<StartBlock>& blocks, const std::vector<char>& chosen,
                const BenchPlanes& planes, double depth, double section) {
  const double width = planes.y_high - planes.y_low;
  const auto count = static_cast<size_t>(std::max(1.0, std::round(width / section)));
  std::vector<double> farthest(count, 0.0);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& start = blocks[b].centroid;
    if (chosen[b] == 0 || start.z() <= 0.0 || !planes.abreast(start)) continue;
    const auto k =
        static_cast<size_t>((start.y() - planes.y_low) / width * static_cast<double>(count));
    double& far = farthest[std::min(k, count - 1)];
    far = std::max(far, planes.row_depth(start) - depth);
  }
  Reach reach;
  for (const double far : farthest) {
    reach.largest = std::max(reach.largest, far);
    reach.mean += far / static_cast<double>(count);
  }
  return reach;
}

std::vector<char> shifted(const std::vector<StartBlock>& blocks, const Snapshot& last,
                          double least) {
  std::vector<char> chosen;
  for (size_t b = 0; b < blocks.size(); ++b)
    chosen.push_back((last.states[b].centre - blocks[b].centroid).norm() > least ? 1 : 0);
  return chosen;
}

std::vector<char> loosened(const Snapshot& last) {
  std::vector<char> chosen;
  for (const BlockState& state : last.states) chosen.push_back(state.broken_fraction > 0.5 ? 1 : 0);
  return chosen;
}

ToeLeft toe_left(const std::vector<StartBlock>& blocks, const Snapshot& last,
                 const std::vector<char>& moved, const BenchPlanes& planes, double depth) {
  ToeLeft toe;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (moved[b] != 0 || !planes.in_front_of(depth, blocks[b].centroid)) continue;
    toe.volume += blocks[b].volume;
    for (const Vec3& p : moved_vertices(blocks[b], last.states[b]))
      toe.height = std::max(toe.height, p.z());
  }
  return toe;
}

}  // namespace muckpile
