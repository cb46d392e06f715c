// SPDX-License-Identifier: GPL-2.0-or-later
// Candidate contacts between blocks: grouping, bounding spheres, block pairs, sphere pairs.
// Scope: see the header.
#include "contact/block_contact_list.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muckpile {

void BlockContactList::bound_block(int block) {
  const auto b = static_cast<std::size_t>(block);
  const auto begin = static_cast<std::size_t>(start_[b]);
  const auto end = static_cast<std::size_t>(start_[b + 1]);
  Vec3 low = members_[begin].centre.array() - members_[begin].radius;
  Vec3 high = members_[begin].centre.array() + members_[begin].radius;
  for (std::size_t m = begin; m < end; ++m) {
    low = low.cwiseMin((members_[m].centre.array() - members_[m].radius).matrix());
    high = high.cwiseMax((members_[m].centre.array() + members_[m].radius).matrix());
  }
  BoundingSphere bound{0.5 * (low + high), 0.0};
  for (std::size_t m = begin; m < end; ++m) {
    const double reach = (members_[m].centre - bound.centre).norm() + members_[m].radius;
    bound.radius = std::max(bound.radius, reach);
    if (!std::isfinite(reach)) {
      bound.radius = reach;  // the grid leaves the block out and counts it
      break;
    }
  }
  bounds_[b] = bound;
}

void BlockContactList::group(const SphereSet& spheres, int blocks) {
  const auto n_blocks = static_cast<std::size_t>(blocks);
  start_.assign(n_blocks + 1, 0);
  has_owned_.assign(n_blocks, 0);
  for (int k = 0; k < spheres.count; ++k) {
    if (spheres.blocks[k] < 0) continue;
    const auto b = static_cast<std::size_t>(spheres.blocks[k]);
    ++start_[b + 1];
    if (k < spheres.owned) has_owned_[b] = 1;
  }
  for (std::size_t b = 0; b < n_blocks; ++b) start_[b + 1] += start_[b];
  members_.resize(static_cast<std::size_t>(start_[n_blocks]));
  for (int k = spheres.count - 1; k >= 0; --k) {  // backwards, start_ counts down and up again
    if (spheres.blocks[k] < 0) continue;
    const auto b = static_cast<std::size_t>(spheres.blocks[k]);
    const double* x = spheres.positions + 3 * k;
    members_[static_cast<std::size_t>(--start_[b + 1])] =
        Member{Vec3(x[0], x[1], x[2]), spheres.radii[k], k};
  }
  // start_[b + 1] is now the first member of block b: shift down.
  std::move(start_.begin() + 1, start_.end(), start_.begin());
  start_[n_blocks] = static_cast<int>(members_.size());

  bounds_.resize(n_blocks);
  item_block_.clear();
  items_.clear();
  for (int b = 0; b < blocks; ++b) {
    const auto k = static_cast<std::size_t>(b);
    if (start_[k] == start_[k + 1]) continue;
    bound_block(b);
    item_block_.push_back(b);
    items_.push_back(bounds_[k]);
  }
}

std::vector<BlockPair>& BlockContactList::find_block_pairs(double gap) {
  block_pairs_.clear();
  for (const IndexPair& pair : grid_.find_pairs(items_, gap)) {
    const int a = item_block_[static_cast<std::size_t>(pair.first)];
    const int b = item_block_[static_cast<std::size_t>(pair.second)];
    if (has_owned_[static_cast<std::size_t>(a)] || has_owned_[static_cast<std::size_t>(b)])
      block_pairs_.push_back(BlockPair{a, b, -1, 0, 0});
  }
  skipped_blocks_ = grid_.skipped();
  return block_pairs_;
}

void BlockContactList::members_near(int block, const BoundingSphere& other, double gap,
                                    std::vector<Member>& out) const {
  out.clear();
  const auto b = static_cast<std::size_t>(block);
  for (int m = start_[b]; m < start_[b + 1]; ++m) {
    const Member& member = members_[static_cast<std::size_t>(m)];
    const double limit = member.radius + other.radius + gap;
    if ((member.centre - other.centre).squaredNorm() < limit * limit) out.push_back(member);
  }
}

void BlockContactList::find_sphere_pairs(const SphereSet& spheres, double gap) {
  sphere_pairs_.clear();
  std::size_t kept = 0;
  for (const BlockPair& pair : block_pairs_) {
    members_near(pair.first, bounds_[static_cast<std::size_t>(pair.second)], gap, near_first_);
    if (near_first_.empty()) continue;
    members_near(pair.second, bounds_[static_cast<std::size_t>(pair.first)], gap, near_second_);
    const int begin = static_cast<int>(sphere_pairs_.size());
    for (const Member& a : near_first_)
      for (const Member& b : near_second_) {
        const double reach = a.radius + b.radius;
        if (!((a.centre - b.centre).squaredNorm() < (reach + gap) * (reach + gap))) continue;
        if (a.sphere >= spheres.owned && b.sphere >= spheres.owned) continue;
        const bool in_order = spheres.tags[a.sphere] < spheres.tags[b.sphere];
        sphere_pairs_.push_back(in_order ? SpherePair{a.sphere, b.sphere, -1, reach}
                                         : SpherePair{b.sphere, a.sphere, -1, reach});
      }
    const int end = static_cast<int>(sphere_pairs_.size());
    if (end == begin) continue;
    block_pairs_[kept++] = BlockPair{pair.first, pair.second, pair.facet, begin, end};
  }
  block_pairs_.resize(kept);
}

}  // namespace muckpile
