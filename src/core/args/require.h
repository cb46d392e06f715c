// SPDX-License-Identifier: GPL-2.0-or-later
// Checks of the values that a law is made from.
// Scope: throws an InputError that names the quantity, its rule, its unit and the value.
#pragma once

#include <cmath>
#include <string>
#include <string_view>

#include "args/input_error.h"
#include "args/numbers.h"

namespace muckpile {

/// `rule` names the quantity and what it must be, such as "density must be > 0 kg/m3".
inline void require(bool holds, std::string_view rule, double value) {
  if (!holds) throw InputError(std::string(rule) + ", got '" + number_text(value) + "'");
}

[[noreturn]] inline void refuse_value(std::string_view name, std::string_view rule,
                                      std::string_view unit, double value) {
  std::string text(name);
  text.append(" must be ").append(rule).append(unit.empty() ? "" : " ").append(unit);
  throw InputError(text + ", got '" + number_text(value) + "'");
}

/// value > 0 and finite.
inline void require_positive(std::string_view name, std::string_view unit, double value) {
  if (!(std::isfinite(value) && value > 0.0)) refuse_value(name, "> 0", unit, value);
}

/// value >= 0 and finite.
inline void require_not_negative(std::string_view name, std::string_view unit, double value) {
  if (!(std::isfinite(value) && value >= 0.0)) refuse_value(name, ">= 0", unit, value);
}

}  // namespace muckpile
