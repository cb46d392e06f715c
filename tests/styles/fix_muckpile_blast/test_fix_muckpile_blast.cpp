// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blast in the engine: resultant on each hole, energy, gas, end of the load, errors
// aside. Scope: a small block of rock with two holes; runs on any number of ranks.
#include <fix.h>
#include <gtest/gtest.h>
#include <lammps.h>
#include <modify.h>
#include <mpi.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "explosive/starfield_pulse.h"
#include "fixes/engine/bodies.h"
#include "geometry/cut/tessellation.h"
#include "geometry/shape/polyhedron.h"
#include "silent_engine.h"

namespace muckpile {
namespace {

const std::vector<Hole> kHoles = {{{-0.5, 0.05, -0.3}, {-0.5, 0.05, 0.3}, 0.15},
                                  {{0.5, 0.0, -0.2}, {0.55, 0.0, 0.4}, 0.15}};
constexpr double kBlockSize = 0.22;  // [m]
constexpr unsigned long kSeed = 3;
constexpr double kDensity = 2700.0;

/// The rock that the script below makes, cut again without the engine.
Tessellation rock() {
  TessellationOptions options;
  options.lo = {-1, -0.6, -0.6};
  options.hi = {1, 0.6, 0.6};
  options.holes = kHoles;
  options.size = SizeLaw::uniform(kBlockSize);
  options.seed = kSeed;
  options.sweeps = 3;
  return tessellate(options);
}

class Engine {
 public:
  /// `joint`: words of fix muckpile/joint; `blast`: words of fix muckpile/blast.
  Engine(const std::string& joint, const std::string& blast, const std::string& timestep) {
    test::run_lines(
        *lmp_,
        {"units si", "atom_style granular", "atom_modify map array sort 0 0", "newton off",
         "boundary f f f", "communicate single cutoff 1.0 vel yes", "processors * 1 1",
         "region box block -2 2 -2 2 -2 2 units box", "create_box 1 box", "neighbor 0.01 bin",
         "timestep " + timestep, "region rock block -1 1 -0.6 0.6 -0.6 0.6 units box",
         "fix bodies all multisphere", create_blocks(), "fix joints all muckpile/joint " + joint,
         "fix load all muckpile/blast " + blast});
  }

  void command(const std::string& line) { test::run_lines(*lmp_, {line}); }
  [[nodiscard]] LAMMPS_NS::LAMMPS& lmp() { return *lmp_; }
  /// f_load[n], f_joints[n], n from 1.
  [[nodiscard]] double load(int n) { return fix("load").compute_vector(n - 1); }
  /// f_load[hole][column], both from 1.
  [[nodiscard]] double hole(int hole, int column) {
    return fix("load").compute_array(hole - 1, column - 1);
  }
  /// f_energy[n]; n = 0: f_energy.
  [[nodiscard]] double ledger(int n) {
    return n == 0 ? fix("energy").compute_scalar() : fix("energy").compute_vector(n - 1);
  }
  [[nodiscard]] double joints(int n) { return fix("joints").compute_vector(n - 1); }

  [[nodiscard]] double kinetic_energy() {
    const engine::Bodies bodies(*engine::find_multisphere(*lmp_));
    double own = 0.0, all = 0.0;
    for (int b = 0; b < bodies.count(); ++b) own += bodies.kinetic_energy(b);
    MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return all;
  }

 private:
  static std::string create_blocks() {
    std::string text =
        "create_blocks rock density 2700 size uniform 0.22 block_min 0.22 block_max "
        "0.22 spheres_per_block 1 sweeps 3 seed 3";
    for (const Hole& hole : kHoles) {
      text += " hole";
      for (const Vec3& end : {hole.toe, hole.collar}) {
        for (int k = 0; k < 3; ++k) text += ' ' + std::to_string(end[k]);
      }
      text += ' ' + std::to_string(hole.radius);
    }
    return text;
  }
  LAMMPS_NS::Fix& fix(const std::string& id) {
    return *lmp_->modify->fix[lmp_->modify->find_fix(id.c_str())];
  }

  std::unique_ptr<LAMMPS_NS::LAMMPS> lmp_ = test::silent_engine(MPI_COMM_WORLD);
};

const std::string kStrong =
    " density 2700 cohesion 1e12 friction_angle 50 tension 1e12 contact_damping 0";
const std::string kCharge = "explosive_density 1100 vod 4500 hole_diameter 0.1 poisson_ratio 0.25 ";

/// -sum of A n over a block's faces on a hole: the force per pressure [m2].
Vec3 push(const Block& block, int hole) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
    if (block.neighbour[f] != hole_face(hole)) continue;
    const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
    sum -= face.area * face.normal;
  }
  return sum;
}

TEST(FixMuckpileBlast, ResultantOnEachHoleIsPressureTimesTrueArea) {
  // No force at time 0, so the blocks still stand where they were when the first step is done, and
  // their momentum is half a step of its force. Joints that carry next to nothing: a face's
  // pressure pulls no neighbour along.
  constexpr double kStep = 3e-5;
  Engine engine(
      "youngs_modulus 55e9 poisson_ratio 0 normal_stiffness 1e-6 shear_stiffness 1e-6" + kStrong,
      "explosive_density 1100 vod 1e20 hole_diameter 0.1 peak_pressure 5e7 rise_time 1e-4 "
      "gas no hole 2 delay 1e-5",
      "3e-5");
  engine.command("run 1");
  const Tessellation cut = rock();
  const std::array<double, 2> pressure{5e7 * StarfieldPulse(1e-4).shape(kStep),
                                       5e7 * StarfieldPulse(1e-4).shape(kStep - 1e-5)};
  const engine::Bodies bodies(*engine::find_multisphere(engine.lmp()));
  double worst = 0.0;
  std::array<double, 8> own{}, all{};  // per hole: |F| over its blocks, net force
  for (int b = 0; b < bodies.count(); ++b) {
    const Block& block = cut.blocks.at(static_cast<std::size_t>(bodies.tag(b) - 1));
    const Vec3 force = 2.0 * bodies.mass(b) * bodies.velocity(b) / kStep;
    Vec3 expected = Vec3::Zero();
    for (std::size_t h = 0; h < 2; ++h) {
      const Vec3 share = push(block, static_cast<int>(h));
      expected += pressure[h] * share;
      if (share.norm() == 0.0) continue;
      own[h * 4] += force.dot(share.normalized());
      for (std::size_t k = 0; k < 3; ++k) own[h * 4 + 1 + k] += force[static_cast<int>(k)];
    }
    worst = std::max(worst, (force - expected).norm());
  }
  MPI_Allreduce(own.data(), all.data(), 8, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  for (std::size_t h = 0; h < 2; ++h) {
    double area = 0.0;
    for (const Block& block : cut.blocks) area += push(block, static_cast<int>(h)).norm();
    ASSERT_GT(area,
              0.4);  // about 2 pi 0.15 (0.6 + 0.15) = 0.7 m2, less where a block has two faces
    // rounding of some hundred sums, and of momentum of blocks 1 m from the origin
    EXPECT_NEAR(all[h * 4] / (pressure[h] * area), 1.0, 1e-11) << "hole " << h + 1;
    const Vec3 net(all[h * 4 + 1], all[h * 4 + 2], all[h * 4 + 3]);
    EXPECT_LT(net.norm(), 1e-11 * pressure[h] * area) << "hole " << h + 1;
  }
  EXPECT_LT(worst, 1e-11 * pressure[0] * kBlockSize * kBlockSize);
  EXPECT_NEAR(engine.load(1), pressure[0], 1e-12 * pressure[0]);
}

TEST(FixMuckpileBlast, WorkOfThePressureIsTheEnergyOfTheBlocks) {
  Engine engine("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
                kCharge + "rise_time 1e-4 vent_time 1e-2 vent_decay 5e-3", "1e-6");
  engine.command("run 300");
  const double energy = engine.kinetic_energy() + engine.joints(4);
  ASSERT_GT(energy, 1e4);
  EXPECT_NEAR(engine.load(4) / energy, 1.0, 2e-3);  // O(dt^2) energy of the integrator, O(dt) gas
}

TEST(FixMuckpileBlast, GasFollowsTheSweptVolume) {
  Engine engine("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
                kCharge + "rise_time 1e-4 pulse no vent_time 1e-4 vent_decay 5e-4", "1e-6");
  engine.command("run 300");
  // hole 1: V0 = pi 0.05^2 0.6 = 4.712389e-3, Vk = 2.405648 V0 = 1.133635e-2 m3; both holes sweep
  const double swept = engine.load(3);
  ASSERT_GT(swept, 1e-6);
  const double decay = std::exp(-2e-4 / 5e-4);
  // One hole's swept volume is not an output: its pressure lies between none and all of it swept.
  EXPECT_LT(engine.load(2), 200e6 * decay);
  EXPECT_GT(engine.load(2), 200e6 * std::pow(1.0 + swept / 1.133635e-2, -1.4) * decay);
}

TEST(FixMuckpileBlast, WaveAndGasShareTheWork) {
  const std::string charge = "explosive anfo hole_diameter 0.1 poisson_ratio 0.25 rise_time 2e-5 ";
  Engine both("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
              charge + "vent_time 1e-2 vent_decay 5e-3", "1e-6");
  both.command("run 300");
  EXPECT_GT(both.load(7), 0.0);
  EXPECT_GT(both.load(8), 0.0);
  EXPECT_NEAR(both.load(7) + both.load(8), both.load(4), 1e-9 * both.load(4));
  // two charges, pi 0.05^2 (0.6 + 0.6021) x 800 x 3.8e6; 0.05 m aslant: sqrt(0.6^2 + 0.05^2)
  EXPECT_NEAR(both.load(9), M_PI * 0.0025 * (0.6 + 0.60208) * 800 * 3.8e6, 1e3);
  EXPECT_NEAR(both.load(10), both.load(9) / 3.8e6, 1e-6);
  Engine wave("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong, charge + "gas no", "1e-6");
  wave.command("run 300");
  EXPECT_NEAR(wave.load(7), wave.load(4), 1e-9 * wave.load(4));
}

TEST(FixMuckpileBlast, GasThatFlowsOutIsMissingAndPressesLess) {
  const std::string charge = kCharge + "pulse no rise_time 2e-5 venting flow ";
  Engine open("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
              charge + "stemming_length 0 crack_delay 1", "1e-6");
  Engine closed("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
                charge + "stemming_length 100 crack_delay 1", "1e-6");
  open.command("run 400");
  closed.command("run 400");
  EXPECT_EQ(closed.load(11), 1.0);
  EXPECT_LT(open.load(11), 0.999);
  EXPECT_GT(open.load(11), 0.5);
  EXPECT_LT(open.load(2), closed.load(2));
}

TEST(FixMuckpileBlast, EachHoleAccountsForItsCharge) {
  constexpr int kStemming = 9, kOut = 11, kSpeed = 12, kError = 13;
  Engine engine(
      "youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
      "explosive emulsion hole_diameter 0.1 poisson_ratio 0.25 rise_time 2e-5 venting flow "
      "stemming_length 0.02 crack_delay 1 interval 1e-4",
      "1e-6");
  engine.command("run 90");
  EXPECT_EQ(engine.hole(2, 1), 0.0);  // it has not fired
  EXPECT_EQ(engine.hole(2, kOut), -1.0);
  engine.command("run 310");
  double stemming = 0.0, error = 0.0;
  for (const int hole : {1, 2}) {
    const double charge = engine.hole(hole, 1);
    // pi 0.05^2 0.6 x 1100 x 3.0e6; hole 2 is 0.602 m long
    EXPECT_NEAR(charge, M_PI * 0.0025 * 0.601 * 1100 * 3.0e6, 0.002 * charge) << hole;
    EXPECT_NEAR(engine.hole(hole, kError) / charge, 0.0, 1e-3) << hole;
    // 36 kg/m2 under 1017 MPa or less: after 37 us at the earliest, with 1064 m/s at most
    EXPECT_GT(engine.hole(hole, kOut), 3.7e-5) << hole;
    EXPECT_LT(engine.hole(hole, kOut), 1e-4) << hole;
    EXPECT_LT(engine.hole(hole, kSpeed), 1064.0) << hole;
    // half of 36 kg/m2 pi 0.05^2 m2 times that speed squared; the plug moves in steps
    const double motion = 0.5 * 36.0 * M_PI * 0.0025 * std::pow(engine.hole(hole, kSpeed), 2.0);
    EXPECT_NEAR(engine.hole(hole, kStemming) / motion, 1.0, 0.03) << hole;
    stemming += engine.hole(hole, kStemming);
    error += engine.hole(hole, kError);
  }
  EXPECT_NEAR(engine.load(22) / stemming, 1.0, 1e-12);
  EXPECT_NEAR(engine.load(23), error, 1e-9 * engine.load(9));
}

/// Joints of 22 kPa under some 100 MPa: the walls would give way by thousands of the crushed zone's
/// volume.
TEST(FixMuckpileBlast, GasThatSoftenedJointsDoNotBearIsLetGo) {
  constexpr int kError = 0, kWork = 5;  // of the ledger
  Engine engine("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
                kCharge + "rise_time 2e-5 vent_time 0.01 vent_decay 0.01", "2e-6");
  engine.command("fix energy all muckpile/ledger");
  engine.command("run 100");
  ASSERT_GT(engine.load(1), 1e7);
  const double work = engine.ledger(kWork);
  engine.command("fix_modify joints soften 1e-6");
  engine.command("run 100");
  EXPECT_EQ(engine.load(6), 1.0);  // over
  EXPECT_EQ(engine.load(1), 0.0);
  EXPECT_NEAR(engine.ledger(kWork) / work, 1.0, 1e-6);
  EXPECT_LT(engine.ledger(kError), 0.01);
}

TEST(FixMuckpileBlast, GasThatSoftenedJointsBearStays) {
  Engine engine("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
                kCharge + "rise_time 2e-5 vent_time 1e-4 vent_decay 2e-5", "2e-6");
  engine.command("run 130");  // 0.26 ms: some 1 MPa
  const double pressure = engine.load(1);
  ASSERT_GT(pressure, 1e4);
  ASSERT_LT(pressure, 2e6);
  engine.command("fix_modify joints soften 1e-3");  // 22 MPa
  engine.command("run 1");
  EXPECT_GT(engine.load(1), 0.5 * pressure);
}

TEST(FixMuckpileBlast, StartsWithItsDelayAndEndsWhenTheLoadHasGone) {
  struct Moment {
    const char* run;
    double active, over;
  };
  // Hole 1 fires at 20 us; column 0.6 m / 45 km/s = 13 us; 4 x 2^(-t/3 us) falls below 1e-4 after
  // 46 us: over at 79 us. Hole 2 fires at 100 us and is over at 100 + 14 + 46 = 160 us.
  for (const Moment& moment : {Moment{"run 15", 0.0, 0.0}, Moment{"run 30", 1.0, 0.0},
                               Moment{"run 95", 0.0, 0.0}, Moment{"run 180", 0.0, 1.0}}) {
    Engine engine("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
                  "explosive_density 1100 vod 45000 hole_diameter 0.1 peak_pressure 5e7 "
                  "rise_time 3e-6 gas no interval 1e-4 hole 1 delay 2e-5",
                  "1e-6");
    engine.command(moment.run);
    EXPECT_EQ(engine.load(5), moment.active) << moment.run;
    EXPECT_EQ(engine.load(6), moment.over) << moment.run;
    if (moment.active > 0.0) {
      EXPECT_GT(engine.load(1), 1e7) << moment.run;
    } else {
      EXPECT_EQ(engine.load(1), 0.0) << moment.run;
    }
  }
}

/// The wall of hole 1 opens at 20 m/s: by 1 % of the zone's volume in 0.1 ms. What the gas holds 2
/// us after it has fired.
double energy_of_first(bool opens, bool given_later) {
  const std::string words =
      "explosive_density 1100 vod 4500 hole_diameter 0.1 poisson_ratio 0.25 "
      "pulse no vent_time 0.01 vent_decay 0.005 interval 10 hole 1 delay ";
  Engine engine("youngs_modulus 55e9 poisson_ratio 0.25" + kStrong,
                words + (given_later ? "5" : "2e-4"), "1e-6");
  engine.command("region right block -0.5 2 -2 2 -2 2 units box");
  if (opens) engine.command("block_motion right velocity 20 0 0");
  engine.command("run 150");
  if (given_later) {
    engine.command("unfix load");
    engine.command("fix load all muckpile/blast " + words + "0");
  } else {
    engine.command("run 50");
  }
  engine.command("run 2");
  return engine.hole(1, 6);
}

TEST(FixMuckpileBlast, ChargesFindTheirWallsWhereTheyAre) {
  for (const bool given_later : {false, true}) {
    const double still = energy_of_first(false, given_later);
    ASSERT_GT(still, 0.0);
    EXPECT_NEAR(energy_of_first(true, given_later) / still, 1.0, 1e-3) << given_later;
  }
}

}  // namespace
}  // namespace muckpile
