// SPDX-License-Identifier: GPL-2.0-or-later
// Craters of one charge at several depths beside rules of practice.
// Scope: a table with a row per run.
#pragma once

#include <filesystem>

#include "figures/figures.h"

namespace muckpile::check {

/// Of a table with the columns charge_mass_kg, burial_depth_m, crater_radius_m, crater_volume_m3,
/// apparent_crater_depth_m (empty where rock is still in flight); rows of one depth are seeds, and
/// count by their mean. Gives
///   volume_maxima: local maxima of the volume over the depth;
///   largest_volume_at_m_kg13: the depth of the largest, over the cube root of the mass;
///   crater_radius_m_at_D, crater_volume_m3_at_D, apparent_depth_m_at_D for each depth D in
///   hundredths of m/kg^(1/3), and, where the rules have one,
///   radius_over_boreskov_at_D: over n w, n of W = K w^3 (0.4 + 0.6 n^3), K = 1.5 kg/m3 (Boreskov);
///   apparent_over_pokrovskii_at_D: over 0.33 w (2n - 1), with that n (Pokrovskii).
/// Throws InputError where there is no row, or a number is missing or out of range.
[[nodiscard]] Json crater_depths(const std::filesystem::path& table);

}  // namespace muckpile::check
