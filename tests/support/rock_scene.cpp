// SPDX-License-Identifier: GPL-2.0-or-later
// A LIGGGHTS run inside a test: set-up, motion, read-out.
// Scope: see the header.
#include "rock_scene.h"

#include <atom.h>
#include <fix.h>
#include <fix_multisphere.h>
#include <force.h>
#include <input.h>
#include <lammps.h>
#include <modify.h>
#include <multisphere.h>
#include <update.h>
#include <variable.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "args/numbers.h"
#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/engine/bodies.h"
#include "silent_engine.h"

namespace muckpile::test {
namespace {

constexpr std::size_t kRow = 24;  // numbers per block in blocks()

Mat3 inertia_of(LAMMPS_NS::FixMultisphere& fix, const engine::Bodies& bodies, int b) {
  using Vectors = LAMMPS_NS::VectorContainer<double, 3>;
  double** principal = fix.data().prop().getElementProperty<Vectors>("inertia")->begin();
  const Mat3 axes = bodies.axes(b);
  return axes * Vec3(principal[b]).asDiagonal() * axes.transpose();
}

}  // namespace

RockScene::RockScene(MPI_Comm comm, const std::string& box, const std::string& processors,
                     const std::string& bodies)
    : RockScene(comm) {
  run_lines(*lmp_, {"processors " + processors, "region box block " + box + " units box",
                    "create_box 1 box", "neighbor 0.05 bin", "neigh_modify delay 0",
                    "fix bodies all " + bodies});
}

RockScene::RockScene(MPI_Comm comm) : comm_(comm), lmp_(silent_engine(comm)) {
  run_lines(*lmp_, {"units si", "atom_style granular", "atom_modify map array sort 0 0",
                    "newton off", "boundary f f f", "communicate single cutoff 1.0 vel yes"});
}

RockScene RockScene::restarted(MPI_Comm comm, const std::string& file,
                               const std::string& processors, const std::string& bodies) {
  RockScene scene(comm);
  run_lines(*scene.lmp_, {"processors " + processors, "read_restart " + file, "neighbor 0.05 bin",
                          "neigh_modify delay 0", "fix bodies all " + bodies});
  return scene;
}

RockScene::~RockScene() = default;
RockScene::RockScene(RockScene&&) noexcept = default;

void RockScene::command(const std::string& line) { run_lines(*lmp_, {line}); }

void RockScene::cut(const std::string& block, const std::string& words) {
  command("region rock block " + block + " units box");
  command("create_blocks rock " + words);
}

void RockScene::run(int steps, double time_step) {
  command("timestep " + number_text(time_step));
  command("run " + std::to_string(steps));
}

void RockScene::set_motion(const std::function<Motion(int, const Vec3&)>& rule) {
  LAMMPS_NS::FixMultisphere& fix = *engine::find_multisphere(*lmp_);
  engine::Bodies bodies(fix);
  for (int b = 0; b < bodies.count(); ++b) {
    const Motion motion = rule(bodies.tag(b), bodies.centre(b));
    bodies.velocity(b) = motion.velocity;
    bodies.spin(b) = motion.spin;
    bodies.angular_momentum(b) = inertia_of(fix, bodies, b) * motion.spin;
  }
}

std::map<int, BlockNow> RockScene::blocks() const {
  LAMMPS_NS::FixMultisphere& fix = *engine::find_multisphere(*lmp_);
  const engine::Bodies bodies(fix);
  std::vector<double> mine;
  const auto put = [&](const double* from, int count) {
    mine.insert(mine.end(), from, from + count);
  };
  for (int b = 0; b < bodies.count(); ++b) {
    mine.push_back(bodies.tag(b));
    for (const Vec3& v : {Vec3(bodies.centre(b)), Vec3(bodies.velocity(b)), Vec3(bodies.spin(b)),
                          Vec3(bodies.angular_momentum(b))}) {
      put(v.data(), 3);
    }
    mine.push_back(bodies.mass(b));
    mine.push_back(bodies.kinetic_energy(b));
    put(inertia_of(fix, bodies, b).data(), 9);
  }
  const std::vector<double> all = gather(mine, comm_);
  std::map<int, BlockNow> result;
  for (std::size_t k = 0; k < all.size(); k += kRow) {
    const double* row = all.data() + k;
    result[static_cast<int>(row[0])] = {Vec3(row + 1), Vec3(row + 4), Vec3(row + 7), Vec3(row + 10),
                                        row[13],       row[14],       Mat3(row + 15)};
  }
  return result;
}

std::map<int, SphereNow> RockScene::all_spheres() const {
  const LAMMPS_NS::Atom& atom = *lmp_->atom;
  std::vector<double> mine;
  for (int i = 0; i < atom.nlocal; ++i) {
    mine.push_back(atom.tag[i]);
    mine.insert(mine.end(), atom.x[i], atom.x[i] + 3);
    mine.insert(mine.end(), atom.v[i], atom.v[i] + 3);
    mine.push_back(atom.radius[i]);
  }
  const std::vector<double> all = gather(mine, comm_);
  std::map<int, SphereNow> result;
  for (std::size_t k = 0; k < all.size(); k += 8) {
    const double* row = all.data() + k;
    result[static_cast<int>(row[0])] = {Vec3(row + 1), Vec3(row + 4), row[7]};
  }
  return result;
}

double RockScene::variable(const std::string& name) const {
  std::string word = name;
  return lmp_->input->variable->compute_equal(lmp_->input->variable->find(word.data()));
}

void RockScene::spoil_contacts(double share) {
  dynamic_cast<PairMuckpileBlock&>(*lmp_->force->pair).spoil(share);
}

double RockScene::time_step() const { return lmp_->update->dt; }

double RockScene::output(const std::string& id, int n) const {
  const int index = lmp_->modify->find_fix(id.c_str());
  if (index < 0) throw std::logic_error("no fix " + id);
  LAMMPS_NS::Fix& fix = *lmp_->modify->fix[index];
  return n == 0 ? fix.compute_scalar() : fix.compute_vector(n - 1);
}

double RockScene::kinetic_energy() const {
  double energy = 0.0;
  for (const auto& [tag, block] : blocks()) energy += block.kinetic;
  return energy;
}

int RockScene::own_blocks() const { return engine::find_multisphere(*lmp_)->n_body(); }

double RockScene::spheres() const { return static_cast<double>(lmp_->atom->natoms); }

}  // namespace muckpile::test
