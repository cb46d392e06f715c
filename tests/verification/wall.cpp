// SPDX-License-Identifier: GPL-2.0-or-later
// Static pressure on the wall of a crushed zone in blocks of 0.25 to 6 radii: what the wall sweeps
// and how far around rock moves, against Lame's cylinder, with and without wall_facets.h.
// Scope: a full circle of 1 m radius between mirror planes in a box whose far sides hold; undamped
// equilibrium of unbroken rock.
#include <algorithm>
#include <cmath>
#include <optional>

#include "framework/block_run.h"
#include "framework/cases.h"
#include "framework/rock_samples.h"
#include "framework/static_solver.h"
#include "geometry/cut/tessellation.h"

namespace muckpile::verification {
namespace {

constexpr double kPressure = 1e6;        // [Pa]
constexpr double kTolerance = 0.05;      // wanted of the wall
constexpr double kVoidTolerance = 0.02;  // wanted of its volume

struct Scene {
  double size;          ///< of the blocks at the wall [m]
  double ratio = 0.25;  ///< Poisson's
  unsigned long seed = 1;
};

/// Where the rock around is looked at [m]: to three blocks.
struct Far {
  explicit Far(double size) : to(std::max(6.0, 3.0 * size)) {}
  double from = 2.5, to;
};

struct Ring {
  Tessellation rock;
  Vec3 lo, hi;
  double radius;  ///< of the void as cut [m]
};

Ring cut(const Scene& scene) {
  constexpr double kGrowth = 0.3;  // size per distance
  const double half = scene.size < 0.5 ? 8.0 : std::max(10.0, 6.0 * scene.size),
               far = std::max(scene.size, std::min(2.0 * scene.size, 2.0));
  const double thickness = (scene.size < 0.5 ? 3.0 : 6.0) * scene.size;
  TessellationOptions options;
  options.lo = Vec3(-half, -half, 0.0);
  options.hi = Vec3(half, half, thickness);
  options.seed = scene.seed;
  options.holes = {{Vec3::Zero(), thickness * Vec3::UnitZ(), 1.0}};
  const double near = 1.0 + 0.5 * scene.size;
  options.size =
      far > scene.size
          ? SizeLaw::table({{near, scene.size}, {near + (far - scene.size) / kGrowth, far}},
                           {scene.size, far})
          : SizeLaw::uniform(scene.size);
  Ring ring{tessellate(options), options.lo, options.hi, 0.0};
  ring.radius = std::sqrt(ring.rock.statistics.void_volume / (M_PI * thickness));
  return ring;
}

/// Lame's plane strain between the void and a circle of the box's area that holds:
/// u = c (1/r - r/R^2).
class Lame {
 public:
  Lame(const Ring& ring, const JointMaterial& rock)
      : void_(ring.radius), far_squared_(std::pow(ring.hi.x() - ring.lo.x(), 2) / M_PI) {
    c_ = kPressure / (2.0 * rock.shear_modulus() / (void_ * void_) +
                      2.0 * (rock.lame_lambda() + rock.shear_modulus()) / far_squared_);
  }
  [[nodiscard]] double moved(double r) const { return c_ * (1.0 / r - r / far_squared_); }
  [[nodiscard]] double swept() const { return 2.0 * M_PI * void_ * moved(void_); }  ///< [m2]

 private:
  double void_, far_squared_, c_;
};

struct Yield {
  double swept;  ///< volume, over Lame's
  double far;    ///< displacement of the blocks around, over Lame's
  double step;   ///< stable time step times the P speed over the block size
};

Yield press(const Ring& ring, const Scene& scene, bool round) {
  const double top = ring.hi.z(), edge = ring.hi.x(), slack = 1e-6;
  std::vector<Hole> holes;
  if (round) holes = {{Vec3::Zero(), top * Vec3::UnitZ(), ring.radius}};
  BlockRun run(
      ring.rock.blocks, {test::rock(scene.ratio)},
      [=](const Vec3& at) {
        if (at.z() < slack || at.z() > top - slack) return Wall::mirror;
        return at.head<2>().cwiseAbs().maxCoeff() > edge - slack ? Wall::fixed : Wall::free;
      },
      {}, Leaning::little, holes);
  for (BoundaryFace& face : run.network().faces())
    if (face.hole >= 0) face.pressure = kPressure;
  run.compute();
  Yield yield{0.0, 0.0, run.stable_step() * run.network().material().p_wave_speed() / scene.size};
  settle(run, 1e-6, 1e-6);
  const Lame lame(ring, run.network().material());
  for (const BoundaryFace& face : run.network().faces())
    if (face.hole >= 0) yield.swept += run.network().volume_swept(face) / (top * lame.swept());
  const Far far(scene.size);
  double got = 0.0, exact = 0.0;
  for (std::size_t b = 0; b < run.size(); ++b) {
    Vec3 out = run.start(b);
    out.z() = 0.0;
    const double r = out.norm(), u = lame.moved(r);
    if (r < far.from || r > far.to) continue;
    got += run.volume(b) * u * run.displacement(b).dot(out / r);
    exact += run.volume(b) * u * u;
  }
  yield.far = got / exact;
  return yield;
}

PlotCurve curve_of(const char* name, int colour, bool round) {
  return {name, round ? CurveStyle::kLine : CurveStyle::kDashed, colour, {}};
}

void compare(Report& report, const std::vector<Scene>& scenes) {
  PlotCurve on = curve_of("wall round", 0, true), off = curve_of("wall blocks", 1, false);
  for (const Scene& scene : scenes) {
    const Ring ring = cut(scene);
    const std::string name = "blocks of " + spelled(scene.size) + " radii, nu " +
                             spelled(scene.ratio) + ", cut " + std::to_string(scene.seed);
    const Yield with = press(ring, scene, true), without = press(ring, scene, false);
    report.relative({name, "volume swept by the wall over Lame's", "", "Lame"}, with.swept, 1.0,
                    kTolerance);
    report.relative({name, "displacement from 2.5 radii on over Lame's", "", "Lame"}, with.far, 1.0,
                    kTolerance);
    report.measured({name, "volume swept, wall blocks", "", ""}, without.swept);
    report.measured({name, "displacement, wall blocks", "", ""}, without.far);
    report.relative({name, "void over cylinder", "", "cylinder"}, ring.radius * ring.radius, 1.0,
                    kVoidTolerance);
    report.measured({name, "stable step over that of wall blocks", "", ""},
                    with.step / without.step);
    on.points.emplace_back(scene.size, 100.0 * (with.swept - 1.0));
    off.points.emplace_back(scene.size, 100.0 * (without.swept - 1.0));
  }
  if (scenes.size() < 2) return;
  const PlotFrame frame{"wall_static", "Volume that the wall of a crushed zone sweeps",
                        "block size / radius", "more than Lame's [%]"};
  report.curve(frame, on);
  report.curve(frame, off);
}

const Cases kCases = {
    {"sizes",
     [](Report& report) {
       compare(report, {{0.25}, {0.5}, {0.75}, {1.0}, {1.33}, {1.49}});
     }},
    {"coarse",
     [](Report& report) {
       compare(report, {{1.5}, {1.75}, {2.0}, {2.5}, {3.0}, {4.0}, {6.0}});
     }},
    {"cuts",
     [](Report& report) {
       for (const Scene& scene : {Scene{1.0, 0.25, 2}, Scene{1.33, 0.25, 2}, Scene{1.33, 0.25, 3},
                                  Scene{1.33, 0.0}, Scene{1.33, 0.4}})
         compare(report, {scene});
     }},
    {"quick", [](Report& report) {
       for (const double size : {1.33, 1.5}) compare(report, {{size}});
     }}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("wall", muckpile::verification::kCases, argc, argv);
}
