// SPDX-License-Identifier: GPL-2.0-or-later
// How fast the free face of a bench moves out, as a camera in front of the face would measure it.
// Scope: mass mean over the face layer at the height of the charge; the peak over the snapshots at
// hand.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/bench_planes.h"

namespace muckpile {

// Indices of the blocks that started within max(0.25 burden, one block of the free face) of the
// face, abreast of the holes, z from `low` to `high` [m]. "One block" is the mean size of the
// blocks that touch the face.
std::vector<size_t> face_layer(const std::vector<StartBlock>& blocks, double burden, double low,
                               double high, const BenchPlanes& planes = {});

// The same for bands of height, all between the floor and `height` [m] and equally high.
std::vector<std::vector<size_t>> face_bands(const std::vector<StartBlock>& blocks, double burden,
                                            double height, int bands,
                                            const BenchPlanes& planes = {});

// Mass mean of the velocity outwards [m/s]; 0 for no blocks.
double mean_outward_velocity(const std::vector<StartBlock>& blocks, const Snapshot& snapshot,
                             const std::vector<size_t>& layer, const BenchPlanes& planes = {});

}  // namespace muckpile
