// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/quiet: words, choice of supports, and when it is over; the law is in
// core/bond/ground/quiet_ground.
#include "fixes/joints/fix_muckpile_quiet.h"

#include <modify.h>
#include <mpi.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "args/numbers.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/region.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/keyword_tables.h"

namespace muckpile {
namespace {

enum Output { kYielding, kRadiated, kPower, kOver, kOutputCount };

const ArgTable& table() {
  static const ArgTable args =
      ArgTable("fix muckpile/quiet")
          .group("region", 1, 1, true,
                 "`fixed` supports of `create_blocks` with their centroid in this region yield; at "
                 "least one")
          .real("rock_behind", "m", Range::closed(1e-3, 1e6), std::nullopt,
                "thickness of the rock behind, on a rigid base, for lasting loads")
          .real("until", "s", Range::closed(0.0, 1e30), 1e30,
                "time of the run from which on the ground stands still")
          .real("power_share", "", Range::right_open(0.0, 1.0), 0.0,
                "the ground stands still once less than this share of the greatest radiated power "
                "so far leaves; 0: never")
          .integer("every", "steps", engine::step_counts(), 100,
                   "between checks of time and power, which is the mean between two checks");
  return args;
}

}  // namespace

const ArgTable& quiet_keywords() { return table(); }

FixMuckpileQuiet::FixMuckpileQuiet(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)) {
  engine::refuse_second_fix(*lmp, where_, "muckpile/quiet");
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  for (const auto& words : args.groups("region")) regions_.push_back(words.front());
  if (regions_.empty()) engine::stop(*lmp, where_ + ": keyword 'region' is required");
  rock_behind_ = args.real("rock_behind");
  until_ = args.real("until");
  power_share_ = args.real("power_share");
  nevery = static_cast<int>(args.integer("every"));
  scalar_flag = vector_flag = 1;
  size_vector = kOutputCount;
  global_freq = 1;
  extscalar = extvector = 0;
  restart_global = 1;
}

int FixMuckpileQuiet::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

/// An unfix makes them fixed supports again; at the end of the program there is nothing to do.
void FixMuckpileQuiet::pre_delete(bool unfixflag) {
  YieldingSupports* supports = unfixflag ? engine::find_view<YieldingSupports>(*lmp) : nullptr;
  if (supports != nullptr) supports->stop_ground();
}

void FixMuckpileQuiet::init() {
  supports_ = engine::find_view<YieldingSupports>(*lmp);
  if (supports_ == nullptr) engine::stop(*lmp, where_ + ": needs a fix muckpile/joint before it");
  if (engine::place_of<YieldingSupports>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, where_ + ": must be defined after fix muckpile/joint");
  for (const std::string& region : regions_) engine::require_region(*lmp, where_, region);
}

/// Forces are up to date here, so what the supports carry now is known and can be carried on.
void FixMuckpileQuiet::setup(int) {
  if (state_.begun) return;
  state_.begun = true;
  state_.last_time = update->get_cur_time();
  state_.last_radiated = engine::sum_over_ranks(supports_->energy_radiated(), world);
  const auto mine =
      supports_->let_ground_yield([this](const Vec3& at) { return chosen(at); }, rock_behind_);
  const double count = engine::sum_over_ranks(mine.count, world);
  const double area = engine::sum_over_ranks(mine.area, world);
  if (count == 0.0) {
    engine::stop(*lmp, where_ +
                           ": its regions must hold supports (create_blocks ... support "
                           "fixed REGION), got none that is unbroken");
  }
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%s: %.0f supports of %.4g m2 yield\n", where_.c_str(),
                count, area);
  engine::print_once(*lmp, text.data());
}

bool FixMuckpileQuiet::chosen(const Vec3& centroid) const {
  return std::any_of(regions_.begin(), regions_.end(), [&](const std::string& name) {
    return engine::in_region(*lmp, name, centroid);
  });
}

void FixMuckpileQuiet::end_of_step() {
  if (!state_.over) look();
}

void FixMuckpileQuiet::look() {
  const double time = update->get_cur_time(),
               radiated = engine::sum_over_ranks(supports_->energy_radiated(), world);
  const double passed = time - state_.last_time;  // [s]
  state_.power = passed > 0.0 ? (radiated - state_.last_radiated) / passed : 0.0;
  state_.greatest_power = std::max(state_.greatest_power, state_.power);
  state_.last_time = time;
  state_.last_radiated = radiated;
  if (time >= until_) return stop("until is reached");
  if (state_.greatest_power > 0.0 && state_.power < power_share_ * state_.greatest_power)
    return stop("the wave has passed");
  if (engine::sum_over_ranks(supports_->supports_yielding(), world) == 0.0)
    stop("no support yields any more");
}

void FixMuckpileQuiet::stop(const std::string& why) {
  state_.over = true;
  state_.power = 0.0;
  supports_->stop_ground();
  engine::print_once(*lmp, where_ + ": the ground stands still from " +
                               number_text(update->get_cur_time()) + " s on: " + why + "\n");
}

void FixMuckpileQuiet::write_restart(FILE* file) { engine::write_state(*lmp, style, file, state_); }

void FixMuckpileQuiet::restart(char* state) {
  state_ = engine::read_state<QuietState>(*lmp, style, state);
}

double FixMuckpileQuiet::compute_scalar() {
  const YieldingSupports* supports = engine::find_view<YieldingSupports>(*lmp);
  return supports == nullptr ? 0.0 : engine::sum_over_ranks(supports->energy_given(), world);
}

double FixMuckpileQuiet::compute_vector(int n) {
  const YieldingSupports* supports =
      engine::find_view<YieldingSupports>(*lmp);  // between runs it may have been unfixed
  if (supports == nullptr) return 0.0;
  switch (n) {
    case kYielding:
      return engine::sum_over_ranks(supports->supports_yielding(), world);
    case kRadiated:
      return engine::sum_over_ranks(supports->energy_radiated(), world);
    case kPower:
      return state_.power;
    case kOver:
      return state_.over ? 1.0 : 0.0;
    default:
      return 0.0;
  }
}

}  // namespace muckpile
