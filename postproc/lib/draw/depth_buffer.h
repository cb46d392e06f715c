// SPDX-License-Identifier: GPL-2.0-or-later
// The nearest polygon at each sample of a picture, found on all cores.
// Scope: opaque plane polygons; whole objects that others hide are left out, so that of a solid
// rock only its outer blocks are drawn.
#pragma once

#include <vector>

#include "draw/camera.h"
#include "draw/scene.h"

namespace muckpile {

// Polygons of one object that stand one behind the other in a scene, and the box around them.
struct SceneObject {
  size_t begin, end;  // polygons
  Vec3 low, high;     // [m]
  bool ground;
};
std::vector<SceneObject> objects_of(const std::vector<ScenePolygon>& polygons);

// Area vectors of polygons, of any length.
std::vector<Vec3> normals_of(const std::vector<ScenePolygon>& polygons);

struct SceneParts {
  const std::vector<ScenePolygon>& polygons;
  const std::vector<Vec3>& normals;
  const std::vector<SceneObject>& objects;
};

class DepthBuffer {
 public:
  DepthBuffer(int width, int height);

  // The picture is divided into bands, which may be drawn at the same time.
  [[nodiscard]] size_t bands() const { return bands_; }
  // Called first: the objects, those in front first.
  void look_at(const SceneParts& scene, const Camera& camera, bool with_ground);
  void draw_band(size_t band, const SceneParts& scene, const Camera& camera);

  [[nodiscard]] bool holds(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_;
  }
  [[nodiscard]] double near(int x, int y) const { return near_[index(x, y)]; }
  [[nodiscard]] int polygon(int x, int y) const { return polygon_[index(x, y)]; }

 private:
  // An object as the camera sees the box around it: nothing of it is nearer, or outside of these
  // samples.
  struct Sight {
    size_t object;
    double nearest;
    Vec2 low, high;
  };
  struct Rectangle {
    int x_begin, x_end, y_begin, y_end;
  };
  class Band;

  [[nodiscard]] size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }
  [[nodiscard]] static Sight sight_of(size_t object, const SceneObject& box, const Camera& camera);
  [[nodiscard]] Rectangle covered(const Sight& sight, int row_begin, int row_end) const;

  int width_, height_;
  size_t bands_;
  std::vector<double> near_;
  std::vector<int> polygon_;
  std::vector<Sight> sights_;
};

}  // namespace muckpile
