// SPDX-License-Identifier: GPL-2.0-or-later
// Faults: surfaces through the rock whose facets have a joint law of their own.
// Scope: triangles from files, open or closed, in mine coordinates or those of the run. The cut
// follows those that are plane; along others facets are steps of a block.
#pragma once

#include <string>

#include "rock/rock_model.h"

namespace muckpile {

/// How far a fault may lie off its plane for the cut to follow that, over block_min. Ours: blocks
/// beside it keep their centroid on their side.
inline constexpr double kFlatFault = 0.1;

/// Reads the words and the files. Throws InputError as the readers do, and for points.
void read_faults(CutOptions& options, const ArgValues& args);

/// Once the region is known: adds their planes to those that the cut follows. Throws InputError for
/// a fault beside the region.
void lay_faults(CutOptions& options);

/// Facets between blocks whose centroids lie on two sides of a fault get its class, whatever class
/// they have; the first fault wins.
void assign_fault_classes(const CutOptions& options, int first_tag, RockModel& model);

/// Lines of the log; "" without faults.
[[nodiscard]] std::string describe_faults(const CutOptions& options, const RockModel& model);

}  // namespace muckpile
