// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes of the tests of fix muckpile/wall: a level wall, and blocks of 0.5 m above it.
// Scope: rock_scene.h and wall_scenes.h; every function with a scene is collective.
#pragma once

#include <string>

#include "rock_scene.h"
#include "scratch_folder.h"
#include "wall_scenes.h"

namespace muckpile::test {

inline constexpr double kStep = 2e-5;  // [s]

/// Entries of fix muckpile/ledger and of the wall, numbered from 1.
enum Entry { walls = 11, contacts = 1, stored = 3, rubbed = 4, damped = 5, lift = 8, let_go = 9 };

inline const std::string kPlane = "muckpile/wall plane 0 0 0 0 0 1";
inline const std::string kStockPlane =
    "wall/gran model hertz tangential history primitive type 1 zplane 0";

/// Level ground from x, y = -half to half in cells x cells squares [m]; written by rank 0.
inline std::string mesh_of(const ScratchFolder& folder, double half_x, double half_y, int cells) {
  const std::string file = (folder / "floor.stl").string();
  const auto at = [&](int i, int j) {
    return std::to_string(half_x * (2.0 * i / cells - 1.0)) + " " +
           std::to_string(half_y * (2.0 * j / cells - 1.0)) + " 0";
  };
  write_facets(file, [&](const auto& facet) {
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        facet(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        facet(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  });
  return file;
}

inline std::string words(int spheres, double growth = 1.19) {
  return half_metre_blocks(spheres, growth);
}

/// Contacts of a restitution, the same for LIGGGHTS' walls, and a wall.
inline void add_wall(RockScene& scene, const std::string& wall, double restitution) {
  add_contacts(scene, restitution, "friction 0.3 rolling_friction 0", "0.3");
  scene.command("fix floor all " + wall);
}

inline RockScene scene_on(MPI_Comm comm, const std::string& wall, double restitution,
                          const std::string& processors = "* * 1") {
  RockScene scene(comm, "-12 12 -4 4 -4 6", processors, "multisphere/muckpile");
  add_wall(scene, wall, restitution);
  return scene;
}

/// 27 blocks of five spheres just above the floor, which go down and aside and turn.
inline RockScene thrown(MPI_Comm comm, const std::string& wall, double speed) {
  RockScene scene = scene_on(comm, wall, 0.5);
  scene.cut("-0.75 0.75 -0.75 0.75 0.2 1.7", words(5));
  scene.command("fix weight all gravity 9.81 vector 0 0 -1");
  scene.command("fix ledger all muckpile/ledger");
  throw_down(scene, speed);
  return scene;
}

}  // namespace muckpile::test
