// SPDX-License-Identifier: GPL-2.0-or-later
// What the words of fix muckpile/wall ask for.
// Scope: no engine; every fault in the words throws InputError.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "args/parse_args.h"
#include "contact/contact_law.h"
#include "wall/wall_surface.h"

namespace muckpile {

[[nodiscard]] ArgTable wall_table();

/// The simulation box, in which a mesh must lie at least in part, or reach it as it grows.
struct WallBox {
  Vec3 lo, hi;                                     ///< [m]
  std::array<bool, 3> lo_follows{}, hi_follows{};  ///< sides that go where rock flies
};

struct WallOptions {
  std::shared_ptr<const WallSurface> surface;
  std::string told;                                 ///< of a mesh, for the log; "" for a plane
  double youngs_modulus = 0.0;                      ///< of the ground; 0: of the rock [Pa]
  double restitution = 0.0;                         ///< 0: of the rock [-]
  double friction = -1.0, rolling_friction = -1.0;  ///< below 0: of the rock [-]

  bool torsion = false;  ///< resist spin about the normal

  /// Of the contacts of blocks that touch each other with these.
  [[nodiscard]] ContactParameters parameters(ContactParameters rock) const;
};

/// `where` begins each message.
[[nodiscard]] WallOptions wall_options(const ArgValues& args, const WallBox& box,
                                       const std::string& where);

}  // namespace muckpile
