// SPDX-License-Identifier: GPL-2.0-or-later
// What a picture of the rock holds.
// Scope: see the header.
#include "report/picture_scene.h"

#include <algorithm>

#include "measure/section.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

constexpr Colour kGround{0.74F, 0.72F, 0.68F};

std::vector<Vec3> kept(const CutPlane& plane, const std::vector<Vec3>& polygon) {
  const auto left_of = [&](const Vec3& p) { return plane.line.along_and_left(p.head<2>()).y(); };
  const auto inside = [&](double left) { return (left >= 0.0) == plane.keep_left; };
  std::vector<Vec3> part;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double from = left_of(a), to = left_of(b);
    if (inside(from)) part.push_back(a);
    if (inside(from) != inside(to)) part.emplace_back(a + (b - a) * (from / (from - to)));
  }
  return part;
}

}  // namespace

void add_blocks(const std::vector<StartBlock>& blocks, const Snapshot& snapshot,
                const std::vector<Colour>& colours, const Reflection& reflection, Scene& scene) {
  std::vector<size_t> first{scene.polygons.size()};  // polygon of each block
  for (const StartBlock& block : blocks) first.push_back(first.back() + block.shape.faces.size());
  scene.polygons.resize(first.back());
  each_in_parallel(blocks.size(), [&](size_t b) {
    const std::vector<Vec3> vertices = moved_vertices(blocks[b], snapshot.states[b]);
    size_t number = first[b];
    for (const std::span<const int> face : blocks[b].shape.faces) {
      ScenePolygon& polygon = scene.polygons[number++];
      polygon = {{}, colours[b], static_cast<int>(b)};
      polygon.corners.reserve(face.size());
      for (const int v : face)
        polygon.corners.push_back(reflection.of(vertices[static_cast<size_t>(v)]));
      if (reflection.turns_over()) std::ranges::reverse(polygon.corners);
    }
  });
}

void add_ground(const Extent& rock, double x_high, double margin, Scene& scene) {
  const double x0 = rock.low.x() - margin, x1 = rock.low.x(), x2 = rock.high.x(),
               x3 = x_high + margin;
  const double y0 = rock.low.y() - margin, y1 = rock.low.y(), y2 = rock.high.y(),
               y3 = rock.high.y() + margin;
  const auto add = [&](double xl, double yl, double xh, double yh) {
    scene.polygons.push_back(
        {{{xl, yl, 0}, {xh, yl, 0}, {xh, yh, 0}, {xl, yh, 0}}, kGround, kGroundObject});
  };
  add(x0, y0, x3, y1);
  add(x0, y2, x3, y3);
  add(x0, y1, x1, y2);
  add(x2, y1, x3, y2);
}

std::vector<SceneLine> edges_of(const Extent& rock) {
  const double low = rock.high.z() > 0.0 ? std::max(0.0, rock.low.z()) : rock.low.z();
  const auto corner = [&](int k) {
    return Vec3(k & 1 ? rock.high.x() : rock.low.x(), k & 2 ? rock.high.y() : rock.low.y(),
                k & 4 ? rock.high.z() : low);
  };
  std::vector<SceneLine> edges;
  for (int from = 0; from < 8; ++from) {
    for (const int bit : {1, 2, 4}) {
      if ((from & bit) == 0) edges.push_back({corner(from), corner(from | bit)});
    }
  }
  return edges;
}

CutPlane cut_along(const PlanLine& line, const Vec3& to_eye) {
  const Vec2 way = line.to - line.from, left(-way.y(), way.x());
  return {line, left.dot(to_eye.head<2>()) <= 0.0};
}

void cut_away(const CutPlane& plane, Scene& scene) {
  for (ScenePolygon& polygon : scene.polygons) polygon.corners = kept(plane, polygon.corners);
  std::erase_if(scene.polygons, [](const ScenePolygon& p) { return p.corners.size() < 3; });
}

void add_cut_faces(const CutPlane& plane, const std::vector<StartBlock>& blocks,
                   const Snapshot& snapshot, const std::vector<Colour>& colours, Scene& scene) {
  const std::vector<BlockState> seen = seen_along(plane.line, snapshot.states);
  for (const SectionPolygon& cut : section_at(0.0, blocks, seen)) {
    ScenePolygon face{{}, colours[cut.block], static_cast<int>(cut.block)};
    // In order of rising angle from the line to z, so counter-clockwise seen from its right.
    for (const Vec2& p : cut.outline) {
      const Vec2 at = plane.line.at(p.x());
      face.corners.emplace_back(at.x(), at.y(), p.y());
    }
    if (!plane.keep_left) std::ranges::reverse(face.corners);
    scene.polygons.push_back(std::move(face));
  }
}

}  // namespace muckpile
