// SPDX-License-Identifier: GPL-2.0-or-later
// Bonded lumps of rock in the engine, and what fix muckpile/joint tells of them.
// Scope: for the tests of that fix.
#pragma once

#include <cmath>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {

enum Joint {
  joints = 1,
  broken = 2,
  broken_share = 3,
  elastic = 4,
  fracture = 5,
  friction = 6,
  damping = 7,
  stable_step = 8,
  crushing = 11
};

inline std::string uniform(double size, int seed = 3) {
  const std::string s = std::to_string(size);
  return "density 2600 size uniform " + s + " block_min " + s + " block_max " + s +
         " spheres_per_block 2 seed " + std::to_string(seed);
}

inline Motion spinning(const Vec3& at, double rate) {
  const Vec3 spin(0.2 * rate, -0.3 * rate, rate);
  return {Vec3(3, -2, 1) + spin.cross(at) +
              0.02 * rate * Vec3(std::sin(3 * at.y()), std::cos(2 * at.z()), 0),
          spin};
}

/// Faces lean against the lines between centres: the terms of leaning_faces.h act.
inline const std::string kLeaning =
    " cut joint_sets joint_set 75 90 joint_set 85 0 joint_set 10 270";

/// A bonded lump of some 40 blocks about the origin.
inline void make_lump(RockScene& scene, const std::string& strength, const std::string& cut = "") {
  scene.cut("-1 1 -1 1 -0.6 0.6", uniform(0.5) + cut);
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 "
      "contact_check no " +
      strength);
  scene.command("fix ledger all muckpile/ledger");
}

}  // namespace muckpile::test
