// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/impulse: what has pushed each block, by cause: wave, gas, joints, contacts, weight.
// Scope: reads the forces of each step, and changes nothing; fix muckpile/dump writes the sums.
#pragma once

#include <fix.h>

#include <vector>

#include "fixes/interfaces/block_impulses.h"

namespace LAMMPS_NS {
class FixGravity;
class FixMultisphere;
}  // namespace LAMMPS_NS

namespace muckpile {

class ForceParts;
class RestingBlocks;

class FixMuckpileImpulse : public LAMMPS_NS::Fix, public BlockImpulses {
 public:
  FixMuckpileImpulse(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void final_integrate() override;

  [[nodiscard]] const std::vector<ImpulseRow>& impulses() const override { return sums_.rows(); }

 private:
  void read_forces();
  void begin();

  LAMMPS_NS::FixMultisphere* multisphere_ = nullptr;
  LAMMPS_NS::FixGravity* gravity_ = nullptr;
  ForceParts* joints_ = nullptr;
  RestingBlocks* sleep_ = nullptr;
  ImpulseSums sums_;
  bool begun_ = false;
  std::vector<int> tags_;  // work space
};

}  // namespace muckpile
