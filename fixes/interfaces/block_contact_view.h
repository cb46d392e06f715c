// SPDX-License-Identifier: GPL-2.0-or-later
// What run_blast and fix muckpile/wall need to know of the contacts between blocks.
// Scope: an interface only; pair muckpile/block implements it.
#pragma once

#include <optional>

#include "run/blast_scene.h"

namespace muckpile {

struct ContactParameters;

class BlockContactView {
 public:
  virtual ~BlockContactView() = default;
  /// Nothing where the contacts are not by Hertz.
  [[nodiscard]] virtual std::optional<BlockContacts> hertz_contacts() const = 0;
  /// Of the law between blocks, as the script gave them last.
  [[nodiscard]] virtual const ContactParameters& contact_parameters() const = 0;
};

}  // namespace muckpile
