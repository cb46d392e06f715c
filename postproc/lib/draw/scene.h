// SPDX-License-Identifier: GPL-2.0-or-later
// A 3-D picture of opaque plane polygons under sun and sky, drawn in software.
// Scope: depth buffer, one sun with shadows, darkening of hollows, outlines; no display or graphics
// card.
#pragma once

#include <vector>

#include "draw/camera.h"
#include "draw/canvas.h"
#include "math/types.h"

namespace muckpile {

inline constexpr int kGroundObject = -1;  // receives shadows, throws none, fades into haze

struct ScenePolygon {
  std::vector<Vec3> corners;  // convex, plane, counter-clockwise seen from its visible side [m]
  Colour colour;
  int object;  // outlines are drawn where the object changes; kGroundObject for the ground
};

struct SceneLine {
  Vec3 from, to;  // [m]
};

struct Scene {
  std::vector<ScenePolygon> polygons;
  std::vector<SceneLine> ghost_lines;  // drawn over the rest, faint where something is in front
  Vec3 to_sun;                         // unit
  double hollow_size;                  // reach of the darkening of hollows [m]
  double haze = 1e9;                   // distance over which the ground fades by 1/e [m]
};

// Draws over the whole canvas; the camera counts in the canvas's samples.
void draw_scene(const Scene& scene, const Camera& camera, Canvas& canvas);

}  // namespace muckpile
