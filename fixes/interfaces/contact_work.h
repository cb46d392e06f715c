// SPDX-License-Identifier: GPL-2.0-or-later
// What fix muckpile/ledger needs of a contact style: the work of its forces, measured apart from
// the energies that the style books. Scope: implemented by pair muckpile/block.
#pragma once

namespace muckpile {

class ContactWork {
 public:
  virtual ~ContactWork() = default;
  /// From the next set-up of a run on the forces of each step are kept for end_step().
  virtual void watch() = 0;
  /// Work of the last forces in a step of that length [s] on the bodies, at the bodies' full-step
  /// velocities: what the integrator makes of them. Part of this rank [J]. Books what the dashpots
  /// took of it. Collective.
  virtual double end_step(double time_step) = 0;
};

}  // namespace muckpile
