// SPDX-License-Identifier: GPL-2.0-or-later
// Quiet boundary: energy that comes back from it, at normal and oblique incidence, and a lasting
// load that it carries.
// Scope: nu = 0.25, undamped; what comes back is the difference to a column that goes on.
#include <cmath>
#include <numbers>

#include "analytic/viscous_boundary.h"
#include "framework/cases.h"
#include "framework/plane_pulse.h"
#include "framework/rock_samples.h"

namespace muckpile::verification {
namespace {

constexpr double kRatio = 0.25;      // Poisson's
constexpr double kStepShare = 0.5;   // of the stable step
constexpr double kAmplitude = 1e-6;  // of displacement [m]
constexpr double kDeviation = 1.5;   // of the envelope, in wavelengths
constexpr double kHalf = 3.0;        // half length of a pulse, in deviations
constexpr double kNoSpring = 1e12;   // thickness of rock behind: a dashpot alone [m]

const char* letter(Polarisation kind) { return kind == Polarisation::p ? "P" : "S"; }

double speed_of(Polarisation kind) {
  const JointMaterial material(rock(kRatio));
  return kind == Polarisation::p ? material.p_wave_speed() : material.s_wave_speed();
}

/// The same rock twice: ending in a quiet boundary at the far end of x, and going on behind it.
struct Pair {
  RockSample ends, goes_on;
};

void let_yield(BlockRun& run, double behind) {
  run.compute();
  run.network().let_ground_yield(QuietGround(run.network().material(), behind),
                                 [](const Vec3&) { return true; });
}

WallRule quiet_end(const WallRule& sides, double end) {
  return [=](const Vec3& at) { return at.x() > end - 1e-6 ? Wall::fixed : sides(at); };
}

/// Kinetic energy of what differs between the blocks that both runs have.
double difference_energy(const BlockRun& run, const BlockRun& other) {
  double energy = 0.0;
  for (std::size_t b = 0; b < run.size(); ++b) {
    const Vec3 spin = run.block(b).spin - other.block(b).spin;
    energy += 0.5 * (run.mass(b) * (run.block(b).velocity - other.block(b).velocity).squaredNorm() +
                     spin.dot(run.inertia(b) * spin));
  }
  return energy;
}

/// Share of the energy that has come back when the middle of the pulse, which starts `way` before
/// the boundary, would have. Half of a travelling wave's energy is kinetic.
double returned(const Pair& rock_pair, const WallRule& sides,
                const std::function<void(BlockRun&)>& start, double time) {
  BlockRun run(rock_pair.ends.blocks, {rock(kRatio)}, quiet_end(sides, rock_pair.ends.box.x()));
  BlockRun other(rock_pair.goes_on.blocks, {rock(kRatio)}, sides);
  let_yield(run, kNoSpring);
  for (BlockRun* each : {&run, &other}) {
    start(*each);
    each->compute();
  }
  const double dt = kStepShare * other.stable_step(), energy = other.kinetic_energy();
  for (double t = 0.0; t < time; t += dt) {
    run.step(dt);
    other.step(dt);
  }
  return difference_energy(run, other) / energy;
}

double column_length(double wavelength) {
  return std::ceil(2.2 * kHalf * kDeviation * wavelength) + 2.0;
}

/// Blocks of both columns in the same order.
Pair cuboids_at_quiet(double wavelength, int across) {
  const int n = static_cast<int>(column_length(wavelength));
  Pair two{cuboid_rock({n, across, 1}, Vec3::Ones()), {}};
  two.goes_on = with_mirror_image(two.ends);
  return two;
}

Pair voronoi_at_quiet(double wavelength) {
  Pair two{uniform_rock({column_length(wavelength), 3.0, 3.0}), {}};
  two.goes_on = with_mirror_image(two.ends);
  return two;
}

void straight(Report& report, const std::string& cut, const Pair& two, double wavelength) {
  for (const Polarisation kind : {Polarisation::p, Polarisation::s}) {
    const double half = kHalf * kDeviation * wavelength, centre = two.ends.box.x() - half;
    const PlanePulse pulse = gaussian_pulse(kind, speed_of(kind), wavelength,
                                            kDeviation * wavelength, centre, kAmplitude);
    const double share = returned(
        two, column_walls(kind, {1e9, two.ends.box.y(), two.ends.box.z()}),
        [&](BlockRun& run) { launch(run, pulse); }, 2.0 * half / speed_of(kind));
    report.at_most(
        {cut + ", " + letter(kind) + ", " + spelled(wavelength) + " blocks per wavelength",
         "energy returned at normal incidence", "", ""},
        share, 0.01);
  }
}

void normal(Report& report) {
  for (const double wavelength : {10.0, 20.0}) {
    straight(report, "cubes", cuboids_at_quiet(wavelength, 1), wavelength);
    straight(report, "uniform", voronoi_at_quiet(wavelength), wavelength);
  }
}

/// Two plane waves at +-`angle` from x in a slab between mirror planes y = 0 and y = width, under
/// an envelope along x: gradient (P) or curl along z (S) of a potential.
class ObliquePulse {
 public:
  ObliquePulse(Polarisation kind, double angle, double width, double centre)
      : kind_(kind),
        across_(std::numbers::pi / width),
        along_(across_ / std::tan(angle)),
        centre_(centre),
        speed_(speed_of(kind)),
        slow_(std::cos(angle)) {}

  [[nodiscard]] double wavelength() const {
    return 2.0 * std::numbers::pi / std::hypot(across_, along_);
  }

  void launch(BlockRun& run) const {
    const auto now = [this](const Vec3& x) { return potential(x, 0.0); };
    const auto rate = [this](const Vec3& x) {
      const double dt = 1e-3 * wavelength() / speed_;
      return (potential(x, dt) - potential(x, -dt)) / (2.0 * dt);
    };
    for (std::size_t b = 0; b < run.size(); ++b) {
      const Vec3 x = run.start(b);
      run.place(b, run.displacement(b) + shift(now, x), turn(now, x));
      run.set_motion(b, shift(rate, x), turn(rate, x));
    }
  }

 private:
  [[nodiscard]] double potential(const Vec3& x, double time) const {
    const double deviation = kDeviation * wavelength();
    const double from = (x.x() - centre_ - slow_ * speed_ * time) / deviation;
    const double frequency = speed_ * std::hypot(across_, along_);
    const double phase = across_ * x.y();
    return kAmplitude / across_ * std::exp(-0.5 * from * from) *
           std::cos(along_ * x.x() - frequency * time) *
           (kind_ == Polarisation::p ? std::cos(phase) : std::sin(phase));
  }
  template <typename Field>
  [[nodiscard]] Vec3 shift(const Field& f, const Vec3& x) const {
    const double e = 1e-3 * wavelength();
    const Vec3 ex = e * Vec3::UnitX(), ey = e * Vec3::UnitY();
    const double fx = (f(x + ex) - f(x - ex)) / (2.0 * e), fy = (f(x + ey) - f(x - ey)) / (2.0 * e);
    return kind_ == Polarisation::p ? Vec3(fx, fy, 0.0) : Vec3(fy, -fx, 0.0);
  }
  /// Half the curl: minus half the Laplacian of the potential of S.
  template <typename Field>
  [[nodiscard]] Vec3 turn(const Field& f, const Vec3& x) const {
    if (kind_ == Polarisation::p) return Vec3::Zero();
    const double e = 1e-2 * wavelength();
    const Vec3 ex = e * Vec3::UnitX(), ey = e * Vec3::UnitY();
    const double sum = f(x + ex) + f(x - ex) + f(x + ey) + f(x - ey) - 4.0 * f(x);
    return -0.5 * sum / (e * e) * Vec3::UnitZ();
  }

  Polarisation kind_;
  double across_, along_, centre_, speed_, slow_;
};

void oblique(Report& report) {
  struct Slab {
    double degrees;
    int across;  // cubes; wavelength 2 x that x sin(angle), about 10
  };
  const PlotFrame frame{"quiet_oblique", "Energy that a quiet boundary returns",
                        "angle of incidence [degrees]", "share of the energy"};
  for (const Polarisation kind : {Polarisation::p, Polarisation::s}) {
    const WaveType type = kind == Polarisation::p ? WaveType::p : WaveType::s;
    const int colour = kind == Polarisation::p ? 0 : 1;
    PlotCurve measured{
        std::string(letter(kind)) + ", 10 blocks per wavelength", CurveStyle::kPoints, colour, {}};
    PlotCurve exact{
        std::string(letter(kind)) + ", plane wave, no blocks", CurveStyle::kLine, colour, {}};
    for (double a = 0.0; a <= 70.0; a += 1.0)
      exact.points.emplace_back(
          a, viscous_boundary_reflection(type, a * std::numbers::pi / 180.0, kRatio));
    for (const Slab& slab : {Slab{15.0, 20}, Slab{30.0, 10}, Slab{45.0, 7}, Slab{60.0, 6}}) {
      const double angle = slab.degrees * std::numbers::pi / 180.0;
      const double wavelength = 2.0 * slab.across * std::sin(angle);
      const Pair two = cuboids_at_quiet(wavelength, slab.across);
      const double half = kHalf * kDeviation * wavelength;
      const ObliquePulse pulse(kind, angle, slab.across, two.ends.box.x() - half);
      const double width = slab.across;
      const auto sides = [width](const Vec3& at) {
        const bool side =
            at.y() < 1e-6 || at.y() > width - 1e-6 || at.z() < 1e-6 || at.z() > 1.0 - 1e-6;
        return side ? Wall::even : Wall::free;
      };
      const double share = returned(
          two, sides, [&](BlockRun& run) { pulse.launch(run); },
          2.0 * half / (speed_of(kind) * std::cos(angle)));
      report.measured({std::string(letter(kind)) + " at " + spelled(slab.degrees) + " degrees, " +
                           spelled(wavelength, 3) + " blocks per wavelength",
                       "energy returned", "", ""},
                      share);
      report.measured({std::string(letter(kind)) + " at " + spelled(slab.degrees) + " degrees",
                       "energy returned to a plane wave, without blocks", "", ""},
                      viscous_boundary_reflection(type, angle, kRatio));
      measured.points.emplace_back(slab.degrees, share);
    }
    report.curve(frame, exact);
    report.curve(frame, measured);
  }
}

/// A column that stands on its quiet end under a pressure, which later doubles slowly.
void load(Report& report) {
  constexpr double kPressure = 1e6, kBehind = 40.0;  // [Pa], [m]
  constexpr int kLength = 20;                        // [m]
  const RockSample sample = cuboid_rock({kLength, 1, 1}, Vec3::Ones());
  BlockRun run(sample.blocks, {rock(kRatio)},
               quiet_end(column_walls(Polarisation::p, sample.box), kLength));
  const JointMaterial& material = run.network().material();
  const double stiffness = material.p_wave_modulus(), speed = material.p_wave_speed();
  for (std::size_t b = 0; b < run.size(); ++b)
    run.place(b, kPressure / stiffness * (kLength - run.start(b).x()) * Vec3::UnitX(),
              Vec3::Zero());
  const auto press = [&](double pressure) {
    for (BoundaryFace& face : run.network().faces()) {
      face.hole = 0;
      face.pressure = pressure;
    }
  };
  press(kPressure);
  let_yield(run, kBehind);
  const double dt = kStepShare * run.stable_step(), first = run.displacement(0).x();
  const auto wait = [&](double crossings, const std::function<double(double)>& pressure) {
    const double time = crossings * kLength / speed;
    for (double t = 0.0; t < time; t += dt) {
      press(pressure(t / time));
      run.step(dt);
    }
  };
  wait(100.0, [](double) { return kPressure; });
  const double dashpot = kPressure / (material.parameters().density * speed);
  report.at_most(
      {"load that was there before",
       "velocity at the far end after 100 crossings over that of a dashpot alone", "", ""},
      run.block(0).velocity.norm() / dashpot, 1e-6);
  wait(20.0, [](double share) {
    return kPressure * (1.0 + 0.5 * (1.0 - std::cos(std::numbers::pi * share)));
  });
  wait(100.0, [](double) { return 2.0 * kPressure; });
  const double at = run.displacement(0).x();
  report.relative({"load added", "displacement of the far end, rock of 40 m behind", "m",
                   "p (20 m + 40 m - half a block)/(lambda + 2G)"},
                  at - first, kPressure * (kLength + kBehind - 0.5) / stiffness, 0.001);
  wait(100.0, [](double) { return 2.0 * kPressure; });
  report.at_most({"load added", "creep in 100 crossings more over the displacement", "", ""},
                 (run.displacement(0).x() - at) / (at - first), 1e-6);
}

const Cases kCases = {{"normal", normal}, {"oblique", oblique}, {"load", load}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("quiet", muckpile::verification::kCases, argc, argv);
}
