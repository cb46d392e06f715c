// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks in their start configuration, from a run's dump/blocks.vtk.
// Scope: legacy VTK unstructured grid of convex cells with the cell data that the engine writes;
// faces are turned outwards, else nothing is repaired.
#pragma once

#include <filesystem>
#include <vector>

#include "io/block_shape.h"
#include "math/types.h"

namespace muckpile {

struct StartBlock {
  int id;
  BlockShape shape;  // vertices [m], faces counter-clockwise seen from outside
  Vec3 centroid;     // of the volume [m]
  double volume;     // [m3]
  double size;       // volume^(1/3) [m]
  double mass;       // [kg]
  bool on_free_face;
  int zone = -1;  // number of its zone of rock, 0 beside them; -1: the file has no zones
  int image = 0;  // 0: of the model; else behind its symmetry planes (io/images.h)
};

// All blocks, in ascending order of id. Throws InputError, naming the file, if the file
// is cut short or damaged, an array is missing, an id occurs twice, or a polyhedron's volume is not
// the volume_m3 that the file states.
std::vector<StartBlock> read_blocks(const std::filesystem::path& path);

}  // namespace muckpile
