// SPDX-License-Identifier: GPL-2.0-or-later
// The exponent n of y = c x^n by least squares in ln x and ln y, with a factor c of its own for
// each group of runs. Scope: positive numbers. A group is what shares the values of all other
// variables, so that their influence does not count as scatter.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace muckpile {

struct PowerPoint {
  double x, y;   // > 0
  size_t group;  // any number that names it
};

struct PowerLaw {
  double exponent;
  std::optional<double> error;  // standard error; nothing without a point more than unknowns
  double residual;              // root mean square of ln y about the law
};

// Nothing where there are fewer than three different x, or no group has two.
[[nodiscard]] std::optional<PowerLaw> fit_power_law(const std::vector<PowerPoint>& points);

}  // namespace muckpile
