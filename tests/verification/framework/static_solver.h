// SPDX-License-Identifier: GPL-2.0-or-later
// Equilibrium of a block run under its average strain and the pressures on its faces.
// Scope: small displacements, unbroken rock; preconditioned conjugate gradients without a matrix.
#pragma once

#include "framework/block_run.h"

namespace muckpile::verification {

struct Equilibrium {
  int iterations;
  double residual;  ///< largest unbalanced force over the largest one at the start [-]
};

/// Moves the blocks of `run`, which starts unstrained, to rest. `strain` is the size of the strains
/// to come; it sets the length of the probing displacements.
Equilibrium settle(BlockRun& run, double strain, double tolerance = 1e-7);

}  // namespace muckpile::verification
