// SPDX-License-Identifier: GPL-2.0-or-later
// Writes the blocks in their start configuration for ParaView and for muckpile-post.
// Scope: legacy ASCII VTK, one polyhedron cell per block.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/block_model.h"

namespace muckpile {

/// Cell data: id = first_id + block number, volume_m3, size_m = V^(1/3), mass_kg, on_free_face, and
/// the zone of rock of each block where `zones` has it.
/// The title line ends with run=`run_id`, if there is one. Makes the folder if needed; throws
/// InputError if the file cannot be written.
void write_blocks(const std::string& path, const std::vector<Block>& blocks, int first_id,
                  double density, const std::string& run_id = "");
/// `density`: of the rock of each zone [kg/m3]. The last blocks are muck, of the masses `muck`
/// [kg]: the cell data `muck` is 1 for them, and their faces are no free ones of the rock.
void write_blocks(const std::string& path, const std::vector<Block>& blocks, int first_id,
                  std::span<const double> density, std::span<const std::uint8_t> zones,
                  const std::string& run_id, std::span<const double> muck = {});

}  // namespace muckpile
