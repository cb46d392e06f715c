// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/quiet: the ground behind chosen supports lets waves out.
// Scope: chooses the supports once and decides when they stop yielding; fix muckpile/joint moves
// the ground within its force computation. Between looks it costs nothing of its own.
#pragma once

#include <fix.h>

#include <string>
#include <vector>

#include "fixes/interfaces/yielding_supports.h"
#include "math/types.h"
#include "state/encoding.h"

namespace muckpile {

/// What a restart file holds of the fix; the motion of the ground is in the state of the joints.
struct QuietState {
  bool begun = false, over = false;
  double power = 0.0, greatest_power = 0.0;  ///< radiated, mean between looks [W]
  double last_radiated = 0.0;                ///< at the last look [J]
  double last_time = 0.0;                    ///< of the last look [s]
};
template <>
struct Stored<QuietState> {
  static constexpr std::string_view kName = "quiet_state";
  static constexpr int kVersion = 2;
  static auto fields(auto& state) {
    return std::tie(state.begun, state.over, state.power, state.greatest_power, state.last_radiated,
                    state.last_time);
  }
};

class FixMuckpileQuiet : public LAMMPS_NS::Fix {
 public:
  FixMuckpileQuiet(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void pre_delete(bool unfixflag) override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

 private:
  [[nodiscard]] bool chosen(const Vec3& centroid) const;
  void look();
  void stop(const std::string& why);

  std::string where_;
  std::vector<std::string> regions_;
  double rock_behind_, until_, power_share_;
  YieldingSupports* supports_ = nullptr;  // looked up in every init()
  QuietState state_;
};

}  // namespace muckpile
