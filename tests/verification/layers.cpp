// SPDX-License-Identifier: GPL-2.0-or-later
// Two rocks side by side: plane waves across their boundary, and static moduli of layered rock.
// Scope: normal incidence, unbroken, undamped; exact results of the continuum.
#include <algorithm>
#include <cmath>
#include <complex>

#include "bond/law/joint_material.h"
#include "framework/cases.h"
#include "framework/plane_pulse.h"
#include "framework/rock_samples.h"
#include "framework/static_solver.h"

namespace muckpile::verification {
namespace {

constexpr double kTolerance = 0.01;  // of the issue: 1 %
constexpr double kDeviations = 4.0;  // half length of a pulse over the deviation of its envelope
constexpr double kEnvelope = 0.7;    // deviation of the envelope over the wavelength
constexpr double kAmplitude = 1e-6;  // of displacement [m]
constexpr double kStepShare = 0.5;   // of the stable step
constexpr double kAway = 6.0, kReach = 2.0;  // of the stations from the plane [m]
constexpr double kPerWavelength = 20;        // blocks, in the slower rock

/// Softer and lighter than the rock of the other cases.
JointParameters soft_rock() {
  JointParameters p = rock(0.3);
  p.youngs_modulus = 15e9;
  p.density = 2200.0;
  return p;
}

struct Pair {
  std::string name;
  JointParameters from, into;  ///< the wave comes from the first
};

struct WaveSpeed {
  Polarisation kind;
  [[nodiscard]] double of(const JointParameters& p) const {
    const JointMaterial material(p);
    return kind == Polarisation::p ? material.p_wave_speed() : material.s_wave_speed();
  }
  [[nodiscard]] double impedance(const JointParameters& p) const { return p.density * of(p); }
};

/// Rock on both sides of a plane across x, long enough for a pulse to meet it undisturbed.
struct Column {
  RockSample sample;
  double plane;  ///< [m]
};

double half_pulse(double wavelength) { return kDeviations * kEnvelope * wavelength; }

Column column(bool voronoi, double wavelength) {
  const double half = std::ceil(2.1 * half_pulse(wavelength)) + 8.0;
  if (voronoi) return {with_mirror_image(uniform_rock({half, 3, 3})), half};
  return {cuboid_rock({2 * static_cast<int>(half), 1, 1}, Vec3::Ones()), half};
}

/// What stations in front of the plane and behind it see [m/s].
struct Passage {
  std::vector<double> before, behind;
  double dt;
};

Passage pass(const Column& column, const Pair& rocks, bool two, WaveSpeed speed, double wavelength,
             double dt) {
  test::Zones zones{{rocks.into}, {}};
  for (const Block& block : column.sample.blocks)
    zones.of.push_back(two && block.mass.centroid.x() > column.plane ? 1 : 0);
  BlockRun run(column.sample.blocks, {rocks.from}, column_walls(speed.kind, column.sample.box), {},
               Leaning::little, {}, zones);
  const double half = half_pulse(wavelength), from = speed.of(rocks.from);
  launch(run, gaussian_pulse(speed.kind, from, wavelength, kEnvelope * wavelength,
                             column.plane - half, kAmplitude));
  run.compute();
  if (dt == 0.0) dt = kStepShare * run.stable_step();
  Station before(run, speed.kind, column.plane - kAway, kReach);
  Station behind(run, speed.kind, column.plane + kAway, kReach);
  const double slower = std::min(from, speed.of(rocks.into));
  const double end = (2.0 * half + kAway + 0.5 * wavelength) / from + kAway / slower;
  for (double t = 0.0; t < end; t += dt) {
    before.record(run);
    behind.record(run);
    run.step(dt);
  }
  return {before.velocity(), behind.velocity(), dt};
}

/// What a station at x sees of a wave, whose phases differ over its blocks.
double seen(const Column& column, double x, double wave_number) {
  std::complex<double> sum = 0.0;
  double volume = 0.0;
  for (const Block& block : column.sample.blocks) {
    if (std::abs(block.mass.centroid.x() - x) > kReach) continue;
    sum += block.mass.volume * std::polar(1.0, wave_number * block.mass.centroid.x());
    volume += block.mass.volume;
  }
  return std::abs(sum) / volume;
}

void measure_boundary(Report& report, bool voronoi, const Pair& rocks, Polarisation kind) {
  const WaveSpeed speed{kind};
  const double from = speed.of(rocks.from), into = speed.of(rocks.into);
  const double wavelength = kPerWavelength * std::max(1.0, from / into);
  const double omega = 2.0 * M_PI * from / wavelength;
  const Column where = column(voronoi, wavelength);
  const Passage with = pass(where, rocks, true, speed, wavelength, 0.0);
  const Passage without = pass(where, rocks, false, speed, wavelength, with.dt);
  std::vector<double> returned = with.before;
  for (std::size_t n = 0; n < returned.size(); ++n) returned[n] -= without.before[n];
  const auto size = [&](const std::vector<double>& v, double x, double wave_speed) {
    return std::abs(spectrum(v, with.dt, omega)) / seen(where, x, omega / wave_speed);
  };
  const double before = where.plane - kAway, behind = where.plane + kAway;
  const double incident = size(without.before, before, from);
  const double z1 = speed.impedance(rocks.from), z2 = speed.impedance(rocks.into);
  const std::string name = std::string(voronoi ? "Voronoi" : "cuboids") + ", " + rocks.name + ", " +
                           (kind == Polarisation::p ? "P" : "S");
  report.relative({name, "transmitted over incident velocity", "", "2 Z1/(Z1 + Z2)"},
                  size(with.behind, behind, into) / incident, 2.0 * z1 / (z1 + z2), kTolerance);
  report.difference({name, "reflected over incident velocity", "", "|Z1 - Z2|/(Z1 + Z2)"},
                    size(returned, before, from) / incident, std::abs(z1 - z2) / (z1 + z2),
                    kTolerance);
}

void transmission(Report& report, bool voronoi) {
  for (const Pair& rocks : {Pair{"hard to soft", rock(0.25), soft_rock()},
                            Pair{"soft to hard", soft_rock(), rock(0.25)}})
    for (const Polarisation kind : {Polarisation::p, Polarisation::s})
      measure_boundary(report, voronoi, rocks, kind);
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Stress per strain of a box that its reflections continue, components xx yy zz yz xz xy.
Matrix6 stiffness(const RockSample& sample, const test::Zones& zones) {
  constexpr int kRow[6] = {0, 1, 2, 1, 0, 0}, kColumn[6] = {0, 1, 2, 2, 2, 1};
  constexpr double kProbe = 1e-5, kResidual = 1e-8;  // strain, of the equilibrium
  Matrix6 c;
  for (int n = 0; n < 6; ++n) {
    Mat3 strain = Mat3::Zero();
    strain(kRow[n], kColumn[n]) += 0.5 * kProbe;
    strain(kColumn[n], kRow[n]) += 0.5 * kProbe;
    Vec3 parity = Vec3::Ones();
    if (n >= 3) parity[kRow[n]] = parity[kColumn[n]] = -1.0;
    BlockRun run(sample.blocks, {rock(0.25)}, walls_with(parity, sample.box), {}, sample.leaning,
                 {}, zones);
    run.set_average_strain(strain);
    settle(run, kProbe, kResidual);
    const Mat3 stress = run.average_stress();
    for (int m = 0; m < 6; ++m) c(m, n) = stress(kRow[m], kColumn[m]) / kProbe;
  }
  return c;
}

/// Layers of equal thickness normal to z (Backus 1962).
void measure_layers(Report& report, const std::string& name, const RockSample& sample,
                    double tolerance) {
  test::Zones zones{{soft_rock()}, {}};
  for (const Block& block : sample.blocks)
    zones.of.push_back(block.mass.centroid.z() < 0.5 * sample.box.z() ? 1 : 0);
  const Matrix6 c = stiffness(sample, zones);
  const JointMaterial a(rock(0.25)), b(soft_rock());
  const auto mean = [&](auto&& of) { return 0.5 * (of(a) + of(b)); };
  using Rock = const JointMaterial&;
  const double across = 1.0 / mean([](Rock r) { return 1.0 / r.p_wave_modulus(); });
  const double coupled = mean([](Rock r) { return r.lame_lambda() / r.p_wave_modulus(); });
  const double along = mean([](Rock r) {
    return r.p_wave_modulus() - r.lame_lambda() * r.lame_lambda() / r.p_wave_modulus();
  });
  const auto row = [&](const std::string& what, double value, double reference) {
    report.relative({name, what, "Pa", "Backus (1962)"}, value, reference, tolerance);
  };
  row("lambda + 2G across the layers: harmonic mean", c(2, 2), across);
  row("G across the layers: harmonic mean", c(4, 4),
      1.0 / mean([](Rock r) { return 1.0 / r.shear_modulus(); }));
  if (tolerance < kTolerance)
    report.known_shortfall(
        "facets between blocks beside the boundary resist bending; the error falls with the "
        "blocks per layer");
  row("G in their planes: arithmetic mean", c(5, 5),
      mean([](Rock r) { return r.shear_modulus(); }));
  row("stiffness along the layers, c11", c(0, 0), along + coupled * coupled * across);
  row("coupling along and across, c13", c(0, 2), coupled * across);
}

void layered_cuboids(Report& report) {
  constexpr double kRounding = 1e-5;  // second order in the strain
  measure_layers(report, "layers of three cuboids", cuboid_rock({3, 3, 6}, {1.0, 1.2, 0.8}),
                 kRounding);
  measure_layers(report, "layers of one cuboid", cuboid_rock({2, 2, 2}, {1.0, 1.2, 0.8}),
                 kRounding);
}

void layered_uniform(Report& report) {
  RockSample sample = uniform_rock({6, 6, 8}, {{Vec3(0, 0, 4), Vec3::UnitZ()}});
  sample.leaning = Leaning::little;  // as create_blocks has it beside zones
  measure_layers(report, "layers of four Voronoi blocks", sample, kTolerance);
}

void quick(Report& report) {
  layered_cuboids(report);
  measure_boundary(report, false, {"hard to soft", rock(0.25), soft_rock()}, Polarisation::p);
}

const Cases kCases = {{"quick", quick},
                      {"transmission_cuboids", [](Report& report) { transmission(report, false); }},
                      {"transmission_uniform", [](Report& report) { transmission(report, true); }},
                      {"moduli_cuboids", layered_cuboids},
                      {"moduli_uniform", layered_uniform}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("layers", muckpile::verification::kCases, argc, argv);
}
