// SPDX-License-Identifier: GPL-2.0-or-later
// What a bench would leave beyond its old toe if its burden only broke, swelled and slumped.
// Scope: plane, per metre along the row; no throw, no other rock in the way.
#pragma once

namespace muckpile {

struct CollapseShape {
  double height;     // of the bench and of the wall that stays behind the burden [m]
  double burden;     // from that wall to the old toe [m]
  double rock_area;  // solid rock of the burden above the floor, per metre of the row [m2]
  double swell;      // bulk over solid volume, >= 1
  double angle;      // at which the slumped rock rests [rad]
};

// Share of the slumped rock beyond the old toe. Its bulk, swell * rock_area, leans on the wall and
// falls to the floor at the angle of repose; it is nowhere higher than the bench, where it is level
// if there is more of it than fits under the slope. NaN if one of the figures is.
double collapsed_beyond_toe(const CollapseShape& shape);

}  // namespace muckpile
