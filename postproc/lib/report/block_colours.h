// SPDX-License-Identifier: GPL-2.0-or-later
// A colour for every block, by a property that the user names, and the legend for it.
// Scope: chosen from the start blocks and one snapshot.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "io/snapshot.h"
#include "report/options.h"

namespace muckpile {

// Of muck that lay in front of the face before the blast.
inline constexpr Colour kMuck{0.36F, 0.55F, 0.55F};

struct BlockColours {
  std::vector<Colour> of_block;  // by index
  std::string label;             // what the colours show, with unit
  std::optional<ColourMap> map;  // none where colours only name things
};

// `fixed_high` ends the range of speeds [m/s] or displacements [m], so that frames share one
// legend; default: the snapshot's largest.
BlockColours block_colours(ColourBy by, const std::vector<StartBlock>& blocks,
                           const Snapshot& snapshot,
                           std::optional<double> fixed_high = std::nullopt,
                           std::optional<std::array<double, 2>> range = std::nullopt);

// A bar of the colours with end values, its upper left corner at `place` [px].
void draw_legend(const BlockColours& colours, const Vec2& place, Canvas& canvas);

}  // namespace muckpile
