// SPDX-License-Identifier: GPL-2.0-or-later
// Messages between ranks: buffers of bytes, and values of stored types in them.
// Scope: same machine type on every rank.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "fixes/engine/over_ranks.h"
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
/// The same for numbers, of which every rank has as many.
template <class Numbers>
void take_from_first_rank(Numbers&& values, MPI_Comm world) {
  const std::span all(values);
  using Number = std::remove_reference_t<decltype(all.front())>;
  MPI_Bcast(all.data(), static_cast<int>(all.size()), mpi_type<Number>(), 0, world);
}
/// And for one.
template <class Number>
requires std::is_arithmetic_v<Number>
[[nodiscard]] Number of_first_rank(Number value, MPI_Comm world) {
  take_from_first_rank(std::span(&value, 1), world);
  return value;
}

/// Sends outgoing[r] to rank r and returns what each rank sent here. Collective. Goes in rounds of
/// at most `most_at_once` bytes (below 2 GiB) to or from a rank, or, with more ranks than that, one
/// byte between each two.
[[nodiscard]] std::vector<std::vector<char>> exchange_bytes(
    const std::vector<std::vector<char>>& outgoing, MPI_Comm world,
    std::size_t most_at_once = std::size_t{1} << 30);

}  // namespace muckpile::engine
