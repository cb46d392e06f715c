// SPDX-License-Identifier: GPL-2.0-or-later
// Speed of a burden against its width, v = c W^n, from runs of several widths and seeds.
// Scope: least squares of ln v over ln W; the means at 3 m, the width that the figures are quoted
// at.
#pragma once

#include <filesystem>

#include "figures/figures.h"

namespace muckpile::check {

/// From a table with a row per run: burden_m, face_velocity_m_s, wave_work_J, gas_work_J,
/// explosive_energy_J, other columns as they are. Throws InputError unless there are two widths, 3
/// m among them, and all figures are > 0.
[[nodiscard]] Json fit_burdens(const std::filesystem::path& table);

}  // namespace muckpile::check
