// SPDX-License-Identifier: GPL-2.0-or-later
// How ranks work on one facet network: values of copied blocks from their owners, sums over ranks.
// Scope: an interface that the caller fills in; every rank makes the same calls in the same order.
// As it stands: one rank, which owns all of its blocks.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace muckpile {

struct RankTeam {
  /// `values` has `width` numbers per block, owned blocks first, then the copies, no ground: sets
  /// those of the copies to what their owners have.
  std::function<void(std::span<double> values, std::size_t width)> fill_copies =
      [](std::span<double>, std::size_t) {};
  /// Over all ranks.
  std::function<double(double)> sum = [](double mine) { return mine; };
  int ranks = 1;
};

}  // namespace muckpile
