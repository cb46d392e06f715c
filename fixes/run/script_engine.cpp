// SPDX-License-Identifier: GPL-2.0-or-later
// BlastEngine on LIGGGHTS.
// Scope: see the header. What it reads are the interfaces of the styles.
#include "fixes/run/script_engine.h"

#include <comm.h>
#include <error.h>
#include <fix.h>
#include <input.h>
#include <modify.h>
#include <output.h>
#include <signal_handling.h>
#include <thermo.h>
#include <update.h>

#include <cstdio>
#include <cstring>

#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/blast_energies.h"
#include "fixes/interfaces/blast_surface.h"
#include "fixes/interfaces/energy_account.h"
#include "fixes/interfaces/joint_energies.h"
#include "fixes/interfaces/joint_pressure.h"

namespace muckpile {
namespace {

using LAMMPS_NS::Fix;

/// As long as a number of LIGGGHTS' own variables.
std::string text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.15g", value);
  return digits;
}

}  // namespace

ScriptEngine::ScriptEngine(LAMMPS_NS::LAMMPS* engine, const ArgValues& words)
    : Pointers(engine),
      words_(words),
      directory_(words.word("directory")),
      surface_(engine::find_view<BlastSurface>(*lmp)),
      joints_(engine::find_view<JointEnergies>(*lmp)),
      blast_(engine::find_view<BlastEnergies>(*lmp)),
      gas_(engine::find_view<JointPressure>(*lmp)) {}

double ScriptEngine::time() const { return update->get_cur_time(); }
double ScriptEngine::step() const { return update->dt; }
double ScriptEngine::stiffness() const { return surface_->softened(); }
double ScriptEngine::elastic_energy() const {
  return engine::sum_over_ranks(joints_->energies().elastic, world);
}
double ScriptEngine::kinetic_energy() const { return account_->ledger().kinetic; }
double ScriptEngine::blast_work() const {
  return engine::sum_over_ranks(surface_->pressure_work(), world);
}
double ScriptEngine::wall_pressure() const { return blast_->greatest_pressure(); }
double ScriptEngine::joint_pressure() const {
  return gas_ == nullptr ? 0.0 : gas_->greatest_in_joints();
}
bool ScriptEngine::still() const { return progress_->compute_scalar() > 0.5; }

/// A signal may reach some ranks only, or later.
bool ScriptEngine::interrupted() const {
  return engine::on_any_rank(LAMMPS_NS::SignalHandler::request_quit, world);
}

void ScriptEngine::prepare(const PhaseNews& first, const StepRule& rule) {
  make("muckpile/ledger", "energy", "");
  own_snapshots_ = make("muckpile/dump", "snapshots", "every 1000000 directory " + directory_);
  own_progress_ = make("muckpile/progress", "progress",
                       "every " + std::to_string(first.lines_every) + " directory " + directory_ +
                           " phase " + first.name + " time_end " + text(first.ends) +
                           " fastest_allowed 1000 still_share " + text(words_.real("still_share")) +
                           " scene " + words_.word("scene") + " solid " + words_.word("solid"));
  make("muckpile/timestep", "dt",
       "fraction " + text(rule.share) + " dashpot_fraction 2 every 10 joints_every 250");
  account_ = engine::find_view<EnergyAccount>(*lmp);
  progress_ = find("muckpile/progress");
  write_table();
  const long every = words_.integer("restart_every");
  if (every > 0) {
    tell("restart " + std::to_string(every) + " " + directory_ + "/a.restart " + directory_ +
         "/b.restart");
  }
}

/// The table on the screen, unless the script has chosen another.
void ScriptEngine::write_table() const {
  if (output->thermo_every == 0) tell("thermo 1000");
  if (std::strcmp(output->thermo->style, "one") != 0) return;
  tell("thermo_style custom step time dt f_" + id_of("muckpile/timestep") + " f_" +
       id_of("muckpile/joint") + "[2] f_" + id_of("muckpile/progress") + "[1] f_" +
       id_of("muckpile/ledger"));
  tell("thermo_modify lost ignore norm no");
}

void ScriptEngine::set_up() { tell("run 0"); }

/// Without a set-up where no fix or setting has changed since the last run, except how often files
/// are written.
void ScriptEngine::run(long steps, bool afresh) {
  tell("run " + std::to_string(steps) + (afresh ? "" : " pre no"));
}

void ScriptEngine::bound_step(const StepRule& rule) {
  std::string words = " fraction " + text(rule.share);
  if (rule.collision) {
    words +=
        " collision " + text(*rule.collision) + " collision_speed " + text(rule.collision_speed);
  }
  if (rule.longest) words += " max " + text(*rule.longest);
  tell("fix_modify " + id_of("muckpile/timestep") + words);
}

void ScriptEngine::soften(double factor, std::optional<double> damping) {
  tell("fix_modify " + id_of("muckpile/joint") + " soften " + text(factor) +
       (damping ? " damping " + text(*damping) : ""));
}

void ScriptEngine::begin_phase(const PhaseNews& news) {
  tell("fix_modify " + id_of("muckpile/progress") + " phase " + news.name + " time_end " +
       text(news.ends) +
       (own_progress_ ? " every " + std::to_string(news.lines_every) : std::string()));
}

void ScriptEngine::take_snapshots_every(long steps) {
  if (own_snapshots_)
    tell("fix_modify " + id_of("muckpile/dump") + " every " + std::to_string(steps));
}

void ScriptEngine::let_blocks_rest() {
  make("muckpile/sleep", "sleep", "distance " + text(words_.real("sleep_distance")));
}

void ScriptEngine::say(const std::string& line) { engine::print_once(*lmp, line + "\n"); }

void ScriptEngine::warn(const std::string& line) {
  if (comm->me == 0) error->warning(FLERR, ("run_blast: " + line).c_str());
}

void ScriptEngine::tell(const std::string& command) const { input->one(command.c_str()); }

Fix* ScriptEngine::find(const std::string& style) const {
  return modify->find_fix_style_strict(style.c_str(), 0);
}

std::string ScriptEngine::id_of(const std::string& style) const { return find(style)->id; }

bool ScriptEngine::make(const std::string& style, const std::string& id,
                        const std::string& words) const {
  if (find(style) != nullptr) return false;
  tell("fix " + id + " all " + style + " " + words);
  return true;
}

}  // namespace muckpile
