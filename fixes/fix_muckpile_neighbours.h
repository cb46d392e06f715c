// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/neighbours: when LIGGGHTS looks for neighbours anew, and how far ranks know theirs.
// Scope: spheres of constant size; in place of LIGGGHTS' own check, which looks at each sphere's
// way in any direction only.
#pragma once

#include <fix.h>

#include <string>
#include <vector>

#include "math/types.h"

namespace muckpile {

class FixMuckpileNeighbours : public LAMMPS_NS::Fix {
 public:
  FixMuckpileNeighbours(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup_pre_neighbor() override { pre_neighbor(); }
  void pre_neighbor() override;
  void setup(int vflag) override;
  void post_integrate() override;
  void pre_delete(bool unfixed) override;
  double compute_scalar() override;  ///< how often neighbours were looked for in this run
  double memory_usage() override;

  /// The fix of this run, nullptr if there is none.
  [[nodiscard]] static FixMuckpileNeighbours* find(LAMMPS_NS::LAMMPS& lmp);
  /// By how much a rank knows less of its neighbours than LIGGGHTS' skin would have it [m].
  [[nodiscard]] double thinner_by() const;

 private:
  void refuse_bad_skin() const;
  void refuse_moving_mesh() const;
  void refuse_thin_parts() const;
  [[nodiscard]] bool moved_too_far() const;

  std::string where_;
  double border_skin_;  ///< [m]
  int engine_delay_ = 0, engine_every_ = 1;
  bool took_over_ = false;
  std::vector<Vec3> held_;  ///< per sphere of this rank: place when neighbours were found [m]
};

}  // namespace muckpile
