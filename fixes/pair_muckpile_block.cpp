// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: arguments, block search at reneighbouring, contact loop per step.
// Scope: the law and the search are in src/core/contact; here is the engine side.
#include "pair_muckpile_block.h"

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <fix_multisphere.h>
#include <force.h>
#include <memory.h>
#include <modify.h>
#include <mpi.h>
#include <neighbor.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "args/arg_table.h"
#include "contact/contact_step_bound.h"
#include "engine/bodies.h"
#include "engine/style_args.h"

namespace muckpile {

namespace {

constexpr const char* kStyle = "pair_style muckpile/block";
constexpr const char* kHistoryId = "muckpile_contact_history";
constexpr const char* kHistoryStyle = "muckpile/contact/history";

Vec3 vector_at(const double* values, int atom) {
  return {values[3 * atom], values[3 * atom + 1], values[3 * atom + 2]};
}

void add_to(double* values, int atom, const Vec3& change) {
  for (int d = 0; d < 3; ++d) values[3 * atom + d] += change[d];
}

}  // namespace

ArgTable block_contact_keywords() {
  ArgTable table(kStyle);
  table.word("model", {"hertz", "linear"}, "hertz", "normal force: Hertz-Mindlin or linear spring")
      .real("youngs_modulus", "Pa", Range::above(0.0), 5e8, "contact modulus of the rock")
      .real("poisson_ratio", "", Range::open(-1.0, 0.5), 0.25, "Poisson ratio of the rock")
      .real("restitution", "", Range::closed(0.05, 1.0), 0.2,
            "speed after over speed before a head-on impact")
      .real("friction", "", Range::at_least(0.0), 0.6, "Coulomb friction coefficient")
      .real("rolling_friction", "", Range::at_least(0.0), 0.1,
            "limit torque over reduced radius times normal force");
  return table;
}

PairMuckpileBlock::PairMuckpileBlock(LAMMPS_NS::LAMMPS* engine_object) : Pair(engine_object) {
  single_enable = 0;
  restartinfo = 0;
  no_virial_fdotr_compute = 1;
  comm_forward = comm_reverse = 1;
}

PairMuckpileBlock::~PairMuckpileBlock() {
  if (modify->find_fix(kHistoryId) >= 0) modify->delete_fix(kHistoryId);
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

void PairMuckpileBlock::settings(int narg, char** arg) {
  const ArgValues in = engine::read_args(*lmp, block_contact_keywords(), kStyle, narg, arg, 0);
  law_ = engine::or_engine_error(*lmp, [&] {
    ContactParameters p;
    p.model = in.word("model") == "linear" ? NormalModel::linear : NormalModel::hertz;
    p.youngs_modulus = in.real("youngs_modulus");
    p.poisson_ratio = in.real("poisson_ratio");
    p.restitution = in.real("restitution");
    p.friction = in.real("friction");
    p.rolling_friction = in.real("rolling_friction");
    return ContactLaw(p);
  });
}

void PairMuckpileBlock::coeff(int narg, char** arg) {
  if (narg != 2 || std::strcmp(arg[0], "*") != 0 || std::strcmp(arg[1], "*") != 0)
    engine::stop(*lmp,
                 "pair_coeff of muckpile/block must be 'pair_coeff * *': all blocks are of "
                 "one rock, its values are given with pair_style");
  const int n = atom->ntypes;
  if (!allocated) {
    memory->create(setflag, n + 1, n + 1, "pair:setflag");
    memory->create(cutsq, n + 1, n + 1, "pair:cutsq");
    allocated = 1;
  }
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      setflag[i][j] = 1;
      cutsq[i][j] = 0.0;
    }
}

void PairMuckpileBlock::require_engine_settings() {
  const auto require = [this](bool holds, const char* rule) {
    if (!holds) engine::stop(*lmp, std::string(kStyle) + ": " + rule);
  };
  require(std::strcmp(update->unit_style, "si") == 0, "units must be si, got another unit system");
  require(atom->radius_flag && atom->rmass_flag && atom->omega_flag && atom->torque_flag,
          "atom_style must be granular (spheres with radius, mass and spin)");
  require(!force->newton_pair, "newton must be off");
  require(comm->ghost_velocity != 0,
          "ghost atoms need their velocities: add 'communicate single vel yes'");
  require(modify->find_fix_style("multisphere", 0) != nullptr,
          "a fix multisphere must exist: it holds the blocks");
}

void PairMuckpileBlock::find_partners() {
  bodies_ = dynamic_cast<LAMMPS_NS::FixMultisphere*>(modify->find_fix_style("multisphere", 0));
  joints_ = dynamic_cast<const JointView*>(modify->find_fix_style("muckpile/joint", 0));
  resting_ = dynamic_cast<const RestingBlocks*>(modify->find_fix_style_strict("muckpile/sleep", 0));
  if (modify->find_fix(kHistoryId) < 0) {
    std::array<std::string, 3> words{kHistoryId, "all", kHistoryStyle};
    std::array<char*, 3> arg{words[0].data(), words[1].data(), words[2].data()};
    modify->add_fix(3, arg.data());
  }
  history_ = dynamic_cast<FixMuckpileContactHistory*>(modify->fix[modify->find_fix(kHistoryId)]);
  history_->set_source(this);
}

void PairMuckpileBlock::init_style() {
  require_engine_settings();
  find_partners();
  double smallest = 0.0;
  modify->max_min_rad(largest_radius_, smallest);  // over all ranks, with particle templates
}

double PairMuckpileBlock::init_one(int /*i*/, int /*j*/) { return 2.0 * largest_radius_; }

/// Of contacts that may come: one, with a small overlap, per sphere.
double PairMuckpileBlock::step_of_light_contacts() const {
  double step = std::numeric_limits<double>::infinity();
  for (int k = 0; k < atom->nlocal; ++k)
    step = std::min(step, law_->stable_time_step(atom->rmass[k], atom->radius[k]));
  return step;
}

ContactStepBound PairMuckpileBlock::present_contacts() {
  const engine::Bodies bodies(*bodies_);
  ContactStepBound bound;
  for (const BlockPair& block_pair : list_.block_pairs())
    for (const SpherePair& pair : near_spheres(block_pair)) {
      if (pair.contact < 0) continue;
      const Vec3 first = vector_at(atom->x[0], pair.first);
      const Vec3 between = vector_at(atom->x[0], pair.second) - first;
      ContactMotion motion{};
      motion.overlap = pair.reach - between.norm();
      motion.radius_first = atom->radius[pair.first];
      motion.radius_second = atom->radius[pair.second];
      const double m1 = atom->rmass[pair.first], m2 = atom->rmass[pair.second];
      motion.reduced_mass = m1 * m2 / (m1 + m2);
      const ContactResistance resistance =
          law_->resistance(motion, contacts_[static_cast<std::size_t>(pair.contact)]);
      const Vec3 point = first + (motion.radius_first / pair.reach) * between;
      for (const bool second : {false, true}) {
        const int body =
            bodies_->data().map(bodies_->belongs_to(second ? pair.second : pair.first));
        if (body < 0) continue;  // the other rank's
        Vec3 arm = point - bodies.centre(body);
        domain->minimum_image(arm.x(), arm.y(), arm.z());
        bound.add(static_cast<std::size_t>(body),
                  {bodies.mass(body), bodies.inertia_in_space(body)}, resistance,
                  between.normalized(), arm, second ? m1 : m2);
      }
    }
  return bound;
}

int PairMuckpileBlock::add_block(int body_tag, int sphere) {
  const double* x = atom->x[sphere];
  block_tag_.push_back(body_tag);
  seed_.push_back({x[0], x[1], x[2]});
  first_sphere_.push_back(sphere);
  next_image_.push_back(-1);
  return static_cast<int>(block_tag_.size()) - 1;
}

// Spheres of one body form one block; its periodic images are blocks of their own, told apart by
// their distance: a body is smaller than half the box.
int PairMuckpileBlock::block_of(int body_tag, int sphere) {
  const double* x = atom->x[sphere];
  const auto tag = static_cast<std::size_t>(body_tag);
  if (tag >= first_image_.size()) first_image_.resize(tag + 1, -1);
  int last = -1;
  for (int b = first_image_[tag]; b >= 0; b = next_image_[static_cast<std::size_t>(b)]) {
    const std::array<double, 3>& seed = seed_[static_cast<std::size_t>(b)];
    bool same = true;
    for (std::size_t d = 0; d < 3; ++d)
      same =
          same && !(domain->periodicity[d] != 0 && std::abs(x[d] - seed[d]) > 0.5 * domain->prd[d]);
    if (same) return b;
    last = b;
  }
  const int block = add_block(body_tag, sphere);
  (last < 0 ? first_image_[tag] : next_image_[static_cast<std::size_t>(last)]) = block;
  return block;
}

// Gives every sphere its block. Blocks that nothing outside can touch, because all their joints
// hold and none of their faces is free, take no part; neither do spheres without a body.
void PairMuckpileBlock::number_blocks() {
  const int count = atom->nlocal + atom->nghost;
  std::fill(first_image_.begin(), first_image_.end(), -1);
  block_tag_.clear();
  seed_.clear();
  first_sphere_.clear();
  next_image_.clear();
  atom_block_.assign(static_cast<std::size_t>(count), -1);
  for (int k = 0; k < count; ++k) {
    const int tag = bodies_->belongs_to(k);
    if (tag >= 0) atom_block_[static_cast<std::size_t>(k)] = block_of(tag, k);
  }
  for (std::size_t k = 0; k < enclosed_.size(); ++k)
    if (enclosed_[k] != 0) atom_block_[k] = -1;
}

/// Only the rank that moves a block knows whether it is enclosed; it may have some of its spheres
/// as ghosts: what one rank has marked, all mark.
void PairMuckpileBlock::share_enclosed() {
  enclosed_.clear();
  if (joints_ == nullptr) return;
  enclosed_.resize(static_cast<std::size_t>(atom->nlocal + atom->nghost), 0);
  int last = -1;
  bool last_is_enclosed = false;
  for (std::size_t k = 0; k < enclosed_.size(); ++k) {
    const int tag = bodies_->belongs_to(static_cast<int>(k));
    if (tag < 0 || bodies_->data().map(tag) < 0) continue;
    if (tag != last) last_is_enclosed = joints_->enclosed(tag);
    last = tag;
    enclosed_[k] = last_is_enclosed ? 1 : 0;
  }
  comm->reverse_comm_pair(this);
  comm->forward_comm_pair(this);
}

int PairMuckpileBlock::pack_comm(int n, int* list, double* buffer, int, int*) {
  for (int k = 0; k < n; ++k) buffer[k] = enclosed_[static_cast<std::size_t>(list[k])];
  return 1;
}

void PairMuckpileBlock::unpack_comm(int n, int first, double* buffer) {
  for (int k = 0; k < n; ++k)
    enclosed_[static_cast<std::size_t>(first + k)] = buffer[k] > 0.5 ? 1 : 0;
}

int PairMuckpileBlock::pack_reverse_comm(int n, int first, double* buffer) {
  for (int k = 0; k < n; ++k) buffer[k] = enclosed_[static_cast<std::size_t>(first + k)];
  return 1;
}

void PairMuckpileBlock::unpack_reverse_comm(int n, int* list, double* buffer) {
  for (int k = 0; k < n; ++k)
    if (buffer[k] > 0.5) enclosed_[static_cast<std::size_t>(list[k])] = 1;
}

// A pair whose facet is cracked stays, muted.
void PairMuckpileBlock::drop_intact_pairs(std::vector<BlockPair>& pairs) const {
  const FacetState* states = joints_ != nullptr ? joints_->facet_states() : nullptr;
  std::erase_if(pairs, [&](BlockPair& pair) {
    const int first = block_tag_[static_cast<std::size_t>(pair.first)];
    const int second = block_tag_[static_cast<std::size_t>(pair.second)];
    if (first == second) return true;  // periodic images of one body
    if (joints_ == nullptr) return false;
    pair.facet = joints_->facet_between(first, second);
    return pair.facet >= 0 && states[pair.facet] == FacetState::intact;
  });
}

SphereSet PairMuckpileBlock::spheres() const {
  const int count = atom->nlocal + atom->nghost;
  return {count > 0 ? atom->x[0] : nullptr,
          atom->radius,
          atom->tag,
          atom_block_.data(),
          count,
          atom->nlocal};
}

/// Facets that are whole or cracked carry what contact their two blocks have.
void PairMuckpileBlock::mute_pairs() {
  muted_.clear();
  const FacetState* states = joints_ != nullptr ? joints_->facet_states() : nullptr;
  const std::vector<BlockPair>& pairs = list_.block_pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].facet < 0 || states[pairs[k].facet] >= FacetState::fading) continue;
    list_.mute(k);
    muted_.push_back({k, pairs[k].facet});
  }
}

void PairMuckpileBlock::hear_pairs() {
  const FacetState* states = joints_ != nullptr ? joints_->facet_states() : nullptr;
  std::erase_if(muted_, [&](const MutedPair& muted) {
    if (states[muted.facet] < FacetState::fading) return false;
    list_.hear(muted.pair);
    return true;
  });
}

void PairMuckpileBlock::list_working_pairs() {
  working_.clear();
  left_alone_.clear();
  const bool any = resting_ != nullptr && resting_->any_rests();
  const std::span<const char> resting = any ? resting_->resting_spheres() : std::span<const char>();
  const auto rests = [&](int block) {
    const int sphere = first_sphere_[static_cast<std::size_t>(block)];
    return any && resting[static_cast<std::size_t>(sphere)] != 0;
  };
  for (std::size_t k = 0; k < list_.block_pairs().size(); ++k) {
    const BlockPair& pair = list_.block_pairs()[k];
    (rests(pair.first) && rests(pair.second) ? left_alone_ : working_).push_back(k);
  }
  if (resting_ != nullptr) rests_version_ = resting_->rests_version();
}

double PairMuckpileBlock::resting_energy() {
  double energy = 0.0;
  const AtomArrays atoms = arrays();
  for (const std::size_t k : left_alone_)
    for (const SpherePair& pair : near_spheres(list_.block_pairs()[k])) {
      if (pair.contact < 0) continue;
      const Vec3 to_second = vector_at(atoms.x, pair.second) - vector_at(atoms.x, pair.first);
      ContactState state = contacts_[static_cast<std::size_t>(pair.contact)];
      const double share = pair.first < atoms.owned && pair.second < atoms.owned ? 1.0 : 0.5;
      energy +=
          share * law_->evaluate(motion_of(pair, to_second, to_second.norm(), atoms), 0.0, state)
                      .elastic_energy;
    }
  return energy;
}

void PairMuckpileBlock::mark_near(std::span<const char> from, std::span<char> to) const {
  const auto sphere = [this](int block) {
    return static_cast<std::size_t>(first_sphere_[static_cast<std::size_t>(block)]);
  };
  for (const BlockPair& pair : list_.block_pairs()) {
    if (pair.count == 0) continue;
    const std::size_t first = sphere(pair.first), second = sphere(pair.second);
    if (from[first] != 0) to[second] = 1;
    if (from[second] != 0) to[first] = 1;
  }
}

/// The engine builds its lists anew before any sphere has moved by half the skin.
void PairMuckpileBlock::list_pairs() {
  const double started = MPI_Wtime();
  number_blocks();
  list_.group(spheres(), static_cast<int>(block_tag_.size()));
  const bool any = atom->nlocal + atom->nghost > 0;
  drop_intact_pairs(list_.find_block_pairs(0.5 * neighbor->skin, any ? atom->v[0] : nullptr,
                                           any ? atom->omega[0] : nullptr));
  mute_pairs();
  listed_tags_.assign(atom->tag, atom->tag + atom->nlocal + atom->nghost);
  listed_owned_ = atom->nlocal;
  recall_contacts();
  list_working_pairs();
  list_is_stale_ = false;
  ledger_.rebuild_s += MPI_Wtime() - started;
  ledger_.rebuilds += 1.0;
}

void PairMuckpileBlock::rebuild() {
  share_enclosed();
  list_pairs();
  int bad = list_.skipped_blocks(), all_bad = 0;
  MPI_Allreduce(&bad, &all_bad, 1, MPI_INT, MPI_SUM, world);
  if (all_bad > 0)
    engine::stop(*lmp, std::string(kStyle) + ": " + std::to_string(all_bad) +
                           " blocks have a position that is not a number at step " +
                           std::to_string(update->ntimestep) + "; use a smaller timestep");
}

// A muted pair has no contacts; its spheres are looked up when it is heard again.
void PairMuckpileBlock::recall_contacts() {
  contacts_.clear();
  free_contacts_.clear();
  for (std::size_t k = 0; k < list_.block_pairs().size(); ++k) {
    if (list_.idle(k)) continue;
    BlockPair& block_pair = list_.block_pairs()[k];
    list_.look_up(block_pair, spheres(), free_contacts_);
    for (SpherePair& pair : near_spheres(block_pair)) {
      const bool first_is_owned = pair.first < atom->nlocal;
      const int owner = first_is_owned ? pair.first : pair.second;
      const int partner = first_is_owned ? pair.second : pair.first;
      if (const ContactState* state = history_->find(owner, atom->tag[partner]))
        pair.contact = new_contact(*state);
    }
  }
}

// Other fixes may have deleted or moved atoms since the list was built: go by tag where they have.
void PairMuckpileBlock::store_contacts(FixMuckpileContactHistory& history) {
  list_is_stale_ = true;
  if (!contacts_moved_) return;  // the stored ones are the latest
  contacts_moved_ = false;
  const auto unmoved = [this](int k) {
    return k < atom->nlocal && atom->tag[k] == listed_tags_[static_cast<std::size_t>(k)];
  };
  std::vector<std::pair<int, int>> by_tag;
  const auto index_now = [&](int k) {
    if (k >= listed_owned_) return -1;
    if (unmoved(k)) return k;
    if (by_tag.empty()) {
      for (int a = 0; a < atom->nlocal; ++a) by_tag.emplace_back(atom->tag[a], a);
      std::sort(by_tag.begin(), by_tag.end());
    }
    const int tag = listed_tags_[static_cast<std::size_t>(k)];
    const auto place = std::lower_bound(by_tag.begin(), by_tag.end(), std::make_pair(tag, 0));
    return place != by_tag.end() && place->first == tag ? place->second : -1;
  };
  record_owners_.clear();
  records_.clear();
  for (const BlockPair& block_pair : list_.block_pairs())
    for (const SpherePair& pair : near_spheres(block_pair)) {
      if (pair.contact < 0) continue;
      const ContactState& state = contacts_[static_cast<std::size_t>(pair.contact)];
      for (const auto& [owner, partner] :
           {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)})
        if (const int now = index_now(owner); now >= 0) {
          record_owners_.push_back(now);
          records_.push_back({listed_tags_[static_cast<std::size_t>(partner)], state});
        }
    }
  history.store(record_owners_, records_);
}

void PairMuckpileBlock::compute(int eflag, int vflag) {
  if (eflag || vflag)
    ev_setup(eflag, vflag);
  else
    evflag = vflag_fdotr = 0;
  if (neighbor->ago == 0 && list_is_stale_) {
    rebuild();
  } else if (atom->nlocal + atom->nghost > 0) {
    list_.follow(atom->x[0], atom->omega[0], update->dt);
    if (list_.outgrown()) {
      store_contacts(*history_);
      list_pairs();
    }
  }
  if (resting_ != nullptr && resting_->rests_version() != rests_version_) list_working_pairs();
  step_contacts();
  contacts_moved_ = true;
  if (eflag_global) eng_vdwl += ledger_.elastic_J + resting_energy();
}

PairMuckpileBlock::AtomArrays PairMuckpileBlock::arrays() const {
  return {atom->x[0],      atom->v[0],   atom->omega[0], atom->f[0],
          atom->torque[0], atom->radius, atom->rmass,    atom->nlocal};
}

void PairMuckpileBlock::step_contacts() {
  ledger_.elastic_J = ledger_.power_W = ledger_.contacts = ledger_.max_overlap_ratio = 0.0;
  if (list_.block_pairs().empty()) return;
  const AtomArrays atoms = arrays();
  // Set-up of a run computes the forces of a state that a step has already reached.
  const double history_step = update->setupflag != 0 ? 0.0 : update->dt;
  hear_pairs();
  for (const std::size_t k : working_) {
    if (list_.idle(k)) continue;
    BlockPair& pair = list_.block_pairs()[k];
    if (list_.moved(pair)) list_.look_up(pair, spheres(), free_contacts_);
    step_block_pair(pair, atoms, history_step);
  }
}

void PairMuckpileBlock::step_block_pair(const BlockPair& block_pair, const AtomArrays& atoms,
                                        double history_step) {
  const double* const x = atoms.x;
  for (SpherePair& pair : near_spheres(block_pair)) {
    const double* a = x + 3 * pair.first;
    const double* b = x + 3 * pair.second;
    const double dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2];
    const double squared = dx * dx + dy * dy + dz * dz;
    if (squared < pair.reach * pair.reach) {
      touch(pair, Vec3(dx, dy, dz), std::sqrt(squared), atoms, history_step);
    } else if (pair.contact >= 0) {
      free_contacts_.push_back(pair.contact);
      pair.contact = -1;
    }
  }
}

int PairMuckpileBlock::new_contact(const ContactState& state) {
  if (free_contacts_.empty()) {
    contacts_.push_back(state);
    return static_cast<int>(contacts_.size()) - 1;
  }
  const int contact = free_contacts_.back();
  free_contacts_.pop_back();
  contacts_[static_cast<std::size_t>(contact)] = state;
  return contact;
}

ContactMotion PairMuckpileBlock::motion_of(const SpherePair& pair, const Vec3& to_second,
                                           double distance, const AtomArrays& atoms) const {
  const int i = pair.first, j = pair.second;  // by tag: both ranks of a contact compute the same
  const Vec3 normal = distance > 0.0 ? Vec3(to_second / distance) : Vec3::UnitX();
  const double overlap = pair.reach - distance;
  const double arm_i = atoms.radius[i] - 0.5 * overlap, arm_j = atoms.radius[j] - 0.5 * overlap;
  const Vec3 v_i = vector_at(atoms.v, i), v_j = vector_at(atoms.v, j);
  const Vec3 spin_i = vector_at(atoms.omega, i), spin_j = vector_at(atoms.omega, j);
  const Vec3 arm_spin = arm_i * spin_i + arm_j * spin_j;
  return {normal,
          overlap,
          atoms.radius[i],
          atoms.radius[j],
          atoms.mass[i] * atoms.mass[j] / (atoms.mass[i] + atoms.mass[j]),
          v_i - v_j + arm_spin.cross(normal),
          spin_i - spin_j};
}

void PairMuckpileBlock::touch(SpherePair& pair, const Vec3& to_second, double distance,
                              const AtomArrays& atoms, double history_step) {
  const int i = pair.first, j = pair.second;
  const ContactMotion motion = motion_of(pair, to_second, distance, atoms);
  if (pair.contact < 0) pair.contact = new_contact(ContactLaw::begin_contact(motion, update->dt));
  ContactState& state = contacts_[static_cast<std::size_t>(pair.contact)];
  const ContactResponse response = law_->evaluate(motion, history_step, state);

  const double arm_i = atoms.radius[i] - 0.5 * motion.overlap;
  const double arm_j = atoms.radius[j] - 0.5 * motion.overlap;
  const Vec3 lever = motion.normal.cross(response.force_on_first);
  if (i < atoms.owned)
    apply(atoms, i, response.force_on_first, arm_i * lever + response.torque_on_first);
  if (j < atoms.owned)
    apply(atoms, j, -response.force_on_first, arm_j * lever - response.torque_on_first);

  const double share = i < atoms.owned && j < atoms.owned ? 1.0 : 0.5;  // the other rank: the rest
  ledger_.contacts += share;
  ledger_.elastic_J += share * response.elastic_energy;
  if (history_step > 0.0) {
    losses_.friction += share * response.friction_loss;
    losses_.damping += share * response.damping_loss;
  }
  ledger_.max_overlap_ratio = std::max(ledger_.max_overlap_ratio,
                                       motion.overlap / std::min(atoms.radius[i], atoms.radius[j]));
}

void PairMuckpileBlock::apply(const AtomArrays& atoms, int target, const Vec3& pair_force,
                              const Vec3& pair_torque) {
  add_to(atoms.f, target, pair_force);
  add_to(atoms.torque, target, pair_torque);
  ledger_.power_W +=
      pair_force.dot(vector_at(atoms.v, target)) + pair_torque.dot(vector_at(atoms.omega, target));
}

void* PairMuckpileBlock::extract(const char* name, int& dim) {
  dim = 0;
  const std::string_view key(name);
  if (key == "elastic_J") {
    ledger_.all_elastic_J = ledger_.elastic_J + resting_energy();
    return &ledger_.all_elastic_J;
  }
  if (key == "friction_J") return &losses_.friction;
  if (key == "damping_J") return &losses_.damping;
  if (key == "power_W") return &ledger_.power_W;
  if (key == "contacts") return &ledger_.contacts;
  if (key == "max_overlap_ratio") return &ledger_.max_overlap_ratio;
  if (key == "stable_step_s") {
    ledger_.stable_step_s = std::min(step_of_light_contacts(), present_contacts().step());
    return &ledger_.stable_step_s;
  }
  if (key == "spring_step_s") {
    ledger_.spring_step_s = std::min(step_of_light_contacts(), present_contacts().spring_step());
    return &ledger_.spring_step_s;
  }
  if (key == "rebuild_s") return &ledger_.rebuild_s;
  if (key == "rebuilds") return &ledger_.rebuilds;
  return nullptr;
}

double PairMuckpileBlock::memory_usage() {
  return list_.bytes() + static_cast<double>(contacts_.capacity() * sizeof(ContactState));
}

}  // namespace muckpile
