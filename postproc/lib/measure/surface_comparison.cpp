// SPDX-License-Identifier: GPL-2.0-or-later
// Two surfaces over one grid of columns: volumes between them, vertical differences, mean profiles.
// Scope: see the header.
#include "measure/surface_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

std::vector<double> differences(const SurfacePair& pair) {
  std::vector<double> all;
  for (size_t k = 0; k < pair.grid.cells(); ++k)
    if (pair.compared[k] != 0) all.push_back(pair.run[k] - pair.survey[k]);
  return all;
}

// Means of both over the rows abreast, where half of these are known; false where fewer are.
bool means_at(const SurfacePair& pair, int i, const BenchPlanes& planes, Vec2& means) {
  int known = 0, rows = 0;
  means = Vec2::Zero();
  for (int j = 0; j < pair.grid.ny; ++j) {
    if (!planes.abreast({pair.grid.x(i), pair.grid.y(j), 0.0})) continue;
    ++rows;
    const Vec2 heights(pair.run[pair.grid.at(i, j)], pair.survey[pair.grid.at(i, j)]);
    if (heights.hasNaN()) continue;
    ++known;
    means += heights;
  }
  means /= std::max(known, 1);
  return rows > 0 && 2 * known >= rows;
}

}  // namespace

double difference_at_share(const SurfacePair& pair, double share) {
  std::vector<double> sizes = differences(pair);
  for (double& each : sizes) each = std::abs(each);
  const auto place = sizes.begin() + std::lround(share * static_cast<double>(sizes.size() - 1));
  std::ranges::nth_element(sizes, place);
  return *place;
}

SurfaceDifference difference_of(const SurfacePair& pair) {
  const double cell = pair.grid.dx * pair.grid.dy;
  const std::vector<double> all = differences(pair);
  const auto count = static_cast<double>(all.size());
  SurfaceDifference result;
  for (const double each : all) {
    (each > 0.0 ? result.above : result.below) += std::abs(each) * cell;
    result.mean += each / count;
    result.rms += each * each / count;
  }
  result.area = count * cell;
  result.rms = std::sqrt(result.rms);
  result.p90 = difference_at_share(pair, 0.9);
  return result;
}

ProfilePair profiles_of(const SurfacePair& pair, const BenchPlanes& planes) {
  ProfilePair profiles;
  profiles.dx = pair.grid.dx;
  size_t known = 0;  // up to the last x that is
  for (int i = 0; i < pair.grid.nx; ++i) {
    Vec2 means;
    const bool enough = means_at(pair, i, planes, means);
    if (!enough && known == 0) continue;
    if (!enough) means = {profiles.run[known - 1], profiles.survey[known - 1]};
    profiles.x.push_back(pair.grid.x(i));
    profiles.run.push_back(means.x());
    profiles.survey.push_back(means.y());
    if (enough) known = profiles.x.size();
  }
  for (std::vector<double>* each : {&profiles.x, &profiles.run, &profiles.survey})
    each->resize(known);
  return profiles;
}

PileShape shape_of_profile(const std::vector<double>& x, const std::vector<double>& heights,
                           double dx, double depth, double block_size) {
  if (x.empty()) return PileShape::none();
  PileProfile profile{};
  profile.x = x;
  profile.pile = heights;
  profile.pile_length.assign(x.size(), 0.0);
  profile.dx = dx;
  PileShape shape = pile_shape(profile, depth, block_size);
  if (heights.back() >= block_size) shape.toe = std::numeric_limits<double>::quiet_NaN();
  return shape;
}

}  // namespace muckpile
