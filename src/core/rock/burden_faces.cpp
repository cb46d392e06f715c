// SPDX-License-Identifier: GPL-2.0-or-later
// The free faces that burdens are measured to.
// Scope: see the header.
#include "rock/burden_faces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace muckpile {
namespace {

/// Whether a block's free face is within its size of a survey: blocks round the survey's edges off,
/// so the face may look another way.
bool stands_for_survey(const FaceGeometry& face, double size, const SurveyedRock& surveyed) {
  return std::ranges::any_of(surveyed.surfaces, [&](const RockSurface& surface) {
    return surface.index->closest(face.centroid).distance < size;
  });
}

bool lies_on_box(const FaceGeometry& face, double size, const SurveyedRock& surveyed) {
  constexpr double kRounding = 1e-6;
  const Vec3 away =
      (face.centroid - surveyed.lo).cwiseAbs().cwiseMin((face.centroid - surveyed.hi).cwiseAbs());
  Eigen::Index axis = 0;
  return away.minCoeff(&axis) < kRounding * size && std::abs(face.normal[axis]) > 1.0 - kRounding;
}

void add_blocks(const std::vector<Block>& blocks, const SupportRule& support,
                const SurveyedRock& surveyed, std::vector<FreeFace>& faces) {
  for (const Block& block : blocks) {
    const double size = std::cbrt(block.mass.volume);
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != kFreeFace) continue;
      const FaceGeometry geometry = face_geometry(block.shape, static_cast<int>(f));
      if (support(geometry.centroid) != Support::free) continue;
      if (!lies_on_box(geometry, size, surveyed) && stands_for_survey(geometry, size, surveyed))
        continue;
      Corners corners;
      for (const int v : block.shape.faces[f])
        corners.push_back(block.shape.vertices[static_cast<std::size_t>(v)]);
      faces.push_back({std::move(corners), geometry.normal});
    }
  }
}

Corners within_box(Corners polygon, const Vec3& lo, const Vec3& hi) {
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = cut_at(polygon, Vec3::Zero(), Vec3::Unit(axis), lo[axis], -1.0);
    polygon = cut_at(polygon, Vec3::Zero(), Vec3::Unit(axis), hi[axis], 1.0);
  }
  return polygon;
}

/// Halved until none is longer than `longest` along an axis [m].
template <class Take>
void for_each_part(const Corners& polygon, double longest, const Take& take) {
  if (polygon.size() < 3) return;
  Vec3 lo = polygon.front(), hi = lo;
  for (const Vec3& p : polygon) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  Eigen::Index axis = 0;
  if ((hi - lo).maxCoeff(&axis) <= longest) return take(polygon);
  const double middle = 0.5 * (lo[axis] + hi[axis]);
  for (const double sign : {1.0, -1.0})
    for_each_part(cut_at(polygon, Vec3::Zero(), Vec3::Unit(axis), middle, sign), longest, take);
}

/// Parts of a survey's triangles at which the rock ends and nothing holds it.
void add_survey(std::size_t which, const SupportRule& support, const SurveyedRock& surveyed,
                std::vector<FreeFace>& faces) {
  constexpr double kPart = 0.01, kJustWithin = 1e-7;  // of the box's diagonal
  const double diagonal = (surveyed.hi - surveyed.lo).norm();
  const SurfaceIndex& index = *surveyed.surfaces[which].index;
  const auto in_rock = [&](const Vec3& p) {
    for (std::size_t s = 0; s < surveyed.surfaces.size(); ++s)
      if (s != which && !surveyed.surfaces[s].inside(p)) return false;
    return !surveyed.region.inside || surveyed.region.inside(p);
  };
  for (std::size_t t = 0; t < index.triangles().size(); ++t) {
    const StlTriangle& triangle = index.triangles()[t];
    const Vec3 normal = index.unit_normal(t);
    if (!(normal.squaredNorm() > 0.5)) continue;  // of no area
    const Corners shown =
        within_box({triangle[0], triangle[1], triangle[2]}, surveyed.lo, surveyed.hi);
    for_each_part(shown, kPart * diagonal, [&](const Corners& part) {
      const Vec3 middle = std::accumulate(part.begin(), part.end(), Vec3(Vec3::Zero())) /
                          static_cast<double>(part.size());
      if (support(middle) == Support::free && in_rock(middle - kJustWithin * diagonal * normal))
        faces.push_back({part, normal});
    });
  }
}

}  // namespace

Corners cut_at(const Corners& polygon, const Vec3& from, const Vec3& along, double end,
               double sign) {
  Corners kept;
  const auto over = [&](const Vec3& p) { return sign * (along.dot(p - from) - end); };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double here = over(p), there = over(q);
    if (here <= 0.0) kept.push_back(p);
    if ((here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0))
      kept.push_back(p + here / (here - there) * (q - p));
  }
  return kept;
}

std::vector<FreeFace> free_faces(const std::vector<Block>& blocks, const SupportRule& support,
                                 const SurveyedRock& surveyed) {
  std::vector<FreeFace> faces;
  add_blocks(blocks, support, surveyed, faces);
  for (std::size_t s = 0; s < surveyed.surfaces.size(); ++s)
    add_survey(s, support, surveyed, faces);
  return faces;
}

}  // namespace muckpile
