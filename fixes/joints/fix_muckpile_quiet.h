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

namespace muckpile {

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
  [[nodiscard]] YieldingSupports* find_supports() const;  // nullptr if there are none
  [[nodiscard]] bool chosen(const Vec3& centroid) const;
  void look();
  void stop(const std::string& why);
  [[nodiscard]] double sum(double mine) const;

  std::string where_;
  std::vector<std::string> regions_;
  double rock_behind_, until_, power_share_;
  YieldingSupports* supports_ = nullptr;  // looked up in every init()
  bool begun_ = false, over_ = false;
  double last_time_ = 0.0, last_radiated_ = 0.0;  // at the last look [s], [J]
  double power_ = 0.0, greatest_power_ = 0.0;     // radiated, mean between looks [W]
};

}  // namespace muckpile
