// SPDX-License-Identifier: GPL-2.0-or-later
// perf_blocks: time of the blocks' own step per sphere, on one core: forces of the spheres summed,
// blocks kicked, moved and turned, spheres placed; prints JSON to standard output.
// Scope: core only: no messages, no joints, no contacts; spheres lie body by body.
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "measurement.h"
#include "motion/body_motion.h"
#include "motion_rows.h"
#include "timing.h"

namespace muckpile::perf {
namespace {

constexpr double kStep = 1e-5;                 // [s]
constexpr std::size_t kBodySteps = 2'000'000;  // of a measurement: some 0.1 s

/// Blocks of different inertia that spin; rows as LIGGGHTS has them.
class Blocks {
 public:
  Blocks(std::size_t blocks, std::size_t spheres_each) : spheres_(blocks * spheres_each) {
    for (std::vector<double>& row : rows_.bodies) row.assign(3 * blocks, 0.0);
    for (std::vector<double>& row : rows_.spheres) row.assign(3 * spheres_, 0.0);
    rows_.quaternions.assign(4 * blocks, 0.0);
    std::vector<BodyConstants> constants(blocks);
    std::vector<BodySphere> spheres(spheres_);
    for (std::size_t b = 0; b < blocks; ++b) {
      const double size = 1.0 + 0.1 * static_cast<double>(b % 7);
      constants[b] = {size, Vec3(0.1, 0.2, 0.25) * size};
      rows_.quaternions[4 * b] = rows_.bodies[6][3 * b] = rows_.bodies[7][3 * b + 1] =
          rows_.bodies[8][3 * b + 2] = 1.0;
      for (std::size_t d = 0; d < 3; ++d)
        rows_.bodies[3][3 * b + d] = 0.1 * static_cast<double>(d + 1);
    }
    for (std::size_t s = 0; s < spheres_; ++s) {
      spheres[s] = {static_cast<int>(s / spheres_each), static_cast<int>(s),
                    Vec3(0.3, 0.1 * static_cast<double>(s % spheres_each), -0.2)};
      rows_.spheres[3][3 * s] = 1.0 + static_cast<double>(s % 3);
    }
    motion_ = BodyMotion(constants, spheres);
  }
  [[nodiscard]] std::size_t spheres() const { return spheres_; }

  void advance() {
    motion_.advance(rows_.body_rows(), rows_.sphere_rows(), {kStep, 0.5 * kStep}, false);
  }
  void finish() {
    motion_.finish(rows_.body_rows(), rows_.sphere_rows(), Vec3(0.0, 0.0, -9.81),
                   {kStep, 0.5 * kStep});
  }

 private:
  std::size_t spheres_;
  MotionRows rows_;
  BodyMotion motion_;
};

nlohmann::ordered_json measure_blocks(std::size_t blocks, std::size_t spheres_each) {
  Blocks scene(blocks, spheres_each);
  const std::size_t steps = std::max<std::size_t>(1, kBodySteps / blocks / 10);
  const auto nanoseconds = [&](const auto& work) {
    const double seconds = least_time([&] {
      for (std::size_t step = 0; step < steps; ++step) work();
    });
    return 1e9 * seconds / static_cast<double>(steps * scene.spheres());
  };
  nlohmann::ordered_json result;
  result["blocks"] = blocks;
  result["spheres_per_block"] = spheres_each;
  result["move_and_place"]["ns_per_sphere"] = nanoseconds([&] { scene.advance(); });
  result["sum_and_kick"]["ns_per_sphere"] = nanoseconds([&] { scene.finish(); });
  result["step"]["ns_per_sphere"] = nanoseconds([&] {
    scene.advance();
    scene.finish();
  });
  return result;
}

}  // namespace

nlohmann::ordered_json measure() {
  nlohmann::ordered_json result;
  result["what"] = "blocks that spin: sums of forces, kicks, moves, turns, places of spheres";
  result["target_ns_per_sphere"] = 10.0;
  // In the cache of a core, of the default bench, and behind all caches.
  for (const std::size_t blocks : {200, 10'634, 200'000})
    for (const std::size_t spheres_each : {5, 9})
      result["runs"].push_back(measure_blocks(blocks, spheres_each));
  return result;
}

}  // namespace muckpile::perf
