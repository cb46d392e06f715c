// SPDX-License-Identifier: GPL-2.0-or-later
// Fragments: sets of blocks that joints still hold together, and the size curve of the broken-out
// ones. Scope: the engine has found the connected sets; this adds them up.
#include "measure/fragments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace muckpile {

std::vector<Fragment> fragments_of(const std::vector<StartBlock>& blocks, const Snapshot& last,
                                   const std::vector<char>& moved) {
  std::map<int, Fragment> found;
  std::map<int, double> moved_mass;
  for (size_t b = 0; b < blocks.size(); ++b) {
    const int id = last.states[b].fragment;
    Fragment& f =
        found.try_emplace(id, Fragment{id, 0, 0.0, 0.0, 0.0, Vec3::Zero(), Vec3::Zero(), false})
            .first->second;
    const double mass = blocks[b].mass;
    ++f.blocks;
    f.volume += blocks[b].volume;
    f.mass += mass;
    f.start += mass * blocks[b].centroid;
    f.last += mass * last.states[b].centre;
    if (moved[b] != 0) moved_mass[id] += mass;
  }
  std::vector<Fragment> fragments;
  for (auto& [id, f] : found) {
    f.size = std::cbrt(f.volume);
    f.start /= f.mass;
    f.last /= f.mass;
    f.in_pile = moved_mass[id] > 0.5 * f.mass;
    fragments.push_back(f);
  }
  return fragments;
}

double single_block_share(const std::vector<Fragment>& fragments) {
  double single = 0.0, all = 0.0;
  for (const Fragment& f : fragments) {
    if (!f.in_pile) continue;
    all += f.mass;
    if (f.blocks == 1) single += f.mass;
  }
  return all > 0.0 ? single / all : std::numeric_limits<double>::quiet_NaN();
}

std::vector<SizePoint> passing_curve(std::vector<Piece> pieces) {
  // Of equal blocks, as joint sets cut them, rounding must not decide how many points there are.
  constexpr double kSame = 1e-6;
  std::ranges::sort(pieces, {}, &Piece::size);
  std::vector<SizePoint> curve;
  double sum = 0.0, first = 0.0;  // `first`: smallest size of the last point
  for (const Piece& piece : pieces) {
    sum += piece.mass;
    if (!curve.empty() && piece.size <= first * (1.0 + kSame)) {
      curve.back() = {piece.size, sum, curve.back().pieces + 1};
    } else {
      curve.push_back({piece.size, sum});
      first = piece.size;
    }
  }
  for (SizePoint& point : curve) point.passing /= sum;
  return curve;
}

double size_at(const std::vector<SizePoint>& curve, double passing) {
  if (curve.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto above = std::ranges::lower_bound(curve, passing, {}, &SizePoint::passing);
  if (above == curve.begin()) return curve.front().size;
  if (above == curve.end()) return curve.back().size;
  const SizePoint& below = *std::prev(above);
  const double one_piece = (above->passing - below.passing) / above->pieces;
  return below.size +
         std::min(1.0, (passing - below.passing) / one_piece) * (above->size - below.size);
}

}  // namespace muckpile
