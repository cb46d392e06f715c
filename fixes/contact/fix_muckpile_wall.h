// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall: a plane or a triangle mesh with ground behind it, which blocks touch by the
// law of pair muckpile/block.
// Scope: walls that stand still. Each rank has the whole wall and looks at its own spheres; no
// neighbour list of the engine.
#pragma once

#include <fix.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fixes/interfaces/resting_blocks.h"
#include "fixes/interfaces/standing_contacts.h"
#include "state/encoding.h"
#include "wall/wall_law.h"
#include "wall/wall_options.h"

namespace muckpile {

/// What a sphere remembers of a touch; stored per sphere, as numbers of the engine.
template <>
struct Stored<WallContact> {
  static constexpr std::string_view kName = "wall_contact";
  static constexpr int kVersion = 3;
  static auto fields(auto& contact) {
    return std::tie(contact.normal, contact.state.slide, contact.state.roll,
                    contact.state.overlap_offset, contact.state.tangential_stiffness, contact.twist,
                    contact.overlap);
  }
};

/// What a restart file holds of the wall itself, as sums over ranks: losses [J], and how many
/// spheres have been let go.
struct WallState {
  double friction = 0.0, damping = 0.0, let_go = 0.0;
};
template <>
struct Stored<WallState> {
  static constexpr std::string_view kName = "wall_state";
  static constexpr int kVersion = 2;
  static auto fields(auto& state) { return std::tie(state.friction, state.damping, state.let_go); }
};

class FixMuckpileWall : public LAMMPS_NS::Fix, public StandingContacts {
 public:
  FixMuckpileWall(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  FixMuckpileWall(const FixMuckpileWall&) = delete;
  FixMuckpileWall& operator=(const FixMuckpileWall&) = delete;
  ~FixMuckpileWall() override;

  int setmask() override;
  void init() override;
  void setup_pre_exchange() override { pre_exchange(); }
  void pre_exchange() override;
  void setup_pre_neighbor() override { pre_neighbor(); }
  void pre_neighbor() override;
  void setup(int vflag) override;
  void post_force(int vflag) override;
  void post_run() override { warn_of_let_go(); }
  double compute_vector(int n) override;

  void visit_contacts(const Take& take) const override;
  [[nodiscard]] double light_step() const override {
    return listed_ ? light_step_ : least_light_step();
  }

  void grow_arrays(int nmax) override;
  void copy_arrays(int from, int to, int delflag) override;
  void set_arrays(int index) override;
  int pack_exchange(int index, double* buf) override;
  int unpack_exchange(int index, double* buf) override;
  int pack_restart(int index, double* buf) override;
  void unpack_restart(int index, int nth) override;
  int size_restart(int index) override;
  int maxsize_restart() override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;
  double memory_usage() override;

 private:
  /// A sphere that may touch until neighbours are looked for again, and what of the wall.
  struct Candidate {
    int sphere;
    std::size_t first, last;  ///< in parts_
    Vec3 place;               ///< of its centre, when it was listed [m]
    double gap;               ///< between its surface and the wall then [m]
    double resting = -1.0;    ///< elastic energy while its block rests, below 0: not known [J]
  };
  /// Of this rank, in the last step.
  struct Sums {
    double contacts = 0.0, elastic = 0.0;  ///< [-], [J]
    Vec3 force = Vec3::Zero();             ///< on the wall [N]
    double largest_overlap_ratio = 0.0;    ///< [-]
  };
  /// A sphere that has got too deep; none has a tag below 0.
  struct Sunk {
    int tag = -1;
    double depth = 0.0;         ///< of its centre behind the wall [m]
    Vec3 place = Vec3::Zero();  ///< [m]
  };
  void refuse_spheres_in_the_ground() const;
  [[nodiscard]] Sunk deepest_over_ranks(const Sunk& mine) const;
  [[nodiscard]] bool is_behind(int sphere) const;
  void look_whether_let_go(int sphere);
  void warn_of_let_go();
  void end_contacts(int sphere);
  [[nodiscard]] double least_light_step() const;
  void list_candidates();
  [[nodiscard]] bool still_apart(const Candidate& candidate) const;
  void step(double memory_step);
  void sort_out_resting();
  void work_on(const Candidate& candidate, double memory_step);
  void leave_alone(Candidate& candidate);
  [[nodiscard]] WallSphere sphere(int index) const;
  [[nodiscard]] WallPush push(const Candidate& candidate, double memory_step,
                              std::vector<WallContact>& contacts) const;
  int pack(int index, double* buf) const;
  int unpack(int index, std::span<const double> numbers);

  std::string where_;
  WallOptions options_;
  std::optional<WallLaw> law_;
  const RestingBlocks* resting_ = nullptr;  ///< null: none rests
  bool looked_for_faults_ = false;

  bool listed_ = false;
  double light_step_ = HUGE_VAL;     ///< of the spheres listed [s]
  bool sorted_ = false;              ///< awake_ and resting_sums_ are of these candidates
  std::uint64_t rests_version_ = 0;  ///< and of these resting blocks
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> awake_;                  ///< of candidates_: their blocks do not rest
  std::vector<std::size_t> parts_;                  ///< of the wall, candidate after candidate
  std::vector<std::vector<WallContact>> contacts_;  ///< per sphere
  WallState books_;                                 ///< of this rank
  Sums sums_, resting_sums_;
  Sunk let_go_;               ///< of this rank since the last look for them, the deepest
  double told_let_go_ = 0.0;  ///< how many the last warning was about
};

}  // namespace muckpile
