// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/ledger: where the energy is and where it went.
// Scope: fix multisphere bodies under fix muckpile/joint, fix gravity, walls and pair
// muckpile/block, whichever of them the run has.
#pragma once

#include <fix.h>

#include <array>

namespace LAMMPS_NS {
class FixGravity;
class FixMultisphere;
}  // namespace LAMMPS_NS

namespace muckpile {

class FixMuckpileJoint;
class FixMuckpileSleep;

/// Energies of the whole run [J]; losses and works are cumulative.
struct EnergyLedger {
  double kinetic = 0.0, joint_elastic = 0.0, contact_elastic = 0.0, gravity = 0.0;
  double blast_work = 0.0;
  double fracture = 0.0, joint_friction = 0.0, joint_damping = 0.0;
  double contact_friction = 0.0, contact_damping = 0.0, walls = 0.0;
  double quiet = 0.0;  ///< given to the rock behind quiet boundaries
  double sleep = 0.0;  ///< kinetic energy of blocks as they were laid to rest

  /// What is in the system and what left it, less what came in.
  [[nodiscard]] double residual() const {
    return kinetic + joint_elastic + contact_elastic + gravity + fracture + joint_friction +
           joint_damping + contact_friction + contact_damping + walls + quiet + sleep - blast_work;
  }
};

class FixMuckpileLedger : public LAMMPS_NS::Fix {
 public:
  FixMuckpileLedger(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

  /// Summed over ranks. Collective; computed once per step.
  [[nodiscard]] const EnergyLedger& ledger();
  /// |residual - its start value| over the largest of blast work, kinetic energy at the start and
  /// gravity energy released.
  [[nodiscard]] double balance_error();
  /// False if that error is larger than `allowed`, and not merely rounding of rock at rest.
  [[nodiscard]] bool balanced(double allowed);
  /// Of the fastest block [m/s]. Collective.
  [[nodiscard]] double fastest_block();

 private:
  [[nodiscard]] double work_rate_of_spheres() const;
  [[nodiscard]] double of_pair(const char* name) const;

  LAMMPS_NS::FixMultisphere* multisphere_ = nullptr;
  LAMMPS_NS::FixGravity* gravity_ = nullptr;
  FixMuckpileJoint* joint_ = nullptr;
  FixMuckpileSleep* sleep_ = nullptr;
  double laid_to_rest_ = 0.0;  // of this rank, also after that fix is gone [J]
  EnergyLedger ledger_;
  double sphere_work_ = 0.0;  // this rank, by all forces on spheres since the start [J]
  double start_residual_ = 0.0, start_kinetic_ = 0.0, start_gravity_ = 0.0;
  bool started_ = false;
  LAMMPS_NS::bigint computed_at_ = -1;
};

}  // namespace muckpile
