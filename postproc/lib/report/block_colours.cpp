// SPDX-License-Identifier: GPL-2.0-or-later
// A colour for every block, and the legend for it.
// Scope: see the header.
#include "report/block_colours.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "args/input_error.h"
#include "draw/axes.h"
#include "draw/text.h"

namespace muckpile {
namespace {

constexpr double kThick = 16.0, kTextSize = 18.0;  // of the legend [px]

ColourMap map_of(FieldScale scale, double low, double high) {
  if (scale == FieldScale::kOrigin) return strata_map(low, high);
  if (scale == FieldScale::kSigned) return difference_map(high);
  return amount_map(low, high);
}

// The ends of the colours where the user sets none.
std::array<double, 2> range_of(const BlockField& field, const ValueRange& extremes) {
  const auto [least, largest] = std::ranges::minmax(field.of_rock());
  const auto [low, high] = extremes.value_or(std::array{least, largest});
  if (field.scale == FieldScale::kShare) return {0.0, 1.0};
  if (field.scale == FieldScale::kFromZero) return {0.0, high};
  const double reach = std::max(std::abs(low), std::abs(high));
  if (field.scale == FieldScale::kSigned) return {-reach, reach};
  return {low, high};
}

void add_names(const BlockField& field, BlockColours& colours) {
  for (const double value : field.values)
    colours.of_block.push_back(colour_of_name(static_cast<int>(value)));
  std::set<int> there;
  if (!field.names.empty())
    for (const double value : field.of_rock()) there.insert(static_cast<int>(value));
  for (const int value : there)
    colours.names.emplace_back(colour_of_name(value), field.names.at(value));
}

void paint_muck(const BlockField& field, BlockColours& colours) {
  for (size_t b = field.values.size() - field.muck; b < field.values.size(); ++b)
    colours.of_block[b] = kMuck;
}

// In rows as long as the bar is; what does not fit into two of them is counted.
void draw_names(const BlockColours& colours, const Vec2& place, double length, Canvas& canvas) {
  constexpr double kGap = 8.0;
  constexpr int kRows = 2;
  Vec2 at = place + Vec2(0.0, 1.6 * kTextSize);
  int row = 0;
  for (size_t k = 0; k < colours.names.size(); ++k) {
    const auto& [colour, name] = colours.names[k];
    const double size = fitting_size(name, kTextSize, length - kThick - 0.5 * kGap);
    const double wide = kThick + 0.5 * kGap + text_mask(name, size, 0.0).advance.x() + 1.5 * kGap;
    const bool ends_row = at.x() + wide > place.x() + length + 1.5 * kGap && at.x() > place.x();
    if (ends_row && ++row < kRows) at = {place.x(), at.y() + 1.3 * kTextSize};
    if (row == kRows) {
      canvas.text({at.x(), at.y() + 0.85 * kThick},
                  std::string("+").append(std::to_string(colours.names.size() - k)), kTextSize,
                  kInk);
      return;
    }
    canvas.rectangle(at, at + Vec2(kThick, kThick), colour);
    canvas.text(at + Vec2(kThick + 0.5 * kGap, 0.85 * kThick), name, size, kInk);
    at.x() += wide;
  }
}

// Of both ends of a bar and of its middle, the latter if there is room.
void draw_numbers(double low, double high, const Vec2& place, double length, Canvas& canvas) {
  constexpr double kGap = 8.0;
  const std::string first = spelled(low), middle = spelled(0.5 * (low + high)),
                    last = spelled(high);
  const auto long_is = [](const std::string& number) {
    return text_mask(number, kTextSize, 0.0).advance.x();
  };
  canvas.text(place, first, kTextSize, kInk);
  canvas.text(place + Vec2(length, 0.0), last, kTextSize, kInk, Anchor::kRight);
  if (0.5 * (length - long_is(middle)) > std::max(long_is(first), long_is(last)) + kGap)
    canvas.text(place + Vec2(0.5 * length, 0.0), middle, kTextSize, kInk, Anchor::kCentre);
}

}  // namespace

BlockColours block_colours(const BlockField& field, const ValueRange& extremes,
                           const ValueRange& range) {
  BlockColours colours{{}, field.label, std::nullopt};
  if (field.scale == FieldScale::kNames) {
    if (range)
      refuse("render", "--colour-range has no meaning for colours that name things, as those of " +
                           field.column);
    add_names(field, colours);
    paint_muck(field, colours);
    return colours;
  }
  const auto [low, high] = range.value_or(range_of(field, extremes));
  // Both ends of a range that the user sets count; a signed one without 0 in its middle is one more
  // amount.
  const bool lopsided = field.scale == FieldScale::kSigned && low != -high;
  colours.map = lopsided ? amount_map(low, high) : map_of(field.scale, low, high);
  for (const double value : field.values) colours.of_block.push_back(colours.map->at(value));
  paint_muck(field, colours);
  return colours;
}

void draw_legend(const BlockColours& colours, const Vec2& place, Canvas& canvas, double length) {
  constexpr int kSteps = 60;
  canvas.text(place + Vec2(0.0, kTextSize), colours.label,
              fitting_size(colours.label, kTextSize, length), kInk);
  if (!colours.map) {
    draw_names(colours, place, length, canvas);
    return;
  }
  const Vec2 bar = place + Vec2(0.0, 1.6 * kTextSize);
  const double low = colours.map->low(), high = colours.map->high();
  for (int k = 0; k < kSteps; ++k) {
    const Vec2 corner = bar + Vec2(length * k / kSteps, 0.0);
    canvas.rectangle(corner, corner + Vec2(length / kSteps + 0.34, kThick),
                     colours.map->at(low + (high - low) * (k + 0.5) / kSteps));
  }
  draw_numbers(low, high, bar + Vec2(0.0, kThick + 1.15 * kTextSize), length, canvas);
}

}  // namespace muckpile
