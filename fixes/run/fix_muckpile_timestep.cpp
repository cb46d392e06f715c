// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/timestep: words, looks, and what the engine must be told of a new step; the bounds
// are in core/bond/linear/stable_step and core/contact/contact_step_bound.
#include "fixes/run/fix_muckpile_timestep.h"

#include <force.h>
#include <modify.h>
#include <mpi.h>
#include <pair.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "args/numbers.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/keyword_tables.h"
#include "fixes/interfaces/paced_contacts.h"

namespace muckpile {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kUnbounded = 1e29;     // s, a longer step is none
constexpr double kWorthAChange = 1.01;  // a longer step than now by less is not taken
constexpr double kOfSprings = 0.25;     // longest time between acts of contacts over the stable one

enum Output {
  kJointStep,
  kContactStep,
  kStep,
  kChanges,
  kProducts,
  kDashpotStep,
  kCollisionStep,
  kJoinedSpringStep,
  kPace,
  kOutputCount
};

const ArgTable& table() {
  static const ArgTable args =
      ArgTable("fix muckpile/timestep")
          .real("fraction", "", Range::left_open(0.0, 1.0), 0.8, "of the longest stable step")
          .integer("every", "steps", engine::step_counts(), 100, "between checks of the contacts")
          .integer("joints_every", "checks", Range::closed(0, 1000000), 20,
                   "between checks of the joints; 0: as a run is set up and never within")
          .integer("contact_every", "steps", Range::closed(1, 64), 1,
                   "contacts act at every 2nd, 4th, 8th, ... step where they bear it, at most at "
                   "every so many; 1: at each")
          .word("breaking", {"possible", "none"}, "possible",
                "whether joints may break between two checks: a closed broken one is stiffer")
          .real("dashpot_fraction", "", Range::left_open(0.0, 4.0), 0.8,
                "of the longest stable step with the dashpots of sphere contacts")
          .real("collision", "s", Range::left_open(0.0, 1e30), 1e30,
                "step that resolves a collision of blocks; without: as pair muckpile/block says")
          .real("collision_speed", "m/s", Range::closed(0.0, 1e4), 0.0,
                "of that collision; it follows the fastest block at each check. 0: it does not")
          .real("min", "s", Range::closed(0.0, 1.0), 0.0, "a step shorter than this stops the run")
          .real("max", "s", Range::left_open(0.0, 1e30), 1e30, "the step is never longer");
  return args;
}

/// Cut to three digits, so that the step is the same on any number of ranks although the bound
/// differs by rounding.
double three_digits(double step) {
  const double unit = std::pow(10.0, std::floor(std::log10(step)) - 2.0);
  return std::floor(step / unit * (1.0 + 1e-9)) * unit;
}

/// At worst joints and contacts act on the same block: their stiffnesses, which go with 1/step^2,
/// add.
double acting_together(double joints, double contacts) {
  return 1.0 / std::sqrt(1.0 / (joints * joints) + 1.0 / (contacts * contacts));
}

}  // namespace

const ArgTable& timestep_keywords() { return table(); }

FixMuckpileTimestep::FixMuckpileTimestep(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)) {
  look_.joint_step = kInfinity;
  look_.contact_steps.fill(kInfinity);
  engine::refuse_second_fix(*lmp, where_, "muckpile/timestep");
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  settings_.fraction = args.real("fraction");
  settings_.collision = args.real("collision");
  settings_.collision_speed = args.real("collision_speed");
  settings_.shortest = args.real("min");
  settings_.longest = args.real("max");
  if (settings_.shortest > settings_.longest) engine::stop(*lmp, where_ + ": min must be <= max");
  settings_.joints_every = static_cast<int>(args.integer("joints_every"));
  settings_.contact_every = static_cast<int>(args.integer("contact_every"));
  settings_.breaking = args.word("breaking") == "none" ? Breaking::none : Breaking::possible;
  settings_.dashpot_fraction = args.real("dashpot_fraction");
  nevery = settings_.every = static_cast<int>(args.integer("every"));
  restart_global = 1;
  time_depend = 1;  // the engine's clock counts steps of equal length otherwise
  scalar_flag = vector_flag = 1;
  size_vector = kOutputCount;
  global_freq = 1;
  extscalar = extvector = 0;
}

int FixMuckpileTimestep::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

/// An unfix: nobody looks any more whether contacts bear it.
void FixMuckpileTimestep::pre_delete(bool unfixflag) {
  if (unfixflag) set_pace(1);
}

void FixMuckpileTimestep::init() {
  if (modify->find_fix_style_strict("multisphere/muckpile", 0) == nullptr) {
    engine::stop(*lmp, where_ +
                           ": needs fix multisphere/muckpile; LIGGGHTS' own fix multisphere "
                           "keeps the step that a run began with");
  }
  if (settings_.collision_speed > 0.0 && settings_.collision >= 1e30)
    engine::stop(*lmp, where_ + ": collision_speed needs collision, the step at that speed");
  joints_ = engine::find_view<StepLimit>(*lmp);
  if (engine::place_of<StepLimit>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, where_ + ": must be defined after fix muckpile/joint");
}

/// Forces are up to date here, and with them poses and contacts.
void FixMuckpileTimestep::setup(int) {
  set_up_ = true;
  if (goes_on_unchanged()) {
    if (wanted() <= kUnbounded && update->dt != then_.step) set_step(then_.step);
    if (then_.within_run) return;
  }
  read_at_ = -1;
  if (joints_ != nullptr && joints_->stiffness_changes() != known_changes_)
    look_.since_joints = settings_.joints_every;
  if (look_.since_joints >= settings_.joints_every) look_at_joints();
  look_at_contacts();
  choose();
}

void FixMuckpileTimestep::end_of_step() {
  ++look_.since_joints;
  if (settings_.joints_every > 0 && look_.since_joints >= settings_.joints_every) look_at_joints();
  if (++look_.since_contacts >= look_.pace)
    look_at_contacts();  // as often as they act `every` times
  choose();
}

void FixMuckpileTimestep::look_at_joints() {
  look_.since_joints = 0;
  if (joints_ == nullptr) return;
  known_changes_ = joints_->stiffness_changes();
  const StepBound bound = joints_->stable_step(settings_.breaking, look_.joint_step);
  look_.joint_step = bound.seconds;
  products_ += bound.products;
}

void FixMuckpileTimestep::look_at_contacts() {
  look_.since_contacts = 0;
  int dimension = 0;
  const void* found = force->pair == nullptr ? nullptr : force->pair->extract("steps_s", dimension);
  std::array<double, kContactSteps>& mine = look_.contact_steps;
  mine.fill(kInfinity);
  if (found != nullptr) std::copy_n(static_cast<const double*>(found), mine.size(), mine.begin());
  engine::least_over_ranks_in_place(mine, world);
  if (settings_.collision_speed > 0.0) look_for_fastest_block();
}

void FixMuckpileTimestep::look_for_fastest_block() {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  double fastest = 0.0;
  for (int b = 0; b < bodies.count(); ++b) fastest = std::max(fastest, bodies.velocity(b).norm());
  look_.fastest = engine::greatest_over_ranks(fastest, world);
}

/// Blocks without joints have their contacts alone. At worst a joined block has the stiffest
/// contacts and the stiffest joints: the two stiffnesses, which go with 1/step^2, add.
double FixMuckpileTimestep::longest_stable(ContactStep free, ContactStep joined) const {
  return std::min(look_.contact_steps[free],
                  acting_together(look_.joint_step, look_.contact_steps[joined]));
}

double FixMuckpileTimestep::springs_bear() const {
  return longest_stable(kFreeSprings, kJoinedSprings);
}

double FixMuckpileTimestep::dashpots_bear() const {
  return longest_stable(kFreeContacts, kJoinedContacts);
}

/// Resolves a collision; that is a matter of accuracy, so neither joints nor a share come on top.
/// It lasts the longer the slower it is, by Hertz with speed^(-1/5).
double FixMuckpileTimestep::longest_resolving() const {
  if (settings_.collision >= 1e30) return look_.contact_steps[kCollisions];
  if (settings_.collision_speed == 0.0) return settings_.collision;
  return look_.fastest > 0.0
             ? settings_.collision * std::pow(settings_.collision_speed / look_.fastest, 0.2)
             : kInfinity;
}

double FixMuckpileTimestep::wanted() const {
  return std::min({settings_.fraction * springs_bear(),
                   settings_.dashpot_fraction * dashpots_bear(), longest_resolving(),
                   settings_.longest, cap_});
}

void FixMuckpileTimestep::choose() {
  if (wanted() > kUnbounded) return set_pace(pace());  // nothing holds it: as it is
  const double step = three_digits(wanted());
  if (!(step >= settings_.shortest)) {
    engine::stop(*lmp, where_ + ": the step must be " + number_text(step) + " s at step " +
                           std::to_string(update->ntimestep) + ", shorter than min " +
                           number_text(settings_.shortest) + " s (joints bear " +
                           number_text(look_.joint_step) + " s, with contacts " +
                           number_text(springs_bear()) + " s, with their dashpots " +
                           number_text(dashpots_bear()) + " s, collisions are resolved at " +
                           number_text(longest_resolving()) + " s)");
  }
  const bool longer = step > kWorthAChange * update->dt;
  const auto* const contacts = dynamic_cast<const PacedContacts*>(force->pair);
  // The second half of their kick is still to come: the next look may.
  const bool waits = longer && contacts != nullptr && contacts->act_for_several();
  if (!waits && (step < update->dt || longer)) set_step(step);
  set_pace(pace());
}

void FixMuckpileTimestep::set_pace(int steps) {
  look_.pace = steps;
  if (auto* const contacts = dynamic_cast<PacedContacts*>(force->pair)) contacts->act_every(steps);
}

/// Apart from joints contacts bear, and resolve collisions with, a longer step than the present
/// one.
int FixMuckpileTimestep::pace() const {
  const std::array<double, kContactSteps>& bear = look_.contact_steps;
  const double longest =
      std::min({kOfSprings * bear[kFreeSprings], kOfSprings * bear[kJoinedSprings],
                bear[kFreeContacts], bear[kJoinedContacts], longest_resolving()});
  int steps = 1;
  while (2 * steps <= settings_.contact_every && 2.0 * steps * update->dt <= longest) steps *= 2;
  return steps;
}

void FixMuckpileTimestep::set_step(double step) {
  ++changes_;
  update->update_time();
  update->dt = step;
  if (force->pair != nullptr) force->pair->reset_dt();
  for (int i = 0; i < modify->nfix; ++i) modify->fix[i]->reset_dt();
}

double FixMuckpileTimestep::compute_scalar() { return springs_bear() / update->dt; }

double FixMuckpileTimestep::compute_vector(int n) {
  switch (n) {
    case kJointStep:
      return look_.joint_step;
    case kContactStep:
      return std::min(look_.contact_steps[kFreeSprings], look_.contact_steps[kJoinedSprings]);
    case kStep:
      return update->dt;
    case kChanges:
      return changes_;
    case kProducts:
      return products_;
    case kDashpotStep:
      return std::min(look_.contact_steps[kFreeContacts], look_.contact_steps[kJoinedContacts]);
    case kCollisionStep:
      return look_.contact_steps[kCollisions];
    case kJoinedSpringStep:
      return look_.contact_steps[kJoinedSprings];
    case kPace:
      return look_.pace;
    default:
      return 0.0;
  }
}

int FixMuckpileTimestep::modify_param(int narg, char** arg) {
  const std::string where = engine::name_of_modify(*this);
  const std::string key = arg[0];
  static const std::array known{"fraction",      "max",       "cap",
                                "contact_every", "collision", "collision_speed"};
  if (std::ranges::find(known, key) == known.end()) return 0;
  if (narg < 2) engine::stop(*lmp, where + ": " + key + " needs a value");
  engine::or_engine_error(*lmp, [&] {
    if (key == "fraction")
      settings_.fraction = parse_real(where, key, arg[1], "", Range::left_open(0.0, 1.0));
    if (key == "collision")
      settings_.collision = parse_real(where, key, arg[1], "s", Range::left_open(0.0, 1e30));
    if (key == "collision_speed")
      settings_.collision_speed = parse_real(where, key, arg[1], "m/s", Range::closed(0.0, 1e4));
    if (key == "contact_every")
      settings_.contact_every =
          static_cast<int>(parse_integer(where, key, arg[1], "steps", Range::closed(1, 64)));
    if (key == "max")
      settings_.longest = parse_real(where, key, arg[1], "s", Range::left_open(0.0, 1e30));
    if (key == "cap") cap_ = parse_real(where, key, arg[1], "s", Range::left_open(0.0, 1e30));
    return 0;
  });
  // A run without a set-up looks after `every` steps only.
  const double longest = std::min(settings_.longest, cap_);
  if (set_up_ && three_digits(longest) < update->dt) set_step(three_digits(longest));
  return 2;
}

void FixMuckpileTimestep::write_restart(FILE* file) {
  const bool within_run = update->whichflag != 0 && update->ntimestep < update->laststep;
  const StepState state{settings_, update->dt, within_run, look_, changes_, products_};
  engine::write_state(*lmp, style, file, state);
}

/// The joints have been read before: what changes their stiffness from here on is new.
void FixMuckpileTimestep::restart(char* bytes) {
  then_ = engine::read_state<StepState>(*lmp, style, bytes);
  look_ = then_.look;
  changes_ = then_.changes;
  products_ = then_.products;
  read_at_ = update->ntimestep;
  update->dt = then_.step;
  joints_ = engine::find_view<StepLimit>(*lmp);
  if (joints_ != nullptr) known_changes_ = joints_->stiffness_changes();
}

/// Then the step is that of the restart file, and if that was written within a run, so are the
/// looks: that run did not look once more.
bool FixMuckpileTimestep::goes_on_unchanged() const {
  return update->ntimestep == read_at_ && settings_ == then_.settings && then_.step <= cap_ &&
         (joints_ == nullptr || joints_->stiffness_changes() == known_changes_);
}

}  // namespace muckpile
