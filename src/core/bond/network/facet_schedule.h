// SPDX-License-Identifier: GPL-2.0-or-later
// Which facets a pass visits: those that are not retired, those that are bonded, those of blocks
// that move.
// Scope: owned by the network; lists of facets in groups (LaneSet), in order, one row per block
// where blocks are listed. Lists may have facets too many, never too few: passes look at the
// history. They are listed anew once a quarter of the active facets has changed.
#pragma once

#include <span>
#include <vector>

#include "bond/network/block_fields.h"
#include "bond/network/facet_history.h"
#include "bond/network/facet_tables.h"

namespace muckpile {

class FacetSchedule {
 public:
  /// New blocks, none at rest.
  void reset_blocks(std::size_t count) { rests_.assign(count, 0); }
  /// Lists what is active and what is bonded. `leaning`: there are leaning faces, whose facets are
  /// not told apart by rest. `faces` are loaded where they have a hole.
  void list(const FacetTables& tables, const FacetHistory& history,
            std::span<const BoundaryFace> faces, bool leaning);
  [[nodiscard]] bool outdated() const { return 4 * changed_ > active_count_; }
  void release();  ///< drops all lists and their memory

  /// From now on facets between blocks whose entry is not 0 are left alone; one entry per block,
  /// the ground last.
  void let_rest(std::span<const int> rests);
  void wake_all() { rests_.assign(rests_.size(), 0); }
  /// Lists what rest leaves to do.
  void list_working(const FacetTables& tables, std::span<const BoundaryFace> faces, bool leaning);

  /// Not retired, or with gas.
  [[nodiscard]] const std::vector<LaneSet>& active() const { return active_; }
  /// With a point in the dilatations.
  [[nodiscard]] const std::vector<LaneSet>& bonded() const { return bonded_; }
  /// Active ones that have a block that does not rest.
  [[nodiscard]] const std::vector<LaneSet>& working() const { return working_; }
  /// Where blocks rest: bonded ones that have a block that does not.
  [[nodiscard]] const std::vector<LaneSet>& opening() const { return opening_; }
  /// Where blocks rest: bonded ones that have a block that is stirred.
  [[nodiscard]] const std::vector<LaneSet>& coupled() const { return coupled_; }
  /// Where blocks rest: it does not, or shares a bonded facet with one that does not.
  [[nodiscard]] bool stirred(std::size_t block) const { return stirred_[block] != 0; }
  [[nodiscard]] bool any_rests() const { return any_rests_; }

  /// A facet has retired or lost its last bonded point: the lists have it wrong.
  void note_change() { ++changed_; }

  /// What facets between resting blocks add to BlockSums::bonded, per block [m3]: worked out once,
  /// as those blocks stay where they are.
  [[nodiscard]] const std::vector<double>& resting_sums() const { return resting_sums_; }
  [[nodiscard]] bool resting_known() const { return resting_known_; }
  void set_resting_sums(const std::vector<BlockSums>& sums);
  /// Whether these sums and the bulk stresses of blocks at rest are those of the present pose.
  void set_resting_known(bool known) { resting_known_ = known; }

  [[nodiscard]] double bytes_of_lists() const;
  [[nodiscard]] double bytes_of_rest() const;

 private:
  void list_stirred(const FacetTables& tables, std::span<const BoundaryFace> faces, bool leaning);

  std::vector<LaneSet> bonded_, active_, working_, opening_, coupled_;
  std::vector<char> rests_, stirred_;  // per block
  std::vector<double> resting_sums_;   // per block
  bool resting_known_ = false, any_rests_ = false;
  std::size_t changed_ = 0;       // facets that the lists have wrong
  std::size_t active_count_ = 0;  // facets in active_
};

}  // namespace muckpile
