// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres that lie on one rank while their body is moved by another: a message there and one back.
// Scope: three numbers per sphere and array; no periodic images. The plan holds until bodies or
// spheres change their places.
#pragma once

#include <mpi.h>

#include <initializer_list>
#include <vector>

#include "fixes/engine/block_halo.h"

namespace muckpile::engine {

class BorderSpheres {
 public:
  BorderSpheres() = default;
  /// Collective. `lent`: ghosts here whose body this rank moves; `strange`: spheres of this rank
  /// whose body another rank moves; indices into `tags` and the arrays.
  BorderSpheres(std::vector<int> lent, std::vector<int> strange, const int* tags, MPI_Comm world);

  /// From the ranks that move the bodies to those that own the spheres.
  void to_spheres(std::initializer_list<double**> arrays) {
    carry(outward_, lent_, strange_, arrays);
  }
  /// From the ranks that own the spheres to those that move the bodies.
  void to_bodies(std::initializer_list<double**> arrays) {
    carry(homeward_, strange_, lent_, arrays);
  }

 private:
  void carry(const BlockHalo& halo, const std::vector<int>& from, const std::vector<int>& to,
             std::initializer_list<double**> arrays);

  std::vector<int> lent_, strange_;
  BlockHalo outward_, homeward_;
  std::vector<double> values_;
};

}  // namespace muckpile::engine
