// SPDX-License-Identifier: GPL-2.0-or-later
// What run_blast needs to know of the rock between its joints.
// Scope: an interface only; fix muckpile/joint implements it.
#pragma once

#include "run/blast_scene.h"

namespace muckpile {

class RockView {
 public:
  virtual ~RockView() = default;
  /// As it is before anything is softened.
  [[nodiscard]] virtual RockConstants rock() const = 0;
};

}  // namespace muckpile
