// SPDX-License-Identifier: GPL-2.0-or-later
// Candidate contacts between blocks: the spheres of a block pair that are near each other.
// Scope: members of BlockContactList, see its header.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/block_contact_list.h"

namespace muckpile {
namespace {

// Sphere pairs that a block pair has room for beyond those it has: little, as all are read in turn.
constexpr int kSpare = 1;
// Sphere pairs of two blocks that are looked at sooner than some of them are sorted out before.
constexpr std::size_t kFewPairs = 100;

Vec3 position(const double* positions, int sphere) {
  return Vec3::Map(positions + 3 * static_cast<std::ptrdiff_t>(sphere));
}

}  // namespace

void BlockContactList::open(std::size_t k, const SphereSet& spheres, std::vector<int>& dropped) {
  BlockPair& pair = block_pairs_[k];
  Gate& gate = gates_[k];
  if (moved(pair)) {
    look_up(pair, spheres, dropped);
  } else if (const double left = clearance_left(k); left > 0.0) {
    gate.due = std::min(pair.due, path_of(gate.first, gate.second) + left);
    return;
  }
  clearances_[k].gap = 0.0;
  gate.due = pair.due;
  gate.begin = pair.begin;
  gate.count = pair.count;
}

void BlockContactList::rest(std::size_t k, const double* positions) {
  double gap = std::numeric_limits<double>::infinity();
  for (const SpherePair& pair : candidates(k)) {
    const Vec3 between = position(positions, pair.second) - position(positions, pair.first);
    gap = std::min(gap, between.norm() - pair.reach);
  }
  if (gap > 0.0) rest(k, gap);
}

void BlockContactList::rest(std::size_t k, double gap) {
  Gate& gate = gates_[k];
  gate.due = std::min(gate.due, path_of(gate.first, gate.second) + gap);
  gate.count = 0;
  const Place& a = places_[static_cast<std::size_t>(gate.first)];
  const Place& b = places_[static_cast<std::size_t>(gate.second)];
  clearances_[k] = {gap, a.travel + b.travel, b.reference - a.reference};
}

double BlockContactList::clearance_left(std::size_t k) const {
  const Clearance& then = clearances_[k];
  if (!(then.gap > 0.0)) return 0.0;
  const Place& a = places_[static_cast<std::size_t>(gates_[k].first)];
  const Place& b = places_[static_cast<std::size_t>(gates_[k].second)];
  return then.gap - (a.travel + b.travel - then.travel) -
         (b.reference - a.reference - then.offset).norm();
}

void BlockContactList::look_up(BlockPair& pair, const SphereSet& spheres,
                               std::vector<int>& dropped) {
  const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
  pair.offset = places_[b].reference - places_[a].reference;
  pair.travel = places_[a].travel + places_[b].travel;
  pair.slack = pair.offset.norm() - extent_[a] - extent_[b];
  const double margin = kMargin * std::min(extent_[a], extent_[b]);
  near_.clear();
  if (pair.slack <= margin) list_near(pair, spheres, margin, pair.slack);
  pair.due = path_of(pair.first, pair.second) + pair.slack;
  keep_contacts(pair, dropped);
}

/// The spheres of a block.
void BlockContactList::take_all(int block, const SphereSet& spheres,
                                std::vector<Facing>& kept) const {
  const auto b = static_cast<std::size_t>(block);
  kept.clear();
  for (int m = start_[b]; m < start_[b + 1]; ++m) {
    const Member& member = members_[static_cast<std::size_t>(m)];
    kept.push_back({position(spheres.positions, member.sphere), member.radius, member.sphere});
  }
}

/// Leaves out spheres that are no nearer than the margin to the ball around another block: none of
/// them touches it before a motion of `slack`.
void BlockContactList::drop_averted(int other, double margin, double& slack,
                                    std::vector<Facing>& kept) const {
  const auto o = static_cast<std::size_t>(other);
  std::erase_if(kept, [&](const Facing& sphere) {
    const double gap = (sphere.centre - places_[o].reference).norm() - sphere.radius - extent_[o];
    if (gap >= margin) slack = std::min(slack, gap);
    return gap >= margin;
  });
}

void BlockContactList::list_near(const BlockPair& pair, const SphereSet& spheres, double margin,
                                 double& slack) {
  slack = std::numeric_limits<double>::infinity();
  take_all(pair.first, spheres, facing_first_);
  take_all(pair.second, spheres, facing_second_);
  if (facing_first_.size() * facing_second_.size() > kFewPairs) {
    drop_averted(pair.second, margin, slack, facing_first_);
    drop_averted(pair.first, margin, slack, facing_second_);
  }
  for (const Facing& a : facing_first_) {
    for (const Facing& b : facing_second_) {
      if (a.sphere >= spheres.owned && b.sphere >= spheres.owned) continue;
      const double reach = a.radius + b.radius;
      const double gap = (b.centre - a.centre).norm() - reach;
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
    pair.room = pair.count + kSpare;
    pair.begin = static_cast<int>(sphere_pairs_.size());
    sphere_pairs_.resize(sphere_pairs_.size() + static_cast<std::size_t>(pair.room));
  }
  std::copy(near_.begin(), near_.end(), sphere_pairs(pair));
}

}  // namespace muckpile
