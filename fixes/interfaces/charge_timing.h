// SPDX-License-Identifier: GPL-2.0-or-later
// What run_blast needs to know of the charges.
// Scope: an interface only; fix muckpile/blast implements it.
#pragma once

#include "run/blast_scene.h"

namespace muckpile {

class ChargeTiming {
 public:
  virtual ~ChargeTiming() = default;
  /// Known once the blocks and fix muckpile/joint are there.
  [[nodiscard]] virtual BlastTiming timing() const = 0;
  /// The gas leaves its holes by flow, not by time.
  [[nodiscard]] virtual bool vents_by_flow() const = 0;
  /// Steps up to this are meant while pulses act: no warning of them [s].
  virtual void expect_step(double longest) = 0;
};

}  // namespace muckpile
