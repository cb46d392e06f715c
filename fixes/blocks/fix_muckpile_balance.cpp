// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/balance: the engine side of cutting the box by weight.
// Scope: see the header.
#include "fixes/blocks/fix_muckpile_balance.h"

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <modify.h>
#include <neighbor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/interfaces/acting_joints.h"
#include "partition/even_cuts.h"

namespace muckpile {
namespace {

constexpr int kBins = 8192;

// How far a block may be beyond its rank's border, over the skin: half, and a step more.
constexpr double kGoneOfSkin = 0.6;

// What a joint that acts costs each of its two blocks, over what else a block costs (moving it, its
// spheres and its contacts): profile of the throw phase of the default bench.
constexpr double kJointCost = 0.2;

std::vector<double> block_costs(LAMMPS_NS::LAMMPS& lmp, int blocks) {
  std::vector<double> costs(static_cast<std::size_t>(blocks), 1.0);
  if (const auto* joints = engine::find_view<ActingJoints>(lmp))
    joints->add_cost_of_joints(costs, kJointCost);
  return costs;
}

}  // namespace

FixMuckpileBalance::FixMuckpileBalance(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg) {
  const std::string where = engine::name_of(*this);
  if (narg != 3) engine::stop(*lmp, where + ": takes no keywords, got '" + arg[3] + "'");
  if (engine::find_multisphere(*lmp) == nullptr)
    engine::stop(*lmp, where + ": needs 'fix ID all multisphere' before it");
  if (domain->triclinic != 0) engine::stop(*lmp, where + ": the box must not be triclinic");
  scalar_flag = 1;
  global_freq = 1;
  extscalar = 0;
}

FixMuckpileBalance* FixMuckpileBalance::find(LAMMPS_NS::LAMMPS& lmp) {
  return dynamic_cast<FixMuckpileBalance*>(
      lmp.modify->find_fix_style_strict("muckpile/balance", 0));
}

void FixMuckpileBalance::init() {
  settle_box();
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  const std::vector<double> costs = block_costs(*lmp, bodies.count());
  std::vector<Load> loads;
  for (int b = 0; b < bodies.count(); ++b)
    loads.push_back({bodies.centre(b), costs[static_cast<std::size_t>(b)]});
  cut(loads, Reach::neighbours);
}

/// Meshes widen a box with `m` boundaries when the run starts, and with it the parts, which are
/// shares of the box: ranks would get blocks of ranks beyond their neighbours, which the engine
/// loses. So widen it now, and leave the borders in place.
void FixMuckpileBalance::settle_box() {
  if (atom->natoms == 0) return;
  std::array<std::vector<double>, 3> borders;  // [m]
  for (int axis = 0; axis < 3; ++axis) {
    const double low = domain->boxlo[axis], length = domain->boxhi[axis] - low;
    for (const double share : splits(axis)) borders.at(axis).push_back(low + share * length);
  }
  domain->reset_box();
  for (int axis = 0; axis < 3; ++axis) {
    const double low = domain->boxlo[axis], length = domain->boxhi[axis] - low;
    const std::span<double> shares = splits(axis);
    for (std::size_t k = 1; k + 1 < shares.size(); ++k)
      shares[k] = std::clamp((borders.at(axis)[k] - low) / length, 0.0, 1.0);
  }
  domain->set_local_box();
}

void FixMuckpileBalance::cut_for(std::span<const Vec3> centres) {
  if (atom->natoms > 0) return;
  std::vector<Load> loads;
  for (const Vec3& centre : centres) loads.push_back({centre, 1.0});
  cut(loads, Reach::any);
}

void FixMuckpileBalance::cut(std::span<const Load> loads, Reach reach) {
  for (int axis = 0; axis < 3; ++axis) {
    if (comm->procgrid[axis] > 1) cut_axis(axis, loads, reach);
  }
  domain->set_local_box();
}

std::span<double> FixMuckpileBalance::splits(int axis) {
  const std::array<double*, 3> all{comm->xsplit, comm->ysplit, comm->zsplit};
  return {all[static_cast<std::size_t>(axis)], static_cast<std::size_t>(comm->procgrid[axis]) + 1};
}

void FixMuckpileBalance::cut_axis(int axis, std::span<const Load> loads, Reach reach) {
  const double low = domain->boxlo[axis], length = domain->boxhi[axis] - low;
  std::vector<double> all(kBins, 0.0);
  for (const Load& load : loads) {
    const double bin = std::floor((load.centre[axis] - low) / length * kBins);
    if (std::isfinite(bin))
      all[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))] += load.cost;
  }
  engine::sum_over_ranks_in_place(all, world);
  const std::span<double> now = splits(axis);
  std::vector<double> cuts = even_cuts(all, comm->procgrid[axis]);
  // A part thinner than what it must know of its neighbours would talk to ranks farther away.
  const double halo = halo_known_ ? std::max(comm->cutghost[axis], neighbor->skin) : neighbor->skin;
  cuts = widened_cuts(std::move(cuts), halo / length);
  // Neighbours are looked for, and blocks change rank, once something has gone half the skin.
  const double gone = kGoneOfSkin * neighbor->skin;
  if (reach == Reach::neighbours) cuts = neighbourly_cuts(now, cuts, gone / length);
  std::copy(cuts.begin(), cuts.end(), now.begin());
}

/// The engine leaves its ghost layer's thickness uninitialised until a run is set up.
void FixMuckpileBalance::setup(int) { halo_known_ = true; }

double FixMuckpileBalance::compute_scalar() {
  const double mine = engine::Bodies(*engine::find_multisphere(*lmp)).count();
  const double most = engine::greatest_over_ranks(mine, world);
  const double all = engine::sum_over_ranks(mine, world);
  return all > 0.0 ? most * comm->nprocs / all : 1.0;
}

}  // namespace muckpile
