// SPDX-License-Identifier: GPL-2.0-or-later
// How long a time step the contacts of rigid bodies bear.
// Scope: linearised about the present overlaps; contacts yet to come are not known here.
//
// The springs of all contacts together are at most, for any motion, twice the sum over bodies of
// each body's own contacts: (a - b)^2 <= 2 a^2 + 2 b^2. So omega^2 <= 2 sum k (1/m + r^2/I) over
// the contacts of a body, k the larger of normal and tangential stiffness, r the arm, I the
// smallest principal moment; the dashpots likewise. A leapfrog step with dashpots that lag half a
// step is stable up to (2 / omega) (sqrt(1 + zeta^2) - zeta), zeta = c / (2 omega).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace muckpile {

class ContactStepBound {
 public:
  explicit ContactStepBound(std::size_t bodies) : sums_(bodies) {}

  /// One contact of `body`: stiffness [N/m], damping [N s/m], and 1/m + r^2/I [1/kg].
  void add(std::size_t body, double stiffness, double damping, double mobility) {
    sums_[body].stiffness += 2.0 * stiffness * mobility;
    sums_[body].damping += 2.0 * damping * mobility;
  }

  /// Longest stable step [s]; infinity without contacts.
  [[nodiscard]] double step() const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Sum& sum : sums_) {
      if (sum.stiffness <= 0.0) continue;
      const double omega = std::sqrt(sum.stiffness), zeta = 0.5 * sum.damping / omega;
      shortest = std::min(shortest, 2.0 / omega * (std::sqrt(1.0 + zeta * zeta) - zeta));
    }
    return shortest;
  }

 private:
  struct Sum {
    double stiffness = 0.0;  ///< [1/s2]
    double damping = 0.0;    ///< [1/s]
  };
  std::vector<Sum> sums_;
};

}  // namespace muckpile
