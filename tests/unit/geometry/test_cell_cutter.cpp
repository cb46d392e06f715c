// SPDX-License-Identifier: GPL-2.0-or-later
// The cells of a sweep are those of voro++; a search beside the last one finds what all points
// hold. Scope: a box of 1 m, some hundred points, random or on a lattice whose cells meet eight at
// a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/cut/cell_cutter.h"
#include "geometry/index/point_index.h"
#include "geometry/shape/polyhedron.h"
#include "math/random.h"

namespace muckpile {
namespace {

std::vector<Vec3> graded_points(int count) {
  Random random(5);
  std::vector<Vec3> points;
  for (int k = 0; k < count; ++k) {  // 64 times denser in one corner
    const Vec3 p(random.uniform(), random.uniform(), random.uniform());
    points.push_back(k % 2 == 0 ? p : Vec3(0.25 * p));
  }
  return points;
}

std::vector<Vec3> lattice(int edge) {
  std::vector<Vec3> points;
  for (int k = 0; k < edge * edge * edge; ++k)
    points.push_back((Vec3(k % edge, k / edge % edge, k / edge / edge).array() + 0.5) / edge);
  return points;
}

void expect_same_cells(const std::vector<Vec3>& points, const std::vector<CutPlane>& bounds) {
  CellCutter fast(points, Vec3::Zero(), Vec3::Ones(), bounds);
  CellCutter voro(points, Vec3::Zero(), Vec3::Ones(), bounds);
  constexpr double kRounding = 1e-10, kLeastArea = 1e-9;  // [m], [m2]
  Polyhedron shape, same;
  std::vector<int> behind, same_behind;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    ASSERT_EQ(fast.cut_fast(i, 0.1), voro.cut(i, 0.1)) << i;
    const LaneCell::Measure cell = fast.measure(), other = voro.measure();
    EXPECT_NEAR(cell.volume, other.volume, kRounding * other.volume) << i;
    EXPECT_LT((cell.centroid - other.centroid).norm(), kRounding) << i;
    fast.extract(shape, behind);
    voro.extract(same, same_behind);
    const MassProperties mass = mass_properties(shape);
    EXPECT_NEAR(mass.volume, cell.volume, kRounding * cell.volume) << i;
    EXPECT_LT((mass.centroid - cell.centroid).norm(), kRounding) << i;
    for (std::size_t f = 0; f < same_behind.size(); ++f) {
      const double area = face_geometry(same, static_cast<int>(f)).area;
      if (area < kLeastArea || same_behind[f] < 0) continue;  // each bound has the same number
      const auto at = std::ranges::find(behind, same_behind[f]);
      ASSERT_NE(at, behind.end()) << i;
      const int face = static_cast<int>(at - behind.begin());
      EXPECT_NEAR(face_geometry(shape, face).area, area, kRounding) << i;
    }
    const auto is_last = [&](int p) { return p == behind.back(); };
    EXPECT_TRUE(fast.any_face(is_last));
    EXPECT_FALSE(fast.any_face([&](int p) { return p == i; }));
  }
}

TEST(CellCutter, FastCellsAreThoseOfVoro) { expect_same_cells(graded_points(400), {}); }

TEST(CellCutter, FastCellsEndAtBounds) {
  std::vector<Vec3> points = graded_points(400);
  const Vec3 normal = Vec3(1.0, 2.0, -1.0).normalized();
  const Vec3 middle = Vec3::Constant(0.5);
  std::erase_if(points, [&](const Vec3& p) { return normal.dot(p - middle) > -1e-3; });
  expect_same_cells(points, {{middle, normal}, {0.9 * Vec3::Ones(), Vec3::UnitZ()}});
}

TEST(CellCutter, FastCellsMayMeetEightAtATime) { expect_same_cells(lattice(6), {}); }

// A cell with more faces than LaneCell has room for is given up, and voro++ cuts it.
TEST(CellCutter, FastCellsMayHaveAHundredFaces) {
  Random random(3);
  std::vector<Vec3> points = {Vec3::Constant(0.5)};
  while (points.size() <= 100) {
    const Vec3 p(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    if (p.norm() > 0.1) points.push_back(points[0] + 0.4 * p.normalized());
  }
  expect_same_cells(points, {});
  CellCutter cutter(points, Vec3::Zero(), Vec3::Ones());
  ASSERT_TRUE(cutter.cut_fast(0, 0.1));
  Polyhedron shape;
  std::vector<int> behind;
  cutter.extract(shape, behind);
  EXPECT_GT(behind.size(), 64u);
}

TEST(CellCutter, NothingIsLeftOfAPointOnAnother) {
  const std::vector<Vec3> points = {{0.2, 0.5, 0.5}, {0.2, 0.5, 0.5}, {0.8, 0.5, 0.5}};
  CellCutter cutter(points, Vec3::Zero(), Vec3::Ones());
  for (int k = 0; k < 2; ++k) EXPECT_EQ(cutter.cut_fast(k, 0.1), cutter.cut(k, 0.1));
  EXPECT_FALSE(cutter.cut_fast(1, 0.1));
}

TEST(CellCutter, NothingIsLeftOfAPointBehindABound) {
  const std::vector<Vec3> points = {{0.2, 0.5, 0.5}, {0.8, 0.5, 0.5}};
  CellCutter cutter(points, Vec3::Zero(), Vec3::Ones(), {{{0.5, 0.5, 0.5}, Vec3::UnitX()}});
  EXPECT_TRUE(cutter.cut_fast(0, 0.1));
  EXPECT_NEAR(cutter.measure().volume, 0.5, 1e-12);
  EXPECT_FALSE(cutter.cut_fast(1, 0.1));
}

TEST(PointSearch, FindsWhatALookAtEveryPointFinds) {
  const std::vector<Vec3> points = graded_points(2000);
  const PointIndex index(points);
  PointSearch search(index);
  Random random(7);
  Vec3 centre = points.front();
  for (int k = 0; k < 500; ++k) {  // now and then far from the last
    centre = k % 10 == 0 ? points[static_cast<std::size_t>(k)] : Vec3(centre.array() + 0.002);
    const double inner = 0.1 * random.uniform() * random.uniform();
    const double outer = inner + 0.2 * random.uniform();
    std::vector<std::pair<double, int>> all;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double distance = (points[p] - centre).norm();
      if (distance >= inner && distance < outer)
        all.emplace_back(distance * distance, static_cast<int>(p));
    }
    std::sort(all.begin(), all.end());
    const PointSearch::Found& found = search.shell(centre, inner, outer);
    ASSERT_EQ(found.size(), all.size()) << k;
    for (std::size_t n = 0; n < all.size(); ++n) ASSERT_EQ(found[n].second, all[n].second) << k;
  }
}

}  // namespace
}  // namespace muckpile
