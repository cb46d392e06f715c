// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts that need not act at every step.
// Scope: an interface only; pair muckpile/block implements it, fix muckpile/timestep sets the pace.
#pragma once

namespace muckpile {

class PacedContacts {
 public:
  virtual ~PacedContacts() = default;
  /// From the next step on contacts act at every so many steps, as strongly as in all of them.
  virtual void act_every(int steps) = 0;
  /// The forces of this step are those of several: the step must not become longer now.
  [[nodiscard]] virtual bool act_for_several() const = 0;
};

}  // namespace muckpile
