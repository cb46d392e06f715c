// SPDX-License-Identifier: GPL-2.0-or-later
// A 3-D picture of opaque plane polygons under sun and sky, drawn in software.
// Scope: one depth buffer from the eye, one from the sun, then one pass of shading over the
// samples.
#include "draw/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "draw/depth_buffer.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

constexpr Colour kSkyTop{0.62F, 0.75F, 0.88F}, kSkyLow{0.95F, 0.96F, 0.96F};
constexpr int kSunSize = 3000;  // samples along a side of the sun's depth buffer

struct Ball {
  Vec3 middle;
  double radius;
};

// Of all that throws shadows.
Ball ball_around(const std::vector<SceneObject>& objects) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const SceneObject& object : objects) {
    if (!object.ground) low = low.cwiseMin(object.low), high = high.cwiseMax(object.high);
  }
  return {0.5 * (low + high), 0.5 * (high - low).norm()};
}

constexpr int kPoints = 8, kTurns = 9;
using Spiral = std::array<Vec2, kPoints>;

// Points of a spiral within a circle of radius 1, in nine turns.
std::array<Spiral, kTurns> turned_spirals() {
  std::array<Spiral, kTurns> spirals;
  for (int turn = 0; turn < kTurns; ++turn) {
    for (int k = 0; k < kPoints; ++k) {
      const double angle = 2.0 * std::numbers::pi * turn / kTurns + 2.4 * k;
      spirals[static_cast<size_t>(turn)][static_cast<size_t>(k)] =
          (k + 0.5) / kPoints * Vec2(std::cos(angle), std::sin(angle));
    }
  }
  return spirals;
}

// Of numbers within a picture; std::lround is a call.
int nearest_whole(double value) {
  constexpr int kBeyond = 1 << 20;
  return static_cast<int>(value + (kBeyond + 0.5)) - kBeyond;
}

class Shader {
 public:
  Shader(const Scene& scene, const Camera& camera, const Canvas& canvas)
      : scene_(scene),
        camera_(camera),
        objects_(objects_of(scene.polygons)),
        ball_(ball_around(objects_)),
        sun_(Camera::parallel(-scene.to_sun, ball_.middle, ball_.radius, kSunSize)),
        seen_(canvas.sample_width(), canvas.sample_height()),
        lit_(kSunSize, kSunSize),
        normals_(normals_of(scene.polygons)) {
    const SceneParts parts{scene.polygons, normals_, objects_};
    seen_.look_at(parts, camera, true);
    lit_.look_at(parts, sun_, false);
    in_parallel(seen_.bands() + lit_.bands(), [&](size_t band) {
      if (band < seen_.bands()) {
        seen_.draw_band(band, parts, camera);
      } else {
        lit_.draw_band(band - seen_.bands(), parts, sun_);
      }
    });
    each_in_parallel(normals_.size(), [&](size_t p) { normals_[p].normalize(); });
  }

  void shade(Canvas& canvas) const {
    in_parallel(static_cast<size_t>(canvas.sample_height()), [&](size_t row) {
      const int y = static_cast<int>(row);
      for (int x = 0; x < canvas.sample_width(); ++x)
        canvas.set_sample(x, y, colour_at(x, y, canvas.sample_height()));
    });
  }

  [[nodiscard]] bool is_hidden(const Vec3& p) const {
    const Vec2 place = camera_.place(p);
    const int x = static_cast<int>(std::floor(place.x())),
              y = static_cast<int>(std::floor(place.y()));
    return seen_.holds(x, y) && seen_.polygon(x, y) >= 0 &&
           camera_.depth(camera_.point(place, seen_.near(x, y))) <
               camera_.depth(p) - 0.1 * scene_.hollow_size;
  }

 private:
  [[nodiscard]] Colour colour_at(int x, int y, int height) const {
    const int number = seen_.polygon(x, y);
    if (number < 0) return mix(kSkyTop, kSkyLow, 1.4 * y / height);
    const auto n = static_cast<size_t>(number);
    const Vec3 p = camera_.point({x + 0.5, y + 0.5}, seen_.near(x, y));
    const double towards = normals_[n].dot(scene_.to_sun);
    const double sun = towards > 0.0 ? towards * share_in_sun(p, normals_[n]) : 0.0;
    const double sky = (0.72 + 0.28 * normals_[n].z()) * openness(x, y, p, normals_[n]);
    const double outline = is_outline(x, y, number) ? 0.62 : 1.0;
    const ScenePolygon& polygon = scene_.polygons[n];
    const Colour colour = scaled(polygon.colour, outline * (0.60 * sky + 0.58 * sun));
    if (polygon.object != kGroundObject) return colour;
    return mix(kSkyLow, colour, std::exp(-camera_.depth(p) / scene_.haze));
  }

  // Of nine samples of the sun's buffer about the point. It is lifted off its own face by a sample
  // of that buffer.
  [[nodiscard]] double share_in_sun(const Vec3& p, const Vec3& normal) const {
    const double sample = 2.0 * ball_.radius / kSunSize;
    const Vec3 lifted = p + 2.5 * sample * normal;
    const Vec2 place = sun_.place(lifted);
    const double nearness = sun_.nearness(lifted) + 1.5 * sample;
    int lit = 0;
    for (int k = 0; k < 9; ++k) {
      const int x = static_cast<int>(std::floor(place.x())) + k % 3 - 1;
      const int y = static_cast<int>(std::floor(place.y())) + k / 3 - 1;
      if (!lit_.holds(x, y) || lit_.near(x, y) <= nearness) ++lit;
    }
    return lit / 9.0;
  }

  // Share of the hemisphere that neighbours leave open, from points of the picture on a spiral
  // about this one. The spiral is turned by the sample's place; the nine samples of a pixel average
  // the turns.
  [[nodiscard]] double openness(int x, int y, const Vec3& p, const Vec3& normal) const {
    const double reach = scene_.hollow_size * camera_.samples_per_metre(camera_.depth(p));
    const double farthest = 2.0 * scene_.hollow_size;  // that counts [m]
    double closed = 0.0;
    for (const Vec2& way : spirals_[static_cast<size_t>((x % 3) * 3 + y % 3)]) {
      const int sx = x + nearest_whole(reach * way.x()), sy = y + nearest_whole(reach * way.y());
      if (!seen_.holds(sx, sy) || seen_.polygon(sx, sy) < 0) continue;
      const Vec3 to = camera_.point({sx + 0.5, sy + 0.5}, seen_.near(sx, sy)) - p;
      const double rise = normal.dot(to), squared = to.squaredNorm();
      if (rise <= 0.0 || squared >= farthest * farthest) continue;
      const double distance = std::sqrt(squared);
      closed += std::max(0.0, rise / distance - 0.1) * (1.0 - distance / farthest);
    }
    return std::clamp(1.0 - 1.9 * closed / kPoints, 0.25, 1.0);
  }

  [[nodiscard]] bool is_outline(int x, int y, int number) const {
    const int object = scene_.polygons[static_cast<size_t>(number)].object;
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
      if (!seen_.holds(x + dx, y + dy)) continue;
      const int other = seen_.polygon(x + dx, y + dy);
      if (other >= 0 && scene_.polygons[static_cast<size_t>(other)].object != object) return true;
    }
    return false;
  }

  const Scene& scene_;
  const Camera& camera_;
  std::vector<SceneObject> objects_;
  Ball ball_;
  Camera sun_;
  DepthBuffer seen_, lit_;
  std::vector<Vec3> normals_;
  std::array<Spiral, kTurns> spirals_ = turned_spirals();
};

void draw_ghost(const Scene& scene, const Camera& camera, const Shader& shader, Canvas& canvas) {
  constexpr int kPieces = 160;
  for (const SceneLine& line : scene.ghost_lines) {
    for (int k = 0; k < kPieces; ++k) {
      const Vec3 from = line.from + (line.to - line.from) * (static_cast<double>(k) / kPieces);
      const Vec3 to = line.from + (line.to - line.from) * (static_cast<double>(k + 1) / kPieces);
      if (!camera.sees(from) || !camera.sees(to)) continue;
      const bool hidden = shader.is_hidden(0.5 * (from + to));
      if (hidden && k % 4 >= 2) continue;
      canvas.line(camera.place(from) / Canvas::kSamples, camera.place(to) / Canvas::kSamples,
                  hidden ? 1.2 : 2.0, kBench, hidden ? 0.45 : 0.95);
    }
  }
}

}  // namespace

void draw_scene(const Scene& scene, const Camera& camera, Canvas& canvas) {
  const Shader shader(scene, camera, canvas);
  shader.shade(canvas);
  draw_ghost(scene, camera, shader, canvas);
}

}  // namespace muckpile
