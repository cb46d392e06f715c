// SPDX-License-Identifier: GPL-2.0-or-later
// Time that the rock in front of a hole has had to move when the hole fires, per metre of burden.
// Scope: arithmetic on places and times of a plan; no rock moves.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/shape/polygon.h"  // Vec2

namespace muckpile {

struct ReliefHole {
  Vec2 place = Vec2::Zero();  // of its charge, in plan; the throw goes along +x [m]
  double time = 0.0;          // it fires [s]
  std::optional<double>
      face{};  // least way from its charge to the free face, where it is known [m]
};

struct Relief {
  std::optional<std::size_t> in_front{};  // hole that it fires towards; none: the face
  std::optional<double> burden{};         // to that hole, or to the face [m]
  std::optional<double> per_metre{};      // time since that hole fired over the way to it [s/m]
};

// A hole fires towards the nearest one that has fired before and stands less than 60 degrees from
// the throw's direction; where none of those has, towards the nearest of them, and its relief is 0
// or negative. Holes farther off than twice the way to its nearest neighbour do not count, nor such
// as are no nearer than the face.
std::vector<Relief> burden_relief(const std::vector<ReliefHole>& holes);

}  // namespace muckpile
