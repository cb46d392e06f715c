// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style muckpile/block: which blocks there are and which pairs of them are worked through.
// Scope: at reneighbouring, and as joints let go or blocks come to rest; the search itself is
// core's.
#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <fix_multisphere.h>
#include <mpi.h>
#include <neighbor.h>
#include <update.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/contact/solid_parts.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"

namespace muckpile {

int PairMuckpileBlock::add_block(int body_tag, int sphere) {
  const double* x = atom->x[sphere];
  block_tag_.push_back(body_tag);
  seed_.push_back({x[0], x[1], x[2]});
  first_sphere_.push_back(sphere);
  next_image_.push_back(-1);
  return static_cast<int>(block_tag_.size()) - 1;
}

// Spheres of one body form one block; its periodic images are blocks of their own, told apart by
// their distance: a body is smaller than half the box.
int PairMuckpileBlock::block_of(int body_tag, int sphere) {
  const double* x = atom->x[sphere];
  const auto tag = static_cast<std::size_t>(body_tag);
  if (tag >= first_image_.size()) first_image_.resize(tag + 1, -1);
  int last = -1;
  for (int b = first_image_[tag]; b >= 0; b = next_image_[static_cast<std::size_t>(b)]) {
    const std::array<double, 3>& seed = seed_[static_cast<std::size_t>(b)];
    bool same = true;
    for (std::size_t d = 0; d < 3; ++d)
      same =
          same && !(domain->periodicity[d] != 0 && std::abs(x[d] - seed[d]) > 0.5 * domain->prd[d]);
    if (same) return b;
    last = b;
  }
  const int block = add_block(body_tag, sphere);
  (last < 0 ? first_image_[tag] : next_image_[static_cast<std::size_t>(last)]) = block;
  return block;
}

// Gives every sphere its block. Blocks that nothing outside can touch, because all their joints
// hold and none of their faces is free, take no part; neither do spheres without a body.
void PairMuckpileBlock::number_blocks() {
  const int count = atom->nlocal + atom->nghost;
  std::fill(first_image_.begin(), first_image_.end(), -1);
  block_tag_.clear();
  seed_.clear();
  first_sphere_.clear();
  next_image_.clear();
  atom_block_.assign(static_cast<std::size_t>(count), -1);
  for (int k = 0; k < count; ++k) {
    const int tag = bodies_->belongs_to(k);
    if (tag >= 0) atom_block_[static_cast<std::size_t>(k)] = block_of(tag, k);
  }
  for (std::size_t k = 0; k < enclosed_.size(); ++k)
    if (enclosed_[k] != 0) atom_block_[k] = -1;
  if (solids_ != nullptr)
    solids_->blocks.keep_keys(*atom, block_tag_, *solids_->shapes, atom_block_);
}

// A pair whose facet is cracked stays, inactive; but not one that some rank works on without
// knowing the facet.
void PairMuckpileBlock::drop_intact_pairs(std::vector<BlockPair>& pairs,
                                          std::size_t first_pair) const {
  const FacetState* states = joints_ != nullptr ? joints_->facet_states() : nullptr;
  const auto from = pairs.begin() + static_cast<std::ptrdiff_t>(first_pair);
  const auto kept = std::remove_if(from, pairs.end(), [&](BlockPair& pair) {
    const int first = block_tag_[static_cast<std::size_t>(pair.first)];
    const int second = block_tag_[static_cast<std::size_t>(pair.second)];
    if (first == second) return true;  // periodic images of one body
    if (joints_ == nullptr) return false;
    if (std::binary_search(held_pairs_.begin(), held_pairs_.end(),
                           std::pair<int, int>(std::minmax(first, second))))
      return true;
    pair.facet = joints_->facet_between(first, second);
    return pair.facet >= 0 && states[pair.facet] == FacetState::intact;
  });
  pairs.erase(kept, pairs.end());
}

SphereSet PairMuckpileBlock::spheres() const {
  const int count = atom->nlocal + atom->nghost;
  return {count > 0 ? atom->x[0] : nullptr,
          solids_ != nullptr ? solids_->blocks.reaches() : atom->radius,
          atom->tag,
          atom_block_.data(),
          count,
          atom->nlocal,
          solids_ != nullptr};
}

/// Facets that are whole or cracked carry what contact their two blocks have.
void PairMuckpileBlock::deactivate_joined_pairs(std::size_t first) {
  if (first == 0) inactive_.clear();
  const FacetState* states = joints_ != nullptr ? joints_->facet_states() : nullptr;
  const std::vector<BlockPair>& pairs = list_.block_pairs();
  for (std::size_t k = first; k < pairs.size(); ++k) {
    if (pairs[k].facet < 0 || states[pairs[k].facet] >= FacetState::fading) continue;
    list_.deactivate(k);
    inactive_.push_back({k, pairs[k].facet});
  }
}

void PairMuckpileBlock::activate_parted_pairs() {
  const FacetState* states = joints_ != nullptr ? joints_->facet_states() : nullptr;
  std::erase_if(inactive_, [&](const InactivePair& pair) {
    if (states[pair.facet] < FacetState::fading) return false;
    list_.activate(pair.pair);
    return true;
  });
}

void PairMuckpileBlock::list_working_pairs(std::size_t first) {
  if (first == 0) {
    working_.clear();
    left_alone_.clear();
  }
  const bool any = resting_ != nullptr && resting_->any_rests();
  const std::span<const char> resting = any ? resting_->resting_spheres() : std::span<const char>();
  const auto rests = [&](int block) {
    const int sphere = first_sphere_[static_cast<std::size_t>(block)];
    return any && resting[static_cast<std::size_t>(sphere)] != 0;
  };
  for (std::size_t k = first; k < list_.block_pairs().size(); ++k) {
    const BlockPair& pair = list_.block_pairs()[k];
    (rests(pair.first) && rests(pair.second) ? left_alone_ : working_).push_back(k);
  }
  // Pairs from before `first` are still sorted as they were: compute() sees that by the version.
  if (first == 0 && resting_ != nullptr) rests_version_ = resting_->rests_version();
}

void PairMuckpileBlock::mark_near(std::span<const char> from, std::span<char> to) const {
  const auto sphere = [this](int block) {
    return static_cast<std::size_t>(first_sphere_[static_cast<std::size_t>(block)]);
  };
  for (const BlockPair& pair : list_.block_pairs()) {
    if (pair.count == 0) continue;
    const std::size_t first = sphere(pair.first), second = sphere(pair.second);
    if (from[first] != 0) to[second] = 1;
    if (from[second] != 0) to[first] = 1;
  }
}

/// The engine builds its lists anew before any sphere has moved by half the skin.
void PairMuckpileBlock::list_pairs() {
  const double started = MPI_Wtime();
  number_blocks();
  list_.group(spheres(), static_cast<int>(block_tag_.size()));
  const bool any = atom->nlocal + atom->nghost > 0;
  drop_intact_pairs(list_.find_block_pairs(0.5 * neighbor->skin, any ? atom->v[0] : nullptr,
                                           any ? atom->omega[0] : nullptr),
                    0);
  deactivate_joined_pairs(0);
  listed_tags_.assign(atom->tag, atom->tag + atom->nlocal + atom->nghost);
  listed_owned_ = atom->nlocal;
  if (solids_ != nullptr) solids_->axes.clear();
  recall_contacts();
  list_working_pairs(0);
  renumber_loads();
  list_is_stale_ = false;
  ledger_.rebuild_s += MPI_Wtime() - started;
  ledger_.rebuilds += 1.0;
}

/// Pairs that could not meet before have no contacts yet.
bool PairMuckpileBlock::add_pairs() {
  const double started = MPI_Wtime();
  const std::size_t first = list_.block_pairs().size();
  if (!list_.add_block_pairs(spheres(), atom->v[0], atom->omega[0])) return false;
  drop_intact_pairs(list_.block_pairs(), first);
  deactivate_joined_pairs(first);
  list_working_pairs(first);
  ledger_.rebuild_s += MPI_Wtime() - started;
  return true;
}

void PairMuckpileBlock::rebuild() {
  share_enclosed();
  share_joined_pairs();
  if (watched_ && comm->nprocs > 1) strange_ = {*bodies_, *atom, world};
  list_pairs();
  if (solids_ != nullptr) take_shapes();
  const int all_bad = engine::sum_over_ranks(static_cast<int>(list_.skipped_blocks()), world);
  if (all_bad > 0)
    engine::stop(*lmp, std::string(kStyle) + ": " + std::to_string(all_bad) +
                           " blocks have a position that is not a number at step " +
                           std::to_string(update->ntimestep) + "; use a smaller timestep");
}

}  // namespace muckpile
