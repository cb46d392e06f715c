// SPDX-License-Identifier: GPL-2.0-or-later
// Rosin-Rammler and Swebrec curves fitted to a passing curve, with their errors.
// Scope: least squares in mass share at the sizes P5, P10 ... P95 of the curve.
#pragma once

#include <optional>
#include <vector>

#include "geometry/size/size_target.h"
#include "measure/fragments.h"

namespace muckpile {

struct SizeFit {
  double x50;    // [m]
  double xmax;   // [m], of Swebrec; 0 for Rosin-Rammler
  double shape;  // exponent n of Rosin-Rammler, b of Swebrec
  double rms;    // of the differences in mass share at those sizes
  // Standard errors of x50 [m] and shape, from the same differences as if each were by chance.
  double x50_error = 0.0, shape_error = 0.0;
  [[nodiscard]] SizeTarget curve() const;
};

// Nothing where the curve has no breadth: P95 within a hundredth of P5.
std::optional<SizeFit> fit_rosin_rammler(const std::vector<SizePoint>& curve);
// The same with xmax at the curve's largest size.
std::optional<SizeFit> fit_swebrec(const std::vector<SizePoint>& curve);

}  // namespace muckpile
