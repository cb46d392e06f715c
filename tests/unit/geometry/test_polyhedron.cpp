// SPDX-License-Identifier: GPL-2.0-or-later
// Mass and face properties against closed forms and against an independent surface integration.
// Scope: convex bodies; the tessellation's own tests cover whole packings.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/shape/centroid.h"
#include "geometry/shape/polyhedron.h"
#include "shapes.h"

namespace muckpile {
namespace {

// Rounding of a few hundred sums.
constexpr double kRounding = 1e-12;

// Volume integrals of 1, x, x^2 and xy by the divergence theorem with Gauss points on surface
// triangles: fields (x,0,0), (x^2/2,0,0), (x^3/3,0,0), (x^2 y/2,0,0). The degree-5 rule (Dunavant
// 1985, 7 points) is exact for these cubics, and shares no formula with mass_properties.
struct SurfaceIntegrals {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

SurfaceIntegrals integrate_by_surface(const Polyhedron& shape) {
  const double r = std::sqrt(15.0);
  const double a1 = (6.0 - r) / 21.0, w1 = (155.0 - r) / 1200.0;
  const double a2 = (6.0 + r) / 21.0, w2 = (155.0 + r) / 1200.0;
  const double rule[7][4] = {{1.0 / 3, 1.0 / 3, 1.0 / 3, 9.0 / 40},
                             {a1, a1, 1 - 2 * a1, w1},
                             {a1, 1 - 2 * a1, a1, w1},
                             {1 - 2 * a1, a1, a1, w1},
                             {a2, a2, 1 - 2 * a2, w2},
                             {a2, 1 - 2 * a2, a2, w2},
                             {1 - 2 * a2, a2, a2, w2}};
  SurfaceIntegrals sum;
  for (const std::vector<int>& face : shape.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const Vec3& a = shape.vertices[static_cast<std::size_t>(face[0])];
      const Vec3& b = shape.vertices[static_cast<std::size_t>(face[k])];
      const Vec3& c = shape.vertices[static_cast<std::size_t>(face[k + 1])];
      const Vec3 area = 0.5 * (b - a).cross(c - a);
      for (const auto& g : rule) {
        const Vec3 p = g[0] * a + g[1] * b + g[2] * c;
        sum.volume += g[3] * area.x() * p.x();
        for (int i = 0; i < 3; ++i) {
          sum.first[i] += g[3] * area[i] * p[i] * p[i] / 2.0;
          sum.second(i, i) += g[3] * area[i] * p[i] * p[i] * p[i] / 3.0;
          const int j = (i + 1) % 3;
          sum.second(i, j) += g[3] * area[i] * p[i] * p[i] * p[j] / 2.0;
          sum.second(j, i) = sum.second(i, j);
        }
      }
    }
  }
  return sum;
}

Mat3 inertia_about(const SurfaceIntegrals& s, const Vec3& centre) {
  const Mat3 moment = s.second - centre * s.first.transpose() - s.first * centre.transpose() +
                      s.volume * centre * centre.transpose();
  return moment.trace() * Mat3::Identity() - moment;
}

TEST(MassProperties, MatchesTheClosedFormOfABox) {
  const Polyhedron box = test::box(Vec3(1, 2, 3), Vec3(3, 5, 7));  // edges 2, 3, 4 m
  const MassProperties mass = mass_properties(box);
  EXPECT_NEAR(mass.volume, 24.0, 24.0 * kRounding);
  EXPECT_NEAR((mass.centroid - Vec3(2, 3.5, 5)).norm(), 0.0, kRounding);
  // V (b^2 + c^2) / 12: 24 * (9 + 16) / 12 = 50, 24 * (4 + 16) / 12 = 40, 24 * (4 + 9) / 12 = 26
  const Mat3 expected = Vec3(50, 40, 26).asDiagonal();
  EXPECT_LT((mass.inertia - expected).norm(), 50.0 * kRounding);
}

TEST(MassProperties, MatchesTheClosedFormOfACornerTetrahedron) {
  const MassProperties mass = mass_properties(test::corner_tetrahedron());
  EXPECT_NEAR(mass.volume, 1.0 / 6.0, kRounding);
  EXPECT_NEAR((mass.centroid - Vec3::Constant(0.25)).norm(), 0.0, kRounding);
  // About the origin int x^2 = 1/60, int xy = 1/120; about the centroid subtract V/16 = 1/96:
  // 1/60 - 1/96 = 1/160, 1/120 - 1/96 = -1/480. Inertia: 2/160 on the diagonal, +1/480 off it.
  Mat3 expected = Mat3::Constant(1.0 / 480.0);
  expected.diagonal().setConstant(1.0 / 80.0);
  EXPECT_LT((mass.inertia - expected).norm(), kRounding);
}

TEST(VolumeAndCentroid, AreThoseOfTheMassProperties) {
  for (unsigned long seed = 1; seed <= 20; ++seed) {
    const Polyhedron cell = test::voronoi_cell(seed);
    const MassProperties mass = mass_properties(cell);
    const VolumeAndCentroid first = volume_and_centroid(cell);
    EXPECT_EQ(first.volume, mass.volume);
    EXPECT_EQ(first.centroid, mass.centroid);
  }
}

TEST(MassProperties, AgreesWithSurfaceIntegrationOnVoronoiCells) {
  for (unsigned long seed = 1; seed <= 20; ++seed) {
    const Polyhedron cell = test::voronoi_cell(seed);
    const MassProperties mass = mass_properties(cell);
    const SurfaceIntegrals check = integrate_by_surface(cell);
    EXPECT_GT(mass.volume, 0.0);
    // The check cancels moments about the origin, up to 2 cell sizes away: 1e-10 leaves margin.
    EXPECT_NEAR(mass.volume, check.volume, 1e-10 * mass.volume);
    EXPECT_LT((mass.centroid - check.first / check.volume).norm(), 1e-10);
    EXPECT_LT((mass.inertia - inertia_about(check, mass.centroid)).norm(),
              1e-10 * mass.inertia.norm());
  }
}

TEST(MassProperties, FollowsRotationAndTranslation) {
  const Polyhedron cell = test::voronoi_cell(3);
  const MassProperties before = mass_properties(cell);
  const Mat3 rotation = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Vec3 shift(100, -200, 50);
  Polyhedron moved = cell;
  for (Vec3& v : moved.vertices) v = rotation * v + shift;
  const MassProperties after = mass_properties(moved);
  // Vertices 100 cell sizes away from the origin lose two digits.
  EXPECT_NEAR(after.volume, before.volume, 1e-11 * before.volume);
  EXPECT_LT((after.centroid - rotation * before.centroid - shift).norm(), 1e-11);
  EXPECT_LT((after.inertia - rotation * before.inertia * rotation.transpose()).norm(),
            1e-11 * before.inertia.norm());
}

TEST(MassProperties, InwardFacesGiveANegativeVolume) {
  Polyhedron box = test::box(Vec3::Zero(), Vec3::Ones());
  for (auto& face : box.faces) face = {face.rbegin(), face.rend()};
  EXPECT_NEAR(mass_properties(box).volume, -1.0, kRounding);
}

TEST(FaceGeometry, MatchesTheClosedFormOfARectangle) {
  const Polyhedron box = test::box(Vec3::Zero(), Vec3(2, 3, 4));
  for (int f = 0; f < 6; ++f) {
    const FaceGeometry face = face_geometry(box, f);
    Eigen::Index across = 0;
    face.normal.cwiseAbs().maxCoeff(&across);
    const double longer = across == 2 ? 3.0 : 4.0, shorter = across == 0 ? 3.0 : 2.0;
    const Eigen::Index along = across == 2 ? 1 : 2;
    EXPECT_NEAR(face.area, longer * shorter, 12.0 * kRounding);
    EXPECT_NEAR(face.radius1, longer / std::sqrt(12.0), kRounding);
    EXPECT_NEAR(face.radius2, shorter / std::sqrt(12.0), kRounding);
    EXPECT_NEAR(std::abs(face.axis[along]), 1.0, kRounding);
    EXPECT_GT(face.normal.dot(face.centroid - Vec3(1, 1.5, 2)), 0.9);
  }
}

TEST(FaceGeometry, MatchesTheClosedFormOfATriangle) {
  const Polyhedron shape = test::corner_tetrahedron();
  const FaceGeometry face = face_geometry(shape, 3);  // equilateral, edge sqrt(2)
  EXPECT_NEAR(face.area, std::sqrt(3.0) / 2.0, kRounding);
  EXPECT_NEAR((face.centroid - Vec3::Constant(1.0 / 3.0)).norm(), 0.0, kRounding);
  EXPECT_NEAR((face.normal - Vec3::Constant(1.0 / std::sqrt(3.0))).norm(), 0.0, kRounding);
  // Radius of gyration of an equilateral triangle about any in-plane axis: a / sqrt(24).
  EXPECT_NEAR(face.radius1, std::sqrt(2.0 / 24.0), 1e-8);  // square root of a rounding-size gap
  EXPECT_NEAR(face.radius2, std::sqrt(2.0 / 24.0), 1e-8);
}

TEST(FaceGeometry, AxisAndNormalAreOrthogonalUnitVectorsOnVoronoiCells) {
  const Polyhedron cell = test::voronoi_cell(7);
  for (int f = 0; f < static_cast<int>(cell.faces.size()); ++f) {
    const FaceGeometry face = face_geometry(cell, f);
    EXPECT_NEAR(face.axis.norm(), 1.0, kRounding);
    EXPECT_NEAR(face.axis.dot(face.normal), 0.0, kRounding);
    EXPECT_GE(face.radius1, face.radius2);
  }
}

TEST(FaceGeometry, AFaceWithoutAreaStillHasUnitVectors) {
  Polyhedron shape = test::corner_tetrahedron();
  shape.faces.push_back({0, 1, 0});
  const FaceGeometry face = face_geometry(shape, 4);
  EXPECT_EQ(face.area, 0.0);
  EXPECT_NEAR(face.normal.norm(), 1.0, kRounding);
  EXPECT_NEAR(face.axis.norm(), 1.0, kRounding);
}

TEST(AreaVectorSum, VanishesOnlyForAClosedShape) {
  Polyhedron cell = test::voronoi_cell(5);
  EXPECT_LT(area_vector_sum(cell).norm(), 1e-12);
  cell.faces.pop_back();
  EXPECT_GT(area_vector_sum(cell).norm(), 1e-6);
}

}  // namespace
}  // namespace muckpile
