// SPDX-License-Identifier: GPL-2.0-or-later
// An interval that a number must lie in, and how to say so.
// Scope: see range.h.
#include "args/range.h"

#include <cmath>

#include "args/numbers.h"

namespace muckpile {

bool Range::contains(double value) const {
  const bool above_lo = lo_open ? value > lo : value >= lo;
  const bool below_hi = hi_open ? value < hi : value <= hi;
  return above_lo && below_hi;
}

std::string Range::text() const {
  std::string result;
  if (std::isfinite(lo)) result = (lo_open ? "> " : ">= ") + number_text(lo);
  if (std::isfinite(hi)) {
    if (!result.empty()) result += " and ";
    result += (hi_open ? "< " : "<= ") + number_text(hi);
  }
  return result;
}

}  // namespace muckpile
