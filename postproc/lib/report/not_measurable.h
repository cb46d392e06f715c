// SPDX-License-Identifier: GPL-2.0-or-later
// A sound run whose scene a report has no measures for, as against a faulty one.
// Scope: tools/ gives it an exit code of its own, so that scripts can go on with other reports.
#pragma once

#include "args/input_error.h"

namespace muckpile {

class NotMeasurable : public InputError {
 public:
  using InputError::InputError;
};

inline constexpr int kNotMeasurableExitCode = 3;

}  // namespace muckpile
