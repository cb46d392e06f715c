// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/neighbours: the check of each step, in place of LIGGGHTS'.
// Scope: see the header.
#include "fix_muckpile_neighbours.h"

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <modify.h>
#include <mpi.h>
#include <neighbor.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "args/arg_table.h"
#include "args/numbers.h"
#include "engine/single_fix.h"
#include "engine/style_args.h"

namespace muckpile {
namespace {

constexpr const char* kStyle = "muckpile/neighbours";

const ArgTable& table() {
  static const ArgTable args =
      ArgTable(std::string("fix ") + kStyle)
          .real("border_skin", "m", Range::left_open(0.0, 1e3), std::nullopt,
                "how much further than contacts need it a rank knows the spheres of others");
  return args;
}

}  // namespace

FixMuckpileNeighbours::FixMuckpileNeighbours(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg), where_(std::string("fix muckpile/neighbours '") + id + "'") {
  engine::refuse_second_fix(*lmp, where_, kStyle);
  border_skin_ = engine::read_args(*lmp, table(), where_, narg, arg, 3).real("border_skin");
  scalar_flag = 1;
  global_freq = 1;
  extscalar = 0;
  force_reneighbor = 1;
  next_reneighbor = -1;
}

FixMuckpileNeighbours* FixMuckpileNeighbours::find(LAMMPS_NS::LAMMPS& lmp) {
  return dynamic_cast<FixMuckpileNeighbours*>(lmp.modify->find_fix_style_strict(kStyle, 0));
}

int FixMuckpileNeighbours::setmask() {
  return LAMMPS_NS::FixConst::POST_INTEGRATE | LAMMPS_NS::FixConst::PRE_NEIGHBOR;
}

double FixMuckpileNeighbours::thinner_by() const {
  return std::max(neighbor->skin - border_skin_, 0.0);
}

/// LIGGGHTS' own check is put off for ever; neighbours are found when this or another fix asks.
void FixMuckpileNeighbours::init() {
  refuse_bad_skin();
  refuse_moving_mesh();
  if (!took_over_) {
    engine_delay_ = neighbor->delay;
    engine_every_ = neighbor->every;
    took_over_ = true;
  }
  neighbor->every = 1;
  neighbor->delay = std::numeric_limits<int>::max();
}

/// With less than half, meshes would miss spheres: they look for them in bins as far as a rank
/// knows others.
void FixMuckpileNeighbours::refuse_bad_skin() const {
  const double skin = neighbor->skin;
  constexpr double kTyped = 1e-6;  // a script's half is rounded to ten digits
  if (border_skin_ <= (1.0 + kTyped) * skin && border_skin_ >= (0.5 - kTyped) * skin) return;
  engine::stop(*lmp, where_ + ": border_skin must be >= " + number_text(0.5 * skin) + " and <= " +
                         number_text(skin) + " m, half and whole skin of command neighbor, got '" +
                         number_text(border_skin_) + "'");
}

void FixMuckpileNeighbours::pre_delete(bool unfixed) {
  if (!unfixed || !took_over_) return;
  neighbor->delay = engine_delay_;
  neighbor->every = engine_every_;
}

/// A mesh that moves looks for spheres farther away than the bins that a thin border leaves it.
void FixMuckpileNeighbours::refuse_moving_mesh() const {
  if (thinner_by() > 0.0 && modify->n_fixes_style("move/mesh") > 0) {
    engine::stop(*lmp, where_ + ": border_skin must be the skin of command neighbor, " +
                           number_text(neighbor->skin) + " m, where a mesh moves");
  }
}

/// LIGGGHTS takes the skin to find out how many ranks away the spheres are that a rank must know.
void FixMuckpileNeighbours::refuse_thin_parts() const {
  if (thinner_by() <= 0.0) return;
  double thinnest = std::numeric_limits<double>::infinity(), of_all = 0.0, needed = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    if (comm->procgrid[axis] < 2) continue;
    thinnest = std::fmin(thinnest, domain->subhi[axis] - domain->sublo[axis]);
    needed = comm->cutghost[axis] + thinner_by();
  }
  MPI_Allreduce(&thinnest, &of_all, 1, MPI_DOUBLE, MPI_MIN, world);
  if (of_all >= needed) return;
  engine::stop(*lmp, where_ + ": each rank must have at least " + number_text(needed) +
                         " m of the box along each axis, one has " + number_text(of_all) +
                         " m; use fewer ranks, or the skin of command neighbor as border_skin");
}

void FixMuckpileNeighbours::setup(int) { refuse_thin_parts(); }

void FixMuckpileNeighbours::pre_neighbor() {
  held_.resize(static_cast<std::size_t>(atom->nlocal));
  for (std::size_t k = 0; k < held_.size(); ++k) held_[k] = Vec3::Map(atom->x[k]);
}

/// Walls list spheres up to half the skin away. Spheres of two ranks that do not know each other
/// are border_skin apart along an axis that ranks share, or that is periodic.
bool FixMuckpileNeighbours::moved_too_far() const {
  const double far = 0.25 * neighbor->skin * neighbor->skin;
  Vec3 allowed = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < 3; ++axis) {
    if (comm->procgrid[axis] > 1 || domain->periodicity[axis] != 0)
      allowed[axis] = 0.5 * border_skin_;
  }
  bool any = false;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const Vec3 way = Vec3::Map(atom->x[k]) - held_[k];
    any = any || !(way.squaredNorm() <= far) || (way.array().abs() > allowed.array()).any();
  }
  return any;
}

void FixMuckpileNeighbours::post_integrate() {
  int mine = moved_too_far() ? 1 : 0, any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  next_reneighbor = any != 0 ? update->ntimestep : -1;
}

double FixMuckpileNeighbours::compute_scalar() { return static_cast<double>(neighbor->ncalls); }

double FixMuckpileNeighbours::memory_usage() {
  return static_cast<double>(held_.capacity() * sizeof(Vec3));
}

}  // namespace muckpile
