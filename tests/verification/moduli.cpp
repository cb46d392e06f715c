// SPDX-License-Identifier: GPL-2.0-or-later
// Static moduli of cut rock: the whole stiffness tensor of a box that its reflections continue.
// Scope: small strains, unbroken; E, G and K against those that the user gives.
#include <cmath>

#include "framework/block_run.h"
#include "framework/cases.h"
#include "framework/rock_samples.h"
#include "framework/static_solver.h"

namespace muckpile::verification {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
constexpr double kTolerance = 0.005;  // of the issue: half a per cent
constexpr double kStrain = 1e-5;      // second order in it: 1e-5
constexpr double kResidual = 1e-6;    // of the equilibrium

/// Stress per strain, components xx yy zz yz xz xy.
Matrix6 stiffness(const RockSample& sample, const std::vector<JointParameters>& networks) {
  constexpr int kRow[6] = {0, 1, 2, 1, 0, 0}, kColumn[6] = {0, 1, 2, 2, 2, 1};
  Matrix6 c;
  for (int n = 0; n < 6; ++n) {
    Mat3 strain = Mat3::Zero();
    strain(kRow[n], kColumn[n]) += 0.5 * kStrain;
    strain(kColumn[n], kRow[n]) += 0.5 * kStrain;
    Vec3 parity = Vec3::Ones();
    if (n >= 3) parity[kRow[n]] = parity[kColumn[n]] = -1.0;
    BlockRun run(sample.blocks, networks, walls_with(parity, sample.box), {}, sample.leaning);
    run.set_average_strain(strain);
    settle(run, kStrain, kResidual);
    const Mat3 stress = run.average_stress();
    for (int m = 0; m < 6; ++m) c(m, n) = stress(kRow[m], kColumn[m]) / kStrain;
  }
  return c;
}

/// Of all values the one that is farthest from the reference.
double worst(std::initializer_list<double> values, double reference) {
  double out = reference;
  for (const double v : values) {
    if (std::abs(v - reference) >= std::abs(out - reference)) out = v;
  }
  return out;
}

struct Moduli {
  double young, shear, bulk;  ///< worst over the directions [Pa]
};

/// Young's modulus along the axes and the space diagonal, shear moduli of the axes' planes and of
/// the planes at 45 degrees to them.
Moduli moduli(const Matrix6& c, const JointParameters& rock, const JointMaterial& material) {
  // The reflections make the box orthotropic: no coupling between shear and the rest.
  const Mat3 s = c.topLeftCorner<3, 3>().inverse();
  const double along_diagonal = 9.0 / (s.sum() + 1.0 / c(3, 3) + 1.0 / c(4, 4) + 1.0 / c(5, 5));
  const double g = material.shear_modulus();
  const double k = rock.youngs_modulus / (3.0 * (1.0 - 2.0 * rock.poisson_ratio));
  const auto tilted = [&](int a, int b) { return 0.25 * (c(a, a) + c(b, b) - 2.0 * c(a, b)); };
  return {worst({1 / s(0, 0), 1 / s(1, 1), 1 / s(2, 2), along_diagonal}, rock.youngs_modulus),
          worst({c(3, 3), c(4, 4), c(5, 5), tilted(0, 1), tilted(1, 2), tilted(0, 2)}, g),
          worst({c.topLeftCorner<3, 3>().sum() / 9.0}, k)};
}

PlotFrame frame(const std::string& name, const std::string& modulus) {
  return {"moduli_" + name, "Error of the " + modulus + ", worst direction", "Poisson's ratio",
          "error [%]"};
}

void measure(Report& report, const std::string& cut, const RockSample& sample, int colour,
             const std::vector<double>& ratios) {
  PlotCurve young{cut, CurveStyle::kLine, colour, {}}, shear = young;
  for (const double nu : ratios) {
    const JointParameters p = rock(nu);
    const JointMaterial material(p);
    const Moduli m = moduli(stiffness(sample, {p}), p, material);
    const std::string name = cut + ", nu " + spelled(nu);
    const double k = p.youngs_modulus / (3.0 * (1.0 - 2.0 * nu)), g = material.shear_modulus();
    const std::string given = "given E and nu";
    const auto row = [&](const char* what, double value, double reference) {
      report.relative({name, what, "Pa", given}, value, reference, kTolerance);
    };
    row("E, worst of x, y, z, xyz", m.young, p.youngs_modulus);
    row("G, worst of 6 planes", m.shear, g);
    row("K", m.bulk, k);
    young.points.emplace_back(nu, 100.0 * (m.young / p.youngs_modulus - 1.0));
    shear.points.emplace_back(nu, 100.0 * (m.shear / g - 1.0));
  }
  report.curve(frame("young", "Young's modulus"), young);
  report.curve(frame("shear", "shear modulus"), shear);
}

const std::vector<double> kRatios = {0.0, 0.2, 0.25, 0.35, 0.45};

void springs(Report& report) {
  const RockSample sample = uniform_rock(Vec3::Constant(8.0));
  PlotCurve young{"plain springs, uniform cut", CurveStyle::kDashed, 3, {}}, shear = young;
  for (const double nu : kRatios) {
    const JointParameters p = rock(nu);
    const JointMaterial material(p);
    const Moduli m = moduli(stiffness(sample, plain_springs(nu)), p, material);
    const std::string name = "plain springs, uniform, nu " + spelled(nu);
    report.measured({name, "E", "Pa", ""}, m.young);
    report.measured({name, "G", "Pa", ""}, m.shear);
    young.points.emplace_back(nu, 100.0 * (m.young / p.youngs_modulus - 1.0));
    shear.points.emplace_back(nu, 100.0 * (m.shear / material.shear_modulus() - 1.0));
  }
  report.curve(frame("young", "Young's modulus"), young);
  report.curve(frame("shear", "shear modulus"), shear);
}

/// Joints without compliance in planes that the cut follows.
void planes(Report& report) {
  const CutPlane steep{Vec3::Constant(5.0), Vec3(1.0, 0.3, 0.2)},
      flat{Vec3::Constant(5.0), Vec3(0.2, -0.4, 1.0)};
  const std::vector<double> ratios = {0.0, 0.25, 0.45};
  measure(report, "uniform, one plane", uniform_rock(Vec3::Constant(10.0), {steep}), 4, ratios);
  measure(report, "uniform, two crossing planes", uniform_rock(Vec3::Constant(10.0), {steep, flat}),
          5, ratios);
}

/// Cuts by joint sets, upright and leaning, in bands and not.
void joint_sets(Report& report) {
  const std::vector<Vec2> upright = {{90, 90}, {90, 0}, {0, 0}},
                          leaning = {{75, 90}, {85, 0}, {10, 270}};
  const std::vector<double> ratios = {0.0, 0.25, 0.45};
  measure(report, "upright sets, bands 10:1", banded_rock({10, 10, 5}, upright, true), 4, ratios);
  measure(report, "leaning sets, uniform", banded_rock({10, 10, 10}, leaning, false), 5, ratios);
  measure(report, "leaning sets, bands 10:1", banded_rock({10, 10, 5}, leaning, true), 6, ratios);
}

const Cases kCases = {
    {"quick",
     [](Report& r) {
       measure(r, "uniform", uniform_rock({5, 5, 5}), 0, {0.25});
     }},
    {"uniform",
     [](Report& r) { measure(r, "uniform", uniform_rock(Vec3::Constant(10.0)), 0, kRatios); }},
    {"graded",
     [](Report& r) {
       measure(r, "graded 10:1", graded_rock({10, 10, 5}), 1, kRatios);
     }},
    {"cuboids",
     [](Report& r) {
       measure(r, "cuboids", cuboid_rock({4, 4, 4}, {1.0, 0.8, 1.25}), 2, kRatios);
     }},
    {"planes", planes},
    {"joint_sets", joint_sets},
    {"springs", springs},
};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("moduli", muckpile::verification::kCases, argc, argv);
}
