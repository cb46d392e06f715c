// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/sleep: blocks at rest among blocks at rest are left alone until one of them moves.
// Scope: decides who rests; the integrator holds them, joints and contact style skip what lies
// between two of them.
#pragma once

#include <fix.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fixes/interfaces/block_neighbours.h"
#include "fixes/interfaces/resting_blocks.h"
#include "rest/stillness.h"

namespace LAMMPS_NS {
class FixMultisphere;
}

namespace muckpile {

/// What a restart file holds of a block.
struct RestRecord {
  int tag = 0;
  Stillness stay;
  bool rests = false;
};
template <>
struct Stored<RestRecord> {
  static constexpr std::string_view kName = "rest_record";
  static constexpr int kVersion = 1;
  static auto fields(auto& record) { return std::tie(record.tag, record.stay, record.rests); }
};

/// What a restart file holds that is the same on all ranks.
struct SleepState {
  double taken = 0.0;  ///< [J]
};
template <>
struct Stored<SleepState> {
  static constexpr std::string_view kName = "sleep_state";
  static constexpr int kVersion = 1;
  static auto fields(auto& state) { return std::tie(state.taken); }
};

class FixMuckpileSleep : public LAMMPS_NS::Fix, public RestingBlocks {
 public:
  FixMuckpileSleep(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup_pre_neighbor() override { follow_bodies(); }
  void pre_neighbor() override { follow_bodies(); }
  void setup(int vflag) override;
  void end_of_step() override;
  int modify_param(int narg, char** arg) override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;
  int pack_comm(int n, int* list, double* buffer, int pbc_flag, int* pbc) override;
  void unpack_comm(int n, int first, double* buffer) override;
  int pack_reverse_comm(int n, int first, double* buffer) override;
  void unpack_reverse_comm(int n, int* list, double* buffer) override;

  [[nodiscard]] bool any_rests() const override { return any_; }
  [[nodiscard]] bool body_rests(int body) const override {
    return rests_[static_cast<std::size_t>(body)] != 0;
  }
  [[nodiscard]] std::span<const char> resting_spheres() const override { return of_spheres_; }
  [[nodiscard]] std::uint64_t rests_version() const override { return version_; }

  void wake_blocks() override;
  [[nodiscard]] double energy_taken() const override { return taken_; }

 private:
  void follow_bodies();
  void list_bodies_of_spheres();
  [[nodiscard]] bool blast_is_on() const;
  [[nodiscard]] std::vector<char> moving_bodies();
  void mark_near(const std::vector<char>& moving, std::vector<char>& disturbed);
  void lay_to_rest(const std::vector<char>& disturbed);
  void tell();
  void wake_joints();
  void share_sent();
  [[nodiscard]] std::vector<char> on_spheres(const std::vector<char>& of_bodies);

  std::string where_;
  StillnessLimits limits_;
  LAMMPS_NS::FixMultisphere* multisphere_ = nullptr;
  NearBlocks* near_ = nullptr;  // looked up in every init(); null: no such style
  JoinedBlocks* joined_ = nullptr;
  std::vector<int> tags_;         // per body, as of follow_bodies()
  std::vector<Stillness> stays_;  // per body
  std::vector<char> rests_;       // per body
  std::vector<int> body_of_;      // per sphere with ghosts, -1: of another rank or none
  std::vector<char> of_spheres_;  // per sphere with ghosts: its block rests
  std::vector<char> sent_;        // per sphere with ghosts: what share_sent() sends
  int resting_ = 0;               // bodies of this rank
  bool any_ = false;              // of its bodies or spheres
  std::uint64_t version_ = 0;
  double taken_ = 0.0;
};

}  // namespace muckpile
