// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of bodies and their spheres as LIGGGHTS has them, for tests and measurements of BodyMotion.
// Scope: storage. `bodies` in the order of BodyRows; `spheres`: position, velocity, spin, force,
// torque.
#pragma once

#include <array>
#include <vector>

#include "motion/body_motion.h"

namespace muckpile {

struct MotionRows {
  std::array<std::vector<double>, 9> bodies;
  std::array<std::vector<double>, 5> spheres;
  std::vector<double> quaternions;

  [[nodiscard]] BodyRows body_rows() {
    auto& v = bodies;
    return {v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data(),
            v[5].data(), v[6].data(), v[7].data(), v[8].data(), quaternions.data()};
  }
  [[nodiscard]] SphereRows sphere_rows() {
    auto& v = spheres;
    return {v[0].data(), v[1].data(), v[2].data(), v[3].data(), v[4].data()};
  }
};

}  // namespace muckpile
