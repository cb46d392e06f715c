// SPDX-License-Identifier: GPL-2.0-or-later
// A LIGGGHTS run inside a test: set-up, block creation, read-out.
// Scope: see the header.
#include "block_scene.h"

#include <atom.h>
#include <atom_vec.h>
#include <domain.h>
#include <fix.h>
#include <fix_multisphere.h>
#include <force.h>
#include <lammps.h>
#include <modify.h>
#include <multisphere.h>
#include <pair.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "args/numbers.h"
#include "fixes/engine/bodies.h"
#include "fixes/interfaces/contact_work.h"
#include "fixes/interfaces/paced_contacts.h"
#include "silent_engine.h"

namespace muckpile::testing {

BlockScene::BlockScene(MPI_Comm comm, double half_box, double skin, const std::string& contact)
    : comm_(comm) {
  lmp_ = test::silent_engine(comm_);
  const std::string h = number_text(half_box), side = " -" + h + " " + h;
  // A split in x, where the scenes have their action.
  test::run_lines(
      *lmp_,
      {"units si", "atom_style granular", "atom_modify map array", "boundary f f f", "newton off",
       "communicate single vel yes", "processors * 1 1", "region box block" + side + side + side,
       "create_box 1 box", "neighbor " + number_text(skin) + " bin", "neigh_modify delay 0",
       "pair_style muckpile/block " + contact, "pair_coeff * *", "fix bodies all multisphere"});
}

BlockScene::~BlockScene() = default;

void BlockScene::command(const std::string& line) { test::run_lines(*lmp_, {line}); }

void BlockScene::place(const BlockSpec& block, int first_atom_tag) {
  LAMMPS_NS::Atom& atom = *lmp_->atom;
  LAMMPS_NS::FixMultisphere& fix = *engine::find_multisphere(*lmp_);
  const auto count = static_cast<int>(block.balls.size());
  std::vector<Vec3> offsets;
  for (const Ball& ball : block.balls) offsets.push_back(ball.offset);
  std::vector<double*> rows;
  double reach = 0.0;
  for (int k = 0; k < count; ++k) {
    const Ball& ball = block.balls[static_cast<std::size_t>(k)];
    rows.push_back(offsets[static_cast<std::size_t>(k)].data());
    reach = std::max(reach, ball.offset.norm() + ball.radius);
    Vec3 at = block.centre + ball.offset;
    atom.avec->create_atom(1, at.data());
    const int m = atom.nlocal - 1;
    atom.tag[m] = first_atom_tag + k;
    atom.mask[m] = 1;
    atom.radius[m] = ball.radius;
    atom.density[m] = 1000.0;
    atom.rmass[m] = block.mass;
    for (int f = 0; f < lmp_->modify->nfix; ++f)
      if (lmp_->modify->fix[f]->create_attribute != 0) lmp_->modify->fix[f]->set_arrays(m);
    fix.set_body_displace(m, rows.back(), block.tag, 1.0 / count);
  }
  Vec3 centre = block.centre, zero = Vec3::Zero(), velocity = block.velocity, spin = block.spin;
  Vec3 inertia = block.inertia;
  Mat3 axes = Mat3::Identity();
  std::array<bool, 3> free{!block.fixed, !block.fixed, !block.fixed};
  fix.data().add_body(count, centre.data(), zero.data(), reach, velocity.data(), spin.data(),
                      block.mass, 1000.0, 1, 1, inertia.data(), axes.col(0).data(),
                      axes.col(1).data(), axes.col(2).data(), rows.data(), free.data(),
                      free.data());
  fix.data()
      .prop()
      .getElementProperty<LAMMPS_NS::ScalarContainer<int>>("id_multisphere")
      ->set(fix.n_body() - 1, block.tag);
}

void BlockScene::add(const std::vector<BlockSpec>& blocks) {
  LAMMPS_NS::Atom& atom = *lmp_->atom;
  // The first set-up of a run would wipe what a just created fix knows of its atoms.
  for (int f = 0; f < lmp_->modify->nfix; ++f) lmp_->modify->fix[f]->just_created = 0;
  const double *low = lmp_->domain->sublo, *high = lmp_->domain->subhi;
  int tag = 1;
  for (const BlockSpec& block : blocks) {
    bool mine = true;
    for (int d = 0; d < 3; ++d)
      mine = mine && block.centre[d] >= low[d] && block.centre[d] < high[d];
    if (mine) place(block, tag);
    tag += static_cast<int>(block.balls.size());
  }
  LAMMPS_NS::bigint local = atom.nlocal;
  MPI_Allreduce(&local, &atom.natoms, 1, MPI_LMP_BIGINT, MPI_SUM, comm_);
  atom.nghost = 0;
  atom.map_init();
  atom.map_set();
  engine::find_multisphere(*lmp_)->add_body_finalize();
}

void BlockScene::run(int steps, double time_step) {
  command("timestep " + number_text(time_step));
  command("run " + std::to_string(steps));
}

std::map<int, BlockNow> BlockScene::blocks() const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp_));
  std::vector<double> mine;
  for (int b = 0; b < bodies.count(); ++b) {
    mine.push_back(bodies.tag(b));
    for (const Vec3& v : {Vec3(bodies.centre(b)), Vec3(bodies.velocity(b)), Vec3(bodies.spin(b))})
      mine.insert(mine.end(), v.data(), v.data() + 3);
    mine.push_back(bodies.kinetic_energy(b));
  }
  const std::vector<double> all = test::gather(mine, comm_);
  std::map<int, BlockNow> result;
  for (std::size_t k = 0; k + 11 <= all.size(); k += 11) {
    const double* row = all.data() + k;
    result[static_cast<int>(row[0])] = {Vec3(row + 1), Vec3(row + 4), Vec3(row + 7), row[10]};
  }
  return result;
}

void BlockScene::compute_contacts() { lmp_->force->pair->compute(0, 0); }

void BlockScene::act_every(int steps) {
  dynamic_cast<PacedContacts&>(*lmp_->force->pair).act_every(steps);
}

bool BlockScene::acts_for_several() const {
  return dynamic_cast<const PacedContacts&>(*lmp_->force->pair).act_for_several();
}

void BlockScene::watch_contacts() { dynamic_cast<ContactWork&>(*lmp_->force->pair).watch(); }

double BlockScene::sum(const char* name) const {
  int dim = 0;
  const auto* value = static_cast<const double*>(lmp_->force->pair->extract(name, dim));
  if (value == nullptr) throw std::logic_error(name);
  double all = 0.0;
  MPI_Allreduce(value, &all, 1, MPI_DOUBLE, MPI_SUM, comm_);
  return all;
}

double BlockScene::energy_account() const {
  double energy = sum("elastic_J") + sum("friction_J") + sum("damping_J");
  for (const auto& [tag, block] : blocks()) energy += block.kinetic_J;
  return energy;
}

}  // namespace muckpile::testing
