// SPDX-License-Identifier: GPL-2.0-or-later
// An interval that a number must lie in, and how to say so.
// Scope: real bounds, each open or closed, infinity for none; integers use the same type.
#pragma once

#include <limits>
#include <string>

namespace muckpile {

struct Range {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
  bool lo_open = false;  ///< true: lo itself is not allowed
  bool hi_open = false;  ///< true: hi itself is not allowed

  [[nodiscard]] bool contains(double value) const;
  /// "> 0", ">= 0 and < 0.5"; empty for the whole line.
  [[nodiscard]] std::string text() const;

  [[nodiscard]] static Range any() { return {}; }
  [[nodiscard]] static Range positive() { return above(0.0); }
  [[nodiscard]] static Range non_negative() { return at_least(0.0); }
  [[nodiscard]] static Range above(double lo) { return {.lo = lo, .lo_open = true}; }
  [[nodiscard]] static Range at_least(double lo) { return {.lo = lo}; }
  [[nodiscard]] static Range closed(double lo, double hi) { return {.lo = lo, .hi = hi}; }
  [[nodiscard]] static Range open(double lo, double hi) {
    return {.lo = lo, .hi = hi, .lo_open = true, .hi_open = true};
  }
  [[nodiscard]] static Range left_open(double lo, double hi) {
    return {.lo = lo, .hi = hi, .lo_open = true};
  }
  [[nodiscard]] static Range right_open(double lo, double hi) {
    return {.lo = lo, .hi = hi, .hi_open = true};
  }
};

}  // namespace muckpile
