// SPDX-License-Identifier: GPL-2.0-or-later
// Fragments: sets of blocks that joints still hold together, and the size curve of the broken-out
// ones. Scope: size is volume^(1/3); nothing finer than one block is resolved.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

struct Fragment {
  int id;  // smallest block id in it
  int blocks;
  double volume;     // [m3]
  double size;       // volume^(1/3) [m]
  double mass;       // [kg]
  Vec3 start, last;  // centre of mass [m]
  bool in_pile;      // more than half of its mass has been broken out
};

// All fragments in ascending order of id.
std::vector<Fragment> fragments_of(const std::vector<StartBlock>& blocks, const Snapshot& last,
                                   const std::vector<char>& moved);

// Share of the pile's mass that single blocks have; NaN without a pile.
double single_block_share(const std::vector<Fragment>& fragments);

struct SizePoint {
  double size;     // [m]
  double passing;  // fraction of the mass in pieces of this size or smaller
  int pieces = 1;  // of this size
};

struct Piece {
  double size;  // [m]
  double mass;  // [kg]
};

// Passing curve, one point per size, ascending; the last point is 1. Sizes that agree to a
// millionth are one, the largest of them. Empty for no pieces.
std::vector<SizePoint> passing_curve(std::vector<Piece> pieces);

// Size [m] below which the fraction `passing` of the mass lies: straight lines between the points,
// of a point of several pieces, each taken for as heavy, up to the first of them; the smallest size
// below the first point. NaN for an empty curve.
double size_at(const std::vector<SizePoint>& curve, double passing);

}  // namespace muckpile
