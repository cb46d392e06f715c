// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gas: its words, and how gas follows its block from rank to rank and ends.
// Scope: steps and outputs are in the files beside it; the laws are in core/gas.
#include "fixes/explosive/fix_muckpile_gas.h"

#include <fix_multisphere.h>
#include <modify.h>
#include <mpi.h>
#include <update.h>

#include <algorithm>

#include "args/numbers.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/keyword_tables.h"

namespace muckpile {
namespace {

const ArgTable& table() {
  static const ArgTable args =
      ArgTable("fix muckpile/gas")
          .real("residual_aperture", "m", Range::closed(1e-8, 0.1), 2e-4,
                "of a broken joint that is closed, without normal stress; the opening comes on top")
          .real("closure_share", "-", Range::right_open(0.0, 1.0), 0.45,
                "of that what endless normal stress closes; 0: stress closes nothing")
          .real("closure_stiffness", "Pa/m", Range::closed(1e6, 1e15), 2.5e10,
                "normal stiffness of the faces on each other without stress, k_ni")
          .real("roughness_coefficient", "-", Range::closed(0.0, 20.0), 10.0,
                "JRC, for the hydraulic aperture; 0: it is the mechanical one")
          .real("roughness", "m", Range::closed(0.0, 0.1), 1e-4,
                "height of the asperities, for the friction of the flow")
          .real(
              "open_gas", "-", Range::closed(1.0, 100.0), 1.0,
              "how far a joint may part, in radii of opening or slip or in rad of turn, before its "
              "gas goes to the atmosphere; beyond 1 it is a void between two blocks, which keeps "
              "gas that has not expanded to the atmosphere")
          .real("crack_spacing", "m", Range::closed(0.0, 100.0), 0.0,
                "0.01 or more: of the cracks of the rock, where blocks are larger: a joint stands "
                "for that many, which share its opening; 0: for one")
          .integer("every", "-", Range::closed(1, 100), 2,
                   "steps of the blocks in a step of the gas, at most, during which pressures hold")
          .real("longest_step", "s", Range::left_open(0.0, 1.0), 6e-5,
                "longest step of the gas, where `every` steps of the blocks are longer")
          .integer("calm_every", "-", Range::closed(1, 100), 8,
                   "steps of the gas, of which joints between blocks whose pressure hardly "
                   "changes are looked at in one; 1: in all")
          .integer("substeps", "-", Range::closed(1, 1000), 2, "of the flow in a step of the gas")
          .real("ambient_pressure", "Pa", Range::closed(1e3, 1e7), 101325.0, "of the atmosphere")
          .real("effusivity", "W s^0.5/(m2 K)", Range::closed(0.0, 1e5), 2500.0,
                "of the rock, (k rho c)^(1/2), for the heat that the walls of joints take; 0: none")
          .real("crushed_grain", "m", Range::closed(0.0, 1.0), 0.0,
                "diameter of the grains of the crushed zone, which take heat from the gas that "
                "passes them on its way into joints; 0: they take none")
          .real("heat_capacity", "J/(m3 K)", Range::closed(1e5, 1e7), 2.1e6,
                "of the rock by volume, rho c, for those grains")
          .real("rock_temperature", "K", Range::closed(200.0, 400.0), 288.0,
                "of the rock before the blast");
  return args;
}

CrushedBed make_bed(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const ArgValues& args) {
  return engine::or_engine_error(lmp, where, [&] {
    return CrushedBed({.grain = args.real("crushed_grain"),
                       .heat_capacity = args.real("heat_capacity"),
                       .rock = {.effusivity = args.real("effusivity"),
                                .rock_temperature = args.real("rock_temperature")}});
  });
}

JointGas make_gas(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const ArgValues& args,
                  const GasChambers& blast) {
  return engine::or_engine_error(lmp, where, [&] {
    return JointGas({.flow = {.gamma = blast.gas_gamma(), .roughness = args.real("roughness")},
                     .heat = {.effusivity = args.real("effusivity"),
                              .rock_temperature = args.real("rock_temperature")},
                     .open_gas = args.real("open_gas"),
                     .gas_constant = blast.gas_constant(),
                     .joint = {.residual_aperture = args.real("residual_aperture"),
                               .closure_share = args.real("closure_share"),
                               .closure_stiffness = args.real("closure_stiffness"),
                               .roughness = args.real("roughness_coefficient")},
                     .ambient = args.real("ambient_pressure"),
                     .crack_spacing = args.real("crack_spacing"),
                     .calm_every = static_cast<int>(args.integer("calm_every"))});
  });
}

}  // namespace

const ArgTable& gas_keywords() { return table(); }

FixMuckpileGas::FixMuckpileGas(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(engine::name_of(*this)), gas_({}), bed_({}) {
  engine::refuse_second_fix(*lmp, where_, "muckpile/gas");
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  auto* blast = engine::find_view<GasChambers>(*lmp);
  if (blast == nullptr) engine::stop(*lmp, where_ + ": needs a fix muckpile/blast before it");
  ambient_ = args.real("ambient_pressure");
  every_ = static_cast<int>(args.integer("every"));
  longest_step_ = args.real("longest_step");
  substeps_ = static_cast<int>(args.integer("substeps"));
  engine::or_engine_error(*lmp, [&] {
    blast->let_gas_into_joints(ambient_);
    return 0;
  });
  gas_ = make_gas(*lmp, where_, args, *blast);
  bed_ = make_bed(*lmp, where_, args);
  vector_flag = 1;
  size_vector = kOutputs;
  global_freq = 1;
  extvector = 0;
  nevery = 1;
  restart_global = 1;
}

int FixMuckpileGas::setmask() {
  return LAMMPS_NS::FixConst::PRE_NEIGHBOR | LAMMPS_NS::FixConst::END_OF_STEP;
}

/// An unfix lets all gas go, and the holes vent as fix muckpile/blast says by itself; at the end of
/// the program there is nothing to do.
void FixMuckpileGas::pre_delete(bool unfixflag) {
  auto* joints = unfixflag ? engine::find_view<JointsWithGas>(*lmp) : nullptr;
  if (joints != nullptr) joints->release_gas();
  auto* blast = unfixflag ? engine::find_view<GasChambers>(*lmp) : nullptr;
  if (blast != nullptr) blast->keep_gas_out_of_joints();
}

void FixMuckpileGas::init() {
  blast_ = engine::find_view<GasChambers>(*lmp);
  joints_ = engine::find_view<JointsWithGas>(*lmp);
  if (blast_ == nullptr || joints_ == nullptr)
    engine::stop(*lmp, where_ + ": needs fix muckpile/joint and fix muckpile/blast");
  const int here = modify->find_fix(id);
  if (engine::place_of<JointsWithGas>(*lmp) > here || engine::place_of<GasChambers>(*lmp) > here)
    engine::stop(*lmp,
                 where_ + ": must be defined after fix muckpile/joint and fix muckpile/blast");
  if (!spent_) joints_->keep_gas_in_joints();
  const auto holes = static_cast<std::size_t>(joints_->hole_count());
  fed_.resize(holes, 0);
  beds_.resize(holes);
  chambers_.resize(holes);
  kept_.resize(holes, 1.0);
}

/// After a restart file the gas has come to its blocks here, not in init().
void FixMuckpileGas::setup_pre_neighbor() {
  // Blocks that have just come to a rank have no volume for their gas until the next step.
  const double pressure = greatest_pressure();
  follow_blocks();
  release_from_softened_joints(pressure);
}

/// In joints, of the last step [Pa]; before the first one after a restart file, that of the file.
/// Collective.
double FixMuckpileGas::greatest_pressure() const {
  return std::max(greatest_in_joints(), restored_pressure_);
}

double FixMuckpileGas::greatest_in_joints() const {
  return over_ranks(gas_.greatest_pressure(), true);
}

/// Softening takes all tractions to a small share, but gas that stays pushes with all of its
/// pressure. Joints that are far stiffer than the gas that they hold bear that.
void FixMuckpileGas::release_from_softened_joints(double in_joints) {
  constexpr double kBearable = 0.01;  // pressure over shear modulus: strains of less than that
  const double before = softened_;
  softened_ = joints_->softened();
  if (softened_ >= before || !active_) return;
  read_chambers();
  double pressure = in_joints, left = 0.0;
  for (const GasChamber& chamber : chambers_) {
    pressure = std::max(pressure, chamber.gas.pressure);
    left += chamber.mass;
  }
  if (pressure <= kBearable * joints_->shear_modulus()) return;
  blast_->release_gas();
  joints_->unload_softened();
  end_of_gas("is released, as the joints have been softened, with up to " + number_text(pressure) +
             " Pa in them and " + number_text(left) + " kg in the holes,");
}

/// The gas in the joints goes into the atmosphere.
void FixMuckpileGas::end_of_gas(const std::string& how) {
  GasFlow left = gas_.contained();
  left += lost_;
  vented_ += over_ranks(left);
  lost_ = {};
  spent_ = true;
  active_ = false;
  joints_->release_gas();
  gas_.set_rooms(joints_->rooms());
  engine::print_once(*lmp, where_ + ": the gas in joints " + how + " at " +
                               number_text(update->get_cur_time()) + " s\n");
}

/// Gas follows its block from rank to rank.
void FixMuckpileGas::follow_blocks() {
  if (version_ == joints_->lists_version()) return;
  version_ = joints_->lists_version();
  std::vector<int> tags = joints_->block_tags();
  std::unordered_map<int, GasContent> contents;
  if (active_) contents = contents_here(tags);
  contents.merge(restored_);
  restored_.clear();
  gas_.set_rooms(joints_->rooms());
  const engine::BlockHalo& halo = joints_->halo();
  halo.forward(gas_.touches().first(halo.size()));
  tags_ = std::move(tags);
  for (std::size_t b = 0; b < tags_.size(); ++b) {
    const auto found = contents.find(tags_[b]);
    if (found != contents.end()) gas_.cells()[b].content = found->second;
  }
  halo.forward(gas_.press_as_before().first(halo.size()), 1);
}

/// The gas of the blocks with these tags, which are on this rank now. Collective.
std::unordered_map<int, GasContent> FixMuckpileGas::contents_here(const std::vector<int>& tags) {
  const engine::BlockDirectory directory(tags, world);
  std::vector<int> with_gas;
  std::unordered_map<int, GasContent> all;
  for (std::size_t b = 0; b < tags_.size(); ++b) {
    const GasContent& content = gas_.cells()[b].content;
    if (content.mass == 0.0 && content.heat == 0.0) continue;
    with_gas.push_back(tags_[b]);
    all[tags_[b]] = content;
  }
  const std::vector<int> owners = directory.owners(with_gas);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  std::vector<ByteWriter> outgoing(static_cast<std::size_t>(ranks));
  for (std::size_t k = 0; k < with_gas.size(); ++k) {
    const GasContent content = all[with_gas[k]];
    if (owners[k] < 0) lost_ += {content.mass, content.energy};
    if (owners[k] < 0 || owners[k] == rank) continue;
    outgoing[static_cast<std::size_t>(owners[k])].put(BlockGas{with_gas[k], content});
  }
  engine::or_engine_error(*lmp, where_, [&] {
    engine::exchange_messages(outgoing, world, [&all](ByteReader& in, std::size_t) {
      while (!in.empty()) {
        const auto arrived = in.get<BlockGas>();
        all[arrived.tag] = arrived.content;
      }
    });
  });
  return all;
}

}  // namespace muckpile
