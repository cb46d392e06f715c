// SPDX-License-Identifier: GPL-2.0-or-later
// Copies of other ranks' blocks: sends per-block numbers from owners to the ranks that need them.
// Scope: blocks are addressed by position (owned ones first, then the copies in the order of the
// tags asked for); the plan holds until bodies migrate.
#pragma once

#include <mpi.h>

#include <span>
#include <vector>

#include "fixes/engine/block_directory.h"

namespace muckpile::engine {

class BlockHalo {
 public:
  BlockHalo() = default;
  /// Collective. `needed_tags` belong to other ranks, without repeats.
  BlockHalo(const std::vector<int>& owned_tags, const std::vector<int>& needed_tags,
            const BlockDirectory& directory, MPI_Comm world);

  /// values: width numbers per block, owned blocks first; fills in those of the copies.
  void forward(std::span<double> values, std::size_t width) const;
  /// As forward, for one int per block.
  void forward(std::span<int> values) const;

  [[nodiscard]] std::size_t owned() const { return owned_; }
  [[nodiscard]] std::size_t size() const { return owned_ + copies_; }

 private:
  struct Partner {
    int rank;
    std::vector<std::size_t> positions;  // local blocks to send, or copies to fill
  };

  MPI_Comm world_ = MPI_COMM_NULL;
  std::size_t owned_ = 0, copies_ = 0;
  std::vector<Partner> sends_, receives_;
  // Only for use inside forward().
  mutable std::vector<std::vector<double>> send_buffers_, receive_buffers_;
  mutable std::vector<MPI_Request> requests_;
};

}  // namespace muckpile::engine
