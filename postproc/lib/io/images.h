// SPDX-License-Identifier: GPL-2.0-or-later
// The whole blast from a model of its half or quarter: images of the blocks behind symmetry planes.
// Scope: planes x = 0 and y = 0; images stand behind the blocks of the model, in their order.
#pragma once

#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

// Adds the images of a model that is 1/symmetry of the blast: symmetry 1 none, 2 in y = 0, 4 in
// x = 0, y = 0 and both. Ids of images follow those of the model.
void add_images(std::vector<StartBlock>& blocks, int symmetry);

// How many of the blocks are the model's.
size_t modelled(const std::vector<StartBlock>& blocks);

// Fills in the states of images from those of the model.
void add_image_states(const std::vector<StartBlock>& blocks, std::vector<BlockState>& states);

}  // namespace muckpile
