// SPDX-License-Identifier: GPL-2.0-or-later
// Whoever knows where the state of a run that has gone wrong is to be written.
// Scope: an interface only; fix muckpile/progress implements it, styles that stop a run call it.
#pragma once

#include <string>

namespace muckpile {

class StateWriter {
 public:
  virtual ~StateWriter() = default;
  /// Writes a restart file of the present state, for looking at; returns its name. At the end of a
  /// step only. Collective.
  virtual std::string write_state() = 0;
};

}  // namespace muckpile
