// SPDX-License-Identifier: GPL-2.0-or-later
// A colour for every block, by a field that the user names, and the legend for it.
// Scope: fields are those of report/block_fields.h.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "draw/canvas.h"
#include "report/block_fields.h"

namespace muckpile {

// Of muck that lay in front of the face before the blast.
inline constexpr Colour kMuck{0.36F, 0.55F, 0.55F};

struct BlockColours {
  std::vector<Colour> of_block;                         // by index
  std::string label;                                    // what the colours show, with unit
  std::optional<ColourMap> map;                         // none where colours only name things
  std::vector<std::pair<Colour, std::string>> names{};  // of what they name, where it has names
};

// `extremes` are the least and the largest value that the colours are made for, so that frames
// share one legend; default: the field's. `range` replaces both ends; throws InputError for fields
// of names.
using ValueRange = std::optional<std::array<double, 2>>;
BlockColours block_colours(const BlockField& field, const ValueRange& extremes = std::nullopt,
                           const ValueRange& range = std::nullopt);

inline constexpr double kLegendLength = 300.0;  // [px]

// A bar of the colours with end values, or the names, its upper left corner at `place`, both as
// long as `length` [px]; longer words are set smaller.
void draw_legend(const BlockColours& colours, const Vec2& place, Canvas& canvas,
                 double length = kLegendLength);

}  // namespace muckpile
