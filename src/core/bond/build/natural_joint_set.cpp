// SPDX-License-Identifier: GPL-2.0-or-later
// Random planes of a joint set.
// Scope: see the header. Every plane has its own random numbers for normal and discs, so that a
// change of persistence leaves the planes where they are.
#include "bond/build/natural_joint_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/random.h"

namespace muckpile {
namespace {

/// Exponential with mean 1.
double exponential(Random& random) { return -std::log1p(-random.uniform()); }

/// Where along the normal planes are: from one that is beyond `from` to the last before `to` [m].
/// The first distance is that from any point to the next plane, so that planes are as dense next to
/// `from` as anywhere else: uniform below the least spacing with the share of it in the mean,
/// exponential beyond it.
std::vector<double> places(const NaturalJointSet& set, double from, double to, Random& random) {
  const double least = std::min(set.least_spacing, set.spacing), rest = set.spacing - least;
  const double share = random.uniform() * set.spacing;
  std::vector<double> found;
  double at = from + (share < least ? share : least + rest * exponential(random));
  for (; at < to; at += least + rest * exponential(random)) found.push_back(at);
  return found;
}

/// Fisher's distribution about `mean`: the cosine of the angle from it has the density
/// proportional to exp(K cosine).
Vec3 scattered(const Vec3& mean, double concentration, Random& random) {
  const double u = random.uniform(), azimuth = 2.0 * std::numbers::pi * random.uniform();
  if (!std::isfinite(concentration)) return mean;
  const double cosine =
      std::max(-1.0, 1.0 + std::log1p(-u * -std::expm1(-2.0 * concentration)) / concentration);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const Vec3 first = mean.unitOrthogonal(), second = mean.cross(first);
  return cosine * mean + sine * (std::cos(azimuth) * first + std::sin(azimuth) * second);
}

/// How many times the discs would cover the plane if none overlapped: they are so many that they
/// cover the share asked for where they overlap too, 1 - exp(-number per area x area of one).
double covered_times(const NaturalJointSet& set) { return -std::log1p(-set.persistence); }

double distance_from_box(const Vec3& point, const Vec3& lo, const Vec3& hi) {
  return (point - point.cwiseMax(lo).cwiseMin(hi)).norm();
}

/// Centres of discs at random in the plane (a Poisson process). A square of it is filled from one
/// end; discs that do not reach the box are left out.
std::vector<Vec3> disc_centres(const NaturalJointSet& set, const JointPlane& plane, const Vec3& lo,
                               const Vec3& hi, Random& random) {
  const double per_area = covered_times(set) / (std::numbers::pi * set.radius * set.radius);
  const double half = 0.5 * (hi - lo).norm() + set.radius;
  const Vec3 first = plane.normal.unitOrthogonal(), second = plane.normal.cross(first);
  std::vector<Vec3> centres;
  double x = -half;
  while ((x += exponential(random) / (per_area * 2.0 * half)) < half) {
    const double y = (2.0 * random.uniform() - 1.0) * half;
    const Vec3 centre = plane.point + x * first + y * second;
    if (distance_from_box(centre, lo, hi) < set.radius) centres.push_back(centre);
  }
  return centres;
}

bool meets_box(const JointPlane& plane, const Vec3& lo, const Vec3& hi) {
  const Vec3 half = 0.5 * (hi - lo);
  const double reach = plane.normal.cwiseAbs().dot(half);
  return std::abs(plane.normal.dot(plane.point - 0.5 * (lo + hi))) < reach;
}

}  // namespace

double most_planes(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi) {
  return (hi - lo).norm() / set.spacing;
}

// The square that disc_centres() fills is as wide as the diagonal and a disc.
double most_discs(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi) {
  if (set.persistence >= 1.0) return 0.0;
  const double width_in_radii = (hi - lo).norm() / set.radius + 2.0;
  return most_planes(set, lo, hi) * covered_times(set) * width_in_radii * width_in_radii /
         std::numbers::pi;
}

double least_radius(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi, double discs) {
  const double width_in_radii = std::sqrt(std::numbers::pi * std::max(discs, 0.0) /
                                          (most_planes(set, lo, hi) * covered_times(set)));
  if (width_in_radii <= 2.0) return std::numeric_limits<double>::infinity();
  return (hi - lo).norm() / (width_in_radii - 2.0);
}

std::vector<JointPlane> planes_of(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi,
                                  std::uint64_t seed) {
  const Vec3 mean = set.normal.normalized(), middle = 0.5 * (lo + hi);
  const double half = 0.5 * (hi - lo).norm();
  Random random(seed);
  std::vector<JointPlane> planes;
  std::uint64_t number = 0;
  for (const double at : places(set, -half, half, random)) {
    // Each plane at its distance from the middle along its own normal: then no direction is seen
    // more often than the distribution has it.
    Random own(random_bits(~seed, number++));
    JointPlane plane;
    plane.normal = scattered(mean, set.concentration, own);
    plane.point = middle + at * plane.normal;
    plane.joint_class = set.joint_class;
    if (!meets_box(plane, lo, hi)) continue;
    if (set.persistence < 1.0) {
      plane.radius = set.radius;
      plane.centres = disc_centres(set, plane, lo, hi, own);
      if (plane.centres.empty()) continue;
    }
    planes.push_back(plane);
  }
  return planes;
}

}  // namespace muckpile
