// SPDX-License-Identifier: GPL-2.0-or-later
// A cavity under a pressure pulse in blocks, and in an endless elastic medium.
// Scope: see the header.
#include "framework/cavity_scene.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "explosive/starfield_pulse.h"
#include "framework/block_run.h"
#include "framework/rock_samples.h"
#include "geometry/cut/tessellation.h"

namespace muckpile::verification {
namespace {

constexpr double kStepShare = 0.5;  // of the stable step
constexpr double kAfterPeak = 0.1;  // watched after the exact peaks, of the rise time
constexpr double kPeakWait = 1.6;   // a peak comes within that many rise times of the arrival

/// When the last peak has passed, times the P speed.
double last_way(const Scene& scene) {
  const std::vector<double> way = exact_peaks(scene).way;
  return *std::max_element(way.begin(), way.end()) + kAfterPeak * scene.rise;
}

/// So long that the box's far sides send nothing back to a station before its peaks have passed.
double box_edge(const Scene& scene) {
  const std::vector<double> way = exact_peaks(scene).way;
  double edge = 0.0;
  for (std::size_t k = 0; k < way.size(); ++k) {
    const double passed = way[k] + kAfterPeak * scene.rise;
    edge = std::max(edge, 0.5 * (1.0 + scene.stations[k] + passed) + scene.far);
  }
  return edge;
}

/// Of a slim box: the images of the cavity behind its long walls must not reach the beam.
double box_width(const Scene& scene) {
  const double heard = 1.0 + last_way(scene), r = scene.stations.back();
  return 0.5 * (scene.beam + std::sqrt(heard * heard - r * r)) + scene.far;
}

SizeLaw size_law(const Scene& scene) {
  constexpr double kGrowth = 0.15;  // size per distance
  if (scene.wall >= scene.far) return SizeLaw::uniform(scene.far);
  return SizeLaw::table({{1.0, scene.wall}, {1.0 + (scene.far - scene.wall) / kGrowth, scene.far}},
                        {scene.wall, scene.far});
}

struct Cut {
  std::vector<Block> blocks;
  Vec3 box;
  double radius;  ///< of the cavity of equal volume
};

/// A quarter of a slice around the z axis.
TessellationOptions cylinder_options(const Scene& scene) {
  TessellationOptions options;
  options.hi = Vec3(box_edge(scene), box_edge(scene), scene.layers * scene.far);
  options.size = size_law(scene);
  options.holes = {{Vec3::Zero(), options.hi.z() * Vec3::UnitZ(), 1.0}};
  return options;
}

/// An octant around a sphere whose tangent planes are the faces of the blocks.
TessellationOptions sphere_options(const Scene& scene, double radius) {
  TessellationOptions options;
  options.hi = box_edge(scene) * Vec3::Ones();
  if (scene.beam > 0.0) options.hi.tail<2>().setConstant(box_width(scene));
  options.size = size_law(scene);
  options.fine_axes = {{Vec3::Zero(), 1e-3 * Vec3::Ones()}};
  options.region.inside = [radius](const Vec3& p) { return p.norm() > radius; };
  options.region.surface_points = [radius](const Vec3& p, double cutoff) -> std::vector<Vec3> {
    const double r = p.norm();
    if (r == 0.0 || std::abs(r - radius) > cutoff) return {};
    return {radius / r * p};
  };
  return options;
}

Cut cut(const Scene& scene) {
  if (is_cylinder(scene)) {
    const TessellationOptions options = cylinder_options(scene);
    const Tessellation rock = tessellate(options);
    const double gone = rock.statistics.void_volume / options.hi.z();
    return {rock.blocks, options.hi, std::sqrt(4.0 * gone / M_PI)};
  }
  const auto radius_of = [](const Tessellation& rock) {
    return std::cbrt(6.0 * rock.statistics.void_volume / M_PI);
  };
  // Tangent planes enclose more than the sphere, as at holes, for which tessellate() allows.
  const double first = radius_of(tessellate(sphere_options(scene, 1.0)));
  const TessellationOptions options = sphere_options(scene, 1.0 / first);
  const Tessellation rock = tessellate(options);
  return {rock.blocks, options.hi, radius_of(rock)};
}

/// Radial velocity and stress at a distance, by a straight line through the blocks near it.
class Shell {
 public:
  Shell(const BlockRun& run, const Scene& scene, double radius) {
    const double reach = 0.75 * size_law(scene).at(radius);
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    for (std::size_t b = 0; b < run.size(); ++b) {
      Vec3 out = run.start(b);
      if (is_cylinder(scene)) out.z() = 0.0;
      const Eigen::Vector2d basis(1.0, out.norm() - radius);
      if (std::abs(basis[1]) > reach) continue;
      if (scene.beam > 0.0 && std::hypot(out.y(), out.z()) > scene.beam) continue;
      normal += run.volume(b) * basis * basis.transpose();
      parts_.push_back({b, out.normalized(), basis, 0.0});
    }
    const Eigen::Vector2d at_radius = normal.inverse().col(0);
    for (Part& part : parts_) part.weight = run.volume(part.block) * at_radius.dot(part.basis);
  }

  void watch(const BlockRun& run, const std::vector<Mat3>& stresses) {
    double velocity = 0.0, stress = 0.0;
    for (const Part& part : parts_) {
      velocity += part.weight * part.out.dot(run.block(part.block).velocity);
      stress += part.weight * part.out.dot(stresses[part.block] * part.out);
    }
    peak_velocity_ = std::max(peak_velocity_, velocity);
    peak_stress_ = std::max(peak_stress_, -stress);
    stress_ = stress;
  }

  [[nodiscard]] double peak_velocity() const { return peak_velocity_; }
  [[nodiscard]] double peak_stress() const { return peak_stress_; }
  [[nodiscard]] double stress() const { return stress_; }

 private:
  struct Part {
    std::size_t block;
    Vec3 out;
    Eigen::Vector2d basis;
    double weight;
  };
  std::vector<Part> parts_;
  double peak_velocity_ = 0.0, peak_stress_ = 0.0, stress_ = 0.0;
};

BlockRun load(const Cut& rock, const Scene& scene) {
  const Vec3 box = rock.box;
  const double slack = 1e-6;
  std::vector<Hole> holes;
  if (is_cylinder(scene) && scene.round)
    holes = {{Vec3::Zero(), box.z() * Vec3::UnitZ(), rock.radius}};
  BlockRun run(
      rock.blocks, {test::rock(kRatio)},
      [=](const Vec3& at) {
        const bool far = (at.head<2>().array() > box.head<2>().array() - slack).any() ||
                         (!is_cylinder(scene) && at.z() > box.z() - slack);
        if (far) return Wall::fixed;
        const bool plane = at.minCoeff() < slack || at.z() > box.z() - slack;
        return plane ? Wall::mirror : Wall::free;
      },
      {}, Leaning::little, holes);
  for (BoundaryFace& face : run.network().faces()) face.hole = 0;
  run.compute();
  return run;
}

}  // namespace

ExactWave exact_wave(const Scene& scene) {
  const JointParameters p = test::rock(kRatio);
  const ElasticMedium medium = elastic_medium(p.density, p.youngs_modulus, p.poisson_ratio);
  return {medium, starfield_pressure(kPressure, scene.rise / medium.p_speed)};
}

Peaks exact_peaks(const Scene& scene) {
  const ExactWave wave = exact_wave(scene);
  Peaks peaks;
  for (const double r : scene.stations) {
    double stress = 0.0, velocity = 0.0, way = 0.0;
    for (double since = 0.0; since < kPeakWait; since += 0.002) {
      const double here = r - 1.0 + since * scene.rise;
      const CavityResponse now = cavity_response(scene.shape, wave.medium, 1.0, wave.pressure, r,
                                                 here / wave.medium.p_speed);
      if (-now.radial_stress > stress || now.velocity > velocity) way = here;
      stress = std::max(stress, -now.radial_stress);
      velocity = std::max(velocity, now.velocity);
    }
    peaks.stress.push_back(stress);
    peaks.velocity.push_back(velocity);
    peaks.way.push_back(way);
  }
  return peaks;
}

/// Of the pressure on a cylinder's wall until the last peak has passed, per length [J/m].
double exact_work(const Scene& scene) {
  constexpr int kIntervals = 400;
  const ExactWave wave = exact_wave(scene);
  const StarfieldPulse pulse(scene.rise / wave.medium.p_speed);
  const double dt = last_way(scene) / wave.medium.p_speed / kIntervals;
  double work = 0.0;
  for (int n = 0; n < kIntervals; ++n) {
    const double time = (n + 0.5) * dt;
    work += pulse.shape(time) * dt *
            cavity_response(scene.shape, wave.medium, 1.0, wave.pressure, 1.0, time).velocity;
  }
  return 2.0 * M_PI * kPressure * work;
}

Outcome measure(const Scene& scene) {
  const Cut rock = cut(scene);
  BlockRun run = load(rock, scene);
  std::vector<Shell> shells;
  for (const double r : scene.stations) shells.emplace_back(run, scene, r);
  const double speed = run.network().material().p_wave_speed();
  const StarfieldPulse pulse(scene.rise / speed);
  const double dt = kStepShare * run.stable_step();
  const double end = last_way(scene) / speed;
  const int watch_every = std::max(1, static_cast<int>(0.02 * scene.rise / (speed * dt)));
  Outcome outcome{{}, 0.0, 0.0, run.size(), rock.radius, {}};
  const std::clock_t start = std::clock();
  for (int n = 1; n * dt < end; ++n) {
    for (BoundaryFace& face : run.network().faces())
      face.pressure = kPressure * pulse.shape(n * dt);
    run.step(dt);
    if (n % watch_every != 0) continue;
    const std::vector<Mat3> stresses = run.stresses();
    for (Shell& shell : shells) shell.watch(run, stresses);
    outcome.history.emplace_back(n * dt * speed, shells[shells.size() / 2].stress());
  }
  outcome.work = 4.0 * run.network().pressure_work() / rock.box.z();
  outcome.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  for (const Shell& shell : shells) {
    outcome.peaks.stress.push_back(shell.peak_stress());
    outcome.peaks.velocity.push_back(shell.peak_velocity());
  }
  return outcome;
}

double worst_error(const Peaks& got, const Peaks& exact) {
  double worst = 0.0;
  for (std::size_t k = 0; k < exact.stress.size(); ++k) {
    worst = std::max({worst, std::abs(got.stress[k] / exact.stress[k] - 1.0),
                      std::abs(got.velocity[k] / exact.velocity[k] - 1.0)});
  }
  return worst;
}

}  // namespace muckpile::verification
