// SPDX-License-Identifier: GPL-2.0-or-later
// Candidate contacts between blocks: grouping, bounding spheres, block pairs, near spheres.
// Scope: see the header.
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

/// The reference is the sphere nearest to the middle of the block's box: its arm is short.
void BlockContactList::bound_block(const SphereSet& spheres, std::size_t block) {
  const auto begin = members_.begin() + start_[block], end = members_.begin() + start_[block + 1];
  const auto centre = [&](const Member& m) { return position(spheres.positions, m.sphere); };
  Vec3 low = centre(*begin), high = low;
  for (auto m = begin; m != end; ++m) {
    low = low.cwiseMin((centre(*m).array() - m->radius).matrix());
    high = high.cwiseMax((centre(*m).array() + m->radius).matrix());
  }
  BoundingSphere bound{0.5 * (low + high), 0.0};
  const Member* nearest = &*begin;
  for (auto m = begin; m != end; ++m) {
    const double distance = (centre(*m) - bound.centre).norm();
    if (distance < (centre(*nearest) - bound.centre).norm()) nearest = &*m;
    bound.radius = std::max(bound.radius, distance + m->radius);
    if (!std::isfinite(distance)) {
      bound.radius = distance;  // the grid leaves the block out and counts it
      break;
    }
  }
  items_.push_back(bound);
  reference_[block] = nearest->sphere;
  places_[block] = {centre(*nearest), 0.0, centre(*nearest)};
  arm_[block] = extent_[block] = 0.0;
  for (auto m = begin; m != end; ++m) {
    const double arm = (centre(*m) - places_[block].reference).norm();
    arm_[block] = std::max(arm_[block], arm);
    extent_[block] = std::max(extent_[block], arm + m->radius);
  }
}

void BlockContactList::group(const SphereSet& spheres, int blocks) {
  const auto n_blocks = static_cast<std::size_t>(blocks);
  drift_ = 0.0;
  outgrown_ = false;
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
  item_block_.clear();
  items_.clear();
  for (int b = 0; b < blocks; ++b) {
    const auto k = static_cast<std::size_t>(b);
    if (start_[k] == start_[k + 1]) continue;
    bound_block(spheres, k);
    item_block_.push_back(b);
  }
}

std::vector<BlockPair>& BlockContactList::find_block_pairs(double range) {
  for (const int block : item_block_) places_[static_cast<std::size_t>(block)].range = range;
  pair_up();
  return block_pairs_;
}

std::vector<BlockPair>& BlockContactList::find_block_pairs(double range, const double* velocities,
                                                           const double* spins) {
  const auto speed = [&](std::size_t b) {
    return position(velocities, reference_[b]).norm() +
           arm_[b] * position(spins, reference_[b]).norm();
  };
  double fastest = 0.0;
  for (const int block : item_block_)
    fastest = std::max(fastest, speed(static_cast<std::size_t>(block)));
  for (const int block : item_block_) {
    const auto b = static_cast<std::size_t>(block);
    const double share = fastest > 0.0 ? speed(b) / fastest : 1.0;
    places_[b].range = range * std::max(share, kLeastShare);
  }
  pair_up();
  return block_pairs_;
}

void BlockContactList::pair_up() {
  block_pairs_.clear();
  sphere_pairs_.clear();
  rest_.clear();
  swept_ = items_;
  for (std::size_t k = 0; k < swept_.size(); ++k)
    swept_[k].radius += places_[static_cast<std::size_t>(item_block_[k])].range;
  for (const IndexPair& found : grid_.find_pairs(swept_, 0.0)) {
    BlockPair pair;
    pair.first = item_block_[static_cast<std::size_t>(found.first)];
    pair.second = item_block_[static_cast<std::size_t>(found.second)];
    if (has_owned_[static_cast<std::size_t>(pair.first)] ||
        has_owned_[static_cast<std::size_t>(pair.second)])
      block_pairs_.push_back(pair);
  }
  skipped_blocks_ = grid_.skipped();
}

void BlockContactList::follow(const double* positions, const double* spins, double time_step) {
  Vec3 least = Vec3::Constant(std::numeric_limits<double>::infinity()), most = -least;
  double turned = 0.0;
  for (std::size_t b = 0; b < places_.size(); ++b) {
    if (reference_[b] < 0) continue;
    Place& place = places_[b];
    const Vec3 now = position(positions, reference_[b]);
    const Vec3 step = now - place.reference;
    const double turn = kTurnSafety * time_step * arm_[b] * position(spins, reference_[b]).norm();
    place.reference = now;
    place.travel += turn;
    least = least.cwiseMin(step);
    most = most.cwiseMax(step);
    turned = std::max(turned, turn);
    const double left = place.range - place.travel;
    if (left < 0.0 || (now - place.start).squaredNorm() > left * left) outgrown_ = true;
  }
  if (least.x() <= most.x()) drift_ += (most - least).norm() + 2.0 * turned;
}

void BlockContactList::look_up(BlockPair& pair, const SphereSet& spheres,
                               std::vector<int>& dropped) {
  const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
  pair.offset = places_[b].reference - places_[a].reference;
  pair.travel = places_[a].travel + places_[b].travel;
  pair.slack = pair.offset.norm() - extent_[a] - extent_[b];
  const double margin = kMargin * std::min(extent_[a], extent_[b]);
  near_.clear();
  pair.due = drift_;
  if (pair.slack <= margin) list_near(pair, spheres, margin, pair.slack);
  keep_contacts(pair, dropped);
}

void BlockContactList::list_near(const BlockPair& pair, const SphereSet& spheres, double margin,
                                 double& slack) {
  slack = std::numeric_limits<double>::infinity();
  const auto members = [this](int block) {
    const auto b = static_cast<std::size_t>(block);
    return std::span(members_).subspan(static_cast<std::size_t>(start_[b]),
                                       static_cast<std::size_t>(start_[b + 1] - start_[b]));
  };
  for (const Member& a : members(pair.first)) {
    const Vec3 centre = position(spheres.positions, a.sphere);
    for (const Member& b : members(pair.second)) {
      if (a.sphere >= spheres.owned && b.sphere >= spheres.owned) continue;
      const double reach = a.radius + b.radius;
      const double gap = (position(spheres.positions, b.sphere) - centre).norm() - reach;
      if (gap >= margin) {
        slack = std::min(slack, gap);
        continue;
      }
      const bool in_order = spheres.tags[a.sphere] < spheres.tags[b.sphere];
      near_.push_back(in_order ? SpherePair{a.sphere, b.sphere, -1, reach}
                               : SpherePair{b.sphere, a.sphere, -1, reach});
    }
  }
}

/// Puts near_ in the pair's place, with the contacts of the spheres that were listed there before.
void BlockContactList::keep_contacts(BlockPair& pair, std::vector<int>& dropped) {
  for (int k = 0; k < pair.count; ++k) {
    const SpherePair& old = sphere_pairs(pair)[k];
    if (old.contact < 0) continue;
    const auto same = std::find_if(near_.begin(), near_.end(), [&](const SpherePair& p) {
      return p.first == old.first && p.second == old.second;
    });
    if (same != near_.end())
      same->contact = old.contact;
    else
      dropped.push_back(old.contact);
  }
  pair.count = static_cast<int>(near_.size());
  if (pair.count > pair.room) {
    pair.room = 2 * pair.count;
    pair.begin = static_cast<int>(sphere_pairs_.size());
    sphere_pairs_.resize(sphere_pairs_.size() + static_cast<std::size_t>(pair.room));
  }
  std::copy(near_.begin(), near_.end(), sphere_pairs(pair));
}

double BlockContactList::bytes() const {
  const auto size = [](const auto& list) {
    return static_cast<double>(list.capacity() * sizeof(list[0]));
  };
  return size(start_) + size(members_) + size(reference_) + size(arm_) + size(extent_) +
         size(places_) + size(items_) + size(swept_) + size(block_pairs_) + size(rest_) +
         size(sphere_pairs_);
}

}  // namespace muckpile
