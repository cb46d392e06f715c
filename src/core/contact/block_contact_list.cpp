// SPDX-License-Identifier: GPL-2.0-or-later
// Candidate contacts between blocks: grouping, bounding spheres, block pairs.
// Scope: see the header; the near spheres of a pair are found in near_spheres.cpp.
#include "contact/block_contact_list.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace muckpile {
namespace {

// A step turns a block by its mid-step spin, which the spin at hand meets to second order only.
constexpr double kTurnSafety = 1.1;

Vec3 position(const double* positions, int sphere) {
  return Vec3::Map(positions + 3 * static_cast<std::ptrdiff_t>(sphere));
}

}  // namespace

/// About the middle of the block's box. Where a sphere is nowhere its radius is not finite either:
/// the grid leaves the block out and counts it.
BoundingSphere BlockContactList::bound_of(const SphereSet& spheres, std::size_t block) const {
  const auto begin = members_.begin() + start_[block], end = members_.begin() + start_[block + 1];
  const auto centre = [&](const Member& m) { return position(spheres.positions, m.sphere); };
  Vec3 low = centre(*begin), high = low;
  for (auto m = begin; m != end; ++m) {
    low = low.cwiseMin((centre(*m).array() - m->radius).matrix());
    high = high.cwiseMax((centre(*m).array() + m->radius).matrix());
  }
  BoundingSphere bound{0.5 * (low + high), 0.0};
  for (auto m = begin; m != end; ++m) {
    const double distance = (centre(*m) - bound.centre).norm();
    bound.radius = std::max(bound.radius, distance + m->radius);
    if (!std::isfinite(distance)) {
      bound.radius = distance;
      break;
    }
  }
  return bound;
}

/// The reference is the sphere nearest to the middle of the block's box: its arm is short.
void BlockContactList::place_block(const SphereSet& spheres, std::size_t block,
                                   const BoundingSphere& bound) {
  const auto begin = members_.begin() + start_[block], end = members_.begin() + start_[block + 1];
  const auto centre = [&](const Member& m) { return position(spheres.positions, m.sphere); };
  const Member* nearest = &*begin;
  for (auto m = begin; m != end; ++m) {
    if ((centre(*m) - bound.centre).norm() < (centre(*nearest) - bound.centre).norm())
      nearest = &*m;
  }
  reference_[block] = nearest->sphere;
  places_[block] = {centre(*nearest), 0.0, centre(*nearest)};
  arm_[block] = extent_[block] = 0.0;
  for (auto m = begin; m != end; ++m) {
    const double arm = (centre(*m) - places_[block].reference).norm();
    arm_[block] = std::max(arm_[block], arm);
    extent_[block] = std::max(extent_[block], arm + m->radius);
  }
  if (spheres.around_bodies) arm_[block] = extent_[block];
}

void BlockContactList::group(const SphereSet& spheres, int blocks) {
  const auto n_blocks = static_cast<std::size_t>(blocks);
  outgrown_.clear();
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
    members_[static_cast<std::size_t>(--start_[b + 1])] = Member{spheres.radii[k], k};
  }
  // start_[b + 1] is now the first member of block b: shift down.
  std::move(start_.begin() + 1, start_.end(), start_.begin());
  start_[n_blocks] = static_cast<int>(members_.size());

  reference_.assign(n_blocks, -1);
  arm_.resize(n_blocks);
  extent_.resize(n_blocks);
  places_.resize(n_blocks);
  path_.assign(n_blocks, 0.0);
  block_item_.resize(n_blocks);
  item_block_.clear();
  items_.clear();
  for (int b = 0; b < blocks; ++b) {
    const auto k = static_cast<std::size_t>(b);
    if (start_[k] == start_[k + 1]) continue;
    block_item_[k] = static_cast<int>(item_block_.size());
    items_.push_back(bound_of(spheres, k));
    place_block(spheres, k, items_.back());
    item_block_.push_back(b);
  }
}

std::vector<BlockPair>& BlockContactList::find_block_pairs(double range) {
  most_range_ = range;
  fastest_ = 0.0;
  for (const int block : item_block_) places_[static_cast<std::size_t>(block)].range = range;
  pair_up();
  return block_pairs_;
}

double BlockContactList::speed_of(std::size_t block, const double* velocities,
                                  const double* spins) const {
  return position(velocities, reference_[block]).norm() +
         arm_[block] * position(spins, reference_[block]).norm();
}

double BlockContactList::range_of(std::size_t block, const double* velocities,
                                  const double* spins) const {
  const double share = fastest_ > 0.0 ? speed_of(block, velocities, spins) / fastest_ : 1.0;
  return most_range_ * std::clamp(share, kLeastShare, 1.0);
}

std::vector<BlockPair>& BlockContactList::find_block_pairs(double range, const double* velocities,
                                                           const double* spins) {
  most_range_ = range;
  fastest_ = 0.0;
  for (const int block : item_block_)
    fastest_ = std::max(fastest_, speed_of(static_cast<std::size_t>(block), velocities, spins));
  for (const int block : item_block_) {
    const auto b = static_cast<std::size_t>(block);
    places_[b].range = range_of(b, velocities, spins);
  }
  pair_up();
  return block_pairs_;
}

void BlockContactList::pair_up() {
  block_pairs_.clear();
  sphere_pairs_.clear();
  gates_.clear();
  clearances_.clear();
  added_.clear();
  added_at_.assign(reference_.size(), -1);
  added_pairs_.clear();
  swept_ = items_;
  for (std::size_t k = 0; k < swept_.size(); ++k)
    swept_[k].radius += places_[static_cast<std::size_t>(item_block_[k])].range;
  for (const IndexPair& found : grid_.find_pairs(swept_, 0.0))
    list_pair(item_block_[static_cast<std::size_t>(found.first)],
              item_block_[static_cast<std::size_t>(found.second)]);
  skipped_blocks_ = grid_.skipped();
}

void BlockContactList::list_pair(int first, int second) {
  if (!has_owned_[static_cast<std::size_t>(first)] && !has_owned_[static_cast<std::size_t>(second)])
    return;
  BlockPair pair;
  pair.first = first;
  pair.second = second;
  block_pairs_.push_back(pair);
}

bool BlockContactList::add_block_pairs(const SphereSet& spheres, const double* velocities,
                                       const double* spins) {
  const auto most = kMostAdded * static_cast<double>(item_block_.size());
  if (static_cast<double>(added_.size() + outgrown_.size()) > most) return false;
  const auto usable = [&](int block) {
    const auto b = static_cast<std::size_t>(block);
    return places_[b].reference.allFinite() && std::isfinite(range_of(b, velocities, spins));
  };
  if (!std::all_of(outgrown_.begin(), outgrown_.end(), usable)) return false;
  for (const int block : outgrown_)
    give_range(spheres, block, range_of(static_cast<std::size_t>(block), velocities, spins));
  for (const int block : outgrown_) add_partners(block);
  outgrown_.clear();
  return true;
}

void BlockContactList::give_range(const SphereSet& spheres, int block, double range) {
  const auto b = static_cast<std::size_t>(block);
  Place& place = places_[b];
  place.start = place.reference;
  place.travel_then = place.travel;
  place.range = range;
  if (added_at_[b] < 0) {
    added_at_[b] = static_cast<int>(added_.size());
    added_.push_back({});
  }
  BoundingSphere swept = bound_of(spheres, b);
  swept.radius += range;
  added_[static_cast<std::size_t>(added_at_[b])] = {swept, block};
}

/// Pairs of which both blocks could meet as they were in the search for all are listed already.
void BlockContactList::add_partners(int block) {
  const auto b = static_cast<std::size_t>(block);
  const BoundingSphere& swept = added_[static_cast<std::size_t>(added_at_[b])].swept;
  const BoundingSphere& before = swept_[static_cast<std::size_t>(block_item_[b])];
  const auto add = [&](int other) {
    const auto o = static_cast<std::size_t>(other);
    if (other == block || within(before, swept_[static_cast<std::size_t>(block_item_[o])], 0.0))
      return;
    const auto [first, second] = std::minmax(block, other);
    const auto key = static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint32_t>(second);
    if (added_pairs_.insert(key).second) list_pair(first, second);
  };
  partners_.clear();
  grid_.find_partners(swept, partners_);
  for (const int item : partners_) {
    const int other = item_block_[static_cast<std::size_t>(item)];
    if (added_at_[static_cast<std::size_t>(other)] < 0) add(other);
  }
  for (const Added& other : added_)
    if (within(swept, other.swept, 0.0)) add(other.block);
}

void BlockContactList::follow(const double* positions, const double* spins, double time_step) {
  for (std::size_t b = 0; b < places_.size(); ++b) {
    if (reference_[b] < 0) continue;
    Place& place = places_[b];
    const Vec3 now = position(positions, reference_[b]);
    const double turn = kTurnSafety * time_step * arm_[b] * position(spins, reference_[b]).norm();
    path_[b] += (now - place.reference).norm() + turn;
    place.reference = now;
    place.travel += turn;
    const double left = place.range - (place.travel - place.travel_then);
    if (left < 0.0 || (now - place.start).squaredNorm() > left * left)
      outgrown_.push_back(static_cast<int>(b));
  }
}

void BlockContactList::make_gates() {
  for (std::size_t k = gates_.size(); k < block_pairs_.size(); ++k) {
    Gate gate;
    gate.first = block_pairs_[k].first;
    gate.second = block_pairs_[k].second;
    gates_.push_back(gate);
  }
  clearances_.resize(gates_.size());
}

void BlockContactList::deactivate(std::size_t k) {
  make_gates();
  gates_[k].due = std::numeric_limits<double>::infinity();
  gates_[k].count = 0;
}

void BlockContactList::activate(std::size_t k) { gates_[k].due = Gate{}.due; }

double BlockContactList::bytes() const {
  const auto size = [](const auto& list) {
    return static_cast<double>(list.capacity() * sizeof(list[0]));
  };
  return size(start_) + size(members_) + size(reference_) + size(arm_) + size(extent_) +
         size(places_) + size(items_) + size(swept_) + size(block_pairs_) + size(gates_) +
         size(clearances_) + size(path_) + size(sphere_pairs_) + size(block_item_) +
         size(item_block_) + size(added_) + size(added_at_) + size(partners_) + size(outgrown_);
}

}  // namespace muckpile
