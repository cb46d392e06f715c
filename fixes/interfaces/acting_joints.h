// SPDX-License-Identifier: GPL-2.0-or-later
// How many joints of each block cost computing time.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/balance reads it.
#pragma once

#include <span>

namespace muckpile {

class ActingJoints {
 public:
  virtual ~ActingJoints() = default;
  /// Adds `cost` to each body of this rank, in body order, once for every joint or support of it
  /// that is neither retired nor so far open that it is passed over.
  virtual void add_cost_of_joints(std::span<double> costs, double cost) const = 0;
};

}  // namespace muckpile
