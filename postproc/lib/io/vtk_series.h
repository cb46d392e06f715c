// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks of every snapshot as posed polyhedra for ParaView.
// Scope: one .vtu per snapshot and a .pvd with the physical times.
#pragma once

#include "io/result_folder.h"

namespace muckpile {

// Writes vtk/blocks_<step>.vtu for every `every`-th snapshot and for the last, and vtk/blocks.pvd.
// Cell data: id, fragment_id, velocity_m_s, spin_rad_s, displacement_m, size_m, mass_kg, start_m
// (x, y, z), broken_fraction. Returns the number of snapshots written. Throws InputError if a file
// cannot be written.
int write_vtk_series(const ResultFolder& folder, int every);

}  // namespace muckpile
