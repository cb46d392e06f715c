// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/balance: moves the borders between ranks so that all have the same work.
// Scope: at the start of each run that is set up, along the axes that the processor grid cuts.
#pragma once

#include <fix.h>

#include <span>

#include "math/types.h"

namespace muckpile {

class FixMuckpileBalance : public LAMMPS_NS::Fix {
 public:
  FixMuckpileBalance(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override { return 0; }
  void init() override;
  void setup(int vflag) override;
  double compute_scalar() override;

  /// The fix of this run, nullptr if there is none.
  [[nodiscard]] static FixMuckpileBalance* find(LAMMPS_NS::LAMMPS& lmp);

  /// Cuts the box for blocks that are about to be made; `centres` of all of them on rank 0 [m].
  void cut_for(std::span<const Vec3> centres);

 private:
  enum class Reach { neighbours, any };
  struct Load {
    Vec3 centre;  ///< [m]
    double cost;  ///< of a block per step, in units of a loose block's
  };
  void settle_box();
  void cut(std::span<const Load> loads, Reach reach);
  void cut_axis(int axis, std::span<const Load> loads, Reach reach);
  [[nodiscard]] std::span<double> splits(int axis);

  bool halo_known_ = false;
};

}  // namespace muckpile
