// SPDX-License-Identifier: GPL-2.0-or-later
// Dilatations and bulk stresses of blocks: a group of facets at once where they hold at every
// point, others one by one.
// Scope: see the header.
#include "bond/network/dilatation_pass.h"

#include "bond/network/border_relief.h"
#include "bond/network/facet_wide.h"

namespace muckpile {

void DilatationPass::sum_openings() {
  if (leaves_resting_ && !schedule_.resting_known()) open_resting();
  const std::vector<double>& resting = schedule_.resting_sums();
  for (std::size_t b = 0; b < blocks_.sums.size(); ++b) {
    blocks_.sums[b].bonded = leaves_resting_ ? resting[b] : 0.0;
    blocks_.sums[b].loaded = 0.0;
  }
  const std::vector<LaneSet>& sets = leaves_resting_ ? schedule_.opening() : schedule_.bonded();
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (k + kGroupsAhead < sets.size()) facets_.tables.fetch_group(sets[k + kGroupsAhead].group);
    open(sets[k]);
  }
}

/// The parts of facets of which both blocks rest.
void DilatationPass::open_resting() {
  for (BlockSums& sums : blocks_.sums) sums.bonded = 0.0;
  auto moves = schedule_.opening().begin();
  const auto end = schedule_.opening().end();
  for (LaneSet set : schedule_.bonded()) {
    while (moves != end && moves->group < set.group) ++moves;
    if (moves != end && moves->group == set.group) set.lanes &= ~moves->lanes;
    if (set.lanes != 0) open(set);
  }
  schedule_.set_resting_sums(blocks_.sums);
}

/// The parts of facets in the dilatations of their blocks.
void DilatationPass::open(const LaneSet& bonded) {
  const unsigned whole = bonded.lanes & facets_.history.intact_lanes(bonded.group) &
                         ~facets_.tables.alone_lanes(bonded.group);
  const FacetGroup& group = facets_.tables.group(bonded.group);
  alignas(64) FacetRow<double> of_i{}, of_j{};
  if (whole != 0) {
    const WidePose pose = pose_of(group, blocks_.state.front());
    const WideVec turned_back = pose.sum.back(pose.jump);
    const Wide share = wide(group.area) * wide(group.bulk) * pose.scale;
    store(share * dot(wide(group.opening_i), turned_back), of_i);
    store(share * dot(wide(group.opening_j), turned_back), of_j);
  }
  for (std::size_t k = 0; k < kGroup; ++k) {
    if ((whole >> k & 1u) != 0) {
      blocks_.sums[static_cast<std::size_t>(group.i[k])].bonded += of_i[k];
      blocks_.sums[static_cast<std::size_t>(group.j[k])].bonded += of_j[k];
    } else if (bonded.has(k) && facets_.history.bonded_points(bonded.group * kGroup + k) > 0) {
      open_one(bonded.group * kGroup + k);
    }
  }
}

void DilatationPass::open_one(std::size_t f) {
  const BondConstants bond = facets_.tables.bond(f);
  const FacetMotion motion = facets_.motion(f);
  const FacetOpenings openings = facets_.openings(f, motion.scale);
  const Vec3 bonded = facets_.bonded_jump(f, motion);
  const auto [i, j] = facets_.tables.blocks_of(f);
  blocks_.sums[i].bonded += bond.area_i * openings.i.dot(bonded);
  blocks_.sums[j].bonded += bond.area_j * openings.j.dot(bonded);
}

void DilatationPass::find_theta() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) blocks_.theta[b] = blocks_.dilatation(b);
  blocks_.theta.back() = 0.0;  // the ground
}

void DilatationPass::find_bulk_stresses() {
  const bool all = !leaves_resting_ || !schedule_.resting_known();
  schedule_.set_resting_known(leaves_resting_);
  const FacetTables& tables = facets_.tables;
  const std::vector<double>& theta = blocks_.theta;
  std::vector<BlockSums>& sums = blocks_.sums;
  for (BlockSums& of_block : sums) of_block.uneven = 0.0;
  for (const LaneSet& set : all ? schedule_.bonded() : schedule_.coupled()) {
    const FacetGroup& group = tables.group(set.group);
    if (set.group + kGroupsAhead < tables.groups())
      tables.group(set.group + kGroupsAhead).fetch_couplings();
    for (std::size_t k = 0; k < kGroup; ++k) {  // nothing of those that are not bonded
      const auto i = static_cast<std::size_t>(group.i[k]), j = static_cast<std::size_t>(group.j[k]);
      const double part = group.sharpening[k] * (theta[i] - theta[j]);
      sums[i].uneven += part;
      sums[j].uneven -= part;
    }
  }
  if (!tables.borders().empty()) relieve_borders(facets_, blocks_);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!all && !schedule_.stirred(b)) continue;  // no facet that works reads it
    blocks_.bulk_stress[b] =
        blocks_.rock[b].bulk_stress(theta[b], sums[b].uneven, blocks_.stiffened_volume(b, sums[b]));
  }
  blocks_.bulk_stress.back() = 0.0;  // the ground
}

}  // namespace muckpile
