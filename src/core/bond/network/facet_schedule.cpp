// SPDX-License-Identifier: GPL-2.0-or-later
// Which facets a pass visits: making the lists.
// Scope: see the header.
#include "bond/network/facet_schedule.h"

#include <algorithm>

namespace muckpile {

void FacetSchedule::release() {
  bonded_ = {}, active_ = {}, working_ = {}, opening_ = {}, coupled_ = {};
}

void FacetSchedule::list(const FacetTables& tables, const FacetHistory& history,
                         std::span<const BoundaryFace> faces, bool leaning) {
  for (auto* sets : {&active_, &bonded_, &working_}) {
    sets->clear();
    sets->reserve(tables.groups());
  }
  active_count_ = 0;
  for (std::size_t f = 0; f < history.size(); ++f) {
    if (!history.traces(f).over()) {
      add_facet(active_, f);
      ++active_count_;
    }
    if (history.bonded_points(f) > 0) add_facet(bonded_, f);
  }
  changed_ = 0;
  list_working(tables, faces, leaning);
}

void FacetSchedule::let_rest(std::span<const int> rests) {
  for (std::size_t b = 0; b < rests_.size(); ++b) rests_[b] = rests[b] != 0 ? 1 : 0;
}

void FacetSchedule::list_working(const FacetTables& tables, std::span<const BoundaryFace> faces,
                                 bool leaning) {
  working_.clear();
  each_facet(active_, [&](std::size_t f) {
    const auto [i, j] = tables.blocks_of(f);
    if (rests_[i] == 0 || rests_[j] == 0) add_facet(working_, f);
  });
  list_stirred(tables, faces, leaning);
}

/// Blocks at rest stay where they are, and what their facets add to their dilatations stays too.
void FacetSchedule::list_stirred(const FacetTables& tables, std::span<const BoundaryFace> faces,
                                 bool leaning) {
  resting_known_ = false;
  any_rests_ = !leaning && !rests_.empty() && std::count(rests_.begin(), rests_.end() - 1, 1) > 0;
  if (!any_rests_) return;
  stirred_.assign(rests_.size(), 0);
  opening_.clear();
  coupled_.clear();
  each_facet(bonded_, [&](std::size_t f) {
    const auto [i, j] = tables.blocks_of(f);
    if (rests_[i] != 0 && rests_[j] != 0) return;
    add_facet(opening_, f);
    stirred_[i] = stirred_[j] = 1;
  });
  for (const BoundaryFace& face : faces)
    if (face.hole >= 0) stirred_[static_cast<std::size_t>(face.block)] = 1;
  stirred_.back() = 0;  // the ground
  each_facet(bonded_, [&](std::size_t f) {
    const auto [i, j] = tables.blocks_of(f);
    if (stirred_[i] != 0 || stirred_[j] != 0) add_facet(coupled_, f);
  });
}

void FacetSchedule::set_resting_sums(const std::vector<BlockSums>& sums) {
  resting_sums_.resize(sums.size());
  for (std::size_t b = 0; b < sums.size(); ++b) resting_sums_[b] = sums[b].bonded;
}

double FacetSchedule::bytes_of_lists() const {
  std::size_t sets = 0;
  for (const auto* list : {&bonded_, &active_, &working_, &opening_, &coupled_})
    sets += list->capacity();
  return static_cast<double>(sets * sizeof(LaneSet));
}

double FacetSchedule::bytes_of_rest() const {
  return static_cast<double>(rests_.capacity() + stirred_.capacity() +
                             resting_sums_.capacity() * sizeof(double));
}

}  // namespace muckpile
