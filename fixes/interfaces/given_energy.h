// SPDX-License-Identifier: GPL-2.0-or-later
// Kinetic energy that a command has given to blocks before there was an account for it.
// Scope: an interface only; fix muckpile/blocks implements it, block_motion leaves the energy
// there, fix muckpile/ledger takes it over.
#pragma once

namespace muckpile {

class GivenEnergy {
 public:
  virtual ~GivenEnergy() = default;
  virtual void keep_given(double energy) = 0;  ///< of this rank's blocks [J]
  [[nodiscard]] virtual double take_given() = 0;
};

}  // namespace muckpile
