// SPDX-License-Identifier: GPL-2.0-or-later
// Supports whose ground yields: the law of one step, reflection of plane waves, lasting loads,
// energy, breaking and stopping.
// Scope: columns of regular blocks and a corner of Voronoi blocks; no engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "args/input_error.h"
#include "bond_scene.h"

namespace muckpile::test {
namespace {

constexpr double kNoSpring = 1e15;  // m of rock behind: a dashpot alone

bool everywhere(const Vec3&) { return true; }

TEST(QuietGround, TakesImpedanceAndStiffnessFromTheRock) {
  const JointMaterial material(rock(0.25));  // E = 50 GPa, 2600 kg/m3
  const QuietGround ground(material, 8.0);
  // G = 20 GPa, lambda + 2G = 60 GPa: sqrt(2600 x 6e10) and sqrt(2600 x 2e10) Pa s/m
  EXPECT_NEAR(ground.normal_impedance, std::sqrt(1.56e14), 1e-6);
  EXPECT_NEAR(ground.shear_impedance, std::sqrt(0.52e14), 1e-6);
  EXPECT_DOUBLE_EQ(ground.normal_stiffness, 7.5e9);
  EXPECT_DOUBLE_EQ(ground.shear_stiffness, 2.5e9);
  EXPECT_THROW(QuietGround(material, 0.0), InputError);
  EXPECT_THROW(QuietGround(material, std::nan("")), InputError);
}

TEST(QuietGround, StepIsTheTrapezoidalRule) {
  // Z = 3, k = 2, g0 = 5, t0 = 7, carried 1, dt = 0.5, and say t1 = 4 at the end:
  // Z (g1 - 5)/0.5 + (g1 + 5) = -((7 + 4)/2 - 1)  =>  7 g1 = 30 - 5 - 4.5  =>  g1 = 20.5/7
  const GroundStep step = ground_step(3.0, 2.0, 5.0, 7.0, 1.0, 0.5);
  EXPECT_NEAR(step.predicted - step.compliance * 4.0, 20.5 / 7.0, 1e-15);
  EXPECT_EQ(ground_step(3.0, 2.0, 5.0, 7.0, 1.0, 0.0).predicted, 5.0);
  EXPECT_EQ(ground_step(3.0, 2.0, 5.0, 7.0, 1.0, 0.0).compliance, 0.0);
}

/// Column of 1 m cubes along x: supported at x = 0, between symmetry planes.
SupportRule column(double width = 1.0) {
  return [width](const Vec3& at) {
    if (at.x() < 1e-9) return Support::fixed;
    const bool side = std::min({at.y(), at.z(), width - at.y(), width - at.z()}) < 1e-9;
    return side ? Support::mirror : Support::free;
  };
}

/// A P-wave packet that runs towards x = 0, its middle `at` [m] away from there.
void send_packet(BondScene& scene, double at, double wavelength) {
  const double q = 2.0 * std::numbers::pi / wavelength, width = 1.2 * wavelength, size = 1e-5;
  const double speed = scene.network().material().p_wave_speed();
  for (std::size_t b = 0; b < scene.size(); ++b) {
    const double x = scene.start(b).x() - at, shape = size * std::exp(-0.5 * x * x / width / width);
    scene.block(b).centre.x() += shape * std::cos(q * x);
    scene.block(b).velocity.x() +=
        speed * shape * (-q * std::sin(q * x) - x / (width * width) * std::cos(q * x));
  }
}

/// Energy that comes back over that of the packet: the wave in a column with yielding ground less
/// that in a column twice as long, where it runs on.
double reflected_energy(int blocks_per_wave, double nu, double courant) {
  const int n = 10 * blocks_per_wave;
  BondScene bounded(cuboids(n, 1, 1), rock(nu), column()),
      endless(cuboids(2 * n, 1, 1), rock(nu), column());
  const JointMaterial& material = bounded.network().material();
  bounded.compute();
  bounded.network().let_ground_yield(QuietGround(material, kNoSpring), everywhere);
  send_packet(bounded, 0.5 * n, blocks_per_wave);
  send_packet(endless, 1.5 * n, blocks_per_wave);
  bounded.compute();
  endless.compute();
  const double sent = bounded.energy_account();
  for (int k = 0; k * courant < 0.95 * n; ++k) {
    bounded.step(courant / material.p_wave_speed());
    endless.step(courant / material.p_wave_speed());
  }
  double kinetic = 0.0;
  for (std::size_t b = 0; b < bounded.size(); ++b) {
    const Vec3 back =
        bounded.block(b).velocity - endless.block(b + static_cast<std::size_t>(n)).velocity;
    kinetic += 0.5 * bounded.mass(b) * back.squaredNorm();
  }
  return 2.0 * kinetic / sent;  // a wave is half kinetic
}

TEST(QuietGround, LetsPlaneWavesOut) {
  // Regular blocks, nu = 0: tan^4(q h/4) = 6.3e-4 and 3.8e-5 at 10 and 20 blocks per wave; the
  // packet's shorter waves add a tenth, and the two layers of blocks that are not sharpened reflect
  // a little of the short ones. Measured 8.9e-4 and 3.5e-5; nu = 0.25: 2.0e-3 and 6.2e-5; nu =
  // 0.45: 1.1e-2 and 1.9e-4.
  const double coarse = reflected_energy(10, 0.0, 0.1), fine = reflected_energy(20, 0.0, 0.1);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_GT(coarse / fine, 14.0);  // amplitude of second order at least
  EXPECT_LT(reflected_energy(10, 0.25, 0.1), 2.3e-3);
  EXPECT_LT(reflected_energy(20, 0.25, 0.1), 7e-5);
  EXPECT_LT(reflected_energy(10, 0.25, 0.7), 2.3e-3);  // at the step of a run
  EXPECT_LT(reflected_energy(20, 0.45, 0.1), 2.2e-4);
}

TEST(QuietGround, CarriesALastingLoadWithoutCreep) {
  const double pressure = 1e6, behind = 40.0;
  BondScene scene(cuboids(20, 1, 1), rock(0.25), column());
  const JointMaterial& material = scene.network().material();
  scene.compute();
  scene.network().let_ground_yield(QuietGround(material, behind), everywhere);
  BoundaryFace& top = *std::find_if(scene.network().faces().begin(), scene.network().faces().end(),
                                    [](const BoundaryFace& face) { return face.normal.x() > 0.5; });
  top.hole = 0;
  scene.compute();
  const double c = material.p_wave_speed(), dt = 0.5 / c;
  // What swings dies away in the dashpot within rho c / k = behind / c. The load comes smoothly:
  // waves as short as two blocks do not travel, so they would not leave.
  std::array<double, 2> down{};
  for (int part = 0; part < 2; ++part) {
    for (int k = 0; k < 30 * 40 * 2; ++k) {
      const double phase =
          part == 0 ? std::min(1.0, k / 400.0) * std::numbers::pi : std::numbers::pi;
      top.pressure = 0.5 * pressure * (1.0 - std::cos(phase));
      scene.step(dt);
    }
    down[static_cast<std::size_t>(part)] = scene.start(19).x() - scene.block(19).centre.x();
  }
  // Base: pressure x behind / M; the top block's centre is 19.5 m above it.
  EXPECT_NEAR(down[1] / (pressure * 59.5 / material.p_wave_modulus()), 1.0, 1e-6);
  const double creep = std::abs(down[1] - down[0]) / (30 * 40 / c);         // m/s
  EXPECT_LT(creep, 1e-9 * pressure / (material.parameters().density * c));  // of a dashpot alone
}

TEST(QuietGround, HoldsTheLoadThatItBeginsWith) {
  const double pressure = 1e6;
  BondScene scene(cuboids(20, 1, 1), rock(0.25), column());
  const JointMaterial& material = scene.network().material();
  Mat3 squeeze = Mat3::Zero();
  squeeze(0, 0) = -pressure / material.p_wave_modulus();
  scene.deform(squeeze);
  for (BoundaryFace& face : scene.network().faces()) {
    if (face.normal.x() < 0.5) continue;
    face.hole = 0;
    face.pressure = pressure;
  }
  scene.compute();
  EXPECT_EQ(scene.network().let_ground_yield(QuietGround(material, kNoSpring), everywhere), 1);
  const double dt = 0.5 / material.p_wave_speed();
  for (int k = 0; k < 2000; ++k) scene.step(dt);
  // Rounding of coordinates, 1e-15 m, in stiffness over impedance: 1e-15 m x c / 1 m.
  for (std::size_t b = 0; b < scene.size(); ++b)
    EXPECT_LT(scene.block(b).velocity.norm(), 1e-9) << b;  // a dashpot alone gives 0.08 m/s
}

/// Voronoi rock on yielding ground on three sides, so that corner blocks have up to three supports.
struct Corner {
  explicit Corner(const JointParameters& parameters)
      : scene(voronoi_blocks(3.0, 5), parameters, [](const Vec3& at) {
          return at.minCoeff() < -1.5 + 1e-6 ? Support::fixed : Support::free;
        }) {
    scene.compute();
    const QuietGround ground(scene.network().material(), 5.0);
    supports = scene.network().let_ground_yield(ground, everywhere);
  }
  BondScene scene;
  int supports = 0;
};

TEST(QuietGround, SolvesTheStepWithItsDilatation) {
  Corner corner(rock(0.4));
  BondScene& scene = corner.scene;
  FacetNetwork& network = scene.network();
  scene.shake(1e-5, 1e-5, 3);
  const QuietGround ground(network.material(), 5.0);
  const double dt = 1e-4;
  for (int k = 0; k < 3; ++k) {
    const std::vector<FacetMemory> before = network.memory();
    scene.compute(dt);
    const std::vector<FacetMemory> after = network.memory();
    int checked = 0;
    for (std::size_t f = 0; f < network.facets().size(); ++f) {
      const GroundMemory &was = before[f].ground(), &is = after[f].ground();
      if (!is.yields) continue;
      ++checked;
      const Vec3 given = scene.facet_force(f) / network.facets()[f].area;
      // Positions are rounded to 1e-15 m, which is 5e-5 Pa at 5e10 Pa/m.
      EXPECT_LT((given - is.traction).norm(), 1e-4);
      const Vec3& n = network.facets()[f].normal;
      const Vec3 rate = (is.displacement - was.displacement) / dt;
      const Vec3 mean = 0.5 * (is.displacement + was.displacement);
      const Vec3 pull = 0.5 * (is.traction + was.traction);
      const auto law = [&](double impedance, double stiffness, const Vec3& v) {
        return v.dot(impedance * rate + stiffness * mean + pull);
      };
      // Blocks have turned by 1e-5 and the facet's normal by half of that.
      EXPECT_LT(std::abs(law(ground.normal_impedance, ground.normal_stiffness, n)),
                1e-4 * pull.norm());
      EXPECT_LT(std::abs(law(ground.shear_impedance, ground.shear_stiffness, n.unitOrthogonal())),
                1e-4 * pull.norm());
    }
    EXPECT_EQ(checked, corner.supports);
    EXPECT_GT(checked, 20);
  }
}

/// Energy account over its start, and the parts of what the ground took.
double account_error(double courant, JointLosses* losses = nullptr) {
  Corner corner(rock(0.3));
  BondScene& scene = corner.scene;
  scene.shake(1e-5, 1e-5, 3);
  scene.compute();
  const double start = scene.energy_account(),
               dt = courant / scene.network().material().p_wave_speed();
  for (int k = 0; k * courant < 12.0; ++k) scene.step(dt);
  if (losses != nullptr) *losses = scene.network().losses();
  return std::abs(scene.energy_account() / start - 1.0);
}

TEST(QuietGround, BooksTheEnergyThatLeaves) {
  JointLosses losses;
  const double coarse = account_error(0.04), fine = account_error(0.02, &losses);
  EXPECT_LT(fine, 1e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.5);  // second order, as leapfrog
  EXPECT_GT(losses.radiated, 0.0);
  EXPECT_LE(losses.radiated, losses.quiet);  // the rest is in the springs behind
}

TEST(QuietGround, StandsStillOnceItsSupportCracks) {
  JointParameters weak = rock(0.25);
  weak.tension = 2e5;
  weak.cohesion = 4e5;
  Corner corner(weak);
  FacetNetwork& network = corner.scene.network();
  corner.scene.shake(1e-5, 0.0, 3);
  corner.scene.compute(1e-5);
  corner.scene.compute(1e-5);  // supports that have cracked leave the list in the step after
  EXPECT_LT(network.yielding_supports(), static_cast<std::size_t>(corner.supports));
  EXPECT_GT(network.yielding_supports(), 0u);
  const std::vector<FacetMemory> before = network.memory();
  corner.scene.compute(1e-5);
  for (std::size_t f = 0; f < network.facets().size(); ++f) {
    const double moved =
        (network.ground_memory(f).displacement - before[f].ground().displacement).norm();
    if (network.states()[f] == FacetState::intact) continue;
    EXPECT_EQ(moved, 0.0) << f;
  }
}

TEST(QuietGround, IsAFixedSupportOnceStopped) {
  Corner corner(rock(0.25));
  BondScene& scene = corner.scene;
  scene.shake(1e-5, 1e-5, 3);
  scene.compute(1e-4);
  const std::vector<Vec3> before(scene.network().force().begin(), scene.network().force().end());
  const double quiet = scene.network().losses().quiet;
  scene.network().stop_ground();
  EXPECT_EQ(scene.network().yielding_supports(), 0u);
  scene.compute(1e-4);  // the same pose and the ground where it was: the same forces
  for (std::size_t b = 0; b < scene.size(); ++b)
    EXPECT_LT((scene.network().force()[b] - before[b]).norm(), 1e-9 * before[b].norm());
  EXPECT_EQ(scene.network().losses().quiet, quiet);
  // The lists are made anew when blocks migrate: the ground must not jump back.
  scene.network().set_facets(scene.network().lists());
  scene.compute(1e-4);
  for (std::size_t b = 0; b < scene.size(); ++b)
    EXPECT_LT((scene.network().force()[b] - before[b]).norm(), 1e-9 * before[b].norm());
}

}  // namespace
}  // namespace muckpile::test
