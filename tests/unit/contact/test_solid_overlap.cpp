// SPDX-License-Identifier: GPL-2.0-or-later
// Overlap of polyhedra against closed forms and numerical slopes of its energy.
// Scope: random convex bodies and boxes, 1 m in size.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "../geometry/shapes.h"
#include "args/input_error.h"
#include "contact/polyhedra/lane_outline.h"
#include "contact/polyhedra/solid_overlap.h"
#include "geometry/shape/shared_volume.h"
#include "tumbling_solids.h"

namespace muckpile {
namespace {

Solid about_centroid(const Polyhedron& shape) {
  return {shape, {mass_properties(shape).centroid, Mat3::Identity()}};
}

Solid cube(double edge) { return about_centroid(test::box(Vec3::Zero(), Vec3::Constant(edge))); }

/// Two bodies, the second turned and set off against the first.
struct Pair {
  Solid first, second;
  Mat3 turn;
  Vec3 between;

  SolidOverlap overlap(const Vec3& shift = Vec3::Zero(), const Vec3& spin = Vec3::Zero()) {
    const double angle = spin.norm();
    const Mat3 more = angle > 0.0 ? Eigen::AngleAxisd(angle, spin / angle).toRotationMatrix()
                                  : Mat3(Mat3::Identity());
    finder.place(first, second, more * turn, between + shift, 1.0);
    Vec3 n = between.normalized();
    (void)finder.work(n);
    return finder.overlap();
  }
  OverlapFinder finder;
};

Pair random_pair(unsigned seed) {
  std::mt19937 random(seed);
  const Solid a = about_centroid(test::random_solid(random, Vec3(1.0, 1.2, 0.8), 6));
  const Solid b = about_centroid(test::random_solid(random, Vec3(0.9, 1.1, 1.0), 6));
  const Mat3 turn = test::random_turn(random);
  std::normal_distribution<double> normal;
  const Vec3 direction = Vec3(normal(random), normal(random), normal(random)).normalized();
  Pair pair{a, b, turn, 2.0 * direction, {}};
  // Nearer, until the overlap is about 5 % of the size.
  while (pair.overlap().largest_strain < 0.1) pair.between -= 0.01 * direction;
  return pair;
}

class RandomPairs : public testing::TestWithParam<unsigned> {};

TEST_P(RandomPairs, PushIsTheSlopeOfTheEnergy) {
  Pair pair = random_pair(GetParam());
  const SolidOverlap at = pair.overlap();
  constexpr double kStep = 1e-5;
  double worst = 0.0;
  for (int d = 0; d < 3; ++d) {
    const Vec3 e = kStep * Vec3::Unit(d);
    // The second moves by e: the force on it is the opposite of that on the
    // first.
    const double slope = (pair.overlap(e).energy - pair.overlap(-e).energy) / (2.0 * kStep);
    worst = std::max(worst, std::abs(slope - at.push[d]) / at.push.norm());
  }
  std::printf("push against slope of the energy: %.1e of it\n", worst);
  EXPECT_LT(worst, 1e-6);
}

TEST_P(RandomPairs, MomentIsTheSlopeOfTheEnergyAgainstATurn) {
  Pair pair = random_pair(GetParam());
  const SolidOverlap at = pair.overlap();
  constexpr double kStep = 1e-5;
  const Vec3 on_second = -(at.moment - pair.between.cross(at.push));  // about its centre
  double worst = 0.0;
  for (int d = 0; d < 3; ++d) {
    const Vec3 e = kStep * Vec3::Unit(d);
    const double slope =
        (pair.overlap(Vec3::Zero(), e).energy - pair.overlap(Vec3::Zero(), -e).energy) /
        (2.0 * kStep);
    worst = std::max(worst, std::abs(slope + on_second[d]) / at.push.norm());
  }
  std::printf("moment against slope of the energy: %.1e of push times 1 m\n", worst);
  EXPECT_LT(worst, 1e-6);
}

TEST_P(RandomPairs, SharedVolumeIsThatOfTheCutCell) {
  Pair pair = random_pair(GetParam());
  const SolidOverlap at = pair.overlap();
  Polyhedron a, b;
  const auto shape_of = [](const Solid& solid, const Mat3& turn, const Vec3& centre) {
    Polyhedron shape;
    for (const Vec3& corner : solid.corners()) shape.vertices.emplace_back(turn * corner + centre);
    for (const Solid::Face& face : solid.faces()) {
      const auto begin = solid.loop().begin() + face.begin;
      shape.faces.emplace_back(begin, begin + face.count);
    }
    return shape;
  };
  a = shape_of(pair.first, Mat3::Identity(), Vec3::Zero());
  b = shape_of(pair.second, pair.turn, pair.between);
  const double volume = shared_volume(a, 1.0, face_geometries(b));
  EXPECT_NEAR(at.volume, volume, 1e-10);
}

TEST_P(RandomPairs, StiffnessBoundsTheSlopeOfThePush) {
  Pair pair = random_pair(GetParam());
  const SolidOverlap at = pair.overlap();
  constexpr double kStep = 1e-5;
  for (int d = 0; d < 3; ++d) {
    const Vec3 e = kStep * Vec3::Unit(d);
    const double slope = (pair.overlap(e).push - pair.overlap(-e).push).norm() / (2.0 * kStep);
    EXPECT_LT(slope, at.stiffness * (1.0 + 1e-6));
  }
}

TEST_P(RandomPairs, ExchangedBodiesFeelTheOpposite) {
  Pair pair = random_pair(GetParam());
  const SolidOverlap at = pair.overlap();
  Pair other{
      pair.second, pair.first, pair.turn.transpose(), -(pair.turn.transpose() * pair.between), {}};
  const SolidOverlap exchanged = other.overlap();
  EXPECT_NEAR(exchanged.energy, at.energy, 1e-13);
  EXPECT_LT((pair.turn * exchanged.push + at.push).norm(), 1e-12);
}

TEST_P(RandomPairs, GapIsNeverAboveTheDistance) {
  Pair pair = random_pair(GetParam());
  const Vec3 out = pair.between.normalized();
  for (double away = 0.0; away < 1.0; away += 0.02) {
    pair.finder.place(pair.first, pair.second, pair.turn, pair.between + away * out, 1.0);
    Vec3 n = out;
    const double gap = pair.finder.work(n);
    if (gap <= 0.0) continue;
    EXPECT_NEAR(n.norm(), 1.0, 1e-12);
    EXPECT_FALSE(pair.finder.touching());
    // Moved by the gap towards each other they still share nothing.
    pair.finder.place(pair.first, pair.second, pair.turn,
                      pair.between + away * out - 0.999 * gap * n, 1.0);
    (void)pair.finder.work(n);
    EXPECT_LT(pair.finder.overlap().volume, 1e-12);
  }
}

/// Of all parts together: a maximum would pass over what is not a number.
double summed_difference(const SolidOverlap& a, const SolidOverlap& b) {
  const auto off = [](double x, double y) { return std::abs(x - y) / std::max(std::abs(y), 1e-9); };
  const auto off_by = [](const auto& x, const auto& y) { return (x - y).norm() / y.norm(); };
  return off(a.volume, b.volume) + off(a.energy, b.energy) + off(a.stiffness, b.stiffness) +
         off(a.mean_square, b.mean_square) + off(a.largest_strain, b.largest_strain) +
         off(a.pressed, b.pressed) + off(a.arm, b.arm) + off_by(a.push, b.push) +
         off_by(a.moment, b.moment) + off_by(a.point, b.point) + off_by(a.spread, b.spread);
}

// From bodies that only just touch to such as share a fifth of their size. Sums in another order
// differ by rounding, 1e-16 times the 1e3 by which the least overlaps here are smaller than the
// bodies, whose second moments are left over from lengths of theirs.
TEST_P(RandomPairs, CornersInLanesGiveWhatOneByOneGives) {
  if (!kLaneOutlines) GTEST_SKIP() << "this processor has no such lanes";
  Pair pair = random_pair(GetParam()), other = pair;
  other.finder.take_corners_one_by_one();
  const Vec3 in = -pair.between.normalized();
  int compared = 0;
  for (const double deeper : {-0.02, -0.01, 0.0, 0.05, 0.1, 0.2}) {
    const SolidOverlap lanes = pair.overlap(deeper * in), one = other.overlap(deeper * in);
    EXPECT_EQ(pair.finder.touching(), other.finder.touching());
    if (one.largest_strain < 1e-3) continue;
    const double off = summed_difference(lanes, one);
    std::printf("corners in lanes against one by one: %.1e\n", off);
    EXPECT_LT(off, 1e-10);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPairs, testing::Range(1u, 41u));

// A cube of 0.5 m stands d deep on one of 1 m. The large one's strain is 2 d
// (its centre is 0.5 m deep) all over the small one's face of 0.25 m2. The
// small one's strain on the face of the other grows from its edge inwards to d
// / 0.25 m: the frustum d / 3 (A + sqrt(A a) + a), a = (0.5 - 2 d)^2.
TEST(BoxOnBox, PressureIsThatOfTheClosedForm) {
  const double d = 0.01, inner = 0.5 - 2.0 * d;
  Pair pair{cube(1.0), cube(0.5), Mat3::Identity(), Vec3(0, 0, 0.75 - d), {}};
  const SolidOverlap at = pair.overlap();
  const double frustum = d / 3.0 * (0.25 + 0.5 * inner + inner * inner) / 0.25;
  EXPECT_NEAR(at.push.z(), -(0.25 * 2.0 * d + frustum), 1e-14);
  EXPECT_NEAR(at.push.head<2>().norm(), 0.0, 1e-14);
  EXPECT_NEAR(at.volume, 0.25 * d, 1e-14);
  EXPECT_LT(at.moment.norm(), 1e-13);
}

// Cubes that cover each other: no edge is special, and faces in one plane count
// once.
TEST(BoxOnBox, FlushCubesArePressedOverTheWholeFace) {
  const double d = 1e-4;
  Pair pair{cube(1.0), cube(1.0), Mat3::Identity(), Vec3(0, 0, 1.0 - d), {}};
  const SolidOverlap at = pair.overlap();
  EXPECT_NEAR(at.push.z(), -2.0 * 2.0 * d, 4.0 * 4.0 * d * d);
  EXPECT_NEAR(at.energy, 2.0 * d * d, 8.0 * d * d * d);
}

// A body slides and rolls over another: each step may change the push by
// stiffness times motion.
TEST(Sweep, PushIsContinuousOverCornersEdgesAndFaces) {
  std::mt19937 random(7);
  const Polyhedron shape = test::random_solid(random, Vec3(1.0, 1.0, 1.0), 5);
  Pair pair{cube(1.0), about_centroid(shape), Mat3::Identity(), Vec3::Zero(), {}};
  constexpr int kSteps = 20000;
  Vec3 last = Vec3::Zero();
  double worst = 0.0, largest = 0.0;
  int touching = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double t = static_cast<double>(k) / kSteps;
    pair.turn = Eigen::AngleAxisd(6.28 * t, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    pair.between = Vec3(1.6 * t - 0.8, 0.3 * std::sin(12.0 * t), 0.9);
    const SolidOverlap at = pair.overlap();
    if (k > 0) {
      worst = std::max(worst, (at.push - last).norm());
      touching += at.push.norm() > 0.0 && last.norm() > 0.0 ? 1 : 0;
    }
    largest = std::max(largest, at.push.norm());
    last = at.push;
  }
  std::printf("largest change of the push in one of %d steps: %.1e of the largest\n", kSteps,
              worst / largest);
  EXPECT_GT(touching, kSteps / 4);
  EXPECT_LT(worst,
            2e-3 * largest);  // a few m of path, each 0.1 of the push's depth
}

TEST(Solid, RefusesWhatIsNotConvex) {
  Polyhedron box = test::box(Vec3::Zero(), Vec3::Ones());
  box.vertices[0] += Vec3::Constant(0.2);
  EXPECT_THROW(about_centroid(box), InputError);
}

/// An upright prism with so many sides, each cut into so many faces one over the other.
Polyhedron prism(int sides, int layers) {
  Polyhedron shape;
  std::vector<int> bottom, top;
  const int column = layers + 1;  // corners over each other
  for (int k = 0; k < sides; ++k) {
    const double angle = 2.0 * M_PI * k / sides;
    for (int z = 0; z <= layers; ++z)
      shape.vertices.emplace_back(std::cos(angle), std::sin(angle), -0.5 + 1.0 * z / layers);
    const int here = column * k, next = column * ((k + 1) % sides);
    for (int z = 0; z < layers; ++z)
      shape.faces.push_back({here + z, next + z, next + z + 1, here + z + 1});
    bottom.insert(bottom.begin(), here);
    top.push_back(here + layers);
  }
  shape.faces.push_back(bottom);
  shape.faces.push_back(top);
  return shape;
}

/// 236 corners, 61 planes.
TEST(Solid, OfManyCornersPressesAsOneWithoutThoseInItsFaces) {
  const Mat3 turn = Eigen::AngleAxisd(0.3, Vec3(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
  const Vec3 between(1.3, 0.6, 0.4);
  Pair plain{cube(1.2), about_centroid(prism(59, 1)), turn, between, {}};
  Pair cut{cube(1.2), about_centroid(prism(59, 3)), turn, between, {}};
  ASSERT_EQ(cut.second.corners().size(), 236U);
  const SolidOverlap expected = plain.overlap(), found = cut.overlap();
  ASSERT_GT(expected.largest_strain, 0.01);
  EXPECT_NEAR(found.largest_strain / expected.largest_strain, 1.0, 1e-9);
  EXPECT_NEAR(found.energy / expected.energy, 1.0, 1e-9);
}

TEST(Solid, TakesFacesInOnePlaneAsOne) {
  EXPECT_EQ(cube(1.0).planes().size(), 6u);
  EXPECT_NEAR(cube(1.0).radius(), 0.5 * std::sqrt(3.0), 1e-14);
}

}  // namespace
}  // namespace muckpile
