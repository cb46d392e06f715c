// SPDX-License-Identifier: GPL-2.0-or-later
// How wide a broken joint is for gas: under normal stress its faces close onto each other.
// Scope: a pure function of normal stress and opening, without branches, so that a loop over it is
// vectorised; no history. Without stress the faces are E_0
// apart in the mean; stress s closes them on the hyperbola of first loading,
//     s = k c/(1 - c/V),     E = E_0 - c + opening
// (Bandis, Lumsden & Barton 1983), and smooth walls that let as much water through are
//     e = E^2/JRC^2.5 in um, at most E
// apart (Barton, Bandis & Bakhtar 1985).
#pragma once

#include <algorithm>

#include "bond/law/hydraulic_aperture.h"
#include "bond/law/joint_law.h"

namespace muckpile {

class ClosedJoint {
 public:
  struct Parameters {
    double residual_aperture = 1e-4;  ///< E_0 [m]
    double closure_share = 0.0;       ///< V/E_0, below 1; 0: stress closes nothing [-]
    double closure_stiffness = 0.0;   ///< k, without stress [Pa/m]
    double roughness = 0.0;           ///< JRC; 0: e = E [-]
  };

  /// InputError on a value out of range.
  explicit ClosedJoint(const Parameters& parameters);

  /// E of faces that touch under a normal stress [Pa] -> [m].
  [[nodiscard]] double closed(double stress) const {
    const double pressed = std::max(stress, 0.0);
    return p_.residual_aperture - limit_ * pressed / (pressed + half_stress_);
  }
  /// Of faces that are so far apart on top [m].
  [[nodiscard]] JointApertures apertures(double stress, double opening) const {
    const double mechanical = closed(stress) + opening;
    return {mechanical, hydraulic(mechanical)};
  }
  [[nodiscard]] double hydraulic(double mechanical) const {
    return hydraulic_aperture(mechanical, smooth_from_);
  }

 private:
  Parameters p_;
  double limit_;        // V [m]
  double half_stress_;  // k V, that closes by V/2 [Pa]
  double smooth_from_;  // from that E on e is E [m]
};

}  // namespace muckpile
