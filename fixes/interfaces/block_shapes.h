// SPDX-License-Identifier: GPL-2.0-or-later
// The shapes of all blocks of the run, as contact in their own shape needs them.
// Scope: an interface only; fix muckpile/shapes implements it.
#pragma once

#include "contact/polyhedra/solid.h"

namespace muckpile {

struct ShapedBlock {
  int key = 0;      ///< tag of the sphere that stands for the block
  Vec3 key_offset;  ///< of that sphere from the centre, in the body's axes [m]
  Solid solid;      ///< in the body's axes, about the centre
  double reach;     ///< of the farthest corner from the key [m]
};

class BlockShapes {
 public:
  virtual ~BlockShapes() = default;
  /// Of a block by its tag; null: none is known.
  [[nodiscard]] virtual const ShapedBlock* shape(int tag) const = 0;
  [[nodiscard]] virtual double largest_reach() const = 0;  ///< of all [m]
};

}  // namespace muckpile
