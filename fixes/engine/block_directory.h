// SPDX-License-Identifier: GPL-2.0-or-later
// Which rank owns a block, by tag, without a table of all blocks on any rank.
// Scope: rank tag % ranks keeps the entry of a tag; built anew after every exchange of bodies.
#pragma once

#include <mpi.h>

#include <unordered_map>
#include <vector>

namespace muckpile::engine {

class BlockDirectory {
 public:
  /// Collective: every rank tells its tags.
  BlockDirectory(const std::vector<int>& owned_tags, MPI_Comm world);
  /// Owner rank of each tag, -1 for a tag that no rank owns. Collective.
  [[nodiscard]] std::vector<int> owners(const std::vector<int>& tags) const;

 private:
  [[nodiscard]] int home(int tag) const { return tag % ranks_; }

  MPI_Comm world_;
  int ranks_ = 1;
  std::unordered_map<int, int> entries_;  // tag -> owner, of the tags whose home this rank is
};

}  // namespace muckpile::engine
