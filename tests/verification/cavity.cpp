// SPDX-License-Identifier: GPL-2.0-or-later
// Pressure pulse in a cavity, cylinder and sphere: peak stress and velocity around it against the
// exact solution, and how they converge as blocks shrink.
// Scope: cavity of 1 m radius, nu = 0.25, undamped; a quarter or an octant between mirror planes.
#include "analytic/cavity.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "explosive/starfield_pulse.h"
#include "framework/block_run.h"
#include "framework/cases.h"
#include "framework/rock_samples.h"
#include "geometry/cut/tessellation.h"

namespace muckpile::verification {
namespace {

constexpr double kRatio = 0.25;      // Poisson's
constexpr double kPressure = 1e6;    // peak [Pa]
constexpr double kStepShare = 0.5;   // of the stable step
constexpr double kTolerance = 0.03;  // of the issue
constexpr double kAfterPeak = 0.1;   // watched after the exact peaks, of the rise time
constexpr double kPeakWait = 1.6;    // a peak comes within that many rise times of the arrival

/// What is cut and loaded. Lengths in metres, which are cavity radii.
struct Scene {
  CavityShape shape;
  double rise;       ///< rise time times P speed
  double wall, far;  ///< block sizes at the cavity and from some distance on
  std::vector<double> stations;
  double beam = 0.0;    ///< if not 0, only blocks that near the x axis are watched, in a slim box
  double layers = 2.0;  ///< of blocks in the slice around a cylinder
  bool round = true;    ///< a cylinder's wall has the stiffness of a round hole (wall_facets.h)
};

bool is_cylinder(const Scene& scene) { return scene.shape == CavityShape::cylinder; }

struct Peaks {
  std::vector<double> stress, velocity;  ///< per station [Pa], [m/s]
  std::vector<double> way;               ///< P speed times the time of the later one [m]
};

struct ExactWave {
  ElasticMedium medium;
  PressureTransform pressure;
};

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

/// Of a slim box: the images of the cavity behind its long walls must not be heard in the beam.
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

struct Outcome {
  Peaks peaks;
  double seconds;  ///< processor time of the run alone
  std::size_t blocks;
  double radius;
  std::vector<Vec2> history;  ///< P speed x time and stress at the middle station [m], [Pa]
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
  Outcome outcome{{}, 0.0, run.size(), rock.radius, {}};
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
  outcome.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  for (const Shell& shell : shells) {
    outcome.peaks.stress.push_back(shell.peak_stress());
    outcome.peaks.velocity.push_back(shell.peak_velocity());
  }
  return outcome;
}

const char* name_of(const Scene& scene) { return is_cylinder(scene) ? "cylinder" : "sphere"; }

double worst_error(const Peaks& got, const Peaks& exact) {
  double worst = 0.0;
  for (std::size_t k = 0; k < exact.stress.size(); ++k) {
    worst = std::max({worst, std::abs(got.stress[k] / exact.stress[k] - 1.0),
                      std::abs(got.velocity[k] / exact.velocity[k] - 1.0)});
  }
  return worst;
}

void require_peaks(Report& report, const Scene& scene, const Outcome& outcome) {
  const Peaks exact = exact_peaks(scene);
  const std::string source = is_cylinder(scene) ? "Selberg 1952" : "Blake 1952, Sharpe 1942";
  const std::string name = std::string(name_of(scene)) + ", rise " + spelled(scene.rise) + " a/cP";
  const JointMaterial material(test::rock(kRatio));
  const double velocity_scale =
      kPressure / (material.parameters().density * material.p_wave_speed());
  for (std::size_t k = 0; k < scene.stations.size(); ++k) {
    const std::string at = " at r/a = " + spelled(scene.stations[k]);
    report.relative({name, "peak radial stress over p0" + at, "", source},
                    outcome.peaks.stress[k] / kPressure, exact.stress[k] / kPressure, kTolerance);
    report.relative({name, "PPV rho cP over p0" + at, "", source},
                    outcome.peaks.velocity[k] / velocity_scale, exact.velocity[k] / velocity_scale,
                    kTolerance);
  }
  report.measured({name, "blocks", "", ""}, static_cast<double>(outcome.blocks));
  report.measured({name, "radius of the cavity of equal volume over a", "", ""}, outcome.radius);
}

void draw_history(Report& report, const Scene& scene, const Outcome& outcome, int colour) {
  const ExactWave wave = exact_wave(scene);
  const double r = scene.stations[scene.stations.size() / 2];
  const std::string name = std::string(name_of(scene)) + ", rise " + spelled(scene.rise) + " a/cP";
  PlotCurve measured{name, CurveStyle::kPoints, colour, {}};
  PlotCurve exact{"", CurveStyle::kLine, colour, {}};
  for (const Vec2& p : outcome.history) {
    if (p.x() < r - 1.0) continue;
    measured.points.emplace_back(p.x(), p.y() / kPressure);
    exact.points.emplace_back(p.x(), cavity_response(scene.shape, wave.medium, 1.0, wave.pressure,
                                                     r, p.x() / wave.medium.p_speed)
                                             .radial_stress /
                                         kPressure);
  }
  const PlotFrame frame{"cavity_stress", "Radial stress at r = 5 a (points), exact (lines)",
                        "cP t / a", "radial stress over peak pressure"};
  report.curve(frame, measured);
  report.curve(frame, exact);
}

/// Worst error of all peaks against resolution and run time.
void climb(Report& report, Scene scene, const std::vector<double>& sizes, int colour) {
  const Peaks exact = exact_peaks(scene);
  const std::string name = std::string(name_of(scene)) + ", rise " + spelled(scene.rise) + " a/cP";
  PlotCurve by_size{name, CurveStyle::kLine, colour, {}}, by_time = by_size;
  for (const double size : sizes) {
    scene.wall = scene.far = size;
    const Outcome outcome = measure(scene);
    const double error = worst_error(outcome.peaks, exact);
    report.measured({name, "largest error of all peaks, blocks of " + spelled(size) + " a", "", ""},
                    error);
    by_size.points.emplace_back(scene.rise / size, 100.0 * error);
    by_time.points.emplace_back(outcome.seconds, 100.0 * error);
  }
  report.curve(
      {"cavity_convergence", "Largest error of peak stress and velocity",
       "blocks per rise length cP tr", "error [%]", Scale::kLogarithmic, Scale::kLogarithmic},
      by_size);
  report.curve({"cavity_cost", "Largest error of peak stress and velocity",
                "run time, one core [s]", "error [%]", Scale::kLogarithmic, Scale::kLogarithmic},
               by_time);
}

/// Blocks that are not small against the cavity, waves that are long against the blocks.
void coarse_walls(Report& report) {
  constexpr double kCoarseTolerance = 0.1;
  const std::string source = "Selberg 1952";
  for (const auto& [rise, size] :
       {std::pair{3.6, 0.25}, {3.6, 0.5}, {10.0, 0.5}, {10.0, 1.0}, {20.0, 1.0}, {20.0, 1.33}}) {
    Scene scene{CavityShape::cylinder, rise, size, size, {3.0, 5.0, 10.0}};
    scene.layers = 6.0;
    const Peaks exact = exact_peaks(scene), got = measure(scene).peaks;
    scene.round = false;
    const Peaks without = measure(scene).peaks;
    const std::string name = "blocks of " + spelled(size) + " a, rise " + spelled(rise) + " a/cP";
    for (std::size_t k = 0; k < scene.stations.size(); ++k) {
      const std::string at = " at r/a = " + spelled(scene.stations[k]);
      report.relative({name, "peak radial stress over exact" + at, "", source},
                      got.stress[k] / exact.stress[k], 1.0, kCoarseTolerance);
      report.relative({name, "PPV over exact" + at, "", source},
                      got.velocity[k] / exact.velocity[k], 1.0, kCoarseTolerance);
    }
    report.measured({name, "largest error of all peaks", "", ""}, worst_error(got, exact));
    report.measured({name, "largest error of all peaks, wall blocks", "", ""},
                    worst_error(without, exact));
  }
}

Cases::mapped_type peaks_case(CavityShape shape, double rise, double wall, double far,
                              std::vector<double> stations, int colour, double beam = 0.0) {
  return [=](Report& report) {
    const Scene scene{shape, rise, wall, far, stations, beam};
    const Outcome outcome = measure(scene);
    require_peaks(report, scene, outcome);
    if (scene.stations.size() > 1) draw_history(report, scene, outcome, colour);
  };
}

const std::vector<double> kStations = {2.0, 5.0, 10.0};

const Cases kCases = {
    {"cylinder_2", peaks_case(CavityShape::cylinder, 2.0, 0.1, 0.1, kStations, 0)},
    {"cylinder_5", peaks_case(CavityShape::cylinder, 5.0, 0.125, 0.25, kStations, 1)},
    {"cylinder_10", peaks_case(CavityShape::cylinder, 10.0, 0.125, 0.25, kStations, 2)},
    {"sphere_2", peaks_case(CavityShape::sphere, 2.0, 0.08, 0.12, {2.0, 5.0}, 5, 1.0)},
    {"sphere_5", peaks_case(CavityShape::sphere, 5.0, 0.1, 0.16, {2.0, 5.0}, 3)},
    {"sphere_10", peaks_case(CavityShape::sphere, 10.0, 0.125, 0.2, {2.0, 5.0}, 4)},
    {"sphere_far_2", peaks_case(CavityShape::sphere, 2.0, 0.08, 0.1, {10.0}, 5, 1.5)},
    {"sphere_far_5", peaks_case(CavityShape::sphere, 5.0, 0.1, 0.14, {10.0}, 3, 1.0)},
    {"sphere_far_10", peaks_case(CavityShape::sphere, 10.0, 0.125, 0.14, {10.0}, 4, 1.0)},
    {"coarse", coarse_walls},
    {"ladder", [](Report& report) {
       int colour = 0;
       for (const double rise : {2.0, 5.0, 10.0})
         climb(report, {CavityShape::cylinder, rise, 0.0, 0.0, kStations},
               {1.0, 0.7, 0.5, 0.35, 0.25, 0.16}, colour++);
     }}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("cavity", muckpile::verification::kCases, argc, argv);
}
