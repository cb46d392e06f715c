// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/timestep: words, looks, and what the engine must be told of a new step; the bounds
// are in core/bond/stable_step and core/contact/contact_step_bound.
#include "fix_muckpile_timestep.h"

#include <force.h>
#include <modify.h>
#include <mpi.h>
#include <pair.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "args/numbers.h"
#include "engine/bodies.h"
#include "engine/single_fix.h"
#include "engine/style_args.h"
#include "fix_multisphere_muckpile.h"

namespace muckpile {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kWorthAChange = 1.01;  // a longer step than now by less is not taken

enum Output {
  kJointStep,
  kContactStep,
  kStep,
  kChanges,
  kProducts,
  kDashpotStep,
  kCollisionStep,
  kOutputCount
};

const ArgTable& table() {
  static const ArgTable args =
      ArgTable("fix muckpile/timestep")
          .real("fraction", "", Range::left_open(0.0, 1.0), 0.8, "of the longest stable step")
          .integer("every", "steps", engine::step_counts(), 100, "between looks at the contacts")
          .integer("joints_every", "looks", Range::closed(0, 1000000), 20,
                   "between looks at the joints; 0: at the start of each run and never within")
          .word("breaking", {"possible", "none"}, "possible",
                "whether joints may break between two looks: a closed broken one is stiffer")
          .real("dashpot_fraction", "", Range::left_open(0.0, 4.0), 0.8,
                "of the longest stable step with the dashpots of sphere contacts")
          .real("collision", "s", Range::left_open(0.0, 1e30), 1e30,
                "step that resolves a collision of blocks; without: as pair muckpile/block says")
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

FixMuckpileTimestep::FixMuckpileTimestep(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg),
      where_(std::string("fix muckpile/timestep '") + (narg > 0 ? arg[0] : "") + "'"),
      joint_step_(kInfinity) {
  contact_steps_.fill(kInfinity);
  engine::refuse_second_fix(*lmp, where_, "muckpile/timestep");
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  fraction_ = args.real("fraction");
  collision_ = args.real("collision");
  shortest_ = args.real("min");
  longest_ = args.real("max");
  if (shortest_ > longest_) engine::stop(*lmp, where_ + ": min must be <= max");
  joints_every_ = static_cast<int>(args.integer("joints_every"));
  breaking_ = args.word("breaking") == "none" ? Breaking::none : Breaking::possible;
  dashpot_fraction_ = args.real("dashpot_fraction");
  nevery = static_cast<int>(args.integer("every"));
  time_depend = 1;  // the engine's clock counts steps of equal length otherwise
  scalar_flag = vector_flag = 1;
  size_vector = kOutputCount;
  global_freq = 1;
  extscalar = extvector = 0;
}

int FixMuckpileTimestep::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

void FixMuckpileTimestep::init() {
  if (dynamic_cast<FixMultisphereMuckpile*>(engine::find_multisphere(*lmp)) == nullptr) {
    engine::stop(*lmp, where_ +
                           ": needs fix multisphere/muckpile; LIGGGHTS' own fix multisphere "
                           "keeps the step that a run began with");
  }
  joints_ = nullptr;
  for (int i = 0; i < modify->nfix; ++i) {
    auto* joints = dynamic_cast<StepLimit*>(modify->fix[i]);
    if (joints == nullptr) continue;
    joints_ = joints;
    if (i > modify->find_fix(id))
      engine::stop(*lmp, where_ + ": must be defined after fix muckpile/joint");
  }
}

/// Forces are up to date here, and with them poses and contacts.
void FixMuckpileTimestep::setup(int) {
  if (joints_ != nullptr && joints_->stiffness_changes() != known_changes_) looks_ = joints_every_;
  if (looks_ >= joints_every_) look_at_joints();
  look_at_contacts();
  choose();
}

void FixMuckpileTimestep::end_of_step() {
  ++looks_;
  if (joints_every_ > 0 && looks_ >= joints_every_) look_at_joints();
  look_at_contacts();
  choose();
}

void FixMuckpileTimestep::look_at_joints() {
  looks_ = 0;
  if (joints_ == nullptr) return;
  known_changes_ = joints_->stiffness_changes();
  const StepBound bound = joints_->stable_step(breaking_, joint_step_);
  joint_step_ = bound.seconds;
  products_ += bound.products;
}

void FixMuckpileTimestep::look_at_contacts() {
  int dimension = 0;
  const void* found = force->pair == nullptr ? nullptr : force->pair->extract("steps_s", dimension);
  std::array<double, kContactSteps> mine{};
  mine.fill(kInfinity);
  if (found != nullptr) std::copy_n(static_cast<const double*>(found), mine.size(), mine.begin());
  MPI_Allreduce(mine.data(), contact_steps_.data(), kContactSteps, MPI_DOUBLE, MPI_MIN, world);
}

double FixMuckpileTimestep::longest_stable(ContactStep of) const {
  return acting_together(joint_step_, contact_steps_[of]);
}

/// Step that resolves a collision between two looks. The joints of its blocks add to the stiffness
/// of the collision as they add to that of the present contacts.
double FixMuckpileTimestep::longest_resolving() const {
  const double collision = collision_ < 1e30 ? collision_ : contact_steps_[kCollisions];
  return acting_together(fraction_ * joint_step_,
                         std::min(fraction_ * contact_steps_[kStableSprings], collision));
}

void FixMuckpileTimestep::choose() {
  const double wanted = std::min(
      {longest_resolving(), dashpot_fraction_ * longest_stable(kStableContacts), longest_});
  if (wanted > 1e29) return;  // nothing holds it: as it is
  const double step = three_digits(wanted);
  if (!(step >= shortest_)) {
    engine::stop(*lmp, where_ + ": the step must be " + number_text(step) + " s at step " +
                           std::to_string(update->ntimestep) + ", shorter than min " +
                           number_text(shortest_) + " s (joints bear " + number_text(joint_step_) +
                           " s, contacts " + number_text(contact_steps_[kStableSprings]) +
                           " s, with dashpots " + number_text(contact_steps_[kStableContacts]) +
                           " s, collisions are resolved at " + number_text(longest_resolving()) +
                           " s)");
  }
  if (step < update->dt || step > kWorthAChange * update->dt) set_step(step);
}

void FixMuckpileTimestep::set_step(double step) {
  ++changes_;
  update->update_time();
  update->dt = step;
  if (force->pair != nullptr) force->pair->reset_dt();
  for (int i = 0; i < modify->nfix; ++i) modify->fix[i]->reset_dt();
}

double FixMuckpileTimestep::compute_scalar() { return longest_stable(kStableSprings) / update->dt; }

double FixMuckpileTimestep::compute_vector(int n) {
  switch (n) {
    case kJointStep:
      return joint_step_;
    case kContactStep:
      return contact_steps_[kStableSprings];
    case kStep:
      return update->dt;
    case kChanges:
      return changes_;
    case kProducts:
      return products_;
    case kDashpotStep:
      return contact_steps_[kStableContacts];
    case kCollisionStep:
      return contact_steps_[kCollisions];
    default:
      return 0.0;
  }
}

int FixMuckpileTimestep::modify_param(int narg, char** arg) {
  const std::string where = std::string("fix_modify ") + id;
  const std::string key = arg[0];
  if (key != "fraction" && key != "max" && key != "collision") return 0;
  if (narg < 2) engine::stop(*lmp, where + ": " + key + " needs a value");
  engine::or_engine_error(*lmp, [&] {
    if (key == "fraction")
      fraction_ = parse_real(where, key, arg[1], "", Range::left_open(0.0, 1.0));
    if (key == "collision")
      collision_ = parse_real(where, key, arg[1], "s", Range::left_open(0.0, 1e30));
    if (key == "max") longest_ = parse_real(where, key, arg[1], "s", Range::left_open(0.0, 1e30));
    return 0;
  });
  return 2;
}

}  // namespace muckpile
