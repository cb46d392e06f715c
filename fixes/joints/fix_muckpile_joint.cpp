// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint: follows the blocks, and gives them the forces of their joints at each step.
// Scope: arguments, output, restart and what other styles ask are in files of their own.
#include "fixes/joints/fix_muckpile_joint.h"

#include <comm.h>
#include <error.h>
#include <modify.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "args/rounded_text.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/pair_style_check.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/stop_with_state.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/energy_account.h"
#include "fixes/joints/fix_muckpile_joint_arguments.h"

namespace muckpile {
namespace {

constexpr std::size_t kPoseWidth = 18;         // centre, velocity, spin, rotation
constexpr LAMMPS_NS::bigint kCheckEvery = 50;  // steps between looks for newly cracked facets

}  // namespace

FixMuckpileJoint::FixMuckpileJoint(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : FixMuckpileJoint(engine, narg, arg,
                       joint_arguments(*engine, engine::name_of_fix(arg), narg, arg)) {}

FixMuckpileJoint::FixMuckpileJoint(LAMMPS_NS::LAMMPS* engine, int narg, char** arg,
                                   JointArguments arguments)
    : Fix(engine, narg, arg),
      network_(std::move(arguments.network)),
      zones_(std::move(arguments.zones)),
      step_check_(arguments.step_check, engine::name_of_fix(arg)),
      contact_check_(arguments.contact_check) {
  engine::refuse_second_fix(*lmp, engine::name_of_fix(arg), "muckpile/joint");
  engine::require_id_of_restart(*lmp, engine::name_of_fix(arg), *this);
  if (engine::find_multisphere(*lmp) == nullptr) {
    engine::stop(*lmp, engine::name_of_fix(arg) + ": needs 'fix ID all multisphere' before it");
  }
  if (modify->have_restart_data_style("muckpile/blocks") &&
      engine::find_view<FacetStore>(*lmp) == nullptr) {
    engine::stop(*lmp,
                 engine::name_of_fix(arg) +
                     ": after read_restart it needs 'fix ID all multisphere/muckpile', with the "
                     "ID that it had when the file was written, before it");
  }
  if (std::strcmp(update->unit_style, "si") != 0) {
    engine::stop(*lmp, engine::name_of_fix(arg) + ": needs 'units si', got 'units " +
                           update->unit_style + "'");
  }
  vector_flag = 1;
  size_vector = static_cast<int>(Output::count);
  global_freq = 1;
  extvector = 0;
  nevery = 1;
  force_reneighbor = 1;
  next_reneighbor = -1;
  restart_global = 1;
}

FixMuckpileJoint::~FixMuckpileJoint() {
  ends_ = true;
  if (store_ != nullptr) store_->set_keeper(nullptr);
}

/// Known before the first run: what follows in the script asks how soft the joints are.
void FixMuckpileJoint::post_create() {
  if (const auto* store = engine::find_view<FacetStore>(*lmp)) go_on_as_soft(store->softness());
}

int FixMuckpileJoint::setmask() {
  return LAMMPS_NS::FixConst::PRE_NEIGHBOR | LAMMPS_NS::FixConst::POST_FORCE |
         LAMMPS_NS::FixConst::END_OF_STEP;
}

/// An unfix; at the end of the program there is nothing to do.
void FixMuckpileJoint::pre_delete(bool unfixflag) {
  auto* account = unfixflag ? engine::find_view<EnergyAccount>(*lmp) : nullptr;
  if (account == nullptr) return;
  const JointEnergySums mine = energies();
  account->keep_books_of_joints({.joint_elastic = mine.elastic,
                                 .blast_work = mine.pressure_work,
                                 .fracture = mine.fracture,
                                 .joint_friction = mine.friction,
                                 .joint_damping = mine.damping,
                                 .quiet = mine.quiet});
}

void FixMuckpileJoint::init() {
  auto* found = engine::find_view<FacetStore>(*lmp);
  if (found == nullptr) {
    engine::stop(*lmp, engine::name_of(*this) + ": needs create_blocks before the first run");
  }
  if (engine::place_of<FacetStore>(*lmp) > modify->find_fix(id)) {
    engine::stop(*lmp, engine::name_of(*this) + ": must be defined after create_blocks");
  }
  const bool first = store_ == nullptr;
  if (first) {
    store_ = found;
    store_->set_keeper(this);
  }
  gas_ = engine::find_view<JointPressure>(*lmp);
  check_classes();
  follow_blocks();
  if (first) warn_of_other_density();
  end_what_does_not_go_on();
}

void FixMuckpileJoint::check_classes() const {
  const int most = engine::greatest_over_ranks(store_->highest_joint_class(), world);
  const auto given = static_cast<int>(network_.natural_classes());
  if (most > given)
    engine::stop(*lmp, engine::name_of(*this) + ": create_blocks has natural joints of class " +
                           std::to_string(most) + ", but joint_class is given " +
                           std::to_string(given) + " time(s)");
  if (zones_ != store_->zones())
    engine::stop(*lmp, engine::name_of(*this) + ": must be given after all zones of create_blocks");
}

/// Waves run as in rock of the density given here, whatever the blocks weigh. Blocks without
/// joints, as those of muck, may have any.
void FixMuckpileJoint::warn_of_other_density() const {
  constexpr double kSame = 1e-4;
  const JointLaws& laws = network_.tables().laws();
  const std::vector<BlockRecord>& mine = store_->records();
  double worst = 0.0;
  for (std::size_t f = 0; f < network_.facet_count(); ++f) {
    const std::size_t b = network_.tables().blocks_of(f).first;
    if (b >= mine.size()) continue;
    const double given = laws.rock(mine[b].zone).parameters().density;
    worst = std::max(worst, std::abs(mine[b].mass / (mine[b].volume * given) - 1.0));
  }
  worst = engine::greatest_over_ranks(worst, world);
  if (worst <= kSame || comm->me != 0) return;
  const std::string text = engine::name_of(*this) + ": its density is not that of the blocks (" +
                           rounded_text(100.0 * worst, 3) + " % apart)";
  error->warning(FLERR, text.c_str());
}

FacetLists FixMuckpileJoint::copy() const { return network_.lists(); }

FacetLists FixMuckpileJoint::hand_back() {
  return network_.give_up(ends_ ? RankTeam{} : team());  // ranks end one by one
}

void FixMuckpileJoint::follow_blocks() {
  refresh_enclosed();
  if (version_ == store_->version()) return;
  version_ = store_->version();
  std::vector<BlockConstants> blocks;
  for (const BlockRecord& r : store_->records())
    blocks.push_back({r.tag, true, std::max(r.volume, 1e-300), r.mass, r.retired, r.zone});
  // Both ranks that know a facet need the volumes of its two blocks when it breaks, and their rock.
  std::vector<double> volumes(store_->halo().size(), 1.0), zones(store_->halo().size(), 0.0);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    volumes[b] = blocks[b].volume;
    zones[b] = blocks[b].zone;
  }
  store_->halo().forward(volumes, 1);
  store_->halo().forward(zones, 1);
  for (int tag : store_->copy_tags()) {
    const std::size_t b = blocks.size();
    blocks.push_back({tag, false, volumes[b], 1.0, {}, static_cast<std::uint8_t>(zones[b])});
  }
  network_.set(std::move(blocks), store_->hand_over(), team());

  index_facets();
  loaded_.clear();
  loaded_faces_.clear();
  for (std::size_t k = 0; k < network_.faces().size(); ++k) {
    const BoundaryFace& face = network_.faces()[k];
    if (face.hole < 0) continue;
    loaded_faces_.push_back(k);
    loaded_.push_back({face.hole, face.area, face.start});
  }
  refresh_enclosed();
}

/// The store keeps facets in order of their lower tag.
void FixMuckpileJoint::index_facets() {
  lower_tags_.clear();
  first_of_.clear();
  upper_tags_.clear();
  const auto tag = [&](int block) {
    return network_.blocks()[static_cast<std::size_t>(block)].tag;
  };
  for (std::size_t f = 0; f < network_.facet_count(); ++f) {
    const FacetEnds ends = network_.ends(f);
    if (lower_tags_.empty() || lower_tags_.back() != tag(ends.i)) {
      lower_tags_.push_back(tag(ends.i));
      first_of_.push_back(upper_tags_.size());
    }
    upper_tags_.push_back(ends.kind == FacetKind::joint ? tag(ends.j) : kGroundTag);
  }
  first_of_.push_back(upper_tags_.size());
}

void FixMuckpileJoint::refresh_enclosed() {
  cracked_since_build_ = false;
  if (version_ == 0) return;
  std::vector<bool> open(network_.blocks().size(), false);
  for (const BoundaryFace& face : network_.faces())
    open[static_cast<std::size_t>(face.block)] = true;
  for (std::size_t b = 0; b < open.size(); ++b) {
    if (network_.blocks()[b].retired.unbonded > 0.0) open[b] = true;
  }
  for (std::size_t f = 0; f < network_.facet_count(); ++f) {
    if (network_.states()[f] == FacetState::intact) continue;
    const FacetEnds ends = network_.ends(f);
    open[static_cast<std::size_t>(ends.i)] = open[static_cast<std::size_t>(ends.j)] = true;
  }
  enclosed_tags_.clear();
  for (std::size_t b = 0; b < open.size(); ++b) {
    const BlockConstants& block = network_.blocks()[b];
    if (block.owned && !open[b] && block.volume > 1e-300) enclosed_tags_.push_back(block.tag);
  }
  std::sort(enclosed_tags_.begin(), enclosed_tags_.end());
}

void FixMuckpileJoint::setup(int) {
  add_forces(0.0);  // no time passes: nothing is lost in dashpots
  step_check_.at_setup(*lmp, *this, store_->facets_created());
}

void FixMuckpileJoint::post_force(int) {
  add_forces(update->dt);
  ask_for_neighbours();
}

/// Poses and velocities are of one time here, so what is written on a stop can be looked at.
void FixMuckpileJoint::end_of_step() {
  if (contact_missed_) {
    engine::stop_with_state(
        *lmp, engine::name_of(*this) + ": a joint has let go" + engine::at_present(*lmp) +
                  ", and there is no pair_style: its blocks would pass through others; give "
                  "'pair_style muckpile/block' and 'pair_coeff * *'");
  }
  step_check_.at_end_of_step(*lmp, *this);
}

void FixMuckpileJoint::add_forces(double dt) {
  gather_state();
  if (gas_ != nullptr) press_gas();
  network_.step(dt, team());
  apply_forces();
}

void FixMuckpileJoint::press_gas() {
  const std::span<const double> pressure = gas_->pressure_in_joints();
  if (!pressure.empty()) network_.set_gas_pressure(pressure);
}

RankTeam FixMuckpileJoint::team() const {
  return {[this](std::span<double> values, std::size_t width) {
            store_->halo().forward(values, width);
          },
          [this](double mine) { return sum(mine); }, comm->nprocs};
}

void FixMuckpileJoint::gather_state() {
  const engine::Bodies bodies = store_->bodies();
  const engine::BlockHalo& halo = store_->halo();
  const std::span<BlockState> state = network_.state();
  for (int b = 0; b < bodies.count(); ++b) {
    BlockState& s = state[static_cast<std::size_t>(b)];
    s.centre = bodies.centre(b);
    s.velocity = bodies.velocity(b);
    s.spin = bodies.spin(b);
    s.rotation.noalias() =
        bodies.axes(b) * store_->records()[static_cast<std::size_t>(b)].start_axes.transpose();
  }
  if (comm->nprocs == 1) return;
  poses_.resize(halo.size() * kPoseWidth);
  for (std::size_t b = 0; b < halo.owned(); ++b) {
    double* to = poses_.data() + b * kPoseWidth;
    std::copy_n(state[b].centre.data(), 3, to);
    std::copy_n(state[b].velocity.data(), 3, to + 3);
    std::copy_n(state[b].spin.data(), 3, to + 6);
    std::copy_n(state[b].rotation.data(), 9, to + 9);
  }
  halo.forward(poses_, kPoseWidth);
  for (std::size_t b = halo.owned(); b < halo.size(); ++b) {
    const double* from = poses_.data() + b * kPoseWidth;
    state[b] = {Eigen::Map<const Mat3>(from + 9), Eigen::Map<const Vec3>(from),
                Eigen::Map<const Vec3>(from + 3), Eigen::Map<const Vec3>(from + 6)};
  }
}

void FixMuckpileJoint::apply_forces() {
  engine::Bodies bodies = store_->bodies();
  for (int b = 0; b < bodies.count(); ++b) {
    bodies.force(b) += network_.force()[static_cast<std::size_t>(b)];
    bodies.torque(b) += network_.torque()[static_cast<std::size_t>(b)];
  }
}

/// Blocks whose joint cracked need a contact search; looked up now and then, because a cracked
/// facet itself carries contact until it has slid by a tenth of its radius. On several ranks pairs
/// that a facet holds are left out of the list at rank borders: when it lets go they are missed.
void FixMuckpileJoint::ask_for_neighbours() {
  cracked_since_build_ = cracked_since_build_ || network_.books().newly_cracked ||
                         (comm->nprocs > 1 && network_.books().newly_let_go);
  if (update->ntimestep % kCheckEvery != 0) return;
  const bool unguarded = contact_check_ && !engine::has_contact_law(*lmp);
  const int mine = unguarded && joint_let_go() ? 2 : cracked_since_build_ ? 1 : 0;
  const int any = engine::greatest_over_ranks(mine, world);
  next_reneighbor = any != 0 ? update->ntimestep + 1 : -1;
  contact_missed_ = any == 2;
}

/// Two blocks that were joined may from now on meet without their facet.
bool FixMuckpileJoint::joint_let_go() const {
  for (const BlockConstants& block : network_.blocks())
    if (block.retired.count > 0.0) return true;
  for (std::size_t f = 0; f < network_.facet_count(); ++f) {
    if (network_.states()[f] >= FacetState::fading && network_.ends(f).kind == FacetKind::joint)
      return true;
  }
  return false;
}

}  // namespace muckpile
