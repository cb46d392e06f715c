// SPDX-License-Identifier: GPL-2.0-or-later
// Cracks that hang together with a hole, made by hand of faces between cubes.
// Scope: a slab of cubes of 0.5 m, 1 m thick, with a shaft of one cube for each hole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "measure/cracks.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kTiny = 1e-9;

Charge upright(double x, double y) { return {{x, y, 0.0}, {x, y, 1.0}, 0.25}; }

/// Cubes within 5 m of the origin, but for shafts in the middle of which the charges stand.
std::vector<StartBlock> slab(const std::vector<Charge>& charges) {
  std::vector<Block> cubes = cubes_in({-5.25, -5.25, 0.0}, {5.25, 5.25, 1.0});
  std::erase_if(cubes, [&](const Block& cube) {
    return std::ranges::any_of(charges, [&](const Charge& charge) {
      return (cube.mass.centroid - charge.toe).head<2>().norm() < kTiny;
    });
  });
  return as_start_blocks(cubes);
}

class Cracks : public ::testing::Test {
 protected:
  /// Breaks the joints whose centroids are chosen.
  void make(const std::vector<Charge>& charges,
            const std::function<bool(const RockFace&)>& breaks) {
    charges_ = charges;
    faces_ = faces_of_rock(slab(charges));
    std::vector<char> broken;
    for (const RockFace& face : faces_) broken.push_back(face.other && breaks(face) ? 1 : 0);
    holes_ = crack_holes(faces_, broken, charges);
  }
  [[nodiscard]] long connected(size_t hole) const {
    return std::ranges::count(holes_, std::optional(hole));
  }
  [[nodiscard]] std::vector<Reaches> reaches() const {
    std::vector<Reaches> all;
    for (size_t h = 0; h < charges_.size(); ++h)
      all.push_back(crack_reaches(faces_, holes_, charges_[h], h));
    return all;
  }
  std::vector<Charge> charges_;
  std::vector<RockFace> faces_;
  std::vector<std::optional<size_t>> holes_;
};

/// In the plane y = `at`, from x = `low` to `high`.
bool in_y_plane(const RockFace& face, double at, double low, double high) {
  const Vec3& c = face.centroid;
  return std::abs(face.normal.y()) > 0.9 && std::abs(c.y() - at) < kTiny && c.x() > low &&
         c.x() < high;
}

TEST(FacesOfRock, AreThoseBetweenTheCubesOnce) {
  const auto faces = faces_of_rock(as_start_blocks(cubes_in({0, 0, 0}, {1.0, 1.5, 0.5})));
  // 2 x 3 cubes: 3 + 4 joints, 36 sides less two for each.
  EXPECT_EQ(std::ranges::count_if(faces, [](const RockFace& f) { return f.other.has_value(); }), 7);
  EXPECT_EQ(faces.size(), 7U + 36U - 14U);
}

// As the network has it: the first block of two makes their joint, if the face is not too small for
// it.
TEST(FacesOfRock, AreLeftOutWhereTheyAreTooSmallForTheFirstBlock) {
  const std::vector<StartBlock> two = as_start_blocks(cubes_in({0, 0, 0}, {1.0, 0.5, 0.5}));
  ASSERT_EQ(two.size(), 2U);
  constexpr double kHuge = 1e9;  // [m3], for which a face of a cube is too small
  for (const size_t huge : {0U, 1U}) {
    std::vector<StartBlock> blocks = two;
    blocks[huge].volume = kHuge;
    const auto faces = faces_of_rock(blocks);
    EXPECT_EQ(std::ranges::count_if(faces, [](const RockFace& f) { return f.other.has_value(); }),
              huge == 1 ? 1 : 0);
    EXPECT_EQ(faces.size(), huge == 1 ? 6U : 5U);  // the huge one has no free faces either
  }
}

// A radial crack from the corner of the shaft: the plane y = 0.25 m, x from 0.25 to 3.25 m.
TEST_F(Cracks, OfAPlaneOfFacesReachAsFarAsThePlane) {
  make({upright(0, 0)}, [](const RockFace& face) { return in_y_plane(face, 0.25, 0.25, 3.25); });
  EXPECT_EQ(connected(0), 6 * 2);  // faces along x, layers
  const std::vector<Reaches> reach = reaches();
  EXPECT_NEAR(reach[0][0], std::hypot(3.25, 0.25), 1e-9);  // 0 to 10 degrees
  EXPECT_NEAR(reach_exceeded(reach, 0.0), std::hypot(3.25, 0.25), 1e-9);
  EXPECT_NEAR(reach_exceeded(reach, 0.5), 0.25, 1e-9);  // none elsewhere: the wall
  // 0.25 m over x fills directions to 45 degrees, where it begins; beyond 1 m those to 14 degrees.
  EXPECT_NEAR(directions_beyond(reach, 1.0), 2.0 / 36.0, 1e-12);
}

// Half of the sections are below z = 0.5 m.
TEST_F(Cracks, ReachOnlyInTheSectionsThatTheyCross) {
  make({upright(0, 0)}, [](const RockFace& face) {
    return in_y_plane(face, 0.25, 0.25, 3.25) && face.centroid.z() < 0.5;
  });
  EXPECT_NEAR(directions_beyond(reaches(), 1.0), 0.5 * 2.0 / 36.0, 1e-12);
}

// The angle from x around an axis that leans by 45 degrees in the plane x, z: y is at 90 degrees.
TEST(CrackReaches, AreAcrossALeaningCharge) {
  RockFace face{0, 0, 1, {}, Vec3::Zero(), Vec3::UnitZ(), 8.0};
  face.corners = {{-1.0, 2.0, -1.0}, {3.0, 2.0, 3.0}, {3.0, 2.1, 3.0}, {-1.0, 2.1, -1.0}};
  const Charge charge{{0, 0, 0}, {2.0, 0, 2.0}, 0.1};
  const Reaches reach = crack_reaches({face}, {size_t{0}}, charge, 0);
  EXPECT_NEAR(reach[9], 2.1, 1e-9);  // from 90 to 100 degrees
  EXPECT_TRUE(std::isnan(reach[0]));
}

TEST_F(Cracks, LeaveOutAClusterThatIsApart) {
  make({upright(0, 0)}, [](const RockFace& face) {
    return in_y_plane(face, 0.25, 0.25, 1.25) || in_y_plane(face, 0.25, 1.75, 4.75);
  });
  EXPECT_EQ(connected(0), 2 * 2);
  EXPECT_NEAR(reach_exceeded(reaches(), 0.0), std::hypot(1.25, 0.25), 1e-9);
}

// From (1.25, 0.25) the crack would go on at y = 0.75 m from x = 1.75 m: nothing between. In the
// upper layer from x = 1.25 m on, at z = 0.5 m, they would meet in a corner.
TEST_F(Cracks, DoNotGoOnThroughACorner) {
  make({upright(0, 0)}, [](const RockFace& face) {
    const Vec3& c = face.centroid;
    const bool lower = in_y_plane(face, 0.25, 0.25, 1.25) && c.z() < 0.5;
    return lower || (in_y_plane(face, 0.25, 1.25, 3.25) && c.z() > 0.5);
  });
  EXPECT_EQ(connected(0), 2);
}

// The same, with the face between that makes the corner an edge.
TEST_F(Cracks, GoOnAroundABend) {
  make({upright(0, 0)}, [](const RockFace& face) {
    const Vec3& c = face.centroid;
    const bool lower = in_y_plane(face, 0.25, 0.25, 1.25) && c.z() < 0.5;
    const bool level = std::abs(face.normal.z()) > 0.9 && (c - Vec3(1.0, 0.5, 0.5)).norm() < kTiny;
    const bool upright =
        std::abs(face.normal.x()) > 0.9 && (c - Vec3(1.25, 0.5, 0.75)).norm() < kTiny;
    return lower || level || upright;
  });
  EXPECT_EQ(connected(0), 2 + 1 + 1);
}

TEST_F(Cracks, BeginAtAnEdgeOfTheWall) {
  make({upright(0, 0)}, [](const RockFace& face) { return in_y_plane(face, 0.75, -2.0, 2.0); });
  EXPECT_EQ(connected(0), 0);  // the wall is at 0.25 m
  EXPECT_NEAR(reach_exceeded(reaches(), 0.0), 0.25, 1e-9);
}

// Holes at x = -2.5 and 2.5 m: the crack of the first is short, that of the second long.
TEST_F(Cracks, OfSeveralHolesReachFromEach) {
  make({upright(-2.5, 0), upright(2.5, 0)}, [](const RockFace& face) {
    return in_y_plane(face, 0.25, -2.25, -1.25) || in_y_plane(face, -0.25, 2.75, 4.75);
  });
  EXPECT_EQ(connected(0), 2 * 2);
  EXPECT_EQ(connected(1), 4 * 2);
  const std::vector<Reaches> reach = reaches();
  EXPECT_NEAR(reach_exceeded({reach[0]}, 0.0), std::hypot(1.25, 0.25), 1e-9);
  EXPECT_NEAR(reach_exceeded({reach[1]}, 0.0), std::hypot(2.25, 0.25), 1e-9);
}

// One crack from hole to hole: each has its half, and neither reaches beyond the middle.
TEST_F(Cracks, BetweenTwoHolesAreOfTheNearerOne) {
  make({upright(-2.5, 0), upright(2.5, 0)},
       [](const RockFace& face) { return in_y_plane(face, 0.25, -2.25, 2.25); });
  EXPECT_EQ(connected(0) + connected(1), 9 * 2);
  EXPECT_LE(std::abs(connected(0) - connected(1)), 2);  // those of the middle are one's
  const std::vector<Reaches> reach = reaches();
  EXPECT_LE(reach_exceeded(reach, 0.0), std::hypot(2.75, 0.25) + 1e-9);
}

TEST(ReachExceeded, IsLinearBetweenDirectionsInOrder) {
  Reaches reach;
  reach.fill(std::nan(""));  // beyond a symmetry plane
  for (size_t d = 0; d < 11; ++d) reach[d * 7] = static_cast<double>(d);
  EXPECT_DOUBLE_EQ(reach_exceeded({reach}, 0.0), 10.0);
  EXPECT_DOUBLE_EQ(reach_exceeded({reach}, 0.5), 5.0);
  EXPECT_DOUBLE_EQ(reach_exceeded({reach}, 0.25), 7.5);
  EXPECT_DOUBLE_EQ(directions_beyond({reach}, 7.5), 3.0 / 11.0);
}

TEST(ReachExceeded, ShareOfDirectionsIsUnknownWhereTheDistanceIs) {
  EXPECT_TRUE(std::isnan(directions_beyond({}, 1.0)));
  EXPECT_TRUE(std::isnan(directions_beyond({Reaches{}}, std::nan(""))));
}

}  // namespace
}  // namespace muckpile
