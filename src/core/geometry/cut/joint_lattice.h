// SPDX-License-Identifier: GPL-2.0-or-later
// The planes of joint sets: one lattice of three sets through the box of the rock.
// Scope: all planes of a set, at every spacing, are planes of the lattice, so that joints run on
// from block to block through a band. Lengths in m.
#pragma once

#include <array>
#include <optional>
#include <sstream>
#include <utility>

#include "args/input_error.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {

/// A set's planes: normal.x = start + u spacing for whole u, and for halves, quarters, ... of it.
struct LatticeSet {
  Vec3 normal;
  double spacing;   // [m] of the coarsest
  double start;     // [m]
  double relative;  // thickness of a block along the normal over its size [-]
};
using Lattice = std::array<LatticeSet, 3>;

/// A cell and, for each set, the lattice planes around it.
struct LatticeCell {
  ConvexCell cell;
  std::array<std::pair<double, double>, 3> between;  // [spacings]
};

template <class... Words>
[[noreturn]] void refuse_joint_sets(const Words&... words) {
  std::ostringstream text;
  text << "joint set cut: ";
  (text << ... << words);
  throw InputError(text.str());
}

/// Spacings that give blocks of the largest size, rounded so that the box holds whole ones. Throws
/// InputError for other than two or three sets, and for sets that are nearly parallel.
[[nodiscard]] Lattice lattice_in(const TessellationOptions& rock, const JointSetCut& how);

/// A cell with the planes of the lattice around it.
[[nodiscard]] LatticeCell in_lattice(const Lattice& lattice, ConvexCell cell);

/// The set along whose normal the cell is thickest for that set, if there are planes left.
/// `size`: of a block there [m].
[[nodiscard]] std::optional<std::size_t> widest_set(const Lattice& lattice, const LatticeCell& cell,
                                                    double size);

/// The plane between two others that halves the way, or nearly: a whole number if there is one.
[[nodiscard]] double plane_between(const std::pair<double, double>& planes);

}  // namespace muckpile
