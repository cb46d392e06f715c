// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks of an earlier run as its last snapshot has them.
// Scope: a folder of results with dump/blocks.vtk and dump/blocks_<step>.csv or .bin, or that folder dump.
#pragma once

#include <string>
#include <vector>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

struct SavedBlock {
  int id = 0;
  Polyhedron shape;              ///< at the start of that run [m]
  MassProperties mass;           ///< of that shape
  double kg = 0.0;               ///< [kg]
  Vec3 centre = Vec3::Zero();    ///< at the end [m]
  Quat turn = Quat::Identity();  ///< from start to end
  double speed = 0.0;            ///< [m/s]
};

struct SavedPile {
  std::vector<SavedBlock> blocks;
  double time = 0.0;  ///< of the snapshot [s]
};

/// Throws InputError, naming folder or file, if something is missing, is no such file, or is of
/// another run.
[[nodiscard]] SavedPile read_saved_pile(const std::string& folder);

}  // namespace muckpile
