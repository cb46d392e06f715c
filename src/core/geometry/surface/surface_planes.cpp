// SPDX-License-Identifier: GPL-2.0-or-later
// Planes fitted to a surface near a point.
// Scope: see the header.
#include "geometry/surface/surface_planes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

constexpr std::size_t kMostPlanes = 4;
constexpr double kFlat = 1e-7;      // misfit over reach of what is flat
constexpr double kSmooth = 0.03;    // misfit over reach for which one plane is enough
constexpr double kGain = 0.6;       // misfit of one more plane over that before
constexpr double kCoarsest = 0.25;  // longest edge of a piece of the surface, over reach
constexpr double kNearest = 0.05, kNearestFlat = 1e-4;  // from the point to a plane, over reach
constexpr double kHighest = 0.3;                        // of the point over a plane, over reach

struct Sample {
  Vec3 at, normal;
  double weight;
};

struct Plane {
  Vec3 at, normal;
  [[nodiscard]] double height(const Vec3& p) const { return normal.dot(p - at); }
};

/// Halves a triangle across its longest edge until its pieces are small.
void add_samples(const StlTriangle& t, const Vec3& normal, const Vec3& from, double reach,
                 std::vector<Sample>& samples) {
  const std::array<double, 3> edge{(t[1] - t[0]).norm(), (t[2] - t[1]).norm(),
                                   (t[0] - t[2]).norm()};
  const auto k =
      static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  if ((middle - from).norm() > reach + edge[k]) return;
  if (edge[k] > kCoarsest * reach) {
    const Vec3 half = 0.5 * (t[k] + t[(k + 1) % 3]);
    add_samples({t[k], half, t[(k + 2) % 3]}, normal, from, reach, samples);
    add_samples({half, t[(k + 1) % 3], t[(k + 2) % 3]}, normal, from, reach, samples);
    return;
  }
  const double away = (middle - from).norm() / reach;
  if (away >= 1.0 || normal.dot(middle - from) <= 0.0) return;  // seen from behind: not this wall
  const double area = 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
  samples.push_back({middle, normal, area * (1.0 - away * away)});
}

/// Least squares of the heights over the plane of the mean normal; that plane where samples are too
/// few for a slope. None if the normals cancel.
bool fit(const std::vector<Sample>& samples, const std::vector<std::size_t>& of_plane,
         std::size_t number, double reach, Plane& plane) {
  Vec3 at = Vec3::Zero(), normal = Vec3::Zero();
  double weight = 0.0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (of_plane[k] != number) continue;
    at += samples[k].weight * samples[k].at;
    normal += samples[k].weight * samples[k].normal;
    weight += samples[k].weight;
  }
  constexpr double kLeast = 0.2;  // of the mean normal
  if (!(weight > 0.0) || normal.norm() < kLeast * weight) return false;
  plane = {at / weight, normal.normalized()};
  const Vec3 first = plane.normal.unitOrthogonal(), second = plane.normal.cross(first);
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (of_plane[k] != number) continue;
    const Vec3 from = samples[k].at - plane.at;
    const Eigen::Vector2d place(first.dot(from), second.dot(from));
    spread += samples[k].weight * place * place.transpose();
    rise += samples[k].weight * plane.normal.dot(from) * place;
  }
  constexpr double kNarrow = 0.05;  // radius of what is too small for a slope, over reach
  const double least =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues().minCoeff();
  if (least < kNarrow * kNarrow * reach * reach * weight) return true;
  const Eigen::Vector2d slope = spread.inverse() * rise;
  plane.normal = (plane.normal - slope.x() * first - slope.y() * second).normalized();
  return true;
}

using Planes = std::vector<Plane>;

/// Root of the mean square of what the surface lies off the convex body below all planes.
double misfit(const std::vector<Sample>& samples, const Planes& planes) {
  double sum = 0.0, weight = 0.0;
  for (const Sample& s : samples) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes) highest = std::max(highest, plane.height(s.at));
    sum += s.weight * highest * highest;
    weight += s.weight;
  }
  return std::sqrt(sum / weight);
}

/// The two samples whose normals differ most begin the pieces, then the one that differs most from
/// those: pieces of like normals.
std::vector<std::size_t> pieces_of(const std::vector<Sample>& samples, std::size_t count) {
  std::vector<Vec3> normals{samples.front().normal};
  for (std::size_t k = 0; k <= count; ++k) {
    double farthest = -1.0;
    Vec3 next = normals.front();
    for (const Sample& s : samples) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec3& n : normals) nearest = std::min(nearest, (s.normal - n).squaredNorm());
      if (nearest > farthest) {
        farthest = nearest;
        next = s.normal;
      }
    }
    if (k == 0)
      normals.front() = next;  // an end of the spread, not any of it
    else if (normals.size() < count)
      normals.push_back(next);
  }
  constexpr int kRounds = 4;
  std::vector<std::size_t> of_piece(samples.size(), 0);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vec3> sums(count, Vec3::Zero());
    for (std::size_t k = 0; k < samples.size(); ++k) {
      std::size_t best = 0;
      for (std::size_t p = 1; p < count; ++p)
        if ((samples[k].normal - normals[p]).squaredNorm() <
            (samples[k].normal - normals[best]).squaredNorm())
          best = p;
      of_piece[k] = best;
      sums[best] += samples[k].weight * samples[k].normal;
    }
    for (std::size_t p = 0; p < count; ++p)
      if (sums[p].norm() > 0.0) normals[p] = sums[p].normalized();
  }
  return of_piece;
}

/// Planes for so many pieces; none if one cannot be fitted or has the point far outside.
Planes planes_of(const std::vector<Sample>& samples, std::size_t count, const Vec3& point,
                 double reach) {
  const std::vector<std::size_t> of_piece =
      count == 1 ? std::vector<std::size_t>(samples.size(), 0) : pieces_of(samples, count);
  Planes planes;
  for (std::size_t p = 0; p < count; ++p) {
    Plane plane;
    if (!fit(samples, of_piece, p, reach, plane)) return {};
    if (plane.height(point) > kHighest * reach) return {};
    planes.push_back(plane);
  }
  return planes;
}

/// Moved outward where the point is too near to them, or outside.
Planes moved(Planes planes, const Vec3& point, double nearest) {
  for (Plane& plane : planes)
    plane.at += std::max(0.0, plane.height(point) + nearest) * plane.normal;
  return planes;
}

Planes best_planes(const std::vector<Sample>& samples, const Vec3& point, double reach) {
  Planes best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t count = 1; count <= kMostPlanes; ++count) {
    const Planes planes = planes_of(samples, count, point, reach);
    if (planes.empty()) continue;
    const double off = misfit(samples, planes);
    if (off < kFlat * reach) return moved(planes, point, kNearestFlat * reach);
    const bool rough = least > kSmooth * reach;
    if (best.empty() || (rough && off < kGain * least)) {
      best = planes;
      least = off;
    }
  }
  return moved(best, point, kNearest * reach);
}

}  // namespace

std::vector<Vec3> feet_on_planes(const SurfaceIndex& surface, const Vec3& point, double reach) {
  const SurfaceIndex::Closest closest = surface.closest(point);
  if (closest.distance > reach) return {};
  std::vector<std::size_t> near;
  surface.near(point, reach, near);
  std::vector<Sample> samples;
  for (const std::size_t t : near)
    add_samples(surface.triangles()[t], surface.unit_normal(t), point, reach, samples);
  std::vector<Vec3> feet;
  if (!samples.empty()) {
    for (const Plane& plane : best_planes(samples, point, reach))
      feet.push_back(point - plane.height(point) * plane.normal);
  }
  std::erase_if(feet, [&](const Vec3& foot) { return (foot - point).norm() > reach; });
  if (feet.empty()) feet.push_back(closest.point);
  return feet;
}

}  // namespace muckpile
