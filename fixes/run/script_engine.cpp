// SPDX-License-Identifier: GPL-2.0-or-later
// RunEngine on LIGGGHTS.
// Scope: see the header.
#include "fixes/run/script_engine.h"

#include <comm.h>
#include <error.h>
#include <force.h>
#include <output.h>
#include <pair.h>
#include <signal_handling.h>
#include <thermo.h>
#include <update.h>

#include <cstring>
#include <utility>

#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/paced_contacts.h"
#include "fixes/run/script_words.h"

namespace muckpile {

namespace {

std::string words_of_collision(const StepRule& rule) {
  if (!rule.collision) return {};
  return " collision " + script_number(*rule.collision) + " collision_speed " +
         script_number(rule.collision_speed);
}

}  // namespace

bool ScriptEngine::has_been_cut_ = false;

ScriptEngine::ScriptEngine(LAMMPS_NS::LAMMPS* engine, std::string command, const ArgValues& words)
    : Pointers(engine),
      command_(std::move(command)),
      words_(words),
      directory_(words.word("directory")) {}

double ScriptEngine::time() const { return update->get_cur_time(); }
double ScriptEngine::step() const { return update->dt; }
bool ScriptEngine::still() const { return progress_->compute_scalar() > 0.5; }

/// A signal may reach some ranks only, or later.
bool ScriptEngine::interrupted() const {
  return engine::on_any_rank(LAMMPS_NS::SignalHandler::request_quit, world);
}

void ScriptEngine::prepare(const PhaseNews& first, const StepRule& rule) {
  make_fix(*lmp, "muckpile/ledger", "energy", "");
  own_snapshots_ =
      make_fix(*lmp, "muckpile/dump", "snapshots",
               "every 1000000 directory " + directory_ + " form " + words_.word("snapshot_form"));
  own_progress_ = make_fix(*lmp, "muckpile/progress", "progress",
                           "every " + std::to_string(first.lines_every) + " directory " +
                               directory_ + " phase " + first.name + " time_end " +
                               script_number(first.ends) + " fastest_allowed 1000 still_share " +
                               script_number(words_.real("still_share")) + " scene " +
                               words_.word("scene") + " solid " + words_.word("solid"));
  make_fix(*lmp, "muckpile/timestep", "dt",
           "fraction " + script_number(rule.share) +
               " dashpot_fraction 2 every 10 joints_every 250 contact_every " +
               std::to_string(rule.contact_every.value_or(1)) + words_of_collision(rule));
  progress_ = fix_of(*lmp, "muckpile/progress");
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
  const bool joined = fix_of(*lmp, "muckpile/joint") != nullptr;
  tell("thermo_style custom step time dt f_" + id_of("muckpile/timestep") +
       (joined ? " f_" + id_of("muckpile/joint") + "[2]" : std::string()) + " f_" +
       id_of("muckpile/progress") + "[1] f_" + id_of("muckpile/ledger"));
  tell("thermo_modify lost ignore norm no");
}

/// A step for which contacts act for several cannot become longer: one more.
void ScriptEngine::set_up() {
  const auto* const contacts = dynamic_cast<const PacedContacts*>(force->pair);
  if (contacts != nullptr && contacts->act_for_several()) tell("run 1 pre no");
  tell("run 0");
}

/// Without a set-up where no fix or setting has changed since the last run, except how often files
/// are written and how long the step may become. The engine writes its state at the first output
/// behind a signal: one that has come behind the last output of these steps, on whatever rank, gets
/// one step more.
void ScriptEngine::run(long steps, bool afresh) {
  tell("run " + std::to_string(steps) + (afresh ? "" : " pre no"));
  namespace signals = LAMMPS_NS::SignalHandler;
  if (!engine::on_any_rank(signals::request_quit && signals::request_write_restart, world)) return;
  signals::request_quit = signals::request_write_restart = true;
  tell("run 1 pre no");
}

void ScriptEngine::bound_step(const StepRule& rule) {
  std::string words = " fraction " + script_number(rule.share) + words_of_collision(rule);
  if (rule.longest) words += " max " + script_number(*rule.longest);
  if (rule.contact_every) words += " contact_every " + std::to_string(*rule.contact_every);
  tell("fix_modify " + id_of("muckpile/timestep") + words);
}

void ScriptEngine::cap_step(double longest) {
  tell("fix_modify " + id_of("muckpile/timestep") + " cap " + script_number(longest));
}

/// A fix of the script, or of a command before, keeps the share that it has unless one is typed.
void ScriptEngine::begin_phase(const PhaseNews& news) {
  tell("fix_modify " + id_of("muckpile/progress") + " phase " + news.name + " time_end " +
       script_number(news.ends) +
       (words_.given("still_share") ? " still_share " + script_number(words_.real("still_share"))
                                    : std::string()) +
       (own_progress_ ? " every " + std::to_string(news.lines_every) : std::string()));
}

void ScriptEngine::take_snapshots_every(long steps) {
  if (own_snapshots_)
    tell("fix_modify " + id_of("muckpile/dump") + " every " + std::to_string(steps));
}

void ScriptEngine::say(const std::string& line) { engine::print_once(*lmp, line + "\n"); }

void ScriptEngine::warn(const std::string& line) {
  if (comm->me == 0) error->warning(FLERR, (command_ + ": " + line).c_str());
}

void ScriptEngine::tell(const std::string& line) const { tell_script(*lmp, line); }

std::string ScriptEngine::id_of(const std::string& style) const { return fix_of(*lmp, style)->id; }

}  // namespace muckpile
