// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies worked on side by side against the same laws body by body; what becomes of a body does
// not depend on those beside it.
// Scope: motion/body_motion.h.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "motion/body_motion.h"
#include "motion_rows.h"

namespace muckpile {
namespace {

constexpr std::size_t kBodies = 21;  // two groups and five bodies
constexpr BodyStep kStep{1e-2, 5e-3};
const Vec3 kGravity(0.0, 0.0, -9.81);

struct Body {
  BodyConstants constants;
  Vec3 centre, velocity, force, momentum, torque, spin;
  Quat pose;
};

struct Sphere {
  BodySphere of;
  Vec3 position = Vec3::Zero(), velocity = Vec3::Zero(), spin = Vec3::Zero(), force, torque;
};

struct Scene {
  std::vector<Body> bodies;
  std::vector<Sphere> spheres;
};

/// Spheres of all bodies mixed, one to six a body.
Scene make_scene() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  Scene scene;
  for (std::size_t b = 0; b < kBodies; ++b) {
    const double size = 1.5 + number(random);
    scene.bodies.push_back({{size, size * (Vec3(0.2, 0.3, 0.4) + 0.05 * vector())},
                            vector(),
                            vector(),
                            vector(),
                            vector(),
                            vector(),
                            vector(),
                            Quat(number(random), 1.0, number(random), 0.5).normalized()});
    for (std::size_t k = 0; k <= b % 6; ++k)
      scene.spheres.push_back({{static_cast<int>(b), 0, vector()},
                               Vec3::Zero(),
                               Vec3::Zero(),
                               Vec3::Zero(),
                               vector(),
                               vector()});
  }
  std::ranges::shuffle(scene.spheres, random);
  for (std::size_t s = 0; s < scene.spheres.size(); ++s)
    scene.spheres[s].of.sphere = static_cast<int>(s);
  return scene;
}

/// A scene in rows of numbers.
class Rows {
 public:
  explicit Rows(const Scene& scene, std::span<const char> rests = {}) {
    std::vector<BodyConstants> constants;
    for (const Body& body : scene.bodies) {
      constants.push_back(body.constants);
      const Mat3 axes = body.pose.toRotationMatrix();
      const std::array<Vec3, 9> threes = {body.centre,   body.velocity, body.force,
                                          body.momentum, body.torque,   body.spin,
                                          axes.col(0),   axes.col(1),   axes.col(2)};
      for (std::size_t k = 0; k < threes.size(); ++k) append(threes[k], rows_.bodies[k]);
      rows_.quaternions.push_back(body.pose.w());
      append(body.pose.vec(), rows_.quaternions);
    }
    std::vector<BodySphere> spheres;
    for (const Sphere& sphere : scene.spheres) {
      spheres.push_back(sphere.of);
      const std::array<Vec3, 5> threes = {sphere.position, sphere.velocity, sphere.spin,
                                          sphere.force, sphere.torque};
      for (std::size_t k = 0; k < threes.size(); ++k) append(threes[k], rows_.spheres[k]);
    }
    motion_ = BodyMotion(constants, spheres);
    motion_.let_rest(rests);
  }
  void advance(bool place_resting = false) {
    motion_.advance(rows_.body_rows(), rows_.sphere_rows(), kStep, place_resting);
  }
  void sum_forces() { motion_.sum_forces(rows_.body_rows(), rows_.sphere_rows(), kGravity); }
  void finish() { motion_.finish(rows_.body_rows(), rows_.sphere_rows(), kGravity, kStep); }

  [[nodiscard]] Vec3 body(std::size_t what, std::size_t b) const {
    return Vec3::Map(rows_.bodies[what].data() + 3 * b);
  }
  [[nodiscard]] Vec3 sphere(std::size_t what, std::size_t s) const {
    return Vec3::Map(rows_.spheres[what].data() + 3 * s);
  }
  [[nodiscard]] Quat pose(std::size_t b) const {
    const double* q = rows_.quaternions.data() + 4 * b;
    return {q[0], q[1], q[2], q[3]};
  }

 private:
  static void append(const Vec3& v, std::vector<double>& to) {
    to.insert(to.end(), v.data(), v.data() + 3);
  }
  MotionRows rows_;
  BodyMotion motion_;
};

enum Of { centre, velocity, force, momentum, torque, spin, x_axis, y_axis, z_axis };

Vec3 where(const std::array<bool, 3>& flags, const Vec3& yes) {
  return {flags[0] ? yes.x() : 0.0, flags[1] ? yes.y() : 0.0, flags[2] ? yes.z() : 0.0};
}

Vec3 spin_of(const Body& body) {
  const Mat3 axes = body.pose.toRotationMatrix();
  return axes * (axes.transpose() * body.momentum).cwiseQuotient(body.constants.inertia);
}

void kick(Body& body) {
  const BodyConstants& constants = body.constants;
  body.velocity += where(constants.moves, kStep.half_kick / constants.mass * body.force);
  body.momentum += where(constants.turns, kStep.half_kick * body.torque);
}

/// Midpoint rule in the body, twice iterated; see motion/turn.h.
void turn(Body& body) {
  const double half = 0.5 * kStep.time;
  const Vec3 start = body.pose.conjugate() * body.momentum;
  Vec3 middle = start;
  for (int k = 0; k < 2; ++k)
    middle = start + half * middle.cross(middle.cwiseQuotient(body.constants.inertia));
  const Vec3 rate = middle.cwiseQuotient(body.constants.inertia);
  const Vec3 t = (1.0 + half * half * rate.squaredNorm() / 3.0) * half * rate;
  body.pose = (body.pose * Quat(1.0, t.x(), t.y(), t.z())).normalized();
  body.spin = body.pose * rate;
}

/// What BodyMotion::advance() does, one by one.
void advance(Scene& scene) {
  for (Body& body : scene.bodies) {
    kick(body);
    body.centre += kStep.time * body.velocity;
    turn(body);
  }
  for (Sphere& sphere : scene.spheres) {
    const Body& body = scene.bodies[static_cast<std::size_t>(sphere.of.body)];
    const Vec3 arm = body.pose * sphere.of.displacement;
    sphere.position = body.centre + arm + sphere.of.image;
    sphere.velocity = body.velocity + body.spin.cross(arm);
    sphere.spin = body.spin;
  }
}

/// What BodyMotion::finish() does, one by one.
void finish(Scene& scene) {
  for (const Sphere& sphere : scene.spheres) {
    if (!sphere.of.counts) continue;
    Body& body = scene.bodies[static_cast<std::size_t>(sphere.of.body)];
    body.force += sphere.force;
    body.torque += (body.pose * sphere.of.displacement).cross(sphere.force) + sphere.torque;
  }
  for (Body& body : scene.bodies) {
    body.force += body.constants.mass * kGravity;
    kick(body);
    body.spin = spin_of(body);
  }
}

void expect_same(const Rows& rows, const Scene& scene) {
  constexpr double kRounding = 1e-14;  // of numbers about 1 after a few dozen operations
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    const Mat3 axes = body.pose.toRotationMatrix();
    const std::array<Vec3, 9> expected = {body.centre,   body.velocity, body.force,
                                          body.momentum, body.torque,   body.spin,
                                          axes.col(0),   axes.col(1),   axes.col(2)};
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_LT((rows.body(k, b) - expected[k]).norm(), kRounding * (1.0 + expected[k].norm()))
          << b << ' ' << k;
    EXPECT_LT((rows.pose(b).coeffs() - body.pose.coeffs()).norm(), kRounding) << b;
  }
  for (std::size_t s = 0; s < scene.spheres.size(); ++s) {
    const Sphere& sphere = scene.spheres[s];
    EXPECT_LT((rows.sphere(0, s) - sphere.position).norm(), kRounding) << s;
    EXPECT_LT((rows.sphere(1, s) - sphere.velocity).norm(), 10.0 * kRounding) << s;
    EXPECT_LT((rows.sphere(2, s) - sphere.spin).norm(), 10.0 * kRounding) << s;
  }
}

TEST(BodyMotion, DoesToBodiesSideBySideWhatTheLawDoesToOne) {
  Scene scene = make_scene();
  Rows rows(scene);
  for (int step = 0; step < 2; ++step) {
    advance(scene);
    rows.advance();
    finish(scene);
    rows.finish();
    expect_same(rows, scene);
  }
}

TEST(BodyMotion, KeepsBodiesFromMovingAndTurningInDirectionsThatAreShut) {
  Scene scene = make_scene();
  scene.bodies[2].constants.moves = {false, true, true};
  scene.bodies[9].constants.turns = {true, false, false};
  scene.bodies[20].constants.moves = scene.bodies[20].constants.turns = {false, false, false};
  Rows rows(scene);
  const double before = scene.bodies[2].velocity.x();
  advance(scene);
  rows.advance();
  finish(scene);
  rows.finish();
  expect_same(rows, scene);
  EXPECT_EQ(rows.body(velocity, 2).x(), before);
}

TEST(BodyMotion, PlacesImagesOfAPeriodicBoxAndTakesForcesOfOneImageOnly) {
  Scene scene = make_scene();
  for (std::size_t s = 0; s < scene.spheres.size(); s += 3) {
    scene.spheres[s].of.image = Vec3(0.5, 0.0, -1.0);
    scene.spheres[s].of.counts = false;
  }
  Rows rows(scene);
  advance(scene);
  rows.advance();
  finish(scene);
  rows.finish();
  expect_same(rows, scene);
}

TEST(BodyMotion, LeavesHeldBodiesAndTheirSpheresAsTheyAre) {
  const Scene start = make_scene();
  Scene moved = start;
  advance(moved);
  finish(moved);
  std::vector<char> rests(kBodies, 0);
  for (const std::size_t b : {1, 3, 8, 9, 10, 11, 12, 13, 14, 15, 20}) rests[b] = 1;
  Rows rows(start, rests);
  const Rows before(start);
  rows.advance();
  rows.finish();
  for (std::size_t b = 0; b < kBodies; ++b) {
    const Body& expected = rests[b] != 0 ? start.bodies[b] : moved.bodies[b];
    EXPECT_LT((rows.body(velocity, b) - expected.velocity).norm(), 1e-14) << b;
    if (rests[b] == 0) continue;
    for (std::size_t k = 0; k <= z_axis; ++k)
      EXPECT_EQ(rows.body(k, b), before.body(k, b)) << b << ' ' << k;
  }
  for (std::size_t s = 0; s < start.spheres.size(); ++s) {
    const auto b = static_cast<std::size_t>(start.spheres[s].of.body);
    const Vec3 expected = rests[b] != 0 ? start.spheres[s].position : moved.spheres[s].position;
    EXPECT_LT((rows.sphere(0, s) - expected).norm(), 1e-14) << s;
  }
  rows.advance(true);
  for (std::size_t s = 0; s < start.spheres.size(); ++s) {
    const auto b = static_cast<std::size_t>(start.spheres[s].of.body);
    if (rests[b] == 0) continue;
    const Body& body = start.bodies[b];
    const Vec3 expected = body.centre + body.pose * start.spheres[s].of.displacement;
    EXPECT_LT((rows.sphere(0, s) - expected).norm(), 1e-14) << s;
  }
}

TEST(BodyMotion, SumsForcesAloneAsBeforeAKick) {
  const Scene scene = make_scene();
  Rows alone(scene), kicked(scene);
  alone.sum_forces();
  kicked.finish();
  for (std::size_t b = 0; b < kBodies; ++b) {
    EXPECT_EQ(alone.body(force, b), kicked.body(force, b)) << b;
    EXPECT_EQ(alone.body(torque, b), kicked.body(torque, b)) << b;
    EXPECT_EQ(alone.body(velocity, b), scene.bodies[b].velocity) << b;
  }
}

/// The scene's bodies from `first` on, alone.
Scene part_of(const Scene& scene, std::size_t first) {
  Scene part;
  part.bodies.assign(scene.bodies.begin() + static_cast<std::ptrdiff_t>(first), scene.bodies.end());
  for (Sphere sphere : scene.spheres) {
    sphere.of.body -= static_cast<int>(first);
    if (sphere.of.body < 0) continue;
    sphere.of.sphere = static_cast<int>(part.spheres.size());
    part.spheres.push_back(sphere);
  }
  return part;
}

TEST(BodyMotion, GivesTheSameBitsWhateverBodiesAreBesideOne) {
  const Scene scene = make_scene();
  Rows whole(scene);
  std::vector<char> rests(kBodies, 0);
  rests[14] = 1;
  Rows beside_resting(scene, rests);
  for (int step = 0; step < 20; ++step) {
    for (Rows* rows : {&whole, &beside_resting}) {
      rows->advance();
      rows->finish();
    }
  }
  for (std::size_t first = 0; first < kBodies; ++first) {
    Rows part(part_of(scene, first));
    for (int step = 0; step < 20; ++step) {
      part.advance();
      part.finish();
    }
    for (std::size_t k = 0; k <= z_axis; ++k)
      for (std::size_t b = first; b < kBodies; ++b) {
        ASSERT_EQ(part.body(k, b - first), whole.body(k, b)) << first << ' ' << b << ' ' << k;
        if (b != 14) {
          ASSERT_EQ(beside_resting.body(k, b), whole.body(k, b)) << b << ' ' << k;
        }
      }
  }
}

}  // namespace
}  // namespace muckpile
