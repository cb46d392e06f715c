// SPDX-License-Identifier: GPL-2.0-or-later
// Which share of each block of a run is ore.
// Scope: see the header.
#include "measure/ore_shares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "measure/block_finder.h"

namespace muckpile {
namespace {

// The cell that a place lies in, for cells on a grid.
class CellGrid {
 public:
  explicit CellGrid(const std::vector<OreCell>& cells) : origin_(cells.front().middle) {
    for (int axis = 0; axis < 3; ++axis) step_[axis] = step_along(cells, axis);
    for (const OreCell& cell : cells) is_ore_[number(cell.middle)] = cell.is_ore;
  }
  [[nodiscard]] bool is_ore(const Vec3& place) const {
    const auto found = is_ore_.find(number(place));
    return found != is_ore_.end() && found->second;
  }

 private:
  using Number = std::array<long, 3>;

  // The smallest distance of two layers of cells; one layer alone reaches to all places [m].
  static double step_along(const std::vector<OreCell>& cells, int axis) {
    constexpr double kRounding = 1e-3;  // [m]
    std::vector<double> places;
    for (const OreCell& cell : cells) places.push_back(cell.middle[axis]);
    std::ranges::sort(places);
    double least = 1e12;
    for (size_t k = 1; k < places.size(); ++k)
      if (const double step = places[k] - places[k - 1]; step > kRounding)
        least = std::min(least, step);
    return least;
  }
  [[nodiscard]] Number number(const Vec3& place) const {
    Number all{};
    for (int axis = 0; axis < 3; ++axis)
      all[static_cast<size_t>(axis)] = std::lround((place[axis] - origin_[axis]) / step_[axis]);
    return all;
  }

  Vec3 origin_, step_ = Vec3::Zero();
  std::map<Number, bool> is_ore_;
};

}  // namespace

OrePolygon placed(OrePolygon polygon, const SurveyPose& pose) {
  for (Vec2& corner : polygon.corners) corner = pose.of({corner.x(), corner.y(), 0.0}).head<2>();
  polygon.low += pose.shift.z();
  polygon.high += pose.shift.z();
  return polygon;
}

std::vector<double> ore_in_polygons(const std::vector<OrePolygon>& polygons,
                                    const std::vector<StartBlock>& blocks) {
  std::vector<double> shares;
  for (const StartBlock& block : blocks) {
    const bool is_ore = std::ranges::any_of(
        polygons, [&](const OrePolygon& polygon) { return polygon.contains(block.centroid); });
    shares.push_back(is_ore ? 1.0 : 0.0);
  }
  return shares;
}

std::vector<double> ore_of_cells(const std::vector<OreCell>& cells, const SurveyPose& pose,
                                 const std::vector<StartBlock>& blocks) {
  std::vector<double> ore(blocks.size(), 0.0), all(blocks.size(), 0.0);
  const BlockFinder finder(blocks);
  for (const OreCell& cell : cells) {
    const auto block = finder.at(pose.of(cell.middle));
    if (!block) continue;
    all[*block] += 1.0;
    ore[*block] += cell.is_ore ? 1.0 : 0.0;
  }
  const CellGrid grid(cells);
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (all[b] > 0.0) {
      ore[b] /= all[b];
    } else if (grid.is_ore(pose.back(blocks[b].centroid))) {
      ore[b] = 1.0;
    }
  }
  return ore;
}

}  // namespace muckpile
