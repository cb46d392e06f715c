// SPDX-License-Identifier: GPL-2.0-or-later
// The directions of a run's holes: the normals of their burdens.
// Scope: from dump/holes.csv and dump/burden.csv.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "io/result_folder.h"
#include "measure/hole_frames.h"

namespace muckpile {

// None, with the reason in `missing`, where the folder does not tell them.
std::shared_ptr<const HoleFrames> hole_frames_of(const ResultFolder& folder, HolePlan plan,
                                                 std::string& missing);

}  // namespace muckpile
