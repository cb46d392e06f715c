// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gas: words, messages, and totals of mass and work; the laws are in core/gas.
#include "fixes/explosive/fix_muckpile_gas.h"

#include <comm.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <mpi.h>
#include <update.h>

#include <algorithm>
#include <numeric>

#include "args/numbers.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/explosive/fix_muckpile_blast.h"
#include "fixes/interfaces/keyword_tables.h"
#include "fixes/joints/fix_muckpile_joint.h"

namespace muckpile {
namespace {

enum Output { kInJoints, kTaken, kVented, kWork, kGreatest, kBlocks, kSpent, kOutputCount };

constexpr int kCellWidth = 4;                  // mass, entropy, volume, ways
constexpr int kContentWidth = 2;               // mass, entropy
constexpr LAMMPS_NS::bigint kLookEvery = 100;  // steps between looks whether the gas is spent
constexpr double kSpentShare = 0.2;  // spent: nowhere more than that share above the atmosphere

const ArgTable& table() {
  static const ArgTable args =
      ArgTable("fix muckpile/gas")
          .real("residual_aperture", "m", Range::closed(1e-8, 0.1), 1e-4,
                "of a broken joint that is closed; the opening comes on top")
          .real("roughness", "m", Range::closed(0.0, 0.1), 1e-4,
                "height of the asperities, for the friction of the flow")
          .integer("substeps", "-", Range::closed(1, 1000), 2, "of the flow in a step")
          .real("ambient_pressure", "Pa", Range::closed(1e3, 1e7), 101325.0, "of the atmosphere");
  return args;
}

std::string where_of(int narg, char** arg) {
  return std::string("fix muckpile/gas '") + (narg > 0 ? arg[0] : "") + "'";
}

JointGas make_gas(LAMMPS_NS::LAMMPS& lmp, const ArgValues& args, double gamma) {
  return engine::or_engine_error(lmp, [&] {
    return JointGas({.flow = {.gamma = gamma, .roughness = args.real("roughness")},
                     .residual_aperture = args.real("residual_aperture"),
                     .ambient = args.real("ambient_pressure")});
  });
}

}  // namespace

const ArgTable& gas_keywords() { return table(); }

FixMuckpileGas::FixMuckpileGas(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(where_of(narg, arg)), gas_({}) {
  engine::refuse_second_fix(*lmp, where_, "muckpile/gas");
  engine::require_id_of_restart(*lmp, where_, *this);
  const ArgValues args = engine::read_args(*lmp, table(), where_, narg, arg, 3);
  FixMuckpileBlast* blast = find_blast();
  if (blast == nullptr) engine::stop(*lmp, where_ + ": needs a fix muckpile/blast before it");
  ambient_ = args.real("ambient_pressure");
  substeps_ = static_cast<int>(args.integer("substeps"));
  engine::or_engine_error(*lmp, [&] {
    blast->let_gas_into_joints(ambient_);
    return 0;
  });
  gas_ = make_gas(*lmp, args, blast->gas_gamma());
  vector_flag = 1;
  size_vector = kOutputCount;
  global_freq = 1;
  extvector = 0;
  nevery = 1;
  restart_global = 1;
}

int FixMuckpileGas::setmask() {
  return LAMMPS_NS::FixConst::PRE_NEIGHBOR | LAMMPS_NS::FixConst::END_OF_STEP;
}

FixMuckpileBlast* FixMuckpileGas::find_blast() const { return FixMuckpileBlast::find(*lmp); }

FixMuckpileJoint* FixMuckpileGas::find_joint() const {
  return dynamic_cast<FixMuckpileJoint*>(modify->find_fix_style_strict("muckpile/joint", 0));
}

/// An unfix lets all gas go; at the end of the program there is nothing to do.
void FixMuckpileGas::pre_delete(bool unfixflag) {
  FixMuckpileJoint* joint = unfixflag ? find_joint() : nullptr;
  if (joint != nullptr) joint->joints_for_gas().release_gas();
}

void FixMuckpileGas::init() {
  blast_ = find_blast();
  joint_ = find_joint();
  if (blast_ == nullptr || joint_ == nullptr)
    engine::stop(*lmp, where_ + ": needs fix muckpile/joint and fix muckpile/blast");
  const int here = modify->find_fix(id);
  if (modify->find_fix(joint_->id) > here || modify->find_fix(blast_->id) > here)
    engine::stop(*lmp,
                 where_ + ": must be defined after fix muckpile/joint and fix muckpile/blast");
  if (!spent_) joint_->joints_for_gas().keep_gas_in_joints();
  const auto holes = static_cast<std::size_t>(joint_->hole_count());
  fed_.resize(holes, 0);
  chambers_.resize(holes);
}

/// After a restart file the gas has come to its blocks here, not in init().
void FixMuckpileGas::setup_pre_neighbor() {
  // Blocks that have just come to a rank have no volume for their gas until the next step.
  const double pressure = greatest_pressure();
  follow_blocks();
  let_go_of_softened_joints(pressure);
}

/// In joints, of the last step [Pa]; before the first one after a restart file, that of the file.
/// Collective.
double FixMuckpileGas::greatest_pressure() const {
  return std::max(over_ranks(gas_.greatest_pressure(), true), restored_pressure_);
}

/// Softening takes all tractions to a small share, but gas that stays pushes with all of its
/// pressure. Joints that are far stiffer than the gas that they hold bear that.
void FixMuckpileGas::let_go_of_softened_joints(double in_joints) {
  constexpr double kBearable = 0.01;  // pressure over shear modulus: strains of less than that
  const double before = softened_;
  softened_ = joint_->softened();
  if (softened_ >= before || !active_) return;
  read_chambers();
  double pressure = in_joints, left = 0.0;
  for (const GasChamber& chamber : chambers_) {
    pressure = std::max(pressure, chamber.gas.pressure);
    left += chamber.mass;
  }
  if (pressure <= kBearable * joint_->shear_modulus()) return;
  blast_->let_gas_go();
  joint_->unload_softened();
  end_of_gas("is let go, as the joints have been softened, with up to " + number_text(pressure) +
             " Pa in them and " + number_text(left) + " kg in the holes,");
}

/// The gas in the joints goes into the atmosphere.
void FixMuckpileGas::end_of_gas(const std::string& how) {
  vented_ += over_ranks(gas_.mass() + lost_);
  lost_ = 0.0;
  spent_ = true;
  active_ = false;
  joint_->joints_for_gas().release_gas();
  gas_.set_network(joint_->network());
  engine::print_once(*lmp, where_ + ": the gas in joints " + how + " at " +
                               number_text(update->get_cur_time()) + " s\n");
}

/// Gas follows its block from rank to rank.
void FixMuckpileGas::follow_blocks() {
  if (version_ == joint_->loaded_facets_version()) return;
  version_ = joint_->loaded_facets_version();
  std::vector<int> tags;
  for (const BlockRecord& record : joint_->blocks().records()) tags.push_back(record.tag);
  std::unordered_map<int, GasContent> contents;
  if (active_) contents = contents_here(tags);
  contents.merge(restored_);
  restored_.clear();
  gas_.set_network(joint_->network());
  engine::BlockHalo& halo = joint_->blocks().halo();
  halo.forward(gas_.touches().first(halo.size()));
  tags_ = std::move(tags);
  for (std::size_t b = 0; b < tags_.size(); ++b) {
    const auto found = contents.find(tags_[b]);
    if (found != contents.end()) gas_.cells()[b].content = found->second;
  }
}

/// The gas of the blocks with these tags, which are on this rank now. Collective.
std::unordered_map<int, GasContent> FixMuckpileGas::contents_here(const std::vector<int>& tags) {
  const engine::BlockDirectory directory(tags, world);
  std::vector<int> with_gas;
  std::unordered_map<int, GasContent> all;
  for (std::size_t b = 0; b < tags_.size(); ++b) {
    if (gas_.cells()[b].content.mass == 0.0) continue;
    with_gas.push_back(tags_[b]);
    all[tags_[b]] = gas_.cells()[b].content;
  }
  const std::vector<int> owners = directory.owners(with_gas);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  std::vector<engine::ByteWriter> outgoing(static_cast<std::size_t>(ranks));
  for (std::size_t k = 0; k < with_gas.size(); ++k) {
    const GasContent content = all[with_gas[k]];
    if (owners[k] < 0) lost_ += content.mass;
    if (owners[k] < 0 || owners[k] == rank) continue;
    outgoing[static_cast<std::size_t>(owners[k])].put(with_gas[k]);
    outgoing[static_cast<std::size_t>(owners[k])].put(content);
  }
  for (const auto& part : engine::exchange_bytes(engine::bytes_of(outgoing), world)) {
    for (engine::ByteReader reader(part); !reader.empty();) {
      const int tag = reader.get<int>();
      all[tag] = reader.get<GasContent>();
    }
  }
  return all;
}

void FixMuckpileGas::fill_joints(FacetNetwork& network, engine::BlockHalo& halo) {
  if (!active_) return;
  gas_.measure(network, fed_);
  numbers_.resize(halo.size() * kCellWidth);
  const std::span<GasCell> cells = gas_.cells();
  for (std::size_t b = 0; b < halo.owned(); ++b) {
    const GasCell& cell = cells[b];
    const std::array<double, kCellWidth> row = {cell.content.mass, cell.content.entropy,
                                                cell.volume, cell.ways};
    std::copy(row.begin(), row.end(), numbers_.data() + b * kCellWidth);
  }
  halo.forward(numbers_, kCellWidth);
  for (std::size_t b = halo.owned(); b < halo.size(); ++b) {
    const double* row = numbers_.data() + b * kCellWidth;
    cells[b] = {{row[0], row[1]}, row[2], row[3]};
  }
  gas_.press(network);
}

void FixMuckpileGas::end_of_step() {
  if (spent_) return;
  restored_pressure_ = 0.0;
  read_chambers();
  if (!active_) {  // the gas flows from the step after the first hole fires
    active_ = std::any_of(fed_.begin(), fed_.end(), [](char fed) { return fed != 0; });
    return;
  }
  book_work();
  count_chamber_ways();
  for (int k = 0; k < substeps_; ++k) {
    if (k > 0) refresh();
    flow(update->dt / substeps_);
  }
  lost_ += gas_.open_wide(joint_->joints_for_gas());
  if (update->ntimestep % kLookEvery == 0) look_whether_spent();
}

void FixMuckpileGas::read_chambers() {
  for (std::size_t hole = 0; hole < chambers_.size(); ++hole) {
    chambers_[hole] = blast_->chamber(hole);
    fed_[hole] = chambers_[hole].gas.pressure > 0.0 ? 1 : 0;
  }
}

/// With full-step velocities force x velocity x dt is exactly the work that the integrator lets the
/// force do.
void FixMuckpileGas::book_work() {
  const engine::Bodies bodies(joint_->blocks().multisphere());
  const FacetNetwork& network = joint_->network();
  if (network.gas_force().empty()) return;
  double rate = 0.0;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto k = static_cast<std::size_t>(b);
    rate += network.gas_force()[k].dot(bodies.velocity(b)) +
            network.gas_torque()[k].dot(bodies.spin(b));
  }
  work_ += rate * update->dt;
  joint_->joints_for_gas().book_gas_work(rate * update->dt);
}

/// Sums the conductance of the ways out of each chamber over ranks, in the pose that measure() saw.
void FixMuckpileGas::count_chamber_ways() {
  if (std::none_of(fed_.begin(), fed_.end(), [](char hole) { return hole != 0; })) return;
  ways_.assign(chambers_.size(), 0.0);
  std::ranges::copy(gas_.chamber_ways(), ways_.begin());
  MPI_Allreduce(MPI_IN_PLACE, ways_.data(), static_cast<int>(ways_.size()), MPI_DOUBLE, MPI_SUM,
                world);
  for (std::size_t hole = 0; hole < ways_.size(); ++hole) chambers_[hole].ways = ways_[hole];
}

/// Pressures of blocks and chambers after a substep of the flow, for the next one.
void FixMuckpileGas::refresh() {
  const std::vector<GasChamber> before = chambers_;
  read_chambers();
  for (std::size_t hole = 0; hole < chambers_.size(); ++hole)
    chambers_[hole].ways = before[hole].ways;
  engine::BlockHalo& halo = joint_->blocks().halo();
  contents_.resize(halo.size() * kContentWidth);
  const std::span<GasCell> cells = gas_.cells();
  for (std::size_t b = 0; b < halo.owned(); ++b) {
    contents_[b * kContentWidth] = cells[b].content.mass;
    contents_[b * kContentWidth + 1] = cells[b].content.entropy;
  }
  halo.forward(contents_, kContentWidth);
  for (std::size_t b = halo.owned(); b < halo.size(); ++b)
    cells[b].content = {contents_[b * kContentWidth], contents_[b * kContentWidth + 1]};
  gas_.refresh();
}

void FixMuckpileGas::flow(double dt) {
  const JointGas::Flows flows = gas_.flow(chambers_, dt);
  std::vector<double> sums = flows.from_hole;
  sums.push_back(flows.vented + lost_);
  lost_ = 0.0;
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM,
                world);
  vented_ += sums.back();
  sums.pop_back();
  taken_ += std::accumulate(sums.begin(), sums.end(), 0.0);
  blast_->take_gas(sums);
}

void FixMuckpileGas::look_whether_spent() {
  const bool fed = std::any_of(fed_.begin(), fed_.end(), [](char hole) { return hole != 0; });
  const double greatest = over_ranks(gas_.greatest_pressure(), true);
  if (fed || !blast_->over() || greatest > (1.0 + kSpentShare) * ambient_) return;
  end_of_gas("is spent");
}

void FixMuckpileGas::write_restart(FILE* file) {
  engine::ByteWriter common, mine;
  common.put(active_);
  common.put(spent_);
  common.put_all(fed_);
  common.put(taken_);
  common.put(vented_);
  common.put(over_ranks(lost_));
  common.put(over_ranks(work_));
  common.put(softened_);
  common.put(greatest_pressure());
  for (std::size_t b = 0; b < tags_.size(); ++b) {
    mine.put(tags_[b]);
    mine.put(gas_.cells()[b].content);
  }
  // Between read_restart and the first run every rank has the gas of all blocks.
  for (const auto& [tag, content] : restored_) {
    if (comm->me != 0) break;
    mine.put(tag);
    mine.put(content);
  }
  engine::write_state(*lmp, style, file, common, mine);
}

/// The contents of all blocks, until follow_blocks() picks those of this rank.
void FixMuckpileGas::restart(char* state) {
  engine::ByteReader reader = engine::read_state(state);
  active_ = reader.get<bool>();
  spent_ = reader.get<bool>();
  fed_ = reader.get_all<char>();
  taken_ = reader.get<double>();
  vented_ = reader.get<double>();
  lost_ = engine::share_of_total(*lmp, reader.get<double>());
  work_ = engine::share_of_total(*lmp, reader.get<double>());
  softened_ = reader.get<double>();
  restored_pressure_ = reader.get<double>();
  while (!reader.empty()) {
    const int tag = reader.get<int>();
    restored_[tag] = reader.get<GasContent>();
  }
}

double FixMuckpileGas::over_ranks(double mine, bool greatest) const {
  double all = 0.0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, greatest ? MPI_MAX : MPI_SUM, world);
  return all;
}

double FixMuckpileGas::compute_vector(int n) {
  switch (n) {
    case kInJoints:
      return over_ranks(gas_.mass());
    case kTaken:
      return taken_;
    case kVented:
      return vented_ + over_ranks(lost_);
    case kWork:
      return over_ranks(work_);
    case kGreatest:
      return over_ranks(gas_.greatest_pressure(), true);
    case kBlocks:
      return over_ranks(gas_.blocks_with_gas());
    case kSpent:
      return spent_ ? 1.0 : 0.0;
    default:
      return 0.0;
  }
}

}  // namespace muckpile
