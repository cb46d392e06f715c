// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/sleep: looks every few steps who rests, and tells the others.
// Scope: see the header and docs/styles/fix_muckpile_sleep.md.
#include "fixes/blocks/fix_muckpile_sleep.h"

#include <atom.h>
#include <comm.h>
#include <fix_multisphere.h>
#include <force.h>
#include <modify.h>
#include <mpi.h>
#include <pair.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <unordered_map>

#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/blast_energies.h"
#include "fixes/interfaces/energy_account.h"
#include "fixes/interfaces/joint_pressure.h"
#include "fixes/interfaces/keyword_tables.h"

namespace muckpile {
namespace {

const ArgTable& table() {
  static const ArgTable args =
      ArgTable("fix muckpile/sleep")
          .real("distance", "m", Range::left_open(0.0, 1.0), std::nullopt,
                "a block that stays within this of one place may rest")
          .real("time", "s", Range::left_open(0.0, 1e3), 0.2, "for so long")
          .real("speed", "m/s", Range::left_open(0.0, 1e3), 0.1, "and is slower than this")
          .integer("every", "steps", Range::closed(1, 1000), 5, "between checks");
  return args;
}

}  // namespace

const ArgTable& sleep_keywords() { return table(); }

FixMuckpileSleep::FixMuckpileSleep(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)) {
  engine::refuse_second_fix(*lmp, where_, "muckpile/sleep");
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  limits_ = {args.real("distance"), args.real("time"), args.real("speed")};
  nevery = static_cast<int>(args.integer("every"));
  multisphere_ = engine::find_multisphere(*lmp);
  if (multisphere_ == nullptr || std::strcmp(multisphere_->style, "multisphere/muckpile") != 0)
    engine::stop(*lmp, where_ + ": needs 'fix ID all multisphere/muckpile' before it");
  comm_forward = comm_reverse = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 2;
  global_freq = 1;
  extscalar = extvector = 0;
  restart_global = 1;
}

int FixMuckpileSleep::setmask() {
  return LAMMPS_NS::FixConst::PRE_NEIGHBOR | LAMMPS_NS::FixConst::END_OF_STEP;
}

/// An unfix wakes all; at the end of the program there is nothing to do.
void FixMuckpileSleep::pre_delete(bool unfixflag) {
  if (!unfixflag) return;
  wake_joints();
  if (auto* account = engine::find_view<EnergyAccount>(*lmp)) account->keep_books_of_sleep(taken_);
}

/// fix muckpile/joint may have gone since init().
void FixMuckpileSleep::wake_joints() {
  if (auto* joined = engine::find_view<JoinedBlocks>(*lmp)) joined->wake_all();
}

void FixMuckpileSleep::init() {
  near_ = dynamic_cast<NearBlocks*>(force->pair);
  joined_ = engine::find_view<JoinedBlocks>(*lmp);
  if (engine::place_of<JoinedBlocks>(*lmp) > modify->find_fix(id))
    engine::stop(*lmp, where_ + ": must be defined after fix muckpile/joint");
}

/// After bodies have changed places in the lists or ranks; those that arrive are awake.
void FixMuckpileSleep::follow_bodies() {
  const engine::Bodies bodies(*multisphere_);
  std::unordered_map<int, std::size_t> places;
  for (std::size_t b = 0; b < tags_.size(); ++b) places[tags_[b]] = b;
  const auto count = static_cast<std::size_t>(bodies.count());
  std::vector<int> tags(count);
  std::vector<Stillness> stays(count);
  std::vector<char> rests(count, 0);
  for (std::size_t b = 0; b < count; ++b) {
    tags[b] = bodies.tag(static_cast<int>(b));
    const auto old = places.find(tags[b]);
    if (old == places.end()) continue;
    stays[b] = stays_[old->second];
    rests[b] = rests_[old->second];
  }
  tags_ = std::move(tags);
  stays_ = std::move(stays);
  rests_ = std::move(rests);
  list_bodies_of_spheres();
  tell();
}

void FixMuckpileSleep::list_bodies_of_spheres() {
  body_of_.resize(static_cast<std::size_t>(atom->nlocal + atom->nghost));
  for (std::size_t k = 0; k < body_of_.size(); ++k) {
    const int tag = multisphere_->belongs_to(static_cast<int>(k));
    body_of_[k] = tag < 0 ? -1 : multisphere_->data().map(tag);
  }
}

/// The start of a run sums forces anew, without those between resting blocks: hold these again.
void FixMuckpileSleep::setup(int) {
  engine::Bodies bodies(*multisphere_);
  for (int b = 0; b < bodies.count(); ++b) {
    if (body_rests(b)) bodies.hold(b);
  }
}

bool FixMuckpileSleep::blast_is_on() const {
  const auto* const blast = engine::find_view<BlastEnergies>(*lmp);
  const auto* const gas = engine::find_view<JointPressure>(*lmp);
  return (blast != nullptr && !blast->over()) || (gas != nullptr && gas->acts());
}

void FixMuckpileSleep::end_of_step() {
  std::vector<char> disturbed(rests_.size(), 1);
  if (!blast_is_on()) {
    const std::vector<char> moving = moving_bodies();
    disturbed = moving;
    if (joined_ != nullptr) joined_->mark_joined(moving, disturbed);
    if (near_ != nullptr) mark_near(moving, disturbed);
  }
  lay_to_rest(disturbed);
}

std::vector<char> FixMuckpileSleep::moving_bodies() {
  const engine::Bodies bodies(*multisphere_);
  const double now = update->get_cur_time();
  std::vector<char> moving(rests_.size());
  for (int b = 0; b < bodies.count(); ++b) {
    const double radius = multisphere_->data().r_bound(b);
    const double speed = bodies.velocity(b).norm() + bodies.spin(b).norm() * radius;
    const auto k = static_cast<std::size_t>(b);
    const bool still =
        stays_[k].follow(limits_, {bodies.centre(b), bodies.axes(b), radius, speed}, now);
    moving[k] = still ? 0 : 1;
  }
  return moving;
}

void FixMuckpileSleep::mark_near(const std::vector<char>& moving, std::vector<char>& disturbed) {
  const std::vector<char> from = on_spheres(moving);
  sent_.assign(from.size(), 0);
  near_->mark_near(from, sent_);
  share_sent();
  for (std::size_t k = 0; k < sent_.size(); ++k) {
    if (sent_[k] != 0 && body_of_[k] >= 0) disturbed[static_cast<std::size_t>(body_of_[k])] = 1;
  }
}

void FixMuckpileSleep::lay_to_rest(const std::vector<char>& disturbed) {
  engine::Bodies bodies(*multisphere_);
  bool changed = false;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto k = static_cast<std::size_t>(b);
    const char rests = disturbed[k] == 0 ? 1 : 0;
    if (rests == rests_[k]) continue;
    changed = true;
    rests_[k] = rests;
    if (rests == 0) continue;
    taken_ += bodies.kinetic_energy(b);
    bodies.hold(b);
  }
  if (engine::on_any_rank(changed, world)) tell();
}

void FixMuckpileSleep::tell() {
  resting_ = static_cast<int>(std::count(rests_.begin(), rests_.end(), 1));
  ++version_;
  of_spheres_ = on_spheres(rests_);
  any_ = resting_ > 0 || std::count(of_spheres_.begin(), of_spheres_.end(), 1) > 0;
  if (joined_ != nullptr) joined_->let_rest(rests_);
}

/// One flag per sphere, ghosts included, from one per body.
std::vector<char> FixMuckpileSleep::on_spheres(const std::vector<char>& of_bodies) {
  sent_.assign(body_of_.size(), 0);
  for (std::size_t k = 0; k < sent_.size(); ++k) {
    if (body_of_[k] >= 0) sent_[k] = of_bodies[static_cast<std::size_t>(body_of_[k])];
  }
  share_sent();
  return sent_;
}

/// A sphere marked by one rank gets marked by all: a body's rank may know some of its spheres as
/// ghosts only.
void FixMuckpileSleep::share_sent() {
  comm->reverse_comm_fix(this);
  comm->forward_comm_fix(this);
}

int FixMuckpileSleep::pack_comm(int n, int* list, double* buffer, int, int*) {
  for (int k = 0; k < n; ++k) buffer[k] = sent_[static_cast<std::size_t>(list[k])];
  return 1;
}

void FixMuckpileSleep::unpack_comm(int n, int first, double* buffer) {
  for (int k = 0; k < n; ++k) sent_[static_cast<std::size_t>(first + k)] = buffer[k] > 0.5 ? 1 : 0;
}

int FixMuckpileSleep::pack_reverse_comm(int n, int first, double* buffer) {
  for (int k = 0; k < n; ++k) buffer[k] = sent_[static_cast<std::size_t>(first + k)];
  return 1;
}

void FixMuckpileSleep::unpack_reverse_comm(int n, int* list, double* buffer) {
  for (int k = 0; k < n; ++k)
    if (buffer[k] > 0.5) sent_[static_cast<std::size_t>(list[k])] = 1;
}

void FixMuckpileSleep::write_restart(FILE* file) {
  ByteWriter mine;
  for (std::size_t b = 0; b < tags_.size(); ++b)
    mine.put(RestRecord{tags_[b], stays_[b], rests_[b] != 0});
  const SleepState state{engine::sum_over_ranks(taken_, world)};
  engine::write_state<RestRecord>(*lmp, style, file, state, std::move(mine));
}

/// Reads the states of all blocks; follow_bodies() then picks those of this rank.
void FixMuckpileSleep::restart(char* bytes) {
  SleepState state;
  engine::read_state<RestRecord>(*lmp, style, bytes, state, [this](const RestRecord& record) {
    tags_.push_back(record.tag);
    stays_.push_back(record.stay);
    rests_.push_back(record.rests ? 1 : 0);
  });
  taken_ = engine::share_of_total(*lmp, state.taken);
}

int FixMuckpileSleep::modify_param(int, char** arg) {
  if (std::strcmp(arg[0], "wake") != 0) return 0;
  wake_blocks();
  return 1;
}

void FixMuckpileSleep::wake_blocks() {
  stays_.assign(stays_.size(), {});
  rests_.assign(rests_.size(), 0);
  resting_ = 0;
  ++version_;
  of_spheres_.assign(of_spheres_.size(), 0);
  any_ = false;
  wake_joints();
}

double FixMuckpileSleep::compute_scalar() {
  std::array all{static_cast<double>(resting_), static_cast<double>(rests_.size())};
  engine::sum_over_ranks_in_place(all, world);
  return all[1] > 0.0 ? all[0] / all[1] : 0.0;
}

double FixMuckpileSleep::compute_vector(int n) {
  return engine::sum_over_ranks(n == 0 ? static_cast<double>(resting_) : taken_, world);
}

}  // namespace muckpile
