// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts of blocks with what stands still, for the time step that they bear.
// Scope: an interface only; fix muckpile/wall implements it, pair muckpile/block adds them to the
// contacts between blocks.
#pragma once

#include <functional>

#include "contact/contact_step_bound.h"

namespace muckpile {

/// One contact of a sphere.
struct StandingContact {
  ContactResistance resistance{};
  Vec3 normal = Vec3::Zero(), point = Vec3::Zero();  ///< where it acts [m]
};

class StandingContacts {
 public:
  virtual ~StandingContacts() = default;

  using Take = std::function<void(int sphere, const StandingContact& contact)>;
  /// Calls `take` for each contact of the last step of this rank's own spheres.
  virtual void visit_contacts(const Take& take) const = 0;

  /// The step that resolves a light collision of a sphere of this rank with it [s].
  [[nodiscard]] virtual double light_step() const = 0;
};

}  // namespace muckpile
