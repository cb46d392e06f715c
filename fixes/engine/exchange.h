// SPDX-License-Identifier: GPL-2.0-or-later
// Messages between ranks: buffers of bytes, and values of stored types in them.
// Scope: same machine type on every rank.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "state/encoding.h"

namespace muckpile::engine {

/// Sends what is in outgoing[r] to rank r and gives `read` what each rank has sent here, with its
/// number, in the order of ranks. Collective. A StateError of one rank is thrown on all of them.
void exchange_messages(std::vector<ByteWriter>& outgoing, MPI_Comm world,
                       const std::function<void(ByteReader&, std::size_t)>& read);

/// The values of all ranks, in the order of ranks, on every rank. Collective.
[[nodiscard]] std::vector<double> gather_all(const std::vector<double>& mine, MPI_Comm world);

/// The text of the first rank, on every rank. Collective.
[[nodiscard]] std::string of_first_rank(std::string text, MPI_Comm world);

/// Sends outgoing[r] to rank r and returns what each rank sent here. Collective. Goes in rounds of
/// at most `most_at_once` bytes (below 2 GiB) to or from a rank, or, with more ranks than that, one
/// byte between each two.
[[nodiscard]] std::vector<std::vector<char>> exchange_bytes(
    const std::vector<std::vector<char>>& outgoing, MPI_Comm world,
    std::size_t most_at_once = std::size_t{1} << 30);

}  // namespace muckpile::engine
