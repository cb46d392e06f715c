// SPDX-License-Identifier: GPL-2.0-or-later
// Burden along charges, against plane faces for which it is known.
// Scope: blocks of one size; lengths in metres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "../geometry/surface_shapes.h"
#include "geometry/cut/tessellation.h"
#include "geometry/shape/convex_cell.h"
#include "geometry/shape/polygon.h"
#include "input_error_of.h"
#include "rock/burden_faces.h"
#include "rock/burden_file.h"
#include "rock/hole_burdens.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

constexpr double kFaceAngle = 70.0 * M_PI / 180.0;

/// A bench 4 m high whose face leans back from the toe at x = 0, z = 0; free there and on top.
std::vector<Block> bench(const std::vector<Hole>& holes) {
  TessellationOptions options;
  options.lo = Vec3(-6.0, -3.0, 0.0);
  options.hi = Vec3(0.0, 3.0, 4.0);
  options.size = SizeLaw::uniform(0.6);
  options.sweeps = 3;
  options.holes = holes;
  const Vec3 normal(std::sin(kFaceAngle), 0.0, std::cos(kFaceAngle));
  options.region.inside = [normal](const Vec3& p) { return normal.dot(p) < 0.0; };
  options.region.surface_points = [normal](const Vec3& p, double cutoff) {
    const double below = -normal.dot(p);
    return below <= cutoff ? std::vector<Vec3>{p + below * normal} : std::vector<Vec3>{};
  };
  return tessellate(options).blocks;
}

Support support_of_bench(const Vec3& at) {
  const bool supported = std::abs(at.y()) > 3.0 - 1e-6 || at.x() < -6.0 + 1e-6 || at.z() < 1e-6;
  return supported ? Support::fixed : Support::free;
}

// Upright: at height z the face is z cot(70) nearer. In each twentieth the nearest counts, its top.
TEST(HoleBurdens, OfAnUprightHoleShrinkUpward) {
  const std::vector<Hole> holes{{Vec3(-3.0, 0.0, 0.2), Vec3(-3.0, 0.0, 2.2), 0.3}};
  const HoleBurden burden = hole_burdens(bench(holes), holes, support_of_bench).front();
  const auto at = [](double z) { return 3.0 - z / std::tan(kFaceAngle); };
  EXPECT_NEAR(burden.least.value(), at(2.2), 1e-6);
  EXPECT_NEAR(burden.greatest.value(), at(0.3), 1e-6);
  EXPECT_NEAR(burden.mean.value(), at(1.25), 1e-6);
  EXPECT_EQ(burden.bare, 0.0);
  EXPECT_FALSE(burden.in_front);
}

TEST(HoleBurdens, OfAHoleAlongTheFaceAreOneAndRowsHaveTheHoleInFront) {
  const Vec3 along(-std::cos(kFaceAngle), 0.0, std::sin(kFaceAngle));
  const auto hole = [&](double x) {
    return Hole{Vec3(x, 0.0, 0.4), Vec3(x, 0.0, 0.4) + 2.0 * along, 0.3};
  };
  const std::vector<Hole> holes{hole(-1.8), hole(-3.6)};
  const auto burdens = hole_burdens(bench(holes), holes, support_of_bench);
  const double first = 1.8 * std::sin(kFaceAngle) - 0.4 * std::cos(kFaceAngle);
  EXPECT_NEAR(burdens[0].least.value(), first, 1e-6);
  EXPECT_NEAR(burdens[0].greatest.value(), first, 1e-6);
  EXPECT_FALSE(burdens[0].in_front);
  ASSERT_EQ(burdens[1].in_front, 0U);
  EXPECT_NEAR(burdens[1].to_front, 1.8 * std::sin(kFaceAngle), 1e-9);
  // 1.55 m are within 0.6 and 1.5 of a plan's 1.7 m, but not of 1 m, nor of 2.7 m.
  const auto warnings = [&](double plan) {
    const std::string text = describe_burdens(burdens, plan);
    std::size_t count = 0;
    for (auto at = text.find("WARNING"); at != std::string::npos; at = text.find("WARNING", at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(warnings(0.0), 0U);
  EXPECT_EQ(warnings(1.7), 0U);
  EXPECT_EQ(warnings(1.0), 2U);
  EXPECT_EQ(warnings(2.7), 1U);
}

// A piece's place lies on the axis, its face point on the face and so far from it.
TEST(HoleBurdens, OfEachPieceHaveTheirPlaceOnTheFace) {
  const std::vector<Hole> holes{{Vec3(-3.0, 0.0, 0.2), Vec3(-3.0, 0.0, 2.2), 0.3}};
  const HoleBurden burden = hole_burdens(bench(holes), holes, support_of_bench).front();
  const Vec3 normal(std::sin(kFaceAngle), 0.0, std::cos(kFaceAngle));
  ASSERT_EQ(burden.pieces.size(), 20U);  // of 0.1 m
  for (std::size_t k = 0; k < burden.pieces.size(); ++k) {
    const BurdenPiece& piece = burden.pieces[k];
    const double top = 0.2 + 0.1 * static_cast<double>(k + 1);
    EXPECT_NEAR(piece.along, top - 0.25, 1e-9);
    EXPECT_NEAR((piece.at - Vec3(-3.0, 0.0, top - 0.05)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(piece.burden.value(), 3.0 - top / std::tan(kFaceAngle), 1e-6);
    EXPECT_NEAR((piece.face - Vec3(-top / std::tan(kFaceAngle), 0.0, top)).norm(), 0.0, 1e-6);
    EXPECT_NEAR(normal.dot(piece.face), 0.0, 1e-6);
  }
}

// The rock goes on below the floor z = 0, where it is joined to what lies in front: blocks that
// reach across the floor have a face of which only a corner is beside the charge there.
TEST(HoleBurdens, OfASubdrillAreNotToTheEndOfTheFace) {
  const std::vector<Hole> holes{{Vec3(-1.6, 0.0, -0.8), Vec3(-1.6, 0.0, 2.2), 0.3}};
  TessellationOptions options;
  options.lo = Vec3(-6.0, -3.0, -1.4);
  options.hi = Vec3(0.0, 3.0, 4.0);
  options.size = SizeLaw::uniform(0.6);
  options.sweeps = 3;
  options.holes = holes;
  const auto blocks = tessellate(options).blocks;
  const HoleBurden burden = hole_burdens(blocks, holes, [](const Vec3& at) {
                              const bool supported = std::abs(at.y()) > 3.0 - 1e-6 ||
                                                     at.x() < -6.0 + 1e-6 || at.z() < 0.0;
                              return supported ? Support::fixed : Support::free;
                            }).front();
  for (const BurdenPiece& piece : burden.pieces) {
    if (piece.at.z() > 0.3) {
      EXPECT_NEAR(piece.burden.value(), 1.6, 1e-6);
    }
    if (piece.at.z() < -0.6) {
      EXPECT_FALSE(piece.burden);
    }
  }
  EXPECT_LE(burden.greatest.value(), 1.6 / 0.8);
  EXPECT_EQ(describe_burdens({burden}, 1.6).find("WARNING"), std::string::npos);
}

/// A prism 4 m high beside the plane y = 0: a face x = 0 with a notch 1 m deep and 1.5 m wide.
Block beside_a_notch(double side) {
  ConvexCell cell = box_cell(Vec3(-5.0, std::min(0.0, 3.0 * side), 0.0),
                             Vec3(0.0, std::max(0.0, 3.0 * side), 4.0));
  const Vec3 out_of_rock(0.75, -side, 0.0);
  Block block;
  block.shape = divided(cell, Vec3(-1.0, 0.0, 0.0), out_of_rock, 1)->below.shape;
  block.mass = mass_properties(block.shape);
  block.neighbour.assign(block.shape.faces.size(), kFreeFace);
  return block;
}

// Both flanks are steep to the way from the hole to the root of the notch, which is the burden.
TEST(HoleBurdens, OfANotchReachToItsRoot) {
  const std::vector<Hole> holes{{Vec3(-2.0, 0.0, 1.0), Vec3(-2.0, 0.0, 3.0), 0.1}};
  const HoleBurden burden =
      hole_burdens({beside_a_notch(1.0), beside_a_notch(-1.0)}, holes, [](const Vec3& at) {
        const bool within = std::abs(at.y()) < 1e-9 && at.x() < -1.0;
        const bool supported = std::abs(at.y()) > 3.0 - 1e-6 || at.x() < -5.0 + 1e-6;
        return within || supported ? Support::fixed : Support::free;
      }).front();
  for (const BurdenPiece& piece : burden.pieces) {
    EXPECT_NEAR(piece.burden.value(), 1.0, 1e-9);  // 2 m of the plan less 1 m of the notch
    EXPECT_NEAR((piece.face.head<2>() - Vec2(-1.0, 0.0)).norm(), 0.0, 1e-9);
  }
  EXPECT_NE(describe_burdens({burden}, 2.0).find("1 m at least, below 0.6"), std::string::npos);
}

/// A face of 80 degrees with hollows and noses, x = -z cot(80) + 0.5 cos(pi y/6), by triangles to
/// within a millimetre; floor in front, top 4 m above.
RockSurface curved_ground() {
  constexpr double kCot = 0.17632698070846498, kTop = 4.0;
  const auto nose = [](double y) { return 0.5 * std::cos(M_PI * y / 6.0); };
  const auto ground = [&](const Vec3& p) {  // x counts stations: floor to 0, face 0 to 1, top
    const double s = std::clamp(p.x(), 0.0, 1.0), off = p.x() - s;
    return Vec3(nose(p.y()) - s * kTop * kCot - off, p.y(), s * kTop);
  };
  const auto flat = [](double, double) { return 0.0; };
  test::Triangles triangles;
  for (const double from : {-6.0, 0.0, 1.0}) {  // edges of the face are edges of triangles
    const double to = from < 0.0 ? 0.0 : from < 1.0 ? 1.0 : 8.0;
    const auto part = test::heights(Vec3(from, -6.0, 0.0), Vec3(to, 6.0, 0.0), 60, flat);
    triangles.insert(triangles.end(), part.begin(), part.end());
  }
  triangles = test::mapped(triangles, ground);
  for (StlTriangle& t : triangles)
    if ((t[1] - t[0]).cross(t[2] - t[0]).z() < 0.0) std::swap(t[1], t[2]);
  return test::surface_of(triangles, SurfaceIs::terrain);
}

// Blocks of 0.8 m round the toe off; the survey does not. A leaning hole stays beside its face, at
// (burden - nose) sin(80) at right angles; an upright one at the burden less height and nose.
TEST(HoleBurdens, OfSurveyedGroundAreThoseOfTheSurvey) {
  constexpr double kLean = 80.0 * M_PI / 180.0;
  TessellationOptions options;
  options.lo = Vec3(-5.0, -5.0, -1.0);
  options.hi = Vec3(3.0, 5.0, 4.5);
  options.size = SizeLaw::uniform(0.8);
  options.sweeps = 3;
  const SurveyedRock surveyed{{curved_ground()}, {}, options.lo, options.hi};
  options.region = within({}, surveyed.surfaces);
  const Vec3 along(-std::cos(kLean), 0.0, std::sin(kLean));
  const Vec3 nose(-2.0, 0.0, 0.0), hollow(-2.5, -3.0, 0.0);
  const std::vector<Hole> holes{{nose + 0.1 * along, nose + 2.1 * along, 0.1},
                                {hollow, hollow + Vec3(0.0, 0.0, 2.0), 0.1}};
  const auto supported = [&](const Vec3& p) {
    return p.z() < -0.5 || p.x() > 2.9 || p.x() < -4.9 || std::abs(p.y()) > 4.9 ? Support::fixed
                                                                                : Support::free;
  };
  const auto blocks = tessellate(options).blocks;
  const auto exact = hole_burdens(blocks, holes, supported, surveyed);
  const auto coarse = hole_burdens(blocks, holes, supported);
  // On the nose's axis the distance to the curve grows sideways: 2.5 m to its top is not the least.
  const auto least_way = [&](double x, double y, double squeeze) {
    double least = 1e9;
    for (double at = -6.0; at <= 6.0; at += 1e-3)
      least = std::min(least, std::hypot((0.5 * std::cos(M_PI * at / 6.0) - x) * squeeze, at - y));
    return least;
  };
  const double leaning = least_way(nose.x(), nose.y(), std::sin(kLean));
  EXPECT_NEAR(exact[0].least.value(), leaning, 0.005);
  EXPECT_NEAR(exact[0].greatest.value(), leaning, 0.005);
  const double top = 2.0 / std::tan(kLean);
  EXPECT_NEAR(exact[1].least.value(), least_way(hollow.x() + top, hollow.y(), 1.0), 0.005);
  EXPECT_GT(std::abs(coarse[0].least.value() - leaning), 0.05);
  std::cout << "least burden [m]: exact " << leaning << ", by the survey " << *exact[0].least
            << ", by blocks " << *coarse[0].least << '\n';
}

TEST(HoleBurdens, AreJudgedByThePlansAndByTheHoleInFront) {
  EXPECT_EQ(judged(1.79, 3.0), BurdenIs::too_little);  // 0.6 * 3 = 1.8
  EXPECT_EQ(judged(1.81, 3.0), BurdenIs::as_planned);
  EXPECT_EQ(judged(4.49, 3.0), BurdenIs::as_planned);  // 1.5 * 3 = 4.5
  EXPECT_EQ(judged(4.51, 3.0), BurdenIs::too_much);
  EXPECT_EQ(judged(4.51, 0.0), BurdenIs::not_judged);
  EXPECT_EQ(judged(std::nullopt, 3.0), BurdenIs::not_judged);
  HoleBurden hole;
  BurdenPiece piece;
  EXPECT_FALSE(burden_that_counts(hole, piece));
  piece.burden = 6.0;
  EXPECT_EQ(burden_that_counts(hole, piece), 6.0);
  hole.in_front = 0;
  hole.to_front = 3.0;
  EXPECT_EQ(burden_that_counts(hole, piece), 3.0);
  piece.burden = 2.0;  // a face nearer than the hole
  EXPECT_EQ(burden_that_counts(hole, piece), 2.0);
}

TEST(BurdenFile, ComesBackAsItWasWritten) {
  testing::TemporaryFolder temporary;
  const std::string path = (temporary.path() / "dump/burden.csv").string();
  BurdenFile burdens;
  burdens.plan = 2.5;
  burdens.holes.resize(2);
  burdens.holes[0].pieces = {{0.5, Vec3(-2.0, 1.0, 0.5), 2.25, Vec3(0.25, 1.0, 0.5)},
                             {1.5, Vec3(-2.0, 1.0, 1.5), std::nullopt, Vec3::Zero()}};
  burdens.holes[1].pieces = {{0.5, Vec3(-5.0, 1.0, 0.5), 5.25, Vec3(0.25, 1.0, 0.5)}};
  burdens.holes[1].in_front = 0;
  burdens.holes[1].to_front = 3.0;
  write_burdens(path, burdens, "0123456789abcdef");
  const BurdenFile back = read_burdens(path);
  EXPECT_EQ(back.plan, 2.5);
  ASSERT_EQ(back.holes.size(), 2U);
  ASSERT_EQ(back.holes[0].pieces.size(), 2U);
  EXPECT_EQ(back.holes[0].pieces[0].burden, 2.25);
  EXPECT_EQ(back.holes[0].pieces[0].face, Vec3(0.25, 1.0, 0.5));
  EXPECT_EQ(back.holes[0].pieces[1].at, Vec3(-2.0, 1.0, 1.5));
  EXPECT_FALSE(back.holes[0].pieces[1].burden);
  EXPECT_FALSE(back.holes[0].in_front);
  EXPECT_EQ(back.holes[1].in_front, 0U);
  EXPECT_EQ(back.holes[1].to_front, 3.0);
  std::string text = testing::text_of(path);
  text.replace(text.find("\n2,"), 3, "\n4,");
  testing::write_text(path, text);
  EXPECT_NE(input_error_of([&] {
              (void)read_burdens(path);
            }).find("burden.csv:4: hole must be 1 or 2, got '4'"),
            std::string::npos);
}

TEST(HoleBurdens, AreNoneWithoutAFaceBesideTheCharge) {
  const std::vector<Hole> holes{{Vec3(-3.0, 0.0, 0.2), Vec3(-3.0, 0.0, 2.2), 0.3}};
  const auto burdens =
      hole_burdens(bench(holes), holes, [](const Vec3&) { return Support::fixed; });
  EXPECT_FALSE(burdens.front().mean);
  EXPECT_NE(describe_burdens(burdens, 3.0).find("no free face beside it"), std::string::npos);
}

Block box_block(const Vec3& lo, const Vec3& hi) {
  Block block;
  block.shape = box_cell(lo, hi).shape;
  block.mass = mass_properties(block.shape);
  block.neighbour.assign(block.shape.faces.size(), kFreeFace);
  return block;
}

/// Of a hole through the toe of an upright face x = 0 with a free level floor z = 0 in front.
HoleBurden over_a_floor(double dip_degrees) {
  const double dip = dip_degrees * M_PI / 180.0;
  const Vec3 toe(-0.3, 0.0, -1.5);
  const std::vector<Hole> holes{{toe, toe + 3.0 * Vec3(-std::cos(dip), 0.0, std::sin(dip)), 0.05}};
  const std::vector<Block> blocks{box_block({-5, -9, -2}, {0, 9, 0}),
                                  box_block({0, -9, -2}, {6, 9, 0}),
                                  box_block({-5, -9, 0}, {0, 9, 4})};
  return hole_burdens(blocks, holes,
                      [](const Vec3& at) {
                        const bool floor = std::abs(at.z()) < 1e-9 && at.x() > 0.0;
                        const bool face = std::abs(at.x()) < 1e-9 && at.z() > 0.0;
                        return floor || face ? Support::free : Support::fixed;
                      })
      .front();
}

// At right angles to a hole of 70 degrees the floor is met at 20 degrees: what lies below it has no
// burden. Along one of 45 degrees the floor is a face like others: at x it is (1.8 + x) / sqrt(2)
// away and (1.2 - x) / sqrt(2) along the hole, together 3 / sqrt(2).
TEST(HoleBurdens, OfALeaningSubdrillAreNotToALevelFloor) {
  const HoleBurden steep = over_a_floor(70.0), flat = over_a_floor(45.0);
  const double step = 3.0 / 20.0;
  for (std::size_t k = 0; k < 8; ++k) EXPECT_FALSE(steep.pieces[k].burden) << k;
  EXPECT_TRUE(steep.pieces[9].burden);  // beside the face
  for (std::size_t k = 0; k < 5; ++k) {
    const double top = step * static_cast<double>(k + 1);
    EXPECT_NEAR(flat.pieces[k].burden.value_or(0.0), 3.0 / std::sqrt(2.0) - top, 1e-9) << k;
  }
}

}  // namespace
}  // namespace muckpile
