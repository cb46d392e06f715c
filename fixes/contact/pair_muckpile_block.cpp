// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: arguments, checks, and what each step does in which order.
// Scope: its lists of pairs, exchange, forces and output are in files of their own.
#include "fixes/contact/pair_muckpile_block.h"

#include <atom.h>
#include <comm.h>
#include <fix_multisphere.h>
#include <force.h>
#include <memory.h>
#include <modify.h>
#include <neighbor.h>
#include <update.h>

#include <algorithm>
#include <cstring>

#include "args/arg_table.h"
#include "args/input_error.h"
#include "fixes/contact/solid_parts.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/keyword_tables.h"

namespace muckpile {

namespace {

constexpr const char* kHistoryId = "muckpile_contact_history";
constexpr const char* kHistoryStyle = "muckpile/contact/history";
constexpr const char* kShapesId = "muckpile_shapes";
constexpr const char* kShapesStyle = "muckpile/shapes";

/// It gets what a restart file holds of a fix of this ID and style.
void make_fix(LAMMPS_NS::Modify& modify, const char* id, const char* style) {
  std::array<std::string, 3> words{id, "all", style};
  std::array<char*, 3> arg{words[0].data(), words[1].data(), words[2].data()};
  modify.add_fix(3, arg.data());
}

const ArgTable& table() {
  static const ArgTable args =
      ArgTable(PairMuckpileBlock::kStyle)
          .word("shape", {"spheres", "polyhedra"}, "spheres",
                "what touches: the spheres of the blocks, or the blocks themselves")
          .word("model", {"hertz", "linear"}, "hertz",
                "normal force of spheres: Hertz-Mindlin or linear spring")
          .real("youngs_modulus", "Pa", Range::closed(1e3, 1e13), 5e8,
                "contact modulus of the rock")
          .real("poisson_ratio", "", Range::open(-1.0, 0.5), 0.25, "Poisson ratio of the rock")
          .real("restitution", "", Range::closed(0.05, 1.0), 0.2,
                "speed after over speed before a head-on impact")
          .real("friction", "", Range::closed(0.0, 10.0), 0.6, "Coulomb friction coefficient")
          .real("rolling_friction", "", Range::closed(0.0, 10.0), 0.1,
                "limit torque over reduced radius times normal force, of spheres");
  return args;
}

}  // namespace

const ArgTable& block_contact_keywords() { return table(); }

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
  const ArgValues in = engine::read_args(*lmp, table(), kStyle, narg, arg, 0);
  law_ = engine::or_engine_error(*lmp, [&] {
    ContactParameters p;
    p.model = in.word("model") == "linear" ? NormalModel::linear : NormalModel::hertz;
    p.youngs_modulus = in.real("youngs_modulus");
    p.poisson_ratio = in.real("poisson_ratio");
    p.restitution = in.real("restitution");
    p.friction = in.real("friction");
    p.rolling_friction = in.real("rolling_friction");
    const bool polyhedra = in.word("shape") == "polyhedra";
    if (polyhedra && p.model == NormalModel::linear)
      throw InputError(std::string(kStyle) +
                       ": model must be hertz with shape polyhedra, got 'linear'");
    hertz_.reset();
    if (p.model == NormalModel::hertz)
      hertz_ = BlockContacts{p.youngs_modulus, p.poisson_ratio, p.restitution, polyhedra};
    parameters_ = p;
    solids_.reset();
    if (polyhedra) solids_ = std::make_unique<SolidParts>(p);
    return ContactLaw(p);
  });
  if (solids_ != nullptr && engine::find_view<BlockShapes>(*lmp) == nullptr)
    make_fix(*modify, kShapesId, kShapesStyle);
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
  require(force->pair == this, "must be the only pair style, got it within another (hybrid)");
  require(modify->find_fix_style("multisphere", 0) != nullptr,
          "a fix multisphere must exist: it holds the blocks");
}

void PairMuckpileBlock::find_partners() {
  bodies_ = dynamic_cast<LAMMPS_NS::FixMultisphere*>(modify->find_fix_style("multisphere", 0));
  joints_ = engine::find_view<JointView>(*lmp);
  resting_ = engine::find_view<RestingBlocks>(*lmp);
  if (modify->find_fix(kHistoryId) < 0) make_fix(*modify, kHistoryId, kHistoryStyle);
  history_ = dynamic_cast<FixMuckpileContactHistory*>(modify->fix[modify->find_fix(kHistoryId)]);
  history_->set_source(this);
  if (history_->of_other_shape())
    engine::stop(*lmp, std::string(kStyle) +
                           ": shape must be that of the run that wrote the restart file, " +
                           (polyhedra() ? "spheres, got 'polyhedra'" : "polyhedra, got 'spheres'"));
}

void PairMuckpileBlock::init_style() {
  require_engine_settings();
  find_partners();
  double smallest = 0.0;
  modify->max_min_rad(largest_radius_, smallest);  // over all ranks, with particle templates
  if (solids_ == nullptr) return;
  solids_->shapes = engine::find_view<BlockShapes>(*lmp);
  if (solids_->shapes == nullptr)
    engine::stop(*lmp, std::string(kStyle) + ": shape polyhedra needs the fix '" + kShapesId +
                           "' that it has made; do not unfix it");
  largest_radius_ = std::max(largest_radius_, solids_->shapes->largest_reach());
}

double PairMuckpileBlock::init_one(int /*i*/, int /*j*/) { return 2.0 * largest_radius_; }

void PairMuckpileBlock::compute(int eflag, int vflag) {
  if (eflag || vflag)
    ev_setup(eflag, vflag);
  else
    evflag = vflag_fdotr = eflag_global = 0;
  act_ = act_of_step();
  const bool acts = act_.strength > 0.0 || update->setupflag != 0;
  if (neighbor->ago == 0 && list_is_stale_) {
    rebuild();
  } else if (acts && atom->nlocal + atom->nghost > 0) {
    list_.follow(atom->x[0], atom->omega[0], act_.elapsed);
    if (list_.outgrown() && !add_pairs()) {
      store_contacts(*history_);
      list_pairs();
    }
  }
  begin_loads();
  if (acts) {
    if (resting_ != nullptr && resting_->rests_version() != rests_version_) list_working_pairs(0);
    step_contacts();
    contacts_moved_ = true;
  }
  if (eflag_global) eng_vdwl += last_.elastic + resting_energy();
}

}  // namespace muckpile
