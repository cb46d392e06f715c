// SPDX-License-Identifier: GPL-2.0-or-later
// Closest point of a triangle.
// Scope: see the header.
#include "geometry/surface/triangle_point.h"

#include <cmath>

namespace muckpile {

TrianglePoint closest_on(const StlTriangle& t, const Vec3& p) {
  using On = TrianglePoint::On;
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {t[0], On::corner, 0};
  const Vec3 bp = p - t[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {t[1], On::corner, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {t[0] + d1 / (d1 - d3) * ab, On::edge};
  const Vec3 cp = p - t[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {t[2], On::corner, 2};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {t[0] + d2 / (d2 - d6) * ac, On::edge};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return {t[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t[2] - t[1]), On::edge};
  const double sum = va + vb + vc;
  return {t[0] + vb / sum * ab + vc / sum * ac, On::face};
}

TrianglePoint snapped(const StlTriangle& t, const Vec3& at, double slack) {
  using On = TrianglePoint::On;
  for (std::size_t c = 0; c < 3; ++c)
    if ((t[c] - at).squaredNorm() <= slack * slack) return {at, On::corner, c};
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3 along = t[(c + 1) % 3] - t[c];
    if ((at - t[c]).cross(along).squaredNorm() <= slack * slack * along.squaredNorm())
      return {at, On::edge};
  }
  return {at, On::face};
}

double angle_around(const StlTriangle& t, const TrianglePoint& point) {
  if (point.on == TrianglePoint::On::face) return 2.0 * M_PI;
  if (point.on == TrianglePoint::On::edge) return M_PI;
  const Vec3 one = t[(point.corner + 1) % 3] - t[point.corner];
  const Vec3 other = t[(point.corner + 2) % 3] - t[point.corner];
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

}  // namespace muckpile
