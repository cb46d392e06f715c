// SPDX-License-Identifier: GPL-2.0-or-later
// Speeds of plane P and S waves in cut rock, from the frequency of standing waves.
// Scope: unbroken, undamped; time step half the stable one.
#include <cmath>
#include <numbers>

#include "framework/cases.h"
#include "framework/rock_samples.h"
#include "framework/standing_wave.h"

namespace muckpile::verification {
namespace {

constexpr double kTolerance = 0.005;  // of the issue: half a per cent at 20 blocks per wavelength
constexpr double kStepShare = 0.5, kPeriods = 2.0;
const std::vector<double> kRatios = {0.0, 0.2, 0.25, 0.35, 0.45};
const char* const kLetter[2] = {"P", "S"};

double speed_of(Polarisation kind, const JointMaterial& material) {
  return kind == Polarisation::p ? material.p_wave_speed() : material.s_wave_speed();
}

/// Rock and the directions that waves run through it: boxes that hold half a wavelength of 20
/// blocks.
struct Direction {
  const RockSample* sample;
  int axis;  ///< 0, 1, 2; 3: the diagonal of the square in x and y
};

/// Measured over true speed.
double speed_ratio(const Direction& direction, Polarisation kind, int half_waves,
                   const std::vector<JointParameters>& networks, const JointMaterial& material) {
  const RockSample& sample = *direction.sample;
  const double speed = speed_of(kind, material);
  const StandingWave wave = direction.axis == 3
                                ? diagonal_wave(kind, true, sample.box.x(), half_waves, speed)
                                : axial_wave(kind, direction.axis, (direction.axis + 1) % 3,
                                             sample.box[direction.axis], half_waves, speed);
  BlockRun run(sample.blocks, networks, walls_with(wave.parity, sample.box));
  return measured_frequency(run, wave, kPeriods, kStepShare) / (wave.wave_number * speed);
}

void measure_speeds(Report& report, const std::string& cut, const std::vector<Direction>& ways,
                    const std::vector<double>& ratios) {
  for (const double nu : ratios) {
    const JointMaterial material(rock(nu));
    for (const Polarisation kind : {Polarisation::p, Polarisation::s}) {
      double worst = 1.0;
      for (const Direction& way : ways) {
        const double ratio = speed_ratio(way, kind, 1, {rock(nu)}, material);
        if (std::abs(ratio - 1.0) >= std::abs(worst - 1.0)) worst = ratio;
      }
      const double speed = speed_of(kind, material);
      const char* letter = kLetter[kind == Polarisation::s];
      report.relative({cut + ", nu " + spelled(nu),
                       std::string("c") + letter + " at 20 blocks per wavelength, worst direction",
                       "m/s", "given E, nu and density"},
                      worst * speed, speed, kTolerance);
    }
  }
}

/// Dispersion curves along one direction, for a line of blocks of `per_edge` to the box.
void measure_dispersion(Report& report, const std::string& label, const Direction& way,
                        double blocks_per_edge, int colour, CurveStyle style,
                        const std::vector<JointParameters>& networks,
                        const JointMaterial& material) {
  for (const Polarisation kind : {Polarisation::p, Polarisation::s}) {
    PlotCurve curve{label, style, colour, {}};
    for (const int half_waves : {1, 2, 3, 4, 5}) {
      curve.points.emplace_back(2.0 * blocks_per_edge / half_waves,
                                speed_ratio(way, kind, half_waves, networks, material));
    }
    const std::string letter = kLetter[kind == Polarisation::s];
    report.curve(
        {"dispersion_" + letter, "Phase speed of the " + letter + " wave over the true one",
         "blocks per wavelength", "measured over true speed", Scale::kLogarithmic},
        curve);
    report.measured({label, "c" + letter + " over true at 10 blocks per wavelength", "", ""},
                    curve.points[1].y());
    report.measured({label, "c" + letter + " over true at 4 blocks per wavelength", "", ""},
                    curve.points[4].y());
  }
}

const double kDiagonalEdge = 20.0 / std::numbers::sqrt2;  // holds half a wavelength of 20 m

void uniform(Report& report) {
  const RockSample cube = uniform_rock({10, 10, 10});
  const RockSample slab = uniform_rock({kDiagonalEdge, kDiagonalEdge, 5});
  measure_speeds(report, "uniform", {{&cube, 0}, {&cube, 1}, {&cube, 2}, {&slab, 3}}, kRatios);
  for (const double nu : {0.25, 0.45}) {
    measure_dispersion(report, "uniform, nu " + spelled(nu), {&cube, 0}, 10.0, 0,
                       nu < 0.3 ? CurveStyle::kLine : CurveStyle::kDashed, {rock(nu)},
                       JointMaterial(rock(nu)));
  }
}

void graded(Report& report) {
  const RockSample plate = graded_rock({10, 10, 5}), column = graded_rock({5, 5, 10});
  const RockSample slab = graded_rock({kDiagonalEdge, kDiagonalEdge, 3});
  measure_speeds(report, "graded 10:1", {{&plate, 0}, {&plate, 1}, {&column, 2}, {&slab, 3}},
                 kRatios);
  measure_dispersion(report, "graded 10:1 (largest blocks count), nu 0.25", {&plate, 0}, 10.0, 1,
                     CurveStyle::kLine, {rock(0.25)}, JointMaterial(rock(0.25)));
}

void cuboids(Report& report) {
  const Vec3 edge(1.0, 0.8, 1.25);
  const RockSample x = cuboid_rock({10, 2, 2}, edge), y = cuboid_rock({2, 10, 2}, edge),
                   z = cuboid_rock({2, 2, 10}, edge),
                   square = cuboid_rock({14, 14, 2}, {1, 1, 1.25});
  measure_speeds(report, "cuboids", {{&x, 0}, {&y, 1}, {&z, 2}, {&square, 3}}, kRatios);
  measure_dispersion(report, "cuboids, nu 0.25", {&x, 0}, 10.0, 2, CurveStyle::kLine, {rock(0.25)},
                     JointMaterial(rock(0.25)));
}

void springs(Report& report) {
  const RockSample cube = uniform_rock({10, 6, 6});
  measure_dispersion(report, "plain springs, uniform, nu 0.25", {&cube, 0}, 10.0, 3,
                     CurveStyle::kLine, plain_springs(0.25), JointMaterial(rock(0.25)));
}

void quick(Report& report) {
  const RockSample bar = uniform_rock({10, 4, 4});
  measure_speeds(report, "uniform", {{&bar, 0}}, {0.25});
}

const Cases kCases = {{"quick", quick},
                      {"uniform", uniform},
                      {"graded", graded},
                      {"cuboids", cuboids},
                      {"springs", springs}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("waves", muckpile::verification::kCases, argc, argv);
}
