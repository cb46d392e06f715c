// SPDX-License-Identifier: GPL-2.0-or-later
// The nearest polygon at each sample of a picture.
// Scope: see the header. What is hidden is told by tiles of samples, each with its farthest one (the
// hierarchical depth buffer of Greene, Kass and Miller, SIGGRAPH 1993, with one level).
#include "draw/depth_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
constexpr int kTile = 8;  // samples along the side of a tile

Vec3 normal_of(const std::vector<Vec3>& c) {
  Vec3 normal = Vec3::Zero();
  for (size_t k = 1; k + 1 < c.size(); ++k) normal += (c[k] - c[0]).cross(c[k + 1] - c[0]);
  return normal;
}

}  // namespace

std::vector<SceneObject> objects_of(const std::vector<ScenePolygon>& polygons) {
  std::vector<SceneObject> objects;
  for (size_t p = 0; p < polygons.size(); ++p) {
    if (p == 0 || polygons[p].object != polygons[p - 1].object)
      objects.push_back({p, p, Vec3::Constant(-kNothing), Vec3::Constant(kNothing),
                         polygons[p].object == kGroundObject});
    objects.back().end = p + 1;
  }
  each_in_parallel(objects.size(), [&](size_t k) {
    SceneObject& object = objects[k];
    for (size_t p = object.begin; p < object.end; ++p) {
      for (const Vec3& c : polygons[p].corners)
        object.low = object.low.cwiseMin(c), object.high = object.high.cwiseMax(c);
    }
  });
  return objects;
}

std::vector<Vec3> normals_of(const std::vector<ScenePolygon>& polygons) {
  std::vector<Vec3> normals(polygons.size());
  each_in_parallel(normals.size(),
                   [&](size_t p) { normals[p] = normal_of(polygons[p].corners); });
  return normals;
}

// Some rows of the buffer, a whole number of tiles high.
class DepthBuffer::Band {
 public:
  Band(DepthBuffer& buffer, int row_begin, int row_end)
      : buffer_(buffer),
        row_begin_(row_begin),
        row_end_(row_end),
        tiles_across_((buffer.width_ + kTile - 1) / kTile),
        farthest_(static_cast<size_t>(tiles_across_) *
                      static_cast<size_t>((row_end - row_begin + kTile - 1) / kTile),
                  kNothing),
        changed_(farthest_.size(), 0) {}

  // Whether all samples there hold something that is nearer.
  [[nodiscard]] bool hides(const Rectangle& there, double nearest) {
    bool hidden = true;
    each_tile(there, [&](int column, int row, size_t tile) {
      if (hidden && changed_[tile] != 0) look_at_tile(column, row, tile);
      hidden = hidden && farthest_[tile] > nearest;
    });
    return hidden;
  }

  void mark(const Rectangle& there) {
    each_tile(there, [&](int, int, size_t tile) { changed_[tile] = 1; });
  }

  void draw(const ScenePolygon& polygon, const Vec3& normal, int number, const Camera& camera) {
    outline_.clear();
    const bool all_seen =
        std::ranges::all_of(polygon.corners, [&](const Vec3& c) { return camera.sees(c); });
    const auto add = [&](const Vec3& c) {
      outline_.push_back(camera.place(c) - Vec2(0.0, row_begin_));
    };
    if (all_seen) {
      std::ranges::for_each(polygon.corners, add);
    } else {
      std::ranges::for_each(camera.clipped(polygon.corners), add);
    }
    const Vec3 plane = camera.nearness_of_plane(polygon.corners[0], normal);
    scan_polygon(outline_, buffer_.width_, row_end_ - row_begin_, crossings_,
                 [&](int y, int begin, int end) {
                   const int row = y + row_begin_;
                   const double nearness = plane.x() + plane.z() * (row + 0.5);
                   fill(buffer_.index(0, row), begin, end, nearness, plane.y(), number);
                 });
  }

 private:
  // Samples [begin, end) of the row that begins at `first`.
  void fill(size_t first, int begin, int end, double nearness, double per_sample, int number) {
    for (int x = begin; x < end; ++x) {
      const double here = nearness + per_sample * (x + 0.5);
      const size_t i = first + static_cast<size_t>(x);
      if (here > buffer_.near_[i]) buffer_.near_[i] = here, buffer_.polygon_[i] = number;
    }
  }

  template <class Work>
  void each_tile(const Rectangle& there, Work&& work) {
    const int row_low = (there.y_begin - row_begin_) / kTile,
              row_high = (there.y_end - 1 - row_begin_) / kTile;
    for (int row = row_low; row <= row_high; ++row) {
      for (int column = there.x_begin / kTile; column <= (there.x_end - 1) / kTile; ++column)
        work(column, row,
             static_cast<size_t>(row) * static_cast<size_t>(tiles_across_) +
                 static_cast<size_t>(column));
    }
  }

  void look_at_tile(int column, int row, size_t tile) {
    double farthest = -kNothing;
    const int y_begin = row_begin_ + row * kTile, x_begin = column * kTile;
    for (int y = y_begin; y < std::min(y_begin + kTile, row_end_); ++y) {
      for (int x = x_begin; x < std::min(x_begin + kTile, buffer_.width_); ++x)
        farthest = std::min(farthest, buffer_.near_[buffer_.index(x, y)]);
    }
    farthest_[tile] = farthest;
    changed_[tile] = 0;
  }

  DepthBuffer& buffer_;
  int row_begin_, row_end_, tiles_across_;
  std::vector<double> farthest_;  // of each tile, but where it has changed since
  std::vector<char> changed_;
  std::vector<Vec2> outline_;
  std::vector<double> crossings_;
};

DepthBuffer::DepthBuffer(int width, int height)
    : width_(width),
      height_(height),
      bands_(std::min<size_t>(4 * cores(), static_cast<size_t>((height + kTile - 1) / kTile))),
      near_(static_cast<size_t>(width) * static_cast<size_t>(height), kNothing),
      polygon_(near_.size(), -1) {}

DepthBuffer::Sight DepthBuffer::sight_of(size_t object, const SceneObject& box,
                                         const Camera& camera) {
  constexpr double kRoom = 1.0;  // for rounding [samples]
  const double all = -kNothing;
  Sight sight{object, kNothing, Vec2::Constant(all), Vec2::Constant(-all)};
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner((k & 1) != 0 ? box.high.x() : box.low.x(),
                      (k & 2) != 0 ? box.high.y() : box.low.y(),
                      (k & 4) != 0 ? box.high.z() : box.low.z());
    if (!camera.sees(corner)) return {object, all, Vec2::Constant(-all), Vec2::Constant(all)};
    const Vec2 place = camera.place(corner);
    sight.low = sight.low.cwiseMin(place - Vec2::Constant(kRoom));
    sight.high = sight.high.cwiseMax(place + Vec2::Constant(kRoom));
    sight.nearest = std::max(sight.nearest, camera.nearness(corner));
  }
  return sight;
}

void DepthBuffer::look_at(const SceneParts& scene, const Camera& camera, bool with_ground) {
  sights_.resize(scene.objects.size());
  each_in_parallel(sights_.size(),
                   [&](size_t k) { sights_[k] = sight_of(k, scene.objects[k], camera); });
  std::erase_if(sights_, [&](const Sight& sight) {
    return (!with_ground && scene.objects[sight.object].ground) || sight.high.x() <= 0.0 ||
           sight.high.y() <= 0.0 || sight.low.x() >= width_ || sight.low.y() >= height_;
  });
  std::ranges::stable_sort(sights_, std::ranges::greater{}, &Sight::nearest);
}

DepthBuffer::Rectangle DepthBuffer::covered(const Sight& sight, int row_begin, int row_end) const {
  const auto within = [](double place, int low, int high) {
    return static_cast<int>(
        std::clamp(place, static_cast<double>(low), static_cast<double>(high)));
  };
  return {within(std::floor(sight.low.x()), 0, width_), within(std::ceil(sight.high.x()), 0, width_),
          within(std::floor(sight.low.y()), row_begin, row_end),
          within(std::ceil(sight.high.y()), row_begin, row_end)};
}

void DepthBuffer::draw_band(size_t number, const SceneParts& scene, const Camera& camera) {
  const size_t tiles = (static_cast<size_t>(height_) + kTile - 1) / kTile;
  const auto row_of = [&](size_t k) {
    return std::min(static_cast<int>(k * tiles / bands_) * kTile, height_);
  };
  const int row_begin = row_of(number), row_end = row_of(number + 1);
  Band band(*this, row_begin, row_end);
  for (const Sight& sight : sights_) {
    const Rectangle there = covered(sight, row_begin, row_end);
    if (there.x_begin >= there.x_end || there.y_begin >= there.y_end) continue;
    if (band.hides(there, sight.nearest)) continue;
    const SceneObject& object = scene.objects[sight.object];
    for (size_t p = object.begin; p < object.end; ++p) {
      const ScenePolygon& polygon = scene.polygons[p];
      if (camera.faces_eye(polygon.corners[0], scene.normals[p]))
        band.draw(polygon, scene.normals[p], static_cast<int>(p), camera);
    }
    band.mark(there);
  }
}

}  // namespace muckpile
