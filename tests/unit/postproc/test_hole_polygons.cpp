// SPDX-License-Identifier: GPL-2.0-or-later
// Rock shared out among holes in plan: each place has one owner, by blocks as by polygons.
// Scope: measure/hole_frames, measure/hole_polygons, measure/hole_rock, measure/outlines.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "measure/hole_polygons.h"
#include "measure/outlines.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kBurden = 2.0, kSpacing = 3.0;
const PlanCut kCut{1.0, {-12.0, -9.0}, {0.0, 9.0}};

// Behind the face x = 0, throwing by an angle off x [deg].
HoleFrame hole(const std::string& name, const Vec2& foot, double turn = 0.0, int row = 0) {
  const double angle = turn * std::numbers::pi / 180.0;
  const Vec2 direction(std::cos(angle), std::sin(angle));
  const double face = direction.dot(foot) - foot.x() / direction.x();  // through x = 0 on its way
  return {name, foot, {0.0, 0.0}, direction, {{0.0, face}, {3.0, face}}, row};
}

class SharedOut {
 public:
  explicit SharedOut(std::vector<HoleFrame> holes)
      : frames_(std::make_shared<const HoleFrames>(std::move(holes), HolePlan{kBurden, kSpacing})) {
    BenchPlanes planes;
    planes.frames = frames_;
    polygons_ = hole_polygons({}, planes, kCut);
  }
  [[nodiscard]] double area(const std::string& name) const {
    double sum = 0.0;
    for (const HolePolygon& polygon : polygons_)
      if (polygon.hole == name) sum += area_of(polygon.corners);
    return sum;
  }
  [[nodiscard]] double whole() const {
    double sum = 0.0;
    for (const HolePolygon& polygon : polygons_) sum += area_of(polygon.corners);
    return sum;
  }
  [[nodiscard]] const HoleFrames& frames() const { return *frames_; }
  // Places on a grid that no side passes: all polygons around one are its owner's, and one is
  // where the owner has rock in front of its face.
  void expect_one_owner_each() const {
    for (double x = -11.987; x < 0.0; x += 0.11) {
      for (double y = -8.983; y < 9.0; y += 0.13) {
        const std::optional<size_t> owner = frames_->hole_of({x, y, kCut.height});
        int around = 0;
        for (const HolePolygon& polygon : polygons_) {
          if (!contains(polygon.corners, {x, y})) continue;
          ++around;
          ASSERT_TRUE(owner) << x << ' ' << y << " in " << polygon.hole;
          EXPECT_EQ(frames_->holes()[*owner].name, polygon.hole) << x << ' ' << y;
        }
        EXPECT_LE(around, 1) << x << ' ' << y;
        if (owner && in_front_of_face(*owner, {x, y})) {
          EXPECT_EQ(around, 1) << x << ' ' << y;
        }
      }
    }
  }

 private:
  [[nodiscard]] bool in_front_of_face(size_t hole, const Vec2& p) const {
    const Vec2& own = frames_->holes()[hole].foot;
    for (const HoleFrame& other : frames_->holes()) {
      const double face = other.face.front().y();
      const bool theirs = (other.foot - own).norm() < kNeighbours * kSpacing;
      if (theirs && other.direction.dot(p) > face) return false;
    }
    return true;
  }
  static bool contains(const Polygon& ring, const Vec2& p) {
    bool inside = false;
    for (size_t k = 0; k < ring.size(); ++k) {
      const Vec2 &a = ring[k], &b = ring[(k + 1) % ring.size()];
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
  }
  std::shared_ptr<const HoleFrames> frames_;
  std::vector<HolePolygon> polygons_;
};

TEST(HolePolygons, OfASingleRowAreBurdenTimesSpacing) {
  const SharedOut row({hole("a", {-2, -3}), hole("b", {-2, 0}), hole("c", {-2, 3})});
  for (const char* name : {"a", "b", "c"})
    EXPECT_NEAR(row.area(name), kBurden * kSpacing, 1e-9) << name;
  row.expect_one_owner_each();
}

// The hole that stands out beyond the end of the row in front has the rock beside that, too.
TEST(HolePolygons, OfStaggeredRowsHaveTheRockBesideTheEndOfTheRowInFront) {
  const SharedOut rows({hole("a", {-2, -1.5}), hole("b", {-2, 1.5}), hole("c", {-4, 0}, 0, 1),
                        hole("d", {-4, 3}, 0, 1)});
  EXPECT_NEAR(rows.area("a"), 6.0, 1e-9);
  EXPECT_NEAR(rows.area("b"), 6.0, 1e-9);
  EXPECT_NEAR(rows.area("c"), 6.0, 1e-9);
  EXPECT_NEAR(rows.area("d"), 6.0 + 2.0 * 1.5, 1e-9);
  rows.expect_one_owner_each();
}

// A fifth more than the spacing between two holes: what is between their strips is theirs.
TEST(HolePolygons, LeaveNothingOutBetweenNeighboursFartherApart) {
  const SharedOut row({hole("a", {-2, -1.8}), hole("b", {-2, 1.8})});
  EXPECT_NEAR(row.area("a"), 2.0 * (1.8 + 1.5), 1e-9);
  EXPECT_NEAR(row.area("b"), row.area("a"), 1e-9);
  row.expect_one_owner_each();
}

// Its strip crosses those of the front row and goes out beside them.
TEST(HolePolygons, OfASecondRowHoleThatIsTurnedGoAroundTheRockInFront) {
  for (const double turn : {-40.0, 25.0, 60.0}) {
    const SharedOut rows({hole("a", {-2, -1.5}), hole("b", {-2, 1.5}), hole("c", {-4, 0}, 0, 1),
                          hole("d", {-4, 3}, turn, 1)});
    rows.expect_one_owner_each();
    EXPECT_NEAR(rows.area("a"), 6.0, 1e-9) << turn;
    EXPECT_GT(rows.area("d"), 3.0) << turn;
  }
}

// Throws to the middle line, half to either side: by symmetry both halves have as much, and the
// strips, which cross in the middle, are shared out there.
TEST(HolePolygons, OfAVCutMeetInTheMiddle) {
  std::vector<HoleFrame> holes;
  for (const int side : {-1, 1}) {
    for (int k = 0; k < 3; ++k) {
      const std::string name{side < 0 ? 'l' : 'r', static_cast<char>('0' + k)};
      holes.push_back(hole(name, {-2.0 - k, side * (1.5 + k * 1.5)}, -side * 45.0));
    }
  }
  const SharedOut cut(holes);
  for (const char k : {'0', '1', '2'}) EXPECT_NEAR(cut.area({'l', k}), cut.area({'r', k}), 1e-9);
  cut.expect_one_owner_each();
}

// Two sides of a corner: what lies between the strips, at the corner itself, is the nearest hole's.
TEST(HolePolygons, OfACornerHaveItsRock) {
  HoleFrame along_y{"c", {-5, 4}, {0, 0}, {0, 1}, {{0.0, 6.0}, {3.0, 6.0}}, 0};
  const SharedOut corner({hole("a", {-2, 1}), hole("b", {-2, 4}), along_y});
  EXPECT_NEAR(corner.area("a"), 6.0, 1e-9);
  EXPECT_NEAR(corner.area("c"), 6.0, 1e-9);
  EXPECT_NEAR(corner.area("b"), 6.0 + 3.5 * 2.0 - 2.0 * 1.5, 1e-9);
  const Vec3 between(-2.5, 5.0, 1.0);
  EXPECT_EQ(corner.frames().hole_of(between), 1U);
  EXPECT_TRUE(corner.frames().abreast(between));
  EXPECT_LT(corner.frames().row_depth(between), kBurden);
  corner.expect_one_owner_each();
}

HoleTable uprights(const std::vector<Vec2>& feet) {
  std::string text = "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m\n";
  for (size_t k = 0; k < feet.size(); ++k) {
    const std::string place = std::to_string(feet[k].x()) + ',' + std::to_string(feet[k].y());
    text += std::string(1, static_cast<char>('a' + k)) + ',' + place + ",3," + place + ",0,0.1\n";
  }
  return HoleTable(CsvTable::parse(text, "t.csv"));
}

// Of rows that throw along x, from y = -3 - half a spacing to 4.5 + half a spacing.
void expect_rows(const std::vector<Vec2>& feet, const std::vector<double>& areas) {
  const auto holes = pattern_holes(uprights(feet), std::vector<double>(feet.size()), kBurden);
  BenchPlanes planes;
  planes.spacing = kSpacing;
  planes.y_low = -4.5;
  planes.y_high = 6.0;
  const auto polygons = hole_polygons(holes, planes, kCut);
  ASSERT_EQ(polygons.size(), areas.size());
  for (size_t k = 0; k < areas.size(); ++k)
    EXPECT_NEAR(area_of(polygons[k].corners), areas[k], 1e-9) << holes[k].name;
  const auto blocks = as_start_blocks(cubes_in({-6.0, -6.0, 0.0}, {0.0, 7.0, 0.5}));
  const std::vector<int> owner = hole_of_blocks(blocks, holes, planes);
  std::vector<double> of_blocks(holes.size(), 0.0);
  for (size_t b = 0; b < blocks.size(); ++b)
    if (owner[b] >= 0) of_blocks[static_cast<size_t>(owner[b])] += kCube * kCube;
  for (size_t k = 0; k < areas.size(); ++k)
    EXPECT_NEAR(of_blocks[k], areas[k], 1e-9) << holes[k].name;
}

// d stands out by half a spacing and has the rock before it, which no hole of the front row
// reaches; a, of the front row, stands out at the other end, and what is behind it is c's.
TEST(HolePolygons, OfStaggeredRowsThatThrowAlongX) {
  expect_rows({{-2, -3}, {-2, 0}, {-2, 3}, {-4, -1.5}, {-4, 1.5}, {-4, 4.5}},
              {6.0, 6.0, 6.0, 6.0 + 3.0, 6.0, 6.0 + 3.0});
}

// Where the front row lacks a hole the ones behind have its rock, and beyond their reach, half a
// spacing from all, the row behind has it, too.
TEST(HolePolygons, OfARowWithAHoleMissing) {
  expect_rows({{-2, -3}, {-2, 3}, {-4, -3}, {-4, 0}, {-4, 3}},
              {6.0, 6.0 + 3.0, 6.0, 12.0, 6.0 + 3.0});
}

TEST(Outlines, OfPiecesThatTouchAreOneRing) {
  const auto rings =
      outlines_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 0.25}, {2, 0.25}, {2, 2}, {1, 2}}});
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_EQ(rings[0].size(), 8U);
  EXPECT_NEAR(area_of(rings[0]), 1.0 + 1.75, 1e-12);
}

TEST(Outlines, OfPiecesThatMeetAtACornerOrAroundAPlaceAreSeveral) {
  EXPECT_EQ(
      outlines_of({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}}).size(), 2U);
  const auto frame = outlines_of({{{0, 0}, {3, 0}, {3, 1}, {0, 1}},
                                  {{0, 2}, {3, 2}, {3, 3}, {0, 3}},
                                  {{0, 1}, {1, 1}, {1, 2}, {0, 2}},
                                  {{2, 1}, {3, 1}, {3, 2}, {2, 2}}});
  ASSERT_EQ(frame.size(), 2U);
  EXPECT_NEAR(area_of(frame[0]) + area_of(frame[1]), 8.0, 1e-12);
}

}  // namespace
}  // namespace muckpile
