// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes that the tests of walls share: blocks of 0.5 m above a floor, thrown at it.
// Scope: rock_scene.h; every function with a scene is collective.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "rock_scene.h"

namespace muckpile::test {

/// Words of create_blocks for blocks of 0.5 m.
inline std::string half_metre_blocks(int spheres, double growth) {
  return "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block " +
         std::to_string(spheres) + " sphere_growth " + std::to_string(growth);
}

/// Contacts of 2.5e7 Pa between blocks, and the same material for LIGGGHTS' walls.
inline void add_contacts(RockScene& scene, double restitution, const std::string& more_of_pair,
                         const std::string& wall_friction) {
  const std::string bounce = std::to_string(restitution);
  scene.command("pair_style muckpile/block youngs_modulus 2.5e7 " + more_of_pair + " restitution " +
                bounce);
  scene.command("pair_coeff * *");
  scene.command("fix m1 all property/global youngsModulus peratomtype 2.5e7");
  scene.command("fix m2 all property/global poissonsRatio peratomtype 0.25");
  scene.command("fix m3 all property/global coefficientRestitution peratomtypepair 1 " + bounce);
  scene.command("fix m4 all property/global coefficientFriction peratomtypepair 1 " +
                wall_friction);
}

/// Blocks go down at a speed [m/s], and on, aside and around, each in its own way.
inline void throw_down(RockScene& scene, double speed) {
  scene.set_motion([speed](int tag, const Vec3&) {
    return Motion{Vec3(5.0, tag % 3 - 1.0, -speed), Vec3(3, tag % 5, -2)};
  });
}

/// An STL file by rank 0: add(facet) is given facet(a, b, c), of three corners as text. Collective.
template <class Add>
void write_facets(const std::filesystem::path& path, const Add& add) {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) {
    std::ofstream out(path);
    out << "solid floor\n";
    add([&](const std::string& a, const std::string& b, const std::string& c) {
      out << "facet normal 0 0 0\nouter loop\nvertex " << a << "\nvertex " << b << "\nvertex " << c
          << "\nendloop\nendfacet\n";
    });
    out << "endsolid floor\n";
  }
  MPI_Barrier(MPI_COMM_WORLD);
}

/// Of the same block in two scenes [m].
inline double farthest_apart(const RockScene& one, const RockScene& other) {
  double apart = 0.0;
  const auto others = other.blocks();
  for (const auto& [tag, block] : one.blocks())
    apart = std::max(apart, (block.centre - others.at(tag).centre).norm());
  return apart;
}

inline double lowest_centre(const RockScene& scene) {
  double lowest = 1e9;
  for (const auto& [tag, block] : scene.blocks()) lowest = std::min(lowest, block.centre.z());
  return lowest;
}

}  // namespace muckpile::test
