// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/muckpile: LIGGGHTS' fix multisphere with a leaner step.
// Scope: moves bodies and their spheres, and sums the forces on them, through a list made when
// bodies or spheres change their places; leaves out full-step velocities that nobody reads; holds
// bodies that rest. Whatever else a step may need (virial, heat, drag, streams) the base class
// does.
#pragma once

#include <fix_multisphere.h>

#include <cstdint>
#include <vector>

#include "engine/border_spheres.h"
#include "interfaces/resting_blocks.h"
#include "math/types.h"

namespace muckpile {

class FixMultisphereMuckpile : public LAMMPS_NS::FixMultisphere {
 public:
  FixMultisphereMuckpile(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  void post_create() override;  ///< with the blocks of a restart file, if there is one
  void init() override;
  void reset_dt() override;  ///< fix multisphere takes over a new time step only as a run starts
  double extend_cut_ghost() override;
  void pre_neighbor() override;
  void initial_integrate(int vflag) override;
  void pre_final_integrate() override;
  void final_integrate() override;
  void calc_force(bool setupflag) override;

 private:
  /// A sphere of a body of this rank. The sphere may be a ghost, owned by another rank.
  struct Member {
    int sphere, body;
    Vec3 displacement;  ///< from the body's centre, along its axes [m]
  };

  [[nodiscard]] bool velocities_are_read() const;
  [[nodiscard]] bool rests(int body) const { return any_rests_ && resting_->body_rests(body); }
  void list_members();
  void list_border_spheres();
  void move_bodies();
  void place_spheres();
  void sum_forces();
  void kick_bodies();
  void hold_resting();

  const RestingBlocks* resting_ = nullptr;  ///< looked up in every init(); null: none rests
  std::vector<int> readers_;  ///< `nevery` of each fix of LIGGGHTS that works at the end of steps
  bool plain_ = false;        ///< this step needs nothing that only the base class does
  bool any_rests_ = false;    ///< in this step
  std::uint64_t placed_version_ = 0;  ///< of resting_, when the resting were last placed
  bool members_known_ = false;
  std::vector<Member> members_;
  bool own_messages_ = false;  ///< border_ instead of LIGGGHTS' messages about all ghosts
  engine::BorderSpheres border_;
  std::vector<char> counts_;  ///< per member: the one image of its sphere whose force is taken
  std::vector<Vec3> shifts_;  ///< per member: of its periodic image [m]; empty without any
};

}  // namespace muckpile
