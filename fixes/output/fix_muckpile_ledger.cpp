// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/ledger: sums the energies that the other styles keep, and the work of walls.
// Scope: walls are found by difference: the work of all forces on spheres less that of the contact
// style, measured from its forces. What the contact style says it stored and lost faces that work.
#include "fixes/output/fix_muckpile_ledger.h"

#include <atom.h>
#include <fix_gravity.h>
#include <fix_multisphere.h>
#include <force.h>
#include <modify.h>
#include <multisphere.h>
#include <pair.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/engine/walls.h"
#include "fixes/interfaces/contact_work.h"
#include "fixes/interfaces/given_energy.h"
#include "fixes/interfaces/joint_energies.h"
#include "fixes/interfaces/resting_blocks.h"

namespace muckpile {
namespace {

constexpr std::array kColumns = {
    &EnergyLedger::kinetic,         &EnergyLedger::joint_elastic, &EnergyLedger::contact_elastic,
    &EnergyLedger::gravity,         &EnergyLedger::blast_work,    &EnergyLedger::fracture,
    &EnergyLedger::joint_friction,  &EnergyLedger::joint_damping, &EnergyLedger::contact_friction,
    &EnergyLedger::contact_damping, &EnergyLedger::walls,         &EnergyLedger::quiet,
    &EnergyLedger::sleep,           &EnergyLedger::given};

/// What fixes and contact styles leave behind as they end.
constexpr std::array kKept = {
    &EnergyLedger::contact_friction, &EnergyLedger::contact_damping, &EnergyLedger::fracture,
    &EnergyLedger::joint_friction,   &EnergyLedger::joint_damping,   &EnergyLedger::quiet,
    &EnergyLedger::blast_work,       &EnergyLedger::sleep,           &EnergyLedger::joint_elastic};
static_assert(kKept.size() == std::tuple_size_v<decltype(LedgerState::former)>);

/// What is in the system or came into it, each of which may be the largest.
constexpr std::array kSources = {&EnergyLedger::kinetic,         &EnergyLedger::joint_elastic,
                                 &EnergyLedger::contact_elastic, &EnergyLedger::gravity,
                                 &EnergyLedger::blast_work,      &EnergyLedger::given};

}  // namespace

FixMuckpileLedger::FixMuckpileLedger(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg) {
  const std::string where = engine::name_of(*this);
  if (narg != 3) engine::stop(*lmp, where + ": takes no keywords, got '" + arg[3] + "'");
  engine::require_id_of_restart(*lmp, where, *this);
  multisphere_ = engine::find_multisphere(*lmp);
  if (multisphere_ == nullptr)
    engine::stop(*lmp, where + ": needs 'fix ID all multisphere' before it");
  scalar_flag = vector_flag = 1;
  size_vector = static_cast<int>(kColumns.size());
  global_freq = 1;
  extscalar = extvector = 0;
  nevery = 1;
  restart_global = 1;
}

int FixMuckpileLedger::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

void FixMuckpileLedger::init() {
  gravity_ = static_cast<LAMMPS_NS::FixGravity*>(modify->find_fix_style("gravity", 0));
  joints_ = engine::find_view<JointEnergies>(*lmp);
  if (!had_a_run_) require_joints_before();
  sleep_ = engine::find_view<RestingBlocks>(*lmp);
  contacts_ = dynamic_cast<ContactWork*>(force->pair);
  if (contacts_ != nullptr) contacts_->watch();
  keep_books_of_contacts();
  keep_books_of_former_sleep();
  walls_may_move_ = !engine::walls_stand_still(*lmp);
}

/// What joints hold is known from their set-up on, and fixes are set up in their order.
void FixMuckpileLedger::require_joints_before() const {
  if (engine::place_of<JointEnergies>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, engine::name_of(*this) + ": must be defined after fix muckpile/joint");
}

/// A pair style that is given anew begins its books anew.
void FixMuckpileLedger::keep_books_of_contacts() {
  if (of_pair("friction_J") != 0.0 || of_pair("damping_J") != 0.0) return;
  former_.contact_friction += contact_losses_[0];
  former_.contact_damping += contact_losses_[1];
  contact_losses_ = {};
}

void FixMuckpileLedger::keep_books_of_joints(const EnergyLedger& ended) {
  for (const auto kept : kKept) former_.*kept += ended.*kept;
  joints_ = nullptr;
  computed_at_ = -1;
}

void FixMuckpileLedger::keep_books_of_sleep(double taken) {
  former_.sleep += taken;
  laid_to_rest_ = 0.0;
  sleep_ = nullptr;
  computed_at_ = -1;
}

/// A fix muckpile/sleep that is given after the first run behind a restart file begins its sum
/// anew.
void FixMuckpileLedger::keep_books_of_former_sleep() {
  if (sleep_ == nullptr || engine::sum_over_ranks(sleep_->energy_taken(), world) != 0.0) return;
  former_.sleep += laid_to_rest_;
  laid_to_rest_ = 0.0;
}

/// A run begins. Joints that no fix has taken over by now hold nothing any more: what they held is
/// lost, as what softening gives up.
void FixMuckpileLedger::let_go_of_joints() {
  if (joints_ == nullptr) former_.fracture += former_.joint_elastic;
  former_.joint_elastic = 0.0;
}

void FixMuckpileLedger::setup(int) {
  had_a_run_ = true;
  computed_at_ = -1;
  let_go_of_joints();
  auto* const before = engine::find_view<GivenEnergy>(*lmp);
  book_given(before != nullptr ? before->take_given() : 0.0);  // before the start: not booked
  if (started_)
    take_in_new_blocks();
  else
    begin();
  computed_at_ = -1;
}

void FixMuckpileLedger::begin() {
  started_ = true;
  take_in_new_blocks();
  const EnergyLedger& now = ledger();
  start_residual_ = now.residual();
}

/// Their weight's potential is neither released nor created. What rounding makes of rock at rest is
/// less than it has at kCreep.
void FixMuckpileLedger::take_in_new_blocks() {
  constexpr double kCreep = 1e-6;  // [m/s]
  const engine::Bodies bodies(*multisphere_);
  Vec3 g = Vec3::Zero();
  if (gravity_ != nullptr) gravity_->get_gravity(g.data());
  double potential = 0.0, creep = 0.0;  // [J]
  int last = last_tag_;
  for (int b = 0; b < bodies.count(); ++b) {
    creep += 0.5 * bodies.mass(b) * kCreep * kCreep;
    if (bodies.tag(b) <= last_tag_) continue;
    potential -= bodies.mass(b) * g.dot(bodies.centre(b));
    last = std::max(last, bodies.tag(b));
  }
  start_gravity_ += engine::sum_over_ranks(potential, world);
  largest_ = std::max(largest_, engine::sum_over_ranks(creep, world));
  last_tag_ = engine::greatest_over_ranks(last, world);
}

void FixMuckpileLedger::book_given(double energy) {
  if (started_) given_ += energy;
  computed_at_ = -1;
}

void FixMuckpileLedger::end_of_step() {
  sphere_work_ += work_rate_of_spheres() * update->dt;
  if (contacts_ != nullptr) contact_work_ += contacts_->end_step(update->dt);
  if (walls_may_move_) walls_before_ = walls();
  contact_losses_ = {of_pair("friction_J"), of_pair("damping_J")};
}

/// Work rate of the forces on bodies other than gravity and joints. Taken at full-step velocities:
/// with them force x velocity x dt is exactly the integrator's change of kinetic energy between
/// half steps.
double FixMuckpileLedger::work_rate_of_spheres() const {
  const engine::Bodies bodies(*multisphere_);
  Vec3 g = Vec3::Zero();
  if (gravity_ != nullptr) gravity_->get_gravity(g.data());
  std::span<const Vec3> joint_forces, joint_torques;
  if (joints_ != nullptr) {
    joint_forces = joints_->joint_forces();
    joint_torques = joints_->joint_torques();
  }
  double rate = 0.0;
  for (int b = 0; b < bodies.count(); ++b) {
    rate += (bodies.force(b) - bodies.mass(b) * g).dot(bodies.velocity(b)) +
            bodies.torque(b).dot(bodies.spin(b));
    if (joint_forces.empty()) continue;
    const auto k = static_cast<std::size_t>(b);
    rate -= joint_forces[k].dot(bodies.velocity(b)) + joint_torques[k].dot(bodies.spin(b));
  }
  return rate;
}

double FixMuckpileLedger::of_pair(const char* name) const {
  int dimension = 0;
  const void* value = force->pair == nullptr ? nullptr : force->pair->extract(name, dimension);
  return value == nullptr ? 0.0 : *static_cast<const double*>(value);
}

const EnergyLedger& FixMuckpileLedger::ledger() {
  if (computed_at_ == update->ntimestep) return ledger_;
  computed_at_ = update->ntimestep;
  EnergyLedger mine = former_;
  const engine::Bodies bodies(*multisphere_);
  Vec3 g = Vec3::Zero();
  if (gravity_ != nullptr) gravity_->get_gravity(g.data());
  for (int b = 0; b < bodies.count(); ++b) {
    mine.kinetic += bodies.kinetic_energy(b);
    mine.gravity -= bodies.mass(b) * g.dot(bodies.centre(b));
  }
  if (joints_ != nullptr) {
    const JointEnergySums joints = joints_->energies();
    mine.joint_elastic = joints.elastic;  // what a fix before has held until the set-up, too
    mine.fracture += joints.fracture;
    mine.joint_friction += joints.friction;
    mine.joint_damping += joints.damping;
    mine.quiet += joints.quiet;
    mine.blast_work += joints.pressure_work;
  }
  if (sleep_ != nullptr) laid_to_rest_ = sleep_->energy_taken();
  mine.sleep += laid_to_rest_;
  mine.contact_elastic = of_pair("elastic_J");
  mine.contact_friction += of_pair("friction_J");
  mine.contact_damping += of_pair("damping_J");
  mine.walls = walls();
  mine.given = given_;
  std::array<double, kColumns.size()> all{};
  for (std::size_t k = 0; k < kColumns.size(); ++k) all[k] = mine.*kColumns[k];
  engine::sum_over_ranks_in_place(all, world);
  for (std::size_t k = 0; k < kColumns.size(); ++k) ledger_.*kColumns[k] = all[k];
  ledger_.gravity -= start_gravity_;
  for (const auto source : kSources) largest_ = std::max(largest_, std::abs(ledger_.*source));
  return ledger_;
}

/// [J]. Walls at rest can only take energy; what they gave while they moved was theirs to give.
double FixMuckpileLedger::out_of_balance() {
  const EnergyLedger& now = ledger();
  const double apart = std::abs(now.residual() - start_residual_);
  if (walls_may_move_) return apart;
  return std::max(apart, engine::sum_over_ranks(walls_before_, world) - now.walls);
}

double FixMuckpileLedger::balance_error() {
  const double apart = out_of_balance();
  return largest_ > 0.0 ? apart / largest_ : 0.0;
}

bool FixMuckpileLedger::balanced(double allowed) {
  constexpr double kRounding = 1e-9;  // of the weight's potential about the origin, a large sum
  return balance_error() <= allowed || out_of_balance() <= kRounding * std::abs(start_gravity_);
}

double FixMuckpileLedger::fastest_block() {
  const engine::Bodies bodies(*multisphere_);
  double mine = 0.0;
  for (int b = 0; b < bodies.count(); ++b) {
    const double speed = bodies.velocity(b).norm();
    mine = std::isfinite(speed) ? std::max(mine, speed) : HUGE_VAL;
  }
  return engine::greatest_over_ranks(mine, world);
}

void FixMuckpileLedger::write_restart(FILE* file) {
  const auto total = [this](double mine) { return engine::sum_over_ranks(mine, world); };
  LedgerState state{started_, start_residual_, start_gravity_, largest_, last_tag_};
  state.sphere_work = total(sphere_work_);
  state.contact_work = total(contact_work_);
  state.walls_before = total(walls_before_);
  for (std::size_t k = 0; k < kKept.size(); ++k) state.former[k] = total(former_.*kKept[k]);
  state.given = total(given_);
  state.laid_to_rest = total(sleep_ != nullptr ? sleep_->energy_taken() : laid_to_rest_);
  engine::write_state(*lmp, style, file, state);
}

void FixMuckpileLedger::restart(char* bytes) {
  const auto state = engine::read_state<LedgerState>(*lmp, style, bytes);
  const auto share = [this](double all) { return engine::share_of_total(*lmp, all); };
  started_ = state.started;
  start_residual_ = state.start_residual;
  start_gravity_ = state.start_gravity;
  largest_ = state.largest;
  last_tag_ = state.last_tag;
  sphere_work_ = share(state.sphere_work);
  contact_work_ = share(state.contact_work);
  walls_before_ = share(state.walls_before);
  for (std::size_t k = 0; k < kKept.size(); ++k) former_.*kKept[k] = share(state.former[k]);
  given_ = share(state.given);
  laid_to_rest_ = share(state.laid_to_rest);
}

double FixMuckpileLedger::compute_scalar() { return balance_error(); }

double FixMuckpileLedger::compute_vector(int n) {
  return ledger().*kColumns[static_cast<std::size_t>(n)];
}

}  // namespace muckpile
