// SPDX-License-Identifier: GPL-2.0-or-later
// Impulses on blocks by cause.
// Scope: see the header.
#include "motion/impulse_sums.h"

#include <algorithm>

namespace muckpile {

std::span<ByPart> ImpulseSums::forces_on(std::span<const int> tags) {
  forces_.assign(tags.size(), {});
  if (std::ranges::equal(tags, tags_)) return forces_;
  tags_.assign(tags.begin(), tags.end());
  places_.clear();
  for (const int tag : tags) {
    const auto [place, fresh] = row_of_.emplace(tag, rows_.size());
    if (fresh) rows_.push_back({tag, {}});
    places_.push_back(place->second);
  }
  return forces_;
}

void ImpulseSums::begin(std::span<const Vec3> momenta) {
  for (std::size_t b = 0; b < momenta.size(); ++b)
    rows_[places_[b]].impulse[ImpulsePart::before] = momenta[b];
}

void ImpulseSums::kick(double half) {
  for (std::size_t b = 0; b < forces_.size(); ++b) rows_[places_[b]].impulse.add(forces_[b], half);
}

std::vector<ImpulseRow> added_up(std::vector<ImpulseRow> rows) {
  std::ranges::stable_sort(rows, {}, &ImpulseRow::tag);
  std::vector<ImpulseRow> blocks;
  for (const ImpulseRow& row : rows) {
    if (blocks.empty() || blocks.back().tag != row.tag)
      blocks.push_back(row);
    else
      blocks.back().impulse.add(row.impulse);
  }
  return blocks;
}

}  // namespace muckpile
