// SPDX-License-Identifier: GPL-2.0-or-later
// What pair muckpile/block has where blocks touch in their own shape.
// Scope: data.
#pragma once

#include <vector>

#include "contact/polyhedra/solid_forces.h"
#include "fixes/contact/solid_blocks.h"

namespace muckpile {

struct SolidParts {
  explicit SolidParts(const ContactParameters& parameters) : law(parameters) {}

  SolidContactLaw law;
  const BlockShapes* shapes = nullptr;  ///< owned by the engine
  SolidBlocks blocks;
  SolidForces forces;
  SolidContact look;       ///< work space of questions beside the step
  std::vector<Vec3> axes;  ///< per block pair: along which the two were apart, or zero
};

}  // namespace muckpile
