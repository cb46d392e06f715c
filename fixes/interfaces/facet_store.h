// SPDX-License-Identifier: GPL-2.0-or-later
// Facets on their way between who keeps them while blocks migrate and who computes with them.
// Scope: interfaces only; fix muckpile/blocks is the store, fix muckpile/joint the keeper.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bond/facet.h"
#include "bond/network/facet_lists.h"
#include "bond/network/joint_books.h"
#include "fixes/engine/block_halo.h"
#include "fixes/interfaces/known_blocks.h"

namespace muckpile {
namespace engine {
class Bodies;
}

/// Computes with the facets and gives them back before blocks migrate. They are large, so there is
/// only one copy: in the store while blocks migrate, otherwise with the keeper.
class FacetKeeper {
 public:
  virtual ~FacetKeeper() = default;
  [[nodiscard]] virtual FacetLists copy() const = 0;
  [[nodiscard]] virtual FacetLists hand_back() = 0;
  [[nodiscard]] virtual RockSoftness softness() const = 0;
  virtual void store_is_gone() = 0;  ///< called when it is deleted first
};

class FacetStore {
 public:
  virtual ~FacetStore() = default;
  /// nullptr: none any more. The facets of the former keeper come back first.
  virtual void set_keeper(FacetKeeper* keeper) = 0;
  /// Moves the facets to the keeper.
  [[nodiscard]] virtual FacetLists hand_over() = 0;
  /// What keepers so far have made of the rock, those of the run before a restart file included.
  [[nodiscard]] virtual RockSoftness softness() const = 0;
  /// Grows whenever positions, facets or faces changed.
  [[nodiscard]] virtual std::uint64_t version() const = 0;
  /// True if the blocks came from a restart file.
  [[nodiscard]] virtual bool restored() const = 0;

  /// As KnownBlocks has it.
  [[nodiscard]] virtual const std::vector<BlockRecord>& records() const = 0;
  [[nodiscard]] virtual const std::vector<Hole>& holes() const = 0;
  [[nodiscard]] virtual int facets_created() const = 0;
  /// Highest joint class of a facet of this rank so far.
  [[nodiscard]] virtual int highest_joint_class() const = 0;
  /// Names of the zones of rock, from 1 on, the same on every rank.
  [[nodiscard]] virtual const std::vector<std::string>& zones() const = 0;
  /// Tags of the copies of other ranks' blocks, in halo order after the owned ones.
  [[nodiscard]] virtual const std::vector<int>& copy_tags() const = 0;
  [[nodiscard]] virtual const engine::BlockHalo& halo() const = 0;
  /// Of this rank; good until bodies are added, removed or exchanged.
  [[nodiscard]] virtual engine::Bodies bodies() = 0;
};

}  // namespace muckpile
