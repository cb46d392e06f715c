// SPDX-License-Identifier: GPL-2.0-or-later
// Cavity solutions against closed forms, static limits and the golden table of the project's
// dossier. Scope: unit cavity in a medium of unit density and P speed, Poisson's ratio 0.25.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analytic/cavity.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

// rho = cp = a = 1 makes PPV rho cp/p0 and tau cp/a plain numbers; nu = 0.25: cs^2/cp^2 = 1/3.
const ElasticMedium kMedium{1.0, 1.0, std::sqrt(1.0 / 3.0)};

struct Peaks {
  double displacement = 0.0, velocity = 0.0, radial_stress = 0.0, hoop_stress = 0.0;
  double hoop_time = 0.0;  // since arrival
};

/// Largest displacement, velocity and hoop tension and largest |radial stress| over a time.
Peaks peaks(CavityShape shape, const PressureTransform& pressure, double r, double duration,
            double step) {
  Peaks result;
  for (double tau = step; tau <= duration; tau += step) {
    const CavityResponse now = cavity_response(shape, kMedium, 1.0, pressure, r, r - 1.0 + tau);
    result.displacement = std::max(result.displacement, now.displacement);
    result.velocity = std::max(result.velocity, now.velocity);
    result.radial_stress = std::max(result.radial_stress, std::abs(now.radial_stress));
    if (now.hoop_stress > result.hoop_stress) {
      result.hoop_stress = now.hoop_stress;
      result.hoop_time = tau;
    }
  }
  return result;
}

TEST(ElasticMediumFromModuli, GivesTheTextbookSpeeds) {
  // E 50 GPa, nu 0.25: G = 20, M = 60 GPa; rho 2700: cp = 4714.045, cs = 2721.655 m/s
  const ElasticMedium rock = elastic_medium(2700.0, 50e9, 0.25);
  EXPECT_NEAR(rock.p_speed, 4714.045, 1e-3);
  EXPECT_NEAR(rock.s_speed, 2721.655, 1e-3);
}

TEST(SphericalCavity, InversionAgreesWithTheClosedForm) {
  for (const double r : {1.0, 2.0, 5.0}) {
    for (const double tau : {0.1, 1.0, 3.0, 10.0}) {
      const double time = r - 1.0 + tau;
      EXPECT_NEAR(cavity_response(CavityShape::sphere, kMedium, 1.0, step_pressure(1.0), r, time)
                      .displacement,
                  sphere_step_displacement(kMedium, 1.0, 1.0, r, time), 1e-8);  // inversion 1e-10
    }
  }
}

TEST(SphericalCavity, StepGivesTheGoldenHoopStresses) {
  // dossier: 0.716 at r = a at tau 2.03, 0.146 at 2a, 0.0284 at 5a; tolerance = its rounding
  const Peaks wall = peaks(CavityShape::sphere, step_pressure(1.0), 1.0, 6.0, 0.01);
  EXPECT_NEAR(wall.hoop_stress, 0.716, 0.0005);
  EXPECT_NEAR(wall.hoop_time, 2.03, 0.011);  // sampled every 0.01
  EXPECT_NEAR(peaks(CavityShape::sphere, step_pressure(1.0), 2.0, 8.0, 0.01).hoop_stress, 0.146,
              0.0005);
  EXPECT_NEAR(peaks(CavityShape::sphere, step_pressure(1.0), 5.0, 8.0, 0.01).hoop_stress, 0.0284,
              0.00005);
}

TEST(SphericalCavity, WaveFrontVelocityFallsAsOneOverR) {
  for (const double r : {1.0, 3.0, 8.0}) {
    const CavityResponse front =
        cavity_response(CavityShape::sphere, kMedium, 1.0, step_pressure(1.0), r, r - 1.0 + 1e-5);
    EXPECT_NEAR(front.velocity, 1.0 / r, 2e-5);  // slope of order 1 over 1e-5
  }
}

TEST(BothCavities, TakeTheWallPressure) {
  for (const CavityShape shape : {CavityShape::sphere, CavityShape::cylinder}) {
    for (const double time : {0.2, 2.0, 9.0}) {
      EXPECT_NEAR(cavity_response(shape, kMedium, 1.0, step_pressure(3.0), 1.0, time).radial_stress,
                  -3.0, 1e-8);
    }
  }
}

TEST(BothCavities, SettleToTheStaticSolution) {
  // u = p a/(4G) and p a/(2G), G = 1/3; the cylinder's tail falls off as 1/t^2
  EXPECT_NEAR(cavity_response(CavityShape::sphere, kMedium, 1.0, step_pressure(1.0), 1.0, 30.0)
                  .displacement,
              0.75, 1e-7);
  EXPECT_NEAR(cavity_response(CavityShape::cylinder, kMedium, 1.0, step_pressure(1.0), 1.0, 300.0)
                  .displacement,
              1.5, 1e-4);
}

TEST(BothCavities, AreSilentBeforeTheArrival) {
  const CavityResponse quiet =
      cavity_response(CavityShape::cylinder, kMedium, 1.0, step_pressure(1.0), 5.0, 3.999);
  EXPECT_EQ(quiet.velocity, 0.0);
  EXPECT_EQ(quiet.radial_stress, 0.0);
}

TEST(CylindricalCavity, StepGivesTheGoldenDisplacements) {
  // u_max/u_static at r/a = 1, 2, 5, 10, u_static = p a^2/(2 G r) = 1.5/r; tolerance = rounding
  constexpr std::array<double, 4> kR{1.0, 2.0, 5.0, 10.0};
  constexpr std::array<double, 4> kGolden{1.191, 1.338, 1.777, 2.360};
  for (std::size_t i = 0; i < kR.size(); ++i) {
    const Peaks peak = peaks(CavityShape::cylinder, step_pressure(1.0), kR[i], 15.0, 0.02);
    EXPECT_NEAR(peak.displacement * kR[i] / 1.5, kGolden[i], 0.0006) << kR[i];
  }
}

TEST(CylindricalCavity, StepGivesTheGoldenHoopStresses) {
  constexpr std::array<double, 4> kR{1.0, 2.0, 5.0, 10.0};
  constexpr std::array<double, 4> kGolden{1.255, 0.376, 0.0935, 0.0394};
  constexpr std::array<double, 4> kRounding{0.0006, 0.0006, 0.00006, 0.00006};
  for (std::size_t i = 0; i < kR.size(); ++i) {
    const Peaks peak = peaks(CavityShape::cylinder, step_pressure(1.0), kR[i], 15.0, 0.02);
    EXPECT_NEAR(peak.hoop_stress, kGolden[i], kRounding[i]) << kR[i];
  }
}

struct PulseRow {
  double rise;
  std::array<double, 5> velocity, radial_stress, hoop_stress;
};

TEST(CylindricalCavity, StarfieldPulseGivesTheGoldenTable) {
  constexpr std::array<double, 5> kR{1.0, 2.0, 5.0, 10.0, 20.0};
  constexpr std::array<PulseRow, 4> kGolden{{
      {1.0,
       {.851, .555, .334, .232, .163},
       {1, .587, .340, .234, .163},
       {.952, .322, .103, .055, .034}},
      {2.0,
       {.721, .455, .267, .184, .129},
       {1, .502, .275, .187, .129},
       {1.156, .366, .104, .051, .030}},
      {5.0,
       {.493, .298, .170, .116, .080},
       {1, .359, .178, .118, .081},
       {1.202, .351, .085, .036, .018}},
      {10.0,
       {.325, .192, .107, .072, .050},
       {1, .254, .114, .074, .050},
       {1.090, .299, .064, .023, .010}},
  }};
  constexpr double kRounding = 0.0006;  // three printed decimals, and the sampling of the peak
  for (const PulseRow& row : kGolden) {
    for (std::size_t i = 0; i < kR.size(); ++i) {
      const Peaks peak = peaks(CavityShape::cylinder, starfield_pressure(1.0, row.rise), kR[i],
                               4.0 + 1.5 * row.rise, std::min(0.02 * row.rise, 0.05));
      EXPECT_NEAR(peak.velocity, row.velocity[i], kRounding) << row.rise << ' ' << kR[i];
      EXPECT_NEAR(peak.radial_stress, row.radial_stress[i], kRounding) << row.rise << ' ' << kR[i];
      EXPECT_NEAR(peak.hoop_stress, row.hoop_stress[i], kRounding) << row.rise << ' ' << kR[i];
    }
  }
}

TEST(BothCavities, RefuseAPointInside) {
  EXPECT_THROW(
      (void)cavity_response(CavityShape::sphere, kMedium, 1.0, step_pressure(1.0), 0.5, 1.0),
      InputError);
  EXPECT_THROW(
      (void)cavity_response(CavityShape::cylinder, kMedium, 0.0, step_pressure(1.0), 0.5, 1.0),
      InputError);
}

}  // namespace
}  // namespace muckpile
