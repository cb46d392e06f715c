// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: what goes to other ranks, and what goes along with blocks that change
// ranks.
// Scope: enclosed blocks by two messages of the engine; contacts through their history.
#include <atom.h>
#include <comm.h>
#include <fix_multisphere.h>

#include <algorithm>
#include <utility>

#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/engine/exchange.h"

namespace muckpile {

/// Only the rank that moves a block knows whether it is enclosed; it may have some of its spheres
/// as ghosts: what one rank has marked, all mark.
void PairMuckpileBlock::share_enclosed() {
  enclosed_.clear();
  if (joints_ == nullptr) return;
  enclosed_.resize(static_cast<std::size_t>(atom->nlocal + atom->nghost), 0);
  int last = -1;
  bool last_is_enclosed = false;
  for (std::size_t k = 0; k < enclosed_.size(); ++k) {
    const int tag = bodies_->belongs_to(static_cast<int>(k));
    if (tag < 0 || bodies_->data().map(tag) < 0) continue;
    if (tag != last) last_is_enclosed = joints_->enclosed(tag);
    last = tag;
    enclosed_[k] = last_is_enclosed ? 1 : 0;
  }
  comm->reverse_comm_pair(this);
  comm->forward_comm_pair(this);
}

/// A sphere may lie on a rank that does not move its block, and meet there a block that this rank
/// does not move either: it does not know of a facet between the two. Pairs that a facet holds and
/// that may be met so are left out by all ranks alike until the next reneighbouring.
void PairMuckpileBlock::share_joined_pairs() {
  held_pairs_.clear();
  if (joints_ == nullptr || comm->nprocs == 1) return;
  std::vector<double> guests, joined;
  for (int k = 0; k < atom->nlocal; ++k) {
    const int tag = bodies_->belongs_to(k);
    if (tag >= 0 && bodies_->data().map(tag) < 0) guests.push_back(tag);
  }
  const auto sort_out = [](auto& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  };
  sort_out(guests);
  const std::vector<double> of_all = engine::gather_all(guests, world);
  std::vector<int> away(of_all.begin(), of_all.end());
  sort_out(away);
  joints_->joined_pairs(away, joined);
  const std::vector<double> tags = engine::gather_all(joined, world);
  for (std::size_t k = 0; k < tags.size(); k += 2)
    held_pairs_.emplace_back(static_cast<int>(tags[k]), static_cast<int>(tags[k + 1]));
  sort_out(held_pairs_);
}

int PairMuckpileBlock::pack_comm(int n, int* spheres_sent, double* buffer, int, int*) {
  for (int k = 0; k < n; ++k) buffer[k] = enclosed_[static_cast<std::size_t>(spheres_sent[k])];
  return 1;
}

void PairMuckpileBlock::unpack_comm(int n, int first, double* buffer) {
  for (int k = 0; k < n; ++k)
    enclosed_[static_cast<std::size_t>(first + k)] = buffer[k] > 0.5 ? 1 : 0;
}

int PairMuckpileBlock::pack_reverse_comm(int n, int first, double* buffer) {
  for (int k = 0; k < n; ++k) buffer[k] = enclosed_[static_cast<std::size_t>(first + k)];
  return 1;
}

void PairMuckpileBlock::unpack_reverse_comm(int n, int* spheres_sent, double* buffer) {
  for (int k = 0; k < n; ++k)
    if (buffer[k] > 0.5) enclosed_[static_cast<std::size_t>(spheres_sent[k])] = 1;
}

// An inactive pair has no contacts; its spheres are looked up when it is activated again.
void PairMuckpileBlock::recall_contacts() {
  contacts_.clear();
  for (std::size_t k = 0; k < list_.block_pairs().size(); ++k) {
    if (list_.inactive(k)) continue;
    BlockPair& block_pair = list_.block_pairs()[k];
    list_.look_up(block_pair, spheres(), contacts_.free());
    for (SpherePair& pair : near_spheres(block_pair)) {
      const bool first_is_owned = pair.first < atom->nlocal;
      const int owner = first_is_owned ? pair.first : pair.second;
      const int partner = first_is_owned ? pair.second : pair.first;
      if (const ContactState* state = history_->find(owner, atom->tag[partner]))
        pair.contact = contacts_.add(*state);
    }
  }
}

// Other fixes may have deleted or moved atoms since the list was built: go by tag where they have.
void PairMuckpileBlock::store_contacts(FixMuckpileContactHistory& history) {
  list_is_stale_ = true;
  if (!contacts_moved_) return;  // the stored ones are the latest
  contacts_moved_ = false;
  const auto unmoved = [this](int k) {
    return k < atom->nlocal && atom->tag[k] == listed_tags_[static_cast<std::size_t>(k)];
  };
  std::vector<std::pair<int, int>> by_tag;
  const auto index_now = [&](int k) {
    if (k >= listed_owned_) return -1;
    if (unmoved(k)) return k;
    if (by_tag.empty()) {
      for (int a = 0; a < atom->nlocal; ++a) by_tag.emplace_back(atom->tag[a], a);
      std::sort(by_tag.begin(), by_tag.end());
    }
    const int tag = listed_tags_[static_cast<std::size_t>(k)];
    const auto place = std::lower_bound(by_tag.begin(), by_tag.end(), std::make_pair(tag, 0));
    return place != by_tag.end() && place->first == tag ? place->second : -1;
  };
  record_owners_.clear();
  records_.clear();
  for (const BlockPair& block_pair : list_.block_pairs())
    for (const SpherePair& pair : near_spheres(block_pair)) {
      if (pair.contact < 0) continue;
      const ContactState& state = contacts_[pair.contact];
      for (const auto& [owner, partner] :
           {std::pair(pair.first, pair.second), std::pair(pair.second, pair.first)})
        if (const int now = index_now(owner); now >= 0) {
          record_owners_.push_back(now);
          records_.push_back({listed_tags_[static_cast<std::size_t>(partner)], state});
        }
    }
  history.store(record_owners_, records_);
}

}  // namespace muckpile
