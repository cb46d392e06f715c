// SPDX-License-Identifier: GPL-2.0-or-later
// Sums and extremes of numbers over all ranks.
// Scope: every rank gets the result; all of these are collective.
#pragma once

#include <mpi.h>

#include <concepts>
#include <cstdint>
#include <span>
#include <type_traits>

namespace muckpile::engine {

template <class Number>
requires std::same_as<Number, double> || std::same_as<Number, int> ||
    std::same_as<Number, std::int64_t>
[[nodiscard]] MPI_Datatype mpi_type() {
  if constexpr (std::is_same_v<Number, double>) return MPI_DOUBLE;
  if constexpr (std::is_same_v<Number, int>) return MPI_INT;
  return MPI_INT64_T;
}

/// Each value is replaced by that of all ranks together.
template <class Numbers>
void reduce_over_ranks(Numbers&& values, MPI_Op how, MPI_Comm world) {
  const std::span all(values);
  using Number = std::remove_reference_t<decltype(all.front())>;
  MPI_Allreduce(MPI_IN_PLACE, all.data(), static_cast<int>(all.size()), mpi_type<Number>(), how,
                world);
}
template <class Numbers>
void sum_over_ranks_in_place(Numbers&& values, MPI_Comm world) {
  reduce_over_ranks(values, MPI_SUM, world);
}
template <class Numbers>
void least_over_ranks_in_place(Numbers&& values, MPI_Comm world) {
  reduce_over_ranks(values, MPI_MIN, world);
}

template <class Number>
[[nodiscard]] Number sum_over_ranks(Number mine, MPI_Comm world) {
  reduce_over_ranks(std::span(&mine, 1), MPI_SUM, world);
  return mine;
}
template <class Number>
[[nodiscard]] Number greatest_over_ranks(Number mine, MPI_Comm world) {
  reduce_over_ranks(std::span(&mine, 1), MPI_MAX, world);
  return mine;
}
template <class Number>
[[nodiscard]] Number least_over_ranks(Number mine, MPI_Comm world) {
  reduce_over_ranks(std::span(&mine, 1), MPI_MIN, world);
  return mine;
}
[[nodiscard]] inline bool on_any_rank(bool mine, MPI_Comm world) {
  return greatest_over_ranks(mine ? 1 : 0, world) != 0;
}

}  // namespace muckpile::engine
