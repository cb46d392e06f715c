// SPDX-License-Identifier: GPL-2.0-or-later
// Ranks get every byte that is meant for them, in one round and in many.
#include <gtest/gtest.h>
#include <mpi.h>

#include <cstddef>
#include <vector>

#include "fixes/engine/exchange.h"

namespace muckpile::engine {
namespace {

/// What rank `from` has for rank `to`: lengths that differ, none for some.
std::vector<char> message(int from, int to) {
  std::vector<char> bytes(static_cast<std::size_t>((7 * from + 13 * to) % 5) * 100);
  for (std::size_t k = 0; k < bytes.size(); ++k)
    bytes[k] = static_cast<char>(static_cast<int>(k) + 31 * from + 17 * to);
  return bytes;
}

TEST(Exchange, EveryRankGetsItsBytesInOneRoundAndInMany) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<std::vector<char>> outgoing;
  for (int to = 0; to < ranks; ++to) outgoing.push_back(message(rank, to));
  for (const std::size_t most_at_once : {std::size_t{1} << 30, std::size_t{256}, std::size_t{3}}) {
    const auto incoming = exchange_bytes(outgoing, MPI_COMM_WORLD, most_at_once);
    ASSERT_EQ(incoming.size(), static_cast<std::size_t>(ranks));
    for (int from = 0; from < ranks; ++from)
      EXPECT_EQ(incoming[static_cast<std::size_t>(from)], message(from, rank)) << most_at_once;
  }
}

}  // namespace
}  // namespace muckpile::engine
