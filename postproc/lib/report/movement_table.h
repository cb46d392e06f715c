// SPDX-License-Identifier: GPL-2.0-or-later
// The columns in which tables of movement say how rock has moved.
// Scope: they stand behind those that name the rock.
#pragma once

#include <vector>

#include "measure/movement.h"

namespace muckpile {

inline constexpr const char* kMovementColumns =
    "blocks,mass_kg,broken_out_fraction,start_x_m,start_y_m,start_z_m,end_x_m,end_y_m,end_z_m,"
    "moved_x_m,moved_y_m,moved_z_m,moved_m,spread_m";

std::vector<double> movement_columns(const RockMovement& rock);

}  // namespace muckpile
