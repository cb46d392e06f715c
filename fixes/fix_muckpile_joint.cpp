// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint: the engine side of the facet network.
// Scope: see the header.
#include "fix_muckpile_joint.h"

#include <comm.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "args/numbers.h"
#include "engine/bodies.h"
#include "engine/single_fix.h"
#include "engine/style_args.h"

namespace muckpile {
namespace {

constexpr std::size_t kPoseWidth = 18;         // centre, velocity, spin, rotation
constexpr LAMMPS_NS::bigint kCheckEvery = 50;  // steps between looks for newly cracked facets
constexpr double kDegree = M_PI / 180.0;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum Output {
  joints,
  broken,
  broken_share,
  elastic,
  fracture,
  friction,
  damping,
  longest_step,
  pressure_work_done,
  softened,
  output_count
};

/// Of a joint alone [Pa/m]; 0 stands for rigid.
Range stiffness_range() { return Range::closed(0.0, 1e15); }

const ArgTable& table() {
  static const ArgTable args =
      ArgTable("fix muckpile/joint")
          .real("youngs_modulus", "Pa", Range::closed(1e5, 1e13), std::nullopt, "of the rock")
          .real("poisson_ratio", "", Range::right_open(0.0, 0.5), std::nullopt, "of the rock")
          .real("density", "kg/m3", Range::closed(100.0, 30000.0), std::nullopt,
                "of the rock; sets the damping only")
          .real("cohesion", "Pa", Range::non_negative(), std::nullopt,
                "shear strength without normal stress")
          .real("friction_angle", "deg", Range::right_open(0.0, 90.0), std::nullopt,
                "of the unbroken joint")
          .real("tension", "Pa", Range::non_negative(), std::nullopt, "tensile strength (cut-off)")
          .real("residual_friction_angle", "deg", Range::right_open(0.0, 90.0), 35.0,
                "of the broken joint")
          .real("normal_stiffness", "Pa/m", stiffness_range(), 0.0,
                "of the joint alone, in series with the rock; 0: rigid")
          .real("shear_stiffness", "Pa/m", stiffness_range(), 0.0,
                "of the joint alone, in series with the rock; 0: rigid")
          .real("damping", "", Range::closed(0.0, 10.0), 0.0,
                "of intact joints, share of density x P-wave speed per area")
          .real("contact_damping", "", Range::closed(0.0, 10.0), 0.05,
                "of closed broken facets, share of density x P-wave speed per area")
          .group("joint_class", 6, 6, true,
                 "natural joints of the planes that create_blocks gives this class: cohesion [Pa], "
                 "friction angle [deg], tension [Pa], residual friction angle [deg], normal and "
                 "shear stiffness [Pa/m; 0: rigid]; the first one is class 1, the next class 2")
          .real("fracture_energy_tension", "J/m2", Range::non_negative(), 0.0,
                "taken as tension falls to nothing, linearly with the opening; 0: at once")
          .real("fracture_energy_shear", "J/m2", Range::non_negative(), 0.0,
                "taken as cohesion falls to nothing, linearly with the slip; 0: at once")
          .real("rate_exponent", "", Range::closed(0.0, 1.0), 0.0,
                "tension and cohesion grow with this power of the strain rate; 0: not")
          .real("reference_rate", "1/s", Range::positive(), 1e-6,
                "strain rate up to which strength is that at rest")
          .integer(
              "open_sleep", "steps", Range::closed(0, 1000), 20,
              "longest time that a broken, open facet is left alone while its gap lasts; 0: never");
  return args;
}

double rigid_if_0(double stiffness) { return stiffness > 0.0 ? stiffness : kInfinity; }

std::vector<JointClass> joint_classes(const ArgValues& args, const std::string& where) {
  std::vector<JointClass> classes;
  for (const auto& words : args.groups("joint_class")) {
    const auto number = [&](std::size_t k, const char* unit, const Range& range) {
      return parse_real(where, "joint_class", words[k], unit, range);
    };
    const Range size = Range::non_negative(), angle = Range::right_open(0.0, 90.0);
    JointClass joint;
    joint.cohesion = number(0, "Pa", size);
    joint.friction_angle = number(1, "deg", angle) * kDegree;
    joint.tension = number(2, "Pa", size);
    joint.residual_friction_angle = number(3, "deg", angle) * kDegree;
    joint.normal_stiffness = rigid_if_0(number(4, "Pa/m", stiffness_range()));
    joint.shear_stiffness = rigid_if_0(number(5, "Pa/m", stiffness_range()));
    classes.push_back(joint);
  }
  return classes;
}

FacetNetwork make_network(LAMMPS_NS::LAMMPS& lmp, const std::string& where, int narg, char** arg) {
  const ArgValues args = engine::read_args(lmp, table(), where, narg, arg, 3);
  JointParameters p;
  p.youngs_modulus = args.real("youngs_modulus");
  p.poisson_ratio = args.real("poisson_ratio");
  p.density = args.real("density");
  p.cohesion = args.real("cohesion");
  p.tension = args.real("tension");
  p.friction_angle = args.real("friction_angle") * kDegree;
  p.residual_friction_angle = args.real("residual_friction_angle") * kDegree;
  p.normal_stiffness = rigid_if_0(args.real("normal_stiffness"));
  p.shear_stiffness = rigid_if_0(args.real("shear_stiffness"));
  p.damping = args.real("damping");
  p.contact_damping = args.real("contact_damping");
  p.fracture_energy_tension = args.real("fracture_energy_tension");
  p.fracture_energy_shear = args.real("fracture_energy_shear");
  p.rate_exponent = args.real("rate_exponent");
  p.reference_rate = args.real("reference_rate");
  p.longest_sleep = static_cast<double>(args.integer("open_sleep"));
  return engine::or_engine_error(
      lmp, [&] { return FacetNetwork(JointMaterial(p), joint_classes(args, where)); });
}

std::string name_of(int narg, char** arg) {
  return std::string("fix muckpile/joint '") + (narg > 0 ? arg[0] : "") + "'";
}

}  // namespace

FixMuckpileJoint::FixMuckpileJoint(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), network_(make_network(*engine, name_of(narg, arg), narg, arg)) {
  engine::refuse_second_fix(*lmp, name_of(narg, arg), "muckpile/joint");
  engine::require_id_of_restart(*lmp, name_of(narg, arg), *this);
  if (engine::find_multisphere(*lmp) == nullptr) {
    engine::stop(*lmp, name_of(narg, arg) + ": needs 'fix ID all multisphere' before it");
  }
  if (modify->have_restart_data_style("muckpile/blocks") &&
      FixMuckpileBlocks::find(*lmp) == nullptr) {
    engine::stop(*lmp,
                 name_of(narg, arg) +
                     ": after read_restart it needs 'fix ID all multisphere/muckpile', with the "
                     "ID that it had when the file was written, before it");
  }
  if (std::strcmp(update->unit_style, "si") != 0) {
    engine::stop(*lmp,
                 name_of(narg, arg) + ": needs 'units si', got 'units " + update->unit_style + "'");
  }
  vector_flag = 1;
  size_vector = output_count;
  global_freq = 1;
  extvector = 0;
  force_reneighbor = 1;
  next_reneighbor = -1;
  restart_global = 1;
}

FixMuckpileJoint::~FixMuckpileJoint() {
  if (store_ != nullptr) store_->set_keeper(nullptr);
}

int FixMuckpileJoint::setmask() {
  return LAMMPS_NS::FixConst::PRE_NEIGHBOR | LAMMPS_NS::FixConst::POST_FORCE;
}

void FixMuckpileJoint::init() {
  FixMuckpileBlocks* found = FixMuckpileBlocks::find(*lmp);
  if (found == nullptr) {
    engine::stop(*lmp, std::string("fix muckpile/joint '") + id +
                           "': needs create_blocks before the first run");
  }
  if (modify->find_fix(found->id) > modify->find_fix(id)) {
    engine::stop(
        *lmp, std::string("fix muckpile/joint '") + id + "': must be defined after create_blocks");
  }
  if (store_ == nullptr) {
    store_ = found;
    store_->set_keeper(this);
  }
  gas_ = nullptr;
  for (int i = 0; i < modify->nfix; ++i) {
    if (auto* gas = dynamic_cast<JointPressure*>(modify->fix[i])) gas_ = gas;
  }
  check_classes();
  follow_blocks();
  end_what_does_not_go_on();
}

void FixMuckpileJoint::check_classes() const {
  int mine = store_->highest_joint_class(), most = 0;
  MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, world);
  const auto given = static_cast<int>(network_.natural_classes());
  if (most <= given) return;
  engine::stop(*lmp, std::string("fix muckpile/joint '") + id +
                         "': create_blocks has a joint_plane of class " + std::to_string(most) +
                         ", but joint_class is given " + std::to_string(given) + " time(s)");
}

FacetLists FixMuckpileJoint::copy() const {
  return {network_.facets(), network_.memory(), network_.faces()};
}

FacetLists FixMuckpileJoint::hand_back() {
  FacetLists lists;
  network_.give_up(lists.facets, lists.memory, lists.faces);
  return lists;
}

void FixMuckpileJoint::follow_blocks() {
  refresh_enclosed();
  if (version_ == store_->version()) return;
  version_ = store_->version();
  std::vector<BlockConstants> blocks;
  for (const BlockRecord& r : store_->records())
    blocks.push_back({r.tag, std::max(r.volume, 1e-300), r.mass, true, r.retired});
  for (int tag : store_->copy_tags()) blocks.push_back({tag, 1.0, 1.0, false, {}});
  network_.set_blocks(std::move(blocks));
  FacetLists lists = store_->hand_over();
  network_.set_facets(std::move(lists.facets), std::move(lists.memory));
  network_.set_faces(std::move(lists.faces));

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
  for (const Facet& facet : network_.facets()) {
    if (lower_tags_.empty() || lower_tags_.back() != facet.tag_i) {
      lower_tags_.push_back(facet.tag_i);
      first_of_.push_back(upper_tags_.size());
    }
    upper_tags_.push_back(facet.kind == FacetKind::joint ? facet.tag_j : kGroundTag);
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
  add_forces(0.0);
}  // no time passes: nothing is lost in dashpots

void FixMuckpileJoint::post_force(int) {
  add_forces(update->dt);
  ask_for_neighbours();
}

void FixMuckpileJoint::add_forces(double dt) {
  gather_state();
  compute_bulk_stresses(dt);
  if (gas_ != nullptr) gas_->fill_joints(network_, store_->halo());
  network_.tractions(dt);
  apply_forces();
}

void FixMuckpileJoint::compute_bulk_stresses(double dt) {
  engine::BlockHalo& halo = store_->halo();
  network_.dilatation(dt);
  halo.forward(network_.theta().first(halo.size()), 1);
  network_.bulk_stresses();
  halo.forward(network_.bulk_stress().first(halo.size()), 1);
}

void FixMuckpileJoint::gather_state() {
  const engine::Bodies bodies(store_->multisphere());
  engine::BlockHalo& halo = store_->halo();
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
    state[b] = {Eigen::Map<const Vec3>(from), Eigen::Map<const Vec3>(from + 3),
                Eigen::Map<const Vec3>(from + 6), Eigen::Map<const Mat3>(from + 9)};
  }
}

void FixMuckpileJoint::apply_forces() {
  engine::Bodies bodies(store_->multisphere());
  for (int b = 0; b < bodies.count(); ++b) {
    bodies.force(b) += network_.force()[static_cast<std::size_t>(b)];
    bodies.torque(b) += network_.torque()[static_cast<std::size_t>(b)];
  }
}

/// Blocks whose joint cracked need a contact search; looked up now and then, because a cracked
/// facet itself carries contact until it has slid by a tenth of its radius.
void FixMuckpileJoint::ask_for_neighbours() {
  cracked_since_build_ = cracked_since_build_ || network_.newly_cracked();
  if (update->ntimestep % kCheckEvery != 0) return;
  int mine = cracked_since_build_ ? 1 : 0, any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  next_reneighbor = any != 0 ? update->ntimestep + 1 : -1;
}

int FixMuckpileJoint::facet_between(int block_tag_a, int block_tag_b) const {
  const auto [lower, upper] = std::minmax(block_tag_a, block_tag_b);
  const auto found = std::lower_bound(lower_tags_.begin(), lower_tags_.end(), lower);
  if (found == lower_tags_.end() || *found != lower) return -1;
  const auto k = static_cast<std::size_t>(found - lower_tags_.begin());
  for (std::size_t f = first_of_[k]; f < first_of_[k + 1]; ++f) {
    if (upper_tags_[f] == upper) return static_cast<int>(f);
  }
  return -1;
}

bool FixMuckpileJoint::enclosed(int block_tag) const {
  return std::binary_search(enclosed_tags_.begin(), enclosed_tags_.end(), block_tag);
}

int FixMuckpileJoint::hole_count() const {
  const FixMuckpileBlocks* store = FixMuckpileBlocks::find(*lmp);
  return store == nullptr ? 0 : static_cast<int>(store->holes().size());
}

const Hole& FixMuckpileJoint::hole(int index) const {
  return FixMuckpileBlocks::find(*lmp)->holes()[static_cast<std::size_t>(index)];
}

void FixMuckpileJoint::set_pressure(std::span<const double> pressure,
                                    std::span<const double> wave_share) {
  for (std::size_t k = 0; k < loaded_faces_.size(); ++k) {
    BoundaryFace& face = network_.faces()[loaded_faces_[k]];
    face.pressure = pressure[k];
    face.wave_share = wave_share[k];
  }
}

void FixMuckpileJoint::swept_volume(std::span<double> per_hole) const {
  std::fill(per_hole.begin(), per_hole.end(), 0.0);
  for (std::size_t k : loaded_faces_) {
    const BoundaryFace& face = network_.faces()[k];
    per_hole[static_cast<std::size_t>(face.hole)] += network_.volume_swept(face);
  }
}

YieldingSupports::Chosen FixMuckpileJoint::let_ground_yield(
    const std::function<bool(const Vec3&)>& chosen, double rock_behind) {
  network_.let_ground_yield(QuietGround(network_.material(), rock_behind), chosen);
  Chosen yielding;
  for (std::size_t f = 0; f < network_.facet_count(); ++f) {
    if (!network_.memory()[f].ground().yields) continue;
    yielding.count += 1.0;
    yielding.area += network_.area(f);
  }
  return yielding;
}

StepBound FixMuckpileJoint::stable_step(Breaking breaking, double guess) const {
  const engine::Bodies bodies(store_->multisphere());
  std::vector<Mat3> inertia;
  for (int b = 0; b < bodies.count(); ++b) inertia.push_back(bodies.inertia_in_space(b));
  RankTeam team;
  team.fill_copies = [this](std::span<double> values, std::size_t width) {
    store_->halo().forward(values, width);
  };
  team.sum = [this](double mine) { return sum(mine); };
  return muckpile::stable_step(network_, inertia, breaking, team, guess);
}

/// Into of_blocks_, of copies too; the ground's is 0.
void FixMuckpileJoint::gather_flags(std::span<const char> of_bodies) {
  of_blocks_.assign(network_.blocks().size(), 0);
  std::copy(of_bodies.begin(), of_bodies.end(), of_blocks_.begin());
  store_->halo().forward(std::span(of_blocks_).first(store_->halo().size()));
}

void FixMuckpileJoint::mark_joined(std::span<const char> moves, std::span<char> disturbed) {
  gather_flags(moves);
  std::vector<int> all(of_blocks_.size(), 0);
  network_.mark_joined(of_blocks_, all);
  for (std::size_t b = 0; b < disturbed.size(); ++b)
    disturbed[b] = disturbed[b] != 0 || all[b] != 0 ? 1 : 0;
}

void FixMuckpileJoint::let_rest(std::span<const char> rests) {
  gather_flags(rests);
  of_blocks_.back() = 1;  // the ground
  network_.let_rest(of_blocks_);
}

double FixMuckpileJoint::sum(double mine) const {
  double all = 0.0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixMuckpileJoint::compute_vector(int n) {
  switch (n) {
    case joints:
      return store_ == nullptr ? 0.0 : store_->facets_created();
    case broken:
      return sum(network_.broken_count());
    case broken_share:
      return sum(network_.broken_area(false)) / std::max(sum(network_.broken_area(true)), 1e-300);
    case elastic:
      return sum(network_.elastic_energy());
    case fracture:
      return sum(network_.losses().fracture);
    case friction:
      return sum(network_.losses().friction);
    case damping:
      return sum(network_.losses().damping);
    case pressure_work_done:
      return sum(network_.pressure_work());
    case longest_step:
      return version_ == 0 ? kInfinity : stable_step(Breaking::possible, 0.0).seconds;
    case softened:
      return network_.totals().softened;
    default:
      return 0.0;
  }
}

int FixMuckpileJoint::modify_param(int narg, char** arg) {
  if (std::strcmp(arg[0], "soften") != 0) return 0;
  const std::string where = std::string("fix_modify ") + id;
  if (narg < 2) engine::stop(*lmp, where + ": soften needs a factor in (0, 1]");
  const bool damps = narg > 2 && std::strcmp(arg[2], "damping") == 0;
  if (damps && narg < 4) engine::stop(*lmp, where + ": soften ... damping needs a share >= 0");
  if (version_ == 0) engine::stop(*lmp, where + ": soften needs a run (run 0 will do) before it");
  engine::or_engine_error(*lmp, [&] {
    const double factor = parse_real(where, "soften", arg[1], "", Range::left_open(0.0, 1.0));
    std::optional<double> damping;
    if (damps) damping = parse_real(where, "damping", arg[3], "", Range::closed(0.0, 10.0));
    gather_state();
    compute_bulk_stresses(0.0);
    network_.soften(factor, damping);
    return 0;
  });
  return damps ? 4 : 2;
}

double FixMuckpileJoint::memory_usage() {
  const auto bytes = [](const auto&... table) {
    return (static_cast<double>(table.capacity() * sizeof(table[0])) + ...);
  };
  return network_.memory_usage() +
         bytes(lower_tags_, upper_tags_, first_of_, enclosed_tags_, loaded_, poses_);
}

}  // namespace muckpile
