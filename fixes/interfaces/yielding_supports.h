// SPDX-License-Identifier: GPL-2.0-or-later
// What a quiet boundary needs of the joints: supports whose ground can give way.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/quiet drives it.
#pragma once

#include <functional>

#include "math/types.h"

namespace muckpile {

/// Values are this rank's, to be summed over ranks; every support is on exactly one rank.
class YieldingSupports {
 public:
  virtual ~YieldingSupports() = default;

  /// The ground behind the intact fixed supports that `chosen` accepts, by their centroid in the
  /// start configuration [m], yields from now on like rock, `rock_behind` [m] thick for a lasting
  /// load. What the supports carry now stays. To be called when forces are up to date. Returns
  /// their number and area [m2].
  struct Chosen {
    double count = 0.0, area = 0.0;
  };
  virtual Chosen let_ground_yield(const std::function<bool(const Vec3&)>& chosen,
                                  double rock_behind) = 0;
  /// From now on every ground stays where it is, as a fixed support does.
  virtual void stop_ground() = 0;

  [[nodiscard]] virtual double supports_yielding() const = 0;
  /// Energy given to the rock behind so far, and the part of it that waves carried away [J].
  [[nodiscard]] virtual double energy_given() const = 0;
  [[nodiscard]] virtual double energy_radiated() const = 0;
};

}  // namespace muckpile
