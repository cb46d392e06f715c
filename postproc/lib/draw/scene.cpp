// SPDX-License-Identifier: GPL-2.0-or-later
// A 3-D picture of opaque plane polygons under sun and sky, drawn in software.
// Scope: one depth buffer from the eye, one from the sun, then one pass of shading over the
// samples.
#include "draw/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
constexpr Colour kSkyTop{0.62F, 0.75F, 0.88F}, kSkyLow{0.95F, 0.96F, 0.96F};
constexpr int kSunSize = 3000;  // samples along a side of the sun's depth buffer

Vec3 normal_of(const std::vector<Vec3>& c) {
  Vec3 normal = Vec3::Zero();
  for (size_t k = 1; k + 1 < c.size(); ++k) normal += (c[k] - c[0]).cross(c[k + 1] - c[0]);
  return normal;
}

// Nearest polygon of each sample, and how near.
class DepthBuffer {
 public:
  DepthBuffer(int width, int height)
      : width_(width), height_(height), near_(count(), kNothing), polygon_(count(), -1) {}

  // `normals` are those of the polygons, of any length.
  void draw(const std::vector<ScenePolygon>& polygons, const std::vector<Vec3>& normals,
            const Camera& camera, bool with_ground) {
    for (size_t p = 0; p < polygons.size(); ++p) {
      const ScenePolygon& polygon = polygons[p];
      if (!with_ground && polygon.object == kGroundObject) continue;
      if (camera.faces_eye(polygon.corners[0], normals[p]))
        draw(polygon.corners, normals[p], static_cast<int>(p), camera);
    }
  }
  [[nodiscard]] bool holds(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }
  [[nodiscard]] double near(int x, int y) const { return near_[index(x, y)]; }
  [[nodiscard]] int polygon(int x, int y) const { return polygon_[index(x, y)]; }

 private:
  [[nodiscard]] size_t count() const {
    return static_cast<size_t>(width_) * static_cast<size_t>(height_);
  }
  [[nodiscard]] size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }

  void draw(const std::vector<Vec3>& corners, const Vec3& normal, int number,
            const Camera& camera) {
    outline_.clear();
    if (std::ranges::all_of(corners, [&](const Vec3& c) { return camera.sees(c); })) {
      for (const Vec3& c : corners) outline_.push_back(camera.place(c));
    } else {
      for (const Vec3& c : camera.clipped(corners)) outline_.push_back(camera.place(c));
    }
    const Vec3 plane = camera.nearness_of_plane(corners[0], normal);
    scan_polygon(outline_, width_, height_, crossings_, [&](int y, int begin, int end) {
      const double row = plane.x() + plane.z() * (y + 0.5);
      for (int x = begin; x < end; ++x) {
        const double nearness = row + plane.y() * (x + 0.5);
        const size_t i = index(x, y);
        if (nearness > near_[i]) near_[i] = nearness, polygon_[i] = number;
      }
    });
  }

  int width_, height_;
  std::vector<double> near_;
  std::vector<int> polygon_;
  std::vector<Vec2> outline_;
  std::vector<double> crossings_;
};

struct Ball {
  Vec3 middle;
  double radius;
};

// Of all that throws shadows.
Ball ball_around(const std::vector<ScenePolygon>& polygons) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const ScenePolygon& p : polygons) {
    if (p.object == kGroundObject) continue;
    for (const Vec3& c : p.corners) low = low.cwiseMin(c), high = high.cwiseMax(c);
  }
  return {0.5 * (low + high), 0.5 * (high - low).norm()};
}

class Shader {
 public:
  Shader(const Scene& scene, const Camera& camera, const Canvas& canvas)
      : scene_(scene),
        camera_(camera),
        ball_(ball_around(scene.polygons)),
        sun_(Camera::parallel(-scene.to_sun, ball_.middle, ball_.radius, kSunSize)),
        seen_(canvas.sample_width(), canvas.sample_height()),
        lit_(kSunSize, kSunSize),
        normals_(scene.polygons.size()) {
    each_in_parallel(normals_.size(),
                     [&](size_t p) { normals_[p] = normal_of(scene.polygons[p].corners); });
    in_parallel(2, [&](size_t part) {
      if (part == 0) seen_.draw(scene.polygons, normals_, camera, true);
      if (part == 1) lit_.draw(scene.polygons, normals_, sun_, false);
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
    const double sun = std::max(0.0, normals_[n].dot(scene_.to_sun)) * share_in_sun(p, normals_[n]);
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
    constexpr int kPoints = 8;
    const double reach = scene_.hollow_size * camera_.samples_per_metre(camera_.depth(p));
    const double turn = 2.0 * std::numbers::pi * ((x % 3) * 3 + y % 3) / 9.0;
    double closed = 0.0;
    for (int k = 0; k < kPoints; ++k) {
      const double r = reach * (k + 0.5) / kPoints, angle = turn + 2.4 * k;
      const int sx = x + static_cast<int>(std::lround(r * std::cos(angle)));
      const int sy = y + static_cast<int>(std::lround(r * std::sin(angle)));
      if (!seen_.holds(sx, sy) || seen_.polygon(sx, sy) < 0) continue;
      const Vec3 to = camera_.point({sx + 0.5, sy + 0.5}, seen_.near(sx, sy)) - p;
      const double distance = to.norm();
      if (distance <= 0.0) continue;
      const double rise = std::max(0.0, normal.dot(to) / distance - 0.1);
      closed += rise * std::max(0.0, 1.0 - distance / (2.0 * scene_.hollow_size));
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
  Ball ball_;
  Camera sun_;
  DepthBuffer seen_, lit_;
  std::vector<Vec3> normals_;
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
