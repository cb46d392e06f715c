// SPDX-License-Identifier: GPL-2.0-or-later
// Free faces: Young's modulus of a bar, the Rayleigh wave, and a pulse that returns as tension.
// Scope: uniform Voronoi cut, undamped.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "framework/cases.h"
#include "framework/rock_samples.h"
#include "framework/standing_wave.h"
#include "framework/static_solver.h"

namespace muckpile::verification {
namespace {

/// Slope of a straight line through points, by least squares.
double slope(const std::vector<Vec2>& points) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p / static_cast<double>(points.size());
  double xx = 0.0, xy = 0.0;
  for (const Vec2& p : points) {
    xx += (p.x() - mean.x()) * (p.x() - mean.x());
    xy += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  return xy / xx;
}

/// Bar along x with free sides, pulled at its ends; strain over its middle half.
double young_of_bar(const RockSample& bar, double nu) {
  constexpr double kPull = 5e5;  // [Pa]: strain 1e-5
  BlockRun run(bar.blocks, {rock(nu)}, [](const Vec3&) { return Wall::free; });
  for (BoundaryFace& face : run.network().faces()) {
    const bool end = face.start.x() < 1e-6 || face.start.x() > bar.box.x() - 1e-6;
    if (!end) continue;
    face.hole = 0;
    face.pressure = -kPull;
  }
  settle(run, 1e-5, 1e-6);
  std::vector<Vec2> points;
  for (std::size_t b = 0; b < run.size(); ++b) {
    const double x = run.start(b).x() / bar.box.x();
    if (x > 0.25 && x < 0.75) points.emplace_back(run.start(b).x(), run.displacement(b).x());
  }
  return kPull / slope(points);
}

void bar(Report& report) {
  const RockSample fine = uniform_rock({18, 6, 6}), thin = uniform_rock({9, 3, 3});
  for (const double nu : {0.0, 0.2, 0.25, 0.35, 0.45}) {
    const double given = rock(nu).youngs_modulus;
    report.relative({"bar, 6 blocks across, nu " + spelled(nu), "E", "Pa", "given E"},
                    young_of_bar(fine, nu), given, 0.005);
    report.measured({"bar, 3 blocks across, nu " + spelled(nu), "E", "Pa", ""},
                    young_of_bar(thin, nu));
  }
}

/// Speed of the Rayleigh wave over c_S: root of the Rayleigh equation
/// (2 - x^2)^2 = 4 sqrt(1 - x^2) sqrt(1 - x^2 (cS/cP)^2) by bisection.
double rayleigh_ratio(const JointMaterial& material) {
  const double r = std::pow(material.s_wave_speed() / material.p_wave_speed(), 2);
  const auto f = [r](double x2) {
    return std::pow(2.0 - x2, 2) - 4.0 * std::sqrt(1.0 - x2) * std::sqrt(1.0 - x2 * r);
  };
  double low = 0.5, high = 1.0 - 1e-12;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0.0 ? low : high) = middle;
  }
  return std::sqrt(0.5 * (low + high));
}

/// Potentials A e^(-q d) cos kx and B e^(-s d) sin kx at depth d below z = `top`, without traction
/// on the face: B = -2 k q A/(k^2 + s^2).
StandingWave rayleigh_wave(const JointMaterial& material, double top, double edge, int half_waves) {
  const double k = half_waves * std::numbers::pi / edge;
  const double c = rayleigh_ratio(material) * material.s_wave_speed();
  const double q = k * std::sqrt(1.0 - std::pow(c / material.p_wave_speed(), 2));
  const double s = k * std::sqrt(1.0 - std::pow(c / material.s_wave_speed(), 2));
  const double b = -2.0 * k * q / (k * k + s * s);
  StandingWave wave;
  wave.name = "Rayleigh";
  wave.wave_number = k;
  wave.speed = c;
  wave.displacement = [=](const Vec3& x) -> Vec3 {
    const double p_part = std::exp(-q * (top - x.z())), s_part = b * std::exp(-s * (top - x.z()));
    return Vec3(-(k * p_part + s * s_part) * std::sin(k * x.x()), 0.0,
                (q * p_part + k * s_part) * std::cos(k * x.x())) /
           k;
  };
  wave.curl = [=](const Vec3& x) {
    const double turned = (k * k - s * s) * b * std::exp(-s * (top - x.z())) / k;
    return Vec3(0.0, turned * std::sin(k * x.x()), 0.0);
  };
  return wave;
}

void rayleigh(Report& report) {
  constexpr double kTop = 30.0, kEdge = 10.0;  // 1.5 wavelengths deep, half of one long [m]
  const RockSample block = uniform_rock({kEdge, 3.0, kTop});
  const auto walls = [](const Vec3& at) {
    return at.z() > kTop - 1e-6 ? Wall::free : Wall::mirror;
  };
  for (const double nu : {0.0, 0.2, 0.25, 0.35, 0.45}) {
    const JointMaterial material(rock(nu));
    for (const int half_waves : {1, 2}) {
      const StandingWave wave = rayleigh_wave(material, kTop, kEdge, half_waves);
      BlockRun run(block.blocks, {rock(nu)}, walls);
      const double speed = measured_frequency(run, wave, 2.0, 0.5) / wave.wave_number;
      const Quantity what{"free face, nu " + spelled(nu),
                          half_waves == 1 ? "Rayleigh speed at 20 blocks per wavelength"
                                          : "Rayleigh speed at 10 blocks per wavelength",
                          "m/s", "Rayleigh equation"};
      if (half_waves == 1) {
        report.relative(what, speed, wave.speed, 0.01);
      } else {
        report.measured(what, speed);
      }
    }
  }
}

/// Pressure of a pulse over its peak: rises as a half cosine, then falls on a straight line whose
/// end is rounded off; times over the rise time.
double pulse_shape(double t) {
  constexpr double kFall = 4.0;  // fall time over rise time
  if (t <= 0.0 || t >= 1.0 + kFall) return 0.0;
  return t < 1.0 ? 0.5 * (1.0 - std::cos(std::numbers::pi * t))
                 : 0.5 * (1.0 + std::cos(std::numbers::pi * (t - 1.0) / kFall));
}

/// Column along x between symmetry planes, so that the pulse is plane; loaded at x = 0, free at the
/// far end.
class PulseColumn {
 public:
  PulseColumn(RockSample sample, double rise_length, double tension) : sample_(std::move(sample)) {
    const double length = sample_.box.x();
    JointParameters p = rock(0.25);
    p.tension = tension;
    run_ = std::make_unique<BlockRun>(sample_.blocks, std::vector{p}, [length](const Vec3& at) {
      return at.x() < 1e-6 || at.x() > length - 1e-6 ? Wall::free : Wall::mirror;
    });
    speed_ = run_->network().material().p_wave_speed();
    rise_ = rise_length / speed_;
    for (BoundaryFace& face : run_->network().faces()) {
      if (face.start.x() < 1e-6) face.hole = 0;
    }
    run_->compute();
    dt_ = 0.5 * run_->stable_step();
  }

  void step() {
    time_ += dt_;
    for (BoundaryFace& face : run_->network().faces()) {
      if (face.hole == 0) face.pressure = kPeak * pulse_shape(time_ / rise_);
    }
    run_->step(dt_);
  }

  /// Axial stress in a slab about x, tension positive [Pa].
  [[nodiscard]] double stress(double x) const {
    const std::vector<Mat3> stresses = run_->stresses();
    double sum = 0.0, volume = 0.0;
    for (std::size_t b = 0; b < run_->size(); ++b) {
      if (std::abs(run_->start(b).x() - x) > 2.0) continue;
      sum += run_->volume(b) * stresses[b](0, 0);
      volume += run_->volume(b);
    }
    return sum / volume;
  }

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] double rise() const { return rise_; }
  [[nodiscard]] BlockRun& run() { return *run_; }

  static constexpr double kPeak = 1e6;  // [Pa]

 private:
  RockSample sample_;
  std::unique_ptr<BlockRun> run_;
  double speed_ = 0.0, rise_ = 0.0, dt_ = 0.0, time_ = 0.0;
};

/// d'Alembert: the stress at a distance from the free face, `time` after the load began [Pa].
double exact_stress(double x, double length, double time, double speed, double rise) {
  return PulseColumn::kPeak * (pulse_shape((time - (2.0 * length - x) / speed) / rise) -
                               pulse_shape((time - x / speed) / rise));
}

/// Rise in blocks; there is a bound only if `allowed` is given.
void return_pulse(Report& report, double rise, std::optional<double> allowed) {
  constexpr double kLength = 160.0, kStation = 80.0;  // [m]
  PulseColumn column(uniform_rock({kLength, 5.0, 5.0}), rise, 1e30);
  PlotCurve measured{"measured", CurveStyle::kLine, 0, {}};
  PlotCurve exact{"d'Alembert", CurveStyle::kDashed, 1, {}};
  const double there = (2.0 * kLength - 2.0 * kStation) / column.speed();  // from pass to return
  while (column.time() * column.speed() < 2.0 * kLength - kStation + 6.0 * rise) {
    column.step();
    const double stress = column.stress(kStation);
    measured.points.emplace_back(1e3 * column.time(), 1e-6 * stress);
    exact.points.emplace_back(
        1e3 * column.time(),
        1e-6 * exact_stress(kStation, kLength, column.time(), column.speed(), column.rise()));
  }
  // The pulse that comes back against the one that passed, each as measured.
  const auto at = [&](double time) {
    const double step = 1e-3 * (measured.points[1].x() - measured.points[0].x());
    const double place = time / step - 1.0;
    const auto k = static_cast<std::size_t>(
        std::clamp(place, 0.0, static_cast<double>(measured.points.size()) - 2.0));
    const double share = place - static_cast<double>(k);
    return (1.0 - share) * measured.points[k].y() + share * measured.points[k + 1].y();
  };
  double worst = 0.0, off = 0.0;
  const double first = kStation / column.speed();
  for (double t = first; t < first + 5.0 * column.rise(); t += 0.02 * column.rise()) {
    worst = std::max(worst, std::abs(at(t + there) + at(t)));
  }
  for (std::size_t k = 0; k < measured.points.size(); ++k) {
    off = std::max(off, std::abs(measured.points[k].y() - exact.points[k].y()));
  }
  const std::string name = "plane pulse, rise of " + spelled(rise) + " blocks";
  const Quantity shape{name, "returned tension less passed compression, largest over the peak", "",
                       "equal shape"};
  worst *= 1e6 / PulseColumn::kPeak;
  if (!allowed) return report.measured(shape, worst);
  report.at_most(shape, worst, *allowed);
  report.measured({name, "stress less d'Alembert's, largest over the peak", "", ""},
                  off * 1e6 / PulseColumn::kPeak);
  const PlotFrame frame{"spall_pulse",
                        "A pulse passes and comes back from the free face as tension", "time [ms]",
                        "stress at the middle of the column [MPa]"};
  report.curve(frame, measured);
  report.curve(frame, exact);
}

/// Distance from the free face where the net tension first reaches `strength` [m]: as the peak
/// comes back, 1 - shape(1 + 2 depth/(c rise)) of it is left.
double exact_spall(double rise_length, double strength) {
  double low = 0.0, high = 2.0 * rise_length;  // where the tail of the pulse ends
  while (high - low > 1e-9 * rise_length) {
    const double depth = 0.5 * (low + high);
    (1.0 - pulse_shape(1.0 + 2.0 * depth / rise_length) < strength ? low : high) = depth;
  }
  return low;
}

/// How far from the free face a column tears: of the facets that break until their area, seen along
/// the column, is that of the section.
struct Tear {
  double nearest, mean;  ///< [m]
};

Tear torn(PulseColumn& column, const Vec3& box) {
  const FacetNetwork& network = column.run().network();
  double area = 0.0, depth = 0.0, nearest = box.x();
  while (area < (1.0 - 1e-9) * box.y() * box.z() &&
         column.time() * column.speed() < 3.0 * box.x()) {
    column.step();
    area = depth = 0.0;
    for (std::size_t f = 0; f < network.facet_count(); ++f) {
      if (network.states()[f] == FacetState::intact) continue;
      const Facet facet = network.facet(f);
      const double across = facet.area * std::abs(facet.normal.x());
      const double x = column.run().start(static_cast<std::size_t>(facet.i)).x() + facet.arm_i.x();
      area += across;
      depth += across * (box.x() - x);
      nearest = std::min(nearest, box.x() - x);
    }
  }
  return {nearest, depth / area};
}

/// `allowed` in blocks.
void spall(Report& report, const std::string& cut, const RockSample& sample, double rise,
           double Tear::*thickness, double allowed) {
  for (const double share : {0.4, 0.6, 0.8}) {
    PulseColumn column(sample, rise, share * PulseColumn::kPeak);
    const double found = torn(column, sample.box).*thickness, exact = exact_spall(rise, share);
    const std::string name = cut + ", strength " + spelled(share) + " of the peak";
    report.relative({name, "thickness of the spall", "m", "d'Alembert"}, found, exact,
                    allowed * sample.size / exact);
  }
}

void spalls(Report& report) {
  // The joint that breaks first is one of the two beside the place, or the next one: a block.
  spall(report, "cuboids of 1 m", cuboid_rock({120, 1, 1}, Vec3::Ones()), 12.0, &Tear::nearest,
        1.0);
  spall(report, "cuboids of 0.5 m", cuboid_rock({240, 1, 1}, 0.5 * Vec3::Ones()), 12.0,
        &Tear::nearest, 1.0);
  // Facets of a layer zigzag by a block, and the next layer breaks as the peak goes on.
  spall(report, "Voronoi blocks of 1 m", uniform_rock({120.0, 3.0, 3.0}), 12.0, &Tear::mean, 2.0);
  spall(report, "Voronoi blocks of 1 m, rise of 24 m", uniform_rock({240.0, 3.0, 3.0}), 24.0,
        &Tear::mean, 2.0);
}

const Cases kCases = {{"bar", bar},
                      {"rayleigh", rayleigh},
                      {"returning_pulse",
                       [](Report& r) {
                         return_pulse(r, 20.0, 0.01);
                         return_pulse(r, 10.0, std::nullopt);
                       }},
                      {"spall", spalls}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("free_faces", muckpile::verification::kCases, argc, argv);
}
