// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/muckpile: LIGGGHTS' fix multisphere that gives the spheres their full-step
// velocities only when somebody reads them.
// Scope: everything else is the base class; forces see the same mid-step velocities.
#pragma once

#include <fix_multisphere.h>

#include "resting_blocks.h"

namespace muckpile {

class FixMultisphereMuckpile : public LAMMPS_NS::FixMultisphere {
 public:
  FixMultisphereMuckpile(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  void init() override;
  void reset_dt() override;  ///< LIGGGHTS' own takes a time step over at the start of a run only
  void final_integrate() override;

 private:
  [[nodiscard]] bool velocities_are_read() const;
  void integrate_bodies();
  void hold_resting();

  const RestingBlocks* resting_ = nullptr;  ///< looked up in every init(); null: none rests
  bool read_every_step_ = true;  ///< a fix of LIGGGHTS works at the end of each step
};

}  // namespace muckpile
