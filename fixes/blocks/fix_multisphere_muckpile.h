// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/muckpile: LIGGGHTS' fix multisphere with a leaner step.
// Scope: moves bodies and their spheres, and sums the forces on them, through a list made when
// bodies or spheres change their places; leaves out full-step velocities that nothing reads; holds
// bodies that rest. Whatever else a step may need (virial, heat, drag, streams) the base class
// does.
#pragma once

#include <fix_multisphere.h>

#include <cstdint>
#include <vector>

#include "fixes/engine/border_spheres.h"
#include "fixes/interfaces/resting_blocks.h"
#include "math/types.h"
#include "motion/body_motion.h"

namespace muckpile {

class FixMultisphereMuckpile : public LAMMPS_NS::FixMultisphere {
 public:
  FixMultisphereMuckpile(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  void post_create() override;  ///< with the blocks of a restart file, if there is one
  void init() override;
  void reset_dt() override;  ///< fix multisphere takes over a new time step only as a run starts
  double extend_cut_ghost() override;
  void box_extent(double& xlo, double& xhi, double& ylo, double& yhi, double& zlo,
                  double& zhi) override;
  void pre_neighbor() override;
  void initial_integrate(int vflag) override;
  void pre_final_integrate() override;
  void final_integrate() override;
  void calc_force(bool setupflag) override;

 private:
  [[nodiscard]] bool velocities_are_read() const;
  [[nodiscard]] bool any_rests() const { return resting_ != nullptr && resting_->any_rests(); }
  [[nodiscard]] bool periodic() const;
  [[nodiscard]] std::vector<BodySphere> members();
  [[nodiscard]] std::vector<BodyConstants> constants();
  [[nodiscard]] SphereRows sphere_rows() const;
  [[nodiscard]] Vec3 gravity() const;
  void list_members();
  void list_border_spheres(const std::vector<BodySphere>& members);
  void follow_rests();
  void hold_resting();

  const RestingBlocks* resting_ = nullptr;  ///< looked up in every init(); null: none rests
  std::vector<int> readers_;  ///< `nevery` of each fix of LIGGGHTS that works at the end of steps
  bool plain_ = false;        ///< this step needs nothing that only the base class does
  std::uint64_t rests_version_ = 0;   ///< of resting_, as motion_ knows it; 0: none rests
  std::uint64_t placed_version_ = 0;  ///< of resting_, when the resting were last placed
  bool members_known_ = false;
  BodyMotion motion_;          ///< of this rank's bodies and their spheres, ghosts among them
  bool own_messages_ = false;  ///< border_ instead of LIGGGHTS' messages about all ghosts
  engine::BorderSpheres border_;
};

}  // namespace muckpile
