// SPDX-License-Identifier: GPL-2.0-or-later
// The muck pile of a bench blast: its profile, throw, swell and slope.
// Scope: works on column tops, as a survey of the pile would.
#include "measure/pile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "measure/broken_out.h"
#include "measure/slope.h"
#include "measure/start_extent.h"

namespace muckpile {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSectionBlocks = 2.0;  // width of a section over the mean block size

// Mean over the rows [begin, end) of the grid.
template <class Value>
std::vector<double> mean_over_rows(const ColumnGrid& grid, int begin, int end, Value&& value) {
  std::vector<double> mean(static_cast<size_t>(grid.nx), 0.0);
  for (int i = 0; i < grid.nx; ++i) {
    for (int j = begin; j < end; ++j)
      mean[static_cast<size_t>(i)] += value(grid.at(i, j)) / (end - begin);
  }
  return mean;
}

std::vector<double> mean_top(const Columns& columns, int begin, int end) {
  return mean_over_rows(columns.grid, begin, end, [&](size_t cell) { return columns.top[cell]; });
}

std::vector<double> mean_top(const Columns& columns) {
  return mean_top(columns, 0, columns.grid.ny);
}

std::vector<std::vector<double>> section_tops(const Columns& columns, double width) {
  const ColumnGrid& grid = columns.grid;
  const auto wanted = static_cast<int>(std::lround(grid.dy * grid.ny / width));
  const int count = std::clamp(wanted, 1, grid.ny);
  std::vector<std::vector<double>> sections;
  for (int k = 0; k < count; ++k)
    sections.push_back(mean_top(columns, k * grid.ny / count, (k + 1) * grid.ny / count));
  return sections;
}

std::vector<double> highest_top(const Columns& columns) {
  std::vector<double> highest(static_cast<size_t>(columns.grid.nx), kNoRock);
  for (int i = 0; i < columns.grid.nx; ++i) {
    double& out = highest[static_cast<size_t>(i)];
    for (int j = 0; j < columns.grid.ny; ++j)
      out = std::max(out, columns.top[columns.grid.at(i, j)]);
  }
  return highest;
}

// The middle row of columns, or the mean of the two middle ones.
std::vector<double> centre_top(const Columns& columns) {
  const ColumnGrid& grid = columns.grid;
  const int low = (grid.ny - 1) / 2, high = grid.ny / 2;
  std::vector<double> centre;
  for (int i = 0; i < grid.nx; ++i) {
    centre.push_back(0.5 * (columns.top[grid.at(i, low)] + columns.top[grid.at(i, high)]));
  }
  return centre;
}

// Tops of the blocks of both.
Columns over_both(Columns both, const Columns& other) {
  for (size_t k = 0; k < both.top.size(); ++k) both.top[k] = std::max(both.top[k], other.top[k]);
  return both;
}

// No lower than the floor.
Columns above(const std::vector<double>& floor, Columns columns) {
  for (size_t k = 0; k < floor.size(); ++k) columns.top[k] = std::max(columns.top[k], floor[k]);
  return columns;
}

std::vector<double> thickness(const std::vector<double>& top, const std::vector<double>& floor) {
  if (floor.empty()) return top;
  std::vector<double> thick;
  for (size_t i = 0; i < top.size(); ++i) thick.push_back(top[i] - floor[i]);
  return thick;
}

// Highest sample beyond the holes, x.size() where there is no pile.
size_t index_of_peak(const std::vector<double>& x, const std::vector<double>& top, double depth) {
  size_t peak = x.size();
  for (size_t i = 0; i < x.size(); ++i) {
    if (x[i] > -depth && top[i] > 0.0 && (peak == x.size() || top[i] > top[peak])) peak = i;
  }
  return peak;
}

// Last sample at or after the peak where the pile is at least one block thick.
size_t index_of_toe(const std::vector<double>& top, size_t peak, double block_size) {
  size_t toe = top.size() - 1;
  while (toe > peak && top[toe] < block_size) --toe;
  return toe;
}

// Between the last sample above `level` and the next, by a straight line.
double crossing_after(const PileProfile& p, const std::vector<double>& thick, size_t i,
                      double level) {
  if (i + 1 >= p.x.size() || thick[i] <= level) return p.x[i];
  return p.x[i] + (thick[i] - level) / (thick[i] - thick[i + 1]) * p.dx;
}

double place_of_share(const PileProfile& p, double share) {
  const auto beyond = static_cast<size_t>(std::ranges::upper_bound(p.x, 0.0) - p.x.begin());
  const double all =
      std::accumulate(p.pile_length.begin() + static_cast<long>(beyond), p.pile_length.end(), 0.0);
  double sum = 0.0;
  for (size_t i = beyond; i < p.x.size() && all > 0.0; ++i) {
    if (sum + p.pile_length[i] >= share * all) {
      return p.x[i] + ((share * all - sum) / p.pile_length[i] - 0.5) * p.dx;
    }
    sum += p.pile_length[i];
  }
  return kNan;
}

// Blocks in the shortest stretch that has an angle of repose: over fewer, single blocks decide.
constexpr double kRestStretchBlocks = 4.0;

// Sections, because a front that is not straight across the width has a flatter mean; a length as
// long as the pile is high, because a shorter one, or one found by its fall, follows single blocks.
double rest_slope(const PileProfile& p, double depth, double block_size, double stretch) {
  double sum = 0.0;
  int sections = 0;
  for (size_t k = 0; k < p.sections.size(); ++k) {
    const std::vector<double> thick =
        p.section_floors.empty() ? p.sections[k] : thickness(p.sections[k], p.section_floors[k]);
    const size_t peak = index_of_peak(p.x, thick, depth);
    if (peak == p.x.size()) continue;
    const double slope = steepest_slope(p.x, p.sections[k], peak,
                                        index_of_toe(thick, peak, block_size) + 1, stretch);
    if (std::isnan(slope)) continue;
    sum += slope;
    ++sections;
  }
  return sections > 0 ? sum / sections : kNan;
}

}  // namespace

PileProfile pile_profile(const std::vector<StartBlock>& blocks, const Snapshot& last,
                         const std::vector<char>& moved, double cell, const std::vector<char>& lies,
                         const BenchPlanes& planes, const PitFloor& pit_floor) {
  const Snapshot start = start_snapshot(blocks);
  const Extent before = extent_at_start(blocks), after = extent_of(blocks, last.states);
  const ColumnGrid grid = column_grid(
      std::min(before.low.x(), after.low.x()), std::max(after.high.x(), 0.0) + cell,
      std::max(before.low.y(), planes.y_low), std::min(before.high.y(), planes.y_high), cell);
  const std::vector<char> all(blocks.size(), 1);
  std::vector<char> stayed(moved), broken(moved);
  for (size_t b = 0; b < moved.size(); ++b) {
    stayed[b] = moved[b] == 0 && lies[b] != 0;
    broken[b] = moved[b] != 0 && lies[b] != 0;
  }
  const std::vector<double> floor = pit_floor.under(grid);
  const Columns pile = above(floor, columns_through(grid, blocks, last.states, broken));
  const Columns in_place = above(floor, tops_through(grid, blocks, last.states, stayed));
  const Columns rock = over_both(in_place, pile);
  PileProfile profile;
  for (int i = 0; i < grid.nx; ++i) profile.x.push_back(grid.x(i));
  profile.before = mean_top(above(floor, tops_through(grid, blocks, start.states, all)));
  profile.mean = mean_top(rock);
  profile.centre = centre_top(rock);
  profile.highest = highest_top(rock);
  profile.rock_in_place = mean_top(in_place);
  profile.pile = mean_top(pile);
  profile.pile_length =
      mean_over_rows(grid, 0, grid.ny, [&](size_t column) { return pile.length[column]; });
  const double section = kSectionBlocks * mean_block_size(blocks, all);
  const Columns bare{grid, floor, {}, {}};
  profile.sections = section_tops(pile, section);
  profile.section_floors = section_tops(bare, section);
  profile.floor = mean_top(bare);
  profile.dx = grid.dx;
  profile.width = grid.dy * grid.ny;
  return profile;
}

PileShape PileShape::none() { return {kNan, kNan, kNan, kNan, kNan, kNan, kNan, kNan, kNan}; }

PileShape pile_shape(const PileProfile& p, double depth, double block_size) {
  PileShape shape{kNan, kNan, kNan, place_of_share(p, 0.98), kNan, 0.0, 0.0, kNan, kNan};
  const std::vector<double> thick = thickness(p.pile, p.floor);
  const size_t peak = index_of_peak(p.x, thick, depth);
  if (peak == p.x.size()) return shape;
  const size_t toe = index_of_toe(thick, peak, block_size);
  shape.height = thick[peak];
  shape.height_x = p.x[peak];
  shape.toe = crossing_after(p, thick, toe, block_size);
  for (size_t i = 0; i <= toe; ++i) {
    if (p.x[i] < 0.0) continue;
    shape.bulk_volume += thick[i] * p.dx * p.width;
    shape.solid_volume += p.pile_length[i] * p.dx * p.width;
  }
  if (shape.solid_volume > 0.0) shape.swell = shape.bulk_volume / shape.solid_volume;
  const double low = 0.2 * shape.height, high = 0.8 * shape.height;
  shape.front_angle = std::atan(slope_between_heights(p.x, thick, peak, toe + 1, low, high));
  const double stretch = std::max(shape.height, kRestStretchBlocks * block_size);
  shape.rest_angle = std::atan(rest_slope(p, depth, block_size, stretch));
  return shape;
}

Throw throw_of(const std::vector<StartBlock>& blocks, const Snapshot& last, double burden,
               const BenchPlanes& planes) {
  Throw result{};
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& start = blocks[b].centroid;
    const double moved = planes.outward(start).dot(last.states[b].centre - start);
    result.largest = std::max(result.largest, moved);
    if (!planes.in_front_of(burden, start)) continue;
    result.prism_mass += blocks[b].mass;
    result.prism_volume += blocks[b].volume;
    result.centre_of_mass += blocks[b].mass * moved;
    if (planes.beyond_toe(start, last.states[b].centre)) result.beyond_toe += blocks[b].mass;
  }
  const double mass = result.prism_mass > 0.0 ? result.prism_mass : kNan;
  result.centre_of_mass /= mass;
  result.beyond_toe /= mass;
  return result;
}

}  // namespace muckpile
