// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres of other ranks' bodies: what no rank sends stays as it is.
#include <gtest/gtest.h>
#include <mpi.h>

#include <array>
#include <vector>

#include "fixes/engine/border_spheres.h"

namespace muckpile::engine {
namespace {

/// Each rank lends one sphere to the rank before it.
TEST(BorderSpheres, SphereWithoutASenderStaysWhereItIs) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  using Place = std::array<double, 3>;
  Place lent{100.0 + rank, 2.0, 3.0}, borrowed{0.0, 0.0, 0.0}, alone{4.0, 5.0, 6.0};
  std::array<double*, 3> rows{lent.data(), borrowed.data(), alone.data()};
  const int next = (rank + 1) % ranks;
  const std::array<int, 3> tags{100 + rank, 100 + next, 200 + rank};
  BorderSpheres spheres({0}, {1, 2}, tags.data(), MPI_COMM_WORLD);
  spheres.to_spheres({rows.data()});
  EXPECT_EQ(alone, (Place{4.0, 5.0, 6.0}));
  if (ranks > 1) {
    EXPECT_EQ(borrowed, (Place{100.0 + next, 2.0, 3.0}));
  }
}

}  // namespace
}  // namespace muckpile::engine
