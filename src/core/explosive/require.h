// SPDX-License-Identifier: GPL-2.0-or-later
// Range checks shared by the explosive laws.
// Scope: throws InputError naming the quantity, its rule, its unit and the value.
#pragma once

#include <cmath>
#include <sstream>

#include "args/input_error.h"

namespace muckpile::explosive_detail {

[[noreturn]] inline void refuse(const char* name, const char* rule, const char* unit,
                                double value) {
  std::ostringstream text;
  text.precision(12);
  text << name << " must be " << rule << (*unit ? " " : "") << unit << ", got '" << value << "'";
  throw InputError(text.str());
}

/// value > 0 and finite.
inline void require_positive(const char* name, const char* unit, double value) {
  if (!(std::isfinite(value) && value > 0.0)) refuse(name, "> 0", unit, value);
}

/// value >= 0 and finite.
inline void require_not_negative(const char* name, const char* unit, double value) {
  if (!(std::isfinite(value) && value >= 0.0)) refuse(name, ">= 0", unit, value);
}

}  // namespace muckpile::explosive_detail
