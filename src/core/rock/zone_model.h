// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock by a block model: which cells are where the rock is, and whether they cover it.
// Scope: the words `block_model` and `zone NAME DENSITY model` of create_blocks.
#pragma once

#include <memory>
#include <string>

#include "rock/rock_model.h"

namespace muckpile {

/// Reads the cells, once the zones are known. Throws InputError for a file that is not as
/// rock_cells.h tells, a model without zones of it, and zones of a model that is not there.
void read_zone_model(CutOptions& options, const ArgValues& args);

/// Once the region is known: throws InputError for a model beside it, cells that overlap, and cells
/// that leave rock bare, unless the model is partial.
void lay_zone_model(CutOptions& options);

/// Throws InputError for blocks of the cut that no zone and no cell holds, unless it is partial.
void require_cells(const CutOptions& options, const RockModel& model);

/// Lines of the log; "" without a model.
[[nodiscard]] std::string describe_zone_model(const CutOptions& options);

}  // namespace muckpile
