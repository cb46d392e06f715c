// SPDX-License-Identifier: GPL-2.0-or-later
// Random planes of a joint set: number, distances, area per volume, orientation, share of discs.
// Scope: means over many seeds; bounds are four standard errors of what is drawn unless said.
#include <gtest/gtest.h>

#include <cmath>

#include "bond/build/natural_joint_set.h"
#include "geometry/shape/convex_cell.h"

namespace muckpile {
namespace {

const Vec3 kLo(-3.0, 1.0, 2.0), kHi(5.0, 7.0, 12.0);  // 8 x 6 x 10 m
const double kVolume = 480.0;
constexpr int kSeeds = 400;

NaturalJointSet set_of(const Vec3& normal, double spacing, double least) {
  NaturalJointSet set;
  set.normal = normal;
  set.spacing = spacing;
  set.least_spacing = least;
  return set;
}

/// Area of a plane within the box [m2].
double area_in_box(const JointPlane& plane) {
  const auto halves = divided(box_cell(kLo, kHi), plane.point, plane.normal, 0);
  if (!halves) return 0.0;
  for (std::size_t f = 0; f < halves->below.made_by.size(); ++f) {
    if (halves->below.made_by[f] == 0)
      return face_geometry(halves->below.shape, static_cast<int>(f)).area;
  }
  return 0.0;
}

struct Mean {
  double sum = 0.0, squares = 0.0, count = 0.0;
  void add(double value) {
    sum += value;
    squares += value * value;
    count += 1.0;
  }
  [[nodiscard]] double value() const { return sum / count; }
  [[nodiscard]] double four_errors() const {
    return 4.0 * std::sqrt((squares / count - value() * value()) / count);
  }
};

TEST(NaturalJointSet, EvenPlanesAreSpacedAlongTheirNormal) {
  const Vec3 normal = normal_of_dip(70.0 * M_PI / 180.0, 90.0 * M_PI / 180.0);  // dips to the east
  EXPECT_NEAR(normal.x(), std::sin(70.0 * M_PI / 180.0), 1e-15);
  EXPECT_NEAR(normal.y(), 0.0, 1e-15);
  const std::vector<JointPlane> planes = planes_of(set_of(normal, 1.25, 1.25), kLo, kHi, 7);
  // the box is 8 sin 70 + 10 cos 70 = 10.94 m wide along the normal: 8 or 9 planes
  ASSERT_GE(planes.size(), 8u);
  ASSERT_LE(planes.size(), 9u);
  for (std::size_t k = 1; k < planes.size(); ++k) {
    EXPECT_NEAR(normal.dot(planes[k].point - planes[k - 1].point), 1.25, 1e-12);
    EXPECT_NEAR((planes[k].normal - normal).norm(), 0.0, 1e-15);
  }
}

TEST(NaturalJointSet, DistancesHaveTheMeanAndKeepTheLeast) {
  const NaturalJointSet set = set_of(Vec3::UnitZ(), 0.8, 0.2);
  Mean distance, number, first;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const std::vector<JointPlane> planes =
        planes_of(set, kLo, kHi, static_cast<std::uint64_t>(seed));
    number.add(static_cast<double>(planes.size()));
    for (std::size_t k = 1; k < planes.size(); ++k) {
      const double gap = planes[k].point.z() - planes[k - 1].point.z();
      EXPECT_GE(gap, 0.2);
      distance.add(gap);
    }
    for (const JointPlane& plane : planes) first.add(plane.point.z() < 3.0 ? 1.0 : 0.0);
  }
  EXPECT_NEAR(number.value(), 10.0 / 0.8, number.four_errors());
  // gaps that end beyond the box are not seen: their mean is a little below the true one
  EXPECT_NEAR(distance.value(), 0.8, 0.06);
  EXPECT_NEAR(first.value(), 0.1, first.four_errors());  // as dense at the end as elsewhere
}

TEST(NaturalJointSet, AreaPerVolumeIsOneOverTheSpacingWhateverTheScatter) {
  for (const double concentration : {1e300, 5.0}) {
    NaturalJointSet set = set_of(Vec3(1.0, 0.5, 2.0), 1.5, 0.1);
    if (concentration < 1e6) set.concentration = concentration;
    Mean area;
    for (int seed = 0; seed < kSeeds; ++seed) {
      double sum = 0.0;
      for (const JointPlane& plane : planes_of(set, kLo, kHi, static_cast<std::uint64_t>(seed)))
        sum += area_in_box(plane);
      area.add(sum / kVolume);
    }
    EXPECT_NEAR(area.value(), 1.0 / 1.5, area.four_errors()) << concentration;
    EXPECT_LT(area.four_errors(), 0.06);
  }
}

TEST(NaturalJointSet, NormalsHaveFishersDistribution) {
  NaturalJointSet set = set_of(Vec3(0.0, 3.0, 4.0), 0.05, 0.0);
  set.concentration = 30.0;
  const Vec3 mean = set.normal.normalized();
  Mean cosine;
  Vec3 sum = Vec3::Zero();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const JointPlane& plane : planes_of(set, kLo, kHi, seed)) {
      cosine.add(plane.normal.dot(mean));
      sum += plane.normal;
      EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-12);
    }
  }
  EXPECT_NEAR(cosine.value(), 1.0 / std::tanh(30.0) - 1.0 / 30.0, cosine.four_errors());
  EXPECT_GT(sum.normalized().dot(mean), 0.9999);  // no direction about the mean is preferred
}

TEST(NaturalJointSet, DiscsCoverTheShareOfThePlanes) {
  NaturalJointSet set = set_of(Vec3::UnitX(), 2.0, 0.5);
  set.persistence = 0.4;
  set.radius = 1.2;
  Mean covered;
  for (int seed = 0; seed < kSeeds; ++seed) {
    double inside = 0.0;
    for (const JointPlane& plane : planes_of(set, kLo, kHi, static_cast<std::uint64_t>(seed))) {
      const Vec3 at(plane.point.x(), 1.5, 11.5);  // near an edge of the box
      for (const Vec3& centre : plane.centres) {
        EXPECT_NEAR(centre.x(), plane.point.x(), 1e-9);
        if ((centre - at).norm() > plane.radius) continue;
        inside += 1.0;
        break;
      }
    }
    covered.add(inside / (8.0 / 2.0));  // of the mean number of planes
  }
  EXPECT_NEAR(covered.value(), 0.4, covered.four_errors());
}

TEST(NaturalJointSet, TheLeastRadiusGivesTheNumberOfDiscs) {
  NaturalJointSet set = set_of(Vec3::UnitX(), 2.0, 0.5);
  EXPECT_EQ(most_discs(set, kLo, kHi), 0.0);
  set.persistence = 0.4;
  set.radius = least_radius(set, kLo, kHi, 5000.0);
  EXPECT_NEAR(most_discs(set, kLo, kHi), 5000.0, 1e-6);  // round-off
  // the widest discs: sqrt(200) m / 2 m = 7.07 planes, -ln(0.6) 4 / pi = 0.65 in each
  EXPECT_FALSE(std::isfinite(least_radius(set, kLo, kHi, 4.5)));
  EXPECT_TRUE(std::isfinite(least_radius(set, kLo, kHi, 4.7)));
}

TEST(NaturalJointSet, PersistenceLeavesThePlanesWhereTheyAre) {
  NaturalJointSet set = set_of(Vec3(1.0, 1.0, 0.0), 1.0, 0.2);
  set.concentration = 50.0;
  const std::vector<JointPlane> whole = planes_of(set, kLo, kHi, 3);
  set.persistence = 0.9;
  set.radius = 2.0;
  const std::vector<JointPlane> discs = planes_of(set, kLo, kHi, 3);
  ASSERT_EQ(discs.size(), whole.size());
  for (std::size_t k = 0; k < discs.size(); ++k)
    EXPECT_EQ((discs[k].point - whole[k].point).norm(), 0.0);
}

TEST(NaturalJointSet, OneSeedGivesOneSetOfPlanes) {
  const NaturalJointSet set = set_of(Vec3::UnitY(), 0.5, 0.1);
  const std::vector<JointPlane> a = planes_of(set, kLo, kHi, 1), b = planes_of(set, kLo, kHi, 1),
                                c = planes_of(set, kLo, kHi, 2);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ((a[k].point - b[k].point).norm(), 0.0);
  EXPECT_NE(a.front().point.y(), c.front().point.y());
}

}  // namespace
}  // namespace muckpile
