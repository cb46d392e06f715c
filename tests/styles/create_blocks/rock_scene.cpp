// SPDX-License-Identifier: GPL-2.0-or-later
// A LIGGGHTS run inside a test: set-up, motion, read-out.
// Scope: see the header.
#include "rock_scene.h"

#include <atom.h>
#include <fix.h>
#include <fix_multisphere.h>
#include <input.h>
#include <lammps.h>
#include <modify.h>
#include <multisphere.h>

#include <array>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "engine/bodies.h"
#include "engine/registry.h"

namespace muckpile::test {
namespace {

constexpr std::size_t kRow = 24;  // numbers per block in blocks()

std::string text(double value) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.17g", value);
  return buffer.data();
}

Mat3 inertia_of(LAMMPS_NS::FixMultisphere& fix, const engine::Bodies& bodies, int b) {
  using Vectors = LAMMPS_NS::VectorContainer<double, 3>;
  double** principal = fix.data().prop().getElementProperty<Vectors>("inertia")->begin();
  const Mat3 axes = bodies.axes(b);
  return axes * Vec3(principal[b]).asDiagonal() * axes.transpose();
}

}  // namespace

RockScene::RockScene(MPI_Comm comm, const std::string& box, const std::string& processors)
    : comm_(comm) {
  std::array<std::string, 7> words{"test", "-screen", "none", "-log", "none", "-echo", "none"};
  std::array<char*, 7> arg{};
  for (std::size_t i = 0; i < words.size(); ++i) arg[i] = words[i].data();
  lmp_ = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arg.size()), arg.data(), comm_);
  engine::register_styles(*lmp_);
  for (const std::string& line :
       {std::string("units si"), std::string("atom_style granular"),
        std::string("atom_modify map array sort 0 0"), std::string("newton off"),
        std::string("boundary f f f"), std::string("communicate single cutoff 1.0 vel yes"),
        "processors " + processors, "region box block " + box + " units box",
        std::string("create_box 1 box"), std::string("neighbor 0.05 bin"),
        std::string("neigh_modify delay 0"), std::string("fix bodies all multisphere")}) {
    command(line);
  }
}

RockScene::~RockScene() = default;

void RockScene::command(const std::string& line) { lmp_->input->one(line.c_str()); }

void RockScene::cut(const std::string& block, const std::string& words) {
  command("region rock block " + block + " units box");
  command("create_blocks rock " + words);
}

void RockScene::run(int steps, double time_step) {
  command("timestep " + text(time_step));
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
  int ranks = 0, size = static_cast<int>(mine.size()), total = 0;
  MPI_Comm_size(comm_, &ranks);
  std::vector<int> sizes(static_cast<std::size_t>(ranks)), starts(sizes.size());
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm_);
  for (std::size_t r = 0; r < sizes.size(); ++r) {
    starts[r] = total;
    total += sizes[r];
  }
  std::vector<double> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, all.data(), sizes.data(), starts.data(), MPI_DOUBLE,
                 comm_);
  std::map<int, BlockNow> result;
  for (std::size_t k = 0; k < all.size(); k += kRow) {
    const double* row = all.data() + k;
    result[static_cast<int>(row[0])] = {Vec3(row + 1), Vec3(row + 4), Vec3(row + 7), Vec3(row + 10),
                                        row[13],       row[14],       Mat3(row + 15)};
  }
  return result;
}

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
