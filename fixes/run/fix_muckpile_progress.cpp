// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/progress: looks at the run from time to time, and the checks that stop it.
// Scope: what a look is told as is in run_look.cpp.
#include "fixes/run/fix_muckpile_progress.h"

#include <atom.h>
#include <comm.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <multisphere.h>
#include <update.h>
#include <write_restart.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "args/numbers.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/periodic_output.h"
#include "fixes/engine/region.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/stop_with_state.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/blast_energies.h"
#include "fixes/interfaces/energy_account.h"
#include "fixes/interfaces/joint_damage.h"
#include "fixes/interfaces/joint_energies.h"
#include "fixes/interfaces/keyword_tables.h"
#include "fixes/interfaces/known_blocks.h"
#include "run/phase_name.h"

namespace muckpile {
namespace {

Range time_range() { return Range::left_open(0.0, 1e30); }
Range share_range() { return Range::open(0.0, 1.0); }

const ArgTable& table() {
  static const ArgTable args =
      engine::periodic_output_table("fix muckpile/progress", "between checks",
                                    "where history.csv and run.json go")
          .word("phase", {}, "run", "name of the phase that begins, without commas and quotes")
          .real("time_end", "s", time_range(), 1e30,
                "physical time at which the phase ends at the latest; for the time left")
          .real("still_speed", "m/s", Range::left_open(0.0, 1e3), 0.1,
                "a block slower than this is at rest")
          .real("still_share", "", share_range(), 0.001,
                "mass share that may still move in a pile called still")
          .real("fastest_allowed", "m/s", Range::left_open(0.0, 1e5), 2000.0,
                "a faster block stops the run as unstable")
          .real("balance_allowed", "", Range::left_open(0.0, 1e6), 0.1,
                "a larger energy balance error stops the run as unstable")
          .word("scene", {}, "all",
                "region; a block whose centre is outside has left, and no longer keeps the pile "
                "from being still")
          .word("solid", {}, "none",
                "region where no rock can come to be, such as the ground under a floor; a block "
                "whose centre is inside, but was not at the start, is counted and warned about");
  return args;
}

}  // namespace

const ArgTable& progress_keywords() { return table(); }

FixMuckpileProgress::FixMuckpileProgress(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)), wall_start_(MPI_Wtime()) {
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  every_ = static_cast<int>(args.integer("every"));
  nevery = 1;
  folder_ = args.word("directory");
  phase_ = phase_of(where_, args.word("phase"));
  time_end_ = args.real("time_end");
  still_speed_ = args.real("still_speed");
  still_share_ = args.real("still_share");
  fastest_allowed_ = args.real("fastest_allowed");
  balance_allowed_ = args.real("balance_allowed");
  if (args.word("scene") != "all") scene_ = args.word("scene");
  if (args.word("solid") != "none") solid_ = args.word("solid");
  engine::make_output_folder(*lmp, where_, folder_);
  files_ = RunFiles(*lmp, where_, folder_);
  scalar_flag = vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  extscalar = extvector = 0;
  restart_global = 1;
}

int FixMuckpileProgress::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

void FixMuckpileProgress::init() {
  ledger_ = engine::find_view<EnergyAccount>(*lmp);
  joints_ = engine::find_view<JointDamage>(*lmp);
  blocks_ = engine::find_view<KnownBlocks>(*lmp);
  if (ledger_ == nullptr) engine::stop(*lmp, where_ + ": needs a fix muckpile/ledger");
  // Its sums begin with its set-up, and fixes are set up in their order.
  if (engine::place_of<EnergyAccount>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, where_ + ": must be defined after fix muckpile/ledger");
  if (blocks_ == nullptr) engine::stop(*lmp, where_ + ": needs create_blocks before the first run");
  if (!scene_.empty()) engine::require_region(*lmp, where_, scene_);
  if (!solid_.empty()) engine::require_region(*lmp, where_, solid_);
}

void FixMuckpileProgress::setup(int) {
  phase_wall_start_ = MPI_Wtime();
  phase_time_start_ = update->get_cur_time();
  look_if_due();
}

void FixMuckpileProgress::end_of_step() {
  files_.begin(blocks_->run_id(), last_ < 0 ? update->ntimestep : last_);
  look_if_due();
}

void FixMuckpileProgress::look_if_due() {
  if (update->ntimestep % every_ != 0 || last_ == update->ntimestep) return;
  const RunLook now = look();
  stop_if_wrong(now);
  write_history(now);
  warn_of_solid(now);
  warn_of_gone(now);
  if (comm->me == 0) say(now);
}

void FixMuckpileProgress::post_run() {
  files_.begin(blocks_->run_id(), last_ < 0 ? update->ntimestep : last_);
  const RunLook now = look();
  stop_if_wrong(now);
  if (last_ != update->ntimestep) write_history(now);
  warn_of_solid(now);
  warn_of_gone(now);
  write_run(now);
}

RunLook FixMuckpileProgress::look() {
  RunLook now;
  now.step = update->ntimestep;
  now.timestep = update->dt;
  now.time = update->get_cur_time();
  now.fastest = ledger_->fastest_block();
  look_at_blocks(now);
  now.bodies = engine::find_multisphere(*lmp)->n_body_all();
  now.balance = ledger_->balance_error();
  if (joints_ != nullptr) {
    now.joints = blocks_->facets_created();
    now.broken = joints_->joints_broken();
  }
  return now;
}

void FixMuckpileProgress::look_at_blocks(RunLook& now) const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  std::array<double, 5> sums{};
  auto& [moving, mass, gone, gone_mass, in_solid] = sums;
  for (int b = 0; b < bodies.count(); ++b) {
    mass += bodies.mass(b);
    if (has_entered_solid(bodies, b)) in_solid += 1.0;
    if (!scene_.empty() && !engine::in_region(*lmp, scene_, bodies.centre(b))) {
      gone += 1.0;
      gone_mass += bodies.mass(b);
    } else if (bodies.velocity(b).norm() > still_speed_) {
      moving += bodies.mass(b);
    }
  }
  engine::sum_over_ranks_in_place(sums, world);
  now.moving_share = mass > 0.0 ? moving / mass : 0.0;
  now.gone = gone;
  now.gone_mass = gone_mass;
  now.in_solid = in_solid;
}

bool FixMuckpileProgress::has_entered_solid(const engine::Bodies& bodies, int b) const {
  if (solid_.empty() || !engine::in_region(*lmp, solid_, bodies.centre(b))) return false;
  const BlockRecord& record = blocks_->records()[static_cast<std::size_t>(b)];
  return record.mass == 0.0 || !engine::in_region(*lmp, solid_, record.start);
}

bool FixMuckpileProgress::still(const RunLook& now) const {
  return now.moving_share < still_share_;
}

void FixMuckpileProgress::stop_if_wrong(const RunLook& now) {
  const std::string at = engine::at_present(*lmp);
  if (!std::isfinite(now.fastest))
    stop_with_restart("a block's velocity is not a number" + at + "; the time step is too long");
  const int blocks = blocks_->blocks_created() - blocks_->blocks_lost_before();
  if (now.bodies < blocks) {
    const int gone = blocks - now.bodies;
    stop_with_restart(std::to_string(gone) + (gone == 1 ? " block is" : " blocks are") + " gone" +
                      at +
                      ": the simulation box is too small, and it was left, or delete_atoms was "
                      "given");
  }
  if (now.fastest > fastest_allowed_) {
    stop_with_restart("the fastest block moves at " + number_text(now.fastest) + " m/s" + at +
                      ", more than fastest_allowed " + number_text(fastest_allowed_) +
                      "; shorten the time step");
  }
  if (!ledger_->balanced(balance_allowed_)) {
    const bool softened = joints_ != nullptr && joints_->softened() < 1.0;
    stop_with_restart("the energy balance error is " + number_text(now.balance) + at +
                      ", more than balance_allowed " + number_text(balance_allowed_) +
                      "; shorten the time step" +
                      (softened ? ", or soften the joints less: they bear what gas is left" : ""));
  }
}

void FixMuckpileProgress::stop_with_restart(const std::string& why) {
  if (update->ntimestep == read_at_)
    engine::stop(*lmp, where_ + ": " + why +
                           ". It is so in the restart file that was read; go on " +
                           "from an earlier one (command restart)");
  engine::stop_with_state(*lmp, where_ + ": " + why);
}

std::string FixMuckpileProgress::write_state() {
  std::string file = folder_ + "/stopped.restart";
  LAMMPS_NS::WriteRestart(lmp).write(file.data());
  return file;
}

void FixMuckpileProgress::say(const RunLook& now) const {
  const double done = now.time - phase_time_start_;
  const double left = done > 0.0 && time_end_ < 1e29 ? (MPI_Wtime() - phase_wall_start_) / done *
                                                           std::max(time_end_ - now.time, 0.0)
                                                     : -1.0;
  engine::print_once(*lmp, progress_line(now, phase_, left));
  if (screen != nullptr) std::fflush(screen);
}

void FixMuckpileProgress::write_restart(FILE* file) {
  engine::write_state(*lmp, style, file, ProgressState{MPI_Wtime() - wall_start_});
}

void FixMuckpileProgress::restart(char* state) {
  wall_start_ -= engine::read_state<ProgressState>(*lmp, style, state).wall_clock;
  read_at_ = update->ntimestep;
}

void FixMuckpileProgress::write_history(const RunLook& now) {
  last_ = update->ntimestep;
  files_.add_row(history_row(now, phase_, ledger_->ledger(), blocks_->run_id()));
}

void FixMuckpileProgress::write_run(const RunLook& now) const {
  RunFacts facts{.spheres = static_cast<std::int64_t>(atom->natoms),
                 .wall_time = MPI_Wtime() - wall_start_,
                 .ranks = comm->nprocs,
                 .still = still(now),
                 .energies = {},
                 .audit = {}};
  if (const auto* blast = engine::find_view<BlastEnergies>(*lmp)) {
    facts.energies = blast->energies();
    facts.audit = blast->audit();
    facts.holes = blast->hole_audits();
  }
  if (const auto* joints = engine::find_view<JointEnergies>(*lmp))
    facts.crushing = engine::sum_over_ranks(joints->energies().crushing, world);
  files_.write_run(run_json(now, facts, *blocks_));
}

double FixMuckpileProgress::compute_scalar() { return still(look()) ? 1.0 : 0.0; }

std::string FixMuckpileProgress::phase_of(const std::string& where,
                                          const std::string& typed) const {
  return engine::or_engine_error(*lmp, [&] { return phase_name(where, "phase", typed); });
}

double FixMuckpileProgress::compute_vector(int n) {
  const RunLook now = look();
  return std::array{now.fastest, now.moving_share, now.gone,
                    now.in_solid}[static_cast<std::size_t>(n)];
}

int FixMuckpileProgress::modify_param(int narg, char** arg) {
  const std::string where = engine::name_of_modify(*this);
  const std::string key = arg[0];
  if (key != "phase" && key != "time_end" && key != "every" && key != "still_share") return 0;
  if (key == "every") {
    every_ = engine::read_every(*lmp, where, narg, arg);
    return 2;
  }
  if (narg < 2) engine::stop(*lmp, where + ": " + key + " needs a value");
  if (key == "phase") phase_ = phase_of(where, arg[1]);
  if (key == "time_end") {
    time_end_ = engine::or_engine_error(
        *lmp, [&] { return parse_real(where, key, arg[1], "s", time_range()); });
  }
  if (key == "still_share") {
    still_share_ = engine::or_engine_error(
        *lmp, [&] { return parse_real(where, key, arg[1], "", share_range()); });
  }
  return 2;
}

}  // namespace muckpile
