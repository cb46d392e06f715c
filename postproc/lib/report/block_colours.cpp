// SPDX-License-Identifier: GPL-2.0-or-later
// A colour for every block, by a property that the user names, and the legend for it.
// Scope: chosen from the start blocks and one snapshot.
#include "report/block_colours.h"

#include <algorithm>
#include <span>

#include "args/input_error.h"
#include "draw/axes.h"
#include "io/muck.h"
#include "report/block_values.h"

namespace muckpile {
namespace {

struct ColourFacts {
  const char *label, *column;
};

ColourFacts facts_of(ColourBy by) {
  switch (by) {
    case ColourBy::kStartHeight:
      return {"height before the blast [m]", "start_height_m"};
    case ColourBy::kStartDepth:
      return {"distance behind x = 0 before the blast [m]", "start_depth_m"};
    case ColourBy::kSize:
      return {"block size [m]", "size_m"};
    case ColourBy::kSpeed:
      return {"speed [m/s]", "speed_m_s"};
    case ColourBy::kDisplacement:
      return {"displacement [m]", "displacement_m"};
    case ColourBy::kBroken:
      return {"broken share of joint area", "broken_fraction"};
    case ColourBy::kFragment:
      break;
  }
  return {"one colour per fragment", "fragment_id"};
}

void paint_muck(const std::vector<StartBlock>& blocks, BlockColours& colours) {
  for (size_t b = 0; b < blocks.size(); ++b)
    if (is_muck(blocks[b])) colours.of_block[b] = kMuck;
}

ColourMap map_of(ColourBy by, double low, double high) {
  const bool origin = by == ColourBy::kStartHeight || by == ColourBy::kStartDepth;
  return origin ? strata_map(low, high) : amount_map(low, high);
}

}  // namespace

double block_value(ColourBy by, const StartBlock& block, const BlockState& state) {
  switch (by) {
    case ColourBy::kStartHeight:
      return block.centroid.z();
    case ColourBy::kStartDepth:
      return -block.centroid.x();
    case ColourBy::kSize:
      return block.size;
    case ColourBy::kSpeed:
      return state.velocity.norm();
    case ColourBy::kDisplacement:
      return (state.centre - block.centroid).norm();
    case ColourBy::kBroken:
      return state.broken_fraction;
    case ColourBy::kFragment:
      break;
  }
  return state.fragment;
}

const char* column_of(ColourBy by) { return facts_of(by).column; }

BlockColours block_colours(ColourBy by, const std::vector<StartBlock>& blocks,
                           const Snapshot& snapshot, std::optional<double> fixed_high,
                           std::optional<std::array<double, 2>> range) {
  std::vector<double> values;
  for (size_t b = 0; b < blocks.size(); ++b)
    values.push_back(block_value(by, blocks[b], snapshot.states[b]));
  BlockColours colours{{}, facts_of(by).label, std::nullopt};
  if (by == ColourBy::kFragment) {
    if (range) refuse("render", "--colour-range has no meaning for the colours of fragments");
    for (const double value : values)
      colours.of_block.push_back(colour_of_name(static_cast<int>(value)));
    paint_muck(blocks, colours);
    return colours;
  }
  const auto rock = std::span<const double>(values).first(rock_blocks(blocks));
  const auto [low, high] =
      std::ranges::minmax(rock.empty() ? std::span<const double>(values) : rock);
  const bool share = by == ColourBy::kBroken;
  const bool from_zero = share || by == ColourBy::kSpeed || by == ColourBy::kDisplacement;
  colours.map = map_of(by, from_zero ? 0.0 : low, share ? 1.0 : fixed_high.value_or(high));
  if (range) colours.map = map_of(by, (*range)[0], (*range)[1]);
  for (const double value : values) colours.of_block.push_back(colours.map->at(value));
  paint_muck(blocks, colours);
  return colours;
}

void draw_legend(const BlockColours& colours, const Vec2& place, Canvas& canvas) {
  constexpr double kLength = 300.0, kThick = 16.0, kTextSize = 18.0;
  constexpr int kSteps = 60;
  canvas.text(place + Vec2(0.0, kTextSize), colours.label, kTextSize, kInk);
  if (!colours.map) return;
  const Vec2 bar = place + Vec2(0.0, 1.6 * kTextSize);
  const double low = colours.map->low(), high = colours.map->high();
  for (int k = 0; k < kSteps; ++k) {
    const Vec2 corner = bar + Vec2(kLength * k / kSteps, 0.0);
    canvas.rectangle(corner, corner + Vec2(kLength / kSteps + 0.34, kThick),
                     colours.map->at(low + (high - low) * (k + 0.5) / kSteps));
  }
  const double under = kThick + 1.15 * kTextSize;
  canvas.text(bar + Vec2(0.0, under), spelled(low), kTextSize, kInk);
  canvas.text(bar + Vec2(0.5 * kLength, under), spelled(0.5 * (low + high)), kTextSize, kInk,
              Anchor::kCentre);
  canvas.text(bar + Vec2(kLength, under), spelled(high), kTextSize, kInk, Anchor::kRight);
}

}  // namespace muckpile
