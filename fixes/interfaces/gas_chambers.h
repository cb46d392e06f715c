// SPDX-License-Identifier: GPL-2.0-or-later
// The gas in the blastholes, for whoever lets it flow into joints.
// Scope: an interface only; fix muckpile/blast implements it, fix muckpile/gas drives it.
#pragma once

#include <cstddef>
#include <span>

#include "gas/joint_gas.h"

namespace muckpile {

class GasChambers {
 public:
  virtual ~GasChambers() = default;
  /// Before the first run: from now on the caller computes the flow of gas into joints, in place of
  /// crack_discharge, and gas presses on the walls by its excess over `ambient` [Pa]. InputError
  /// unless the gas vents by flow.
  virtual void let_gas_into_joints(double ambient) = 0;
  /// From the next set-up of a run on, gas leaves by crack_discharge again, and presses in full.
  virtual void keep_gas_out_of_joints() = 0;
  [[nodiscard]] virtual double gas_gamma() const = 0;
  /// R of the products of all holes, the mean by mass [J/(kg K)].
  [[nodiscard]] virtual double gas_constant() const = 0;
  /// The gas in a crushed zone; pressure 0 before its hole fires and after it is over.
  [[nodiscard]] virtual GasChamber chamber(std::size_t hole) const = 0;
  /// Removes that from each; the same on all ranks.
  virtual void take_gas(std::span<const GasFlow> per_hole) = 0;
  /// Ends all holes; the gas that they hold does not press any more.
  virtual void release_gas() = 0;
  /// True once no hole will press any more.
  [[nodiscard]] virtual bool over() const = 0;
};

}  // namespace muckpile
