// SPDX-License-Identifier: GPL-2.0-or-later
// Which rank owns a block: rendezvous at rank tag % ranks.
// Scope: see the header.
#include "fixes/engine/block_directory.h"

#include "fixes/engine/exchange.h"

namespace muckpile::engine {

BlockDirectory::BlockDirectory(const std::vector<int>& owned_tags, MPI_Comm world) : world_(world) {
  MPI_Comm_size(world_, &ranks_);
  std::vector<ByteWriter> outgoing(static_cast<std::size_t>(ranks_));
  for (int tag : owned_tags) outgoing[static_cast<std::size_t>(home(tag))].put(tag);
  const auto buffers = bytes_of(outgoing);
  const auto incoming = exchange_bytes(buffers, world_);
  for (std::size_t rank = 0; rank < incoming.size(); ++rank) {
    for (ByteReader reader(incoming[rank]); !reader.empty();) {
      entries_[reader.get<int>()] = static_cast<int>(rank);
    }
  }
}

std::vector<int> BlockDirectory::owners(const std::vector<int>& tags) const {
  const auto ranks = static_cast<std::size_t>(ranks_);
  std::vector<ByteWriter> questions(ranks);
  for (int tag : tags) questions[static_cast<std::size_t>(home(tag))].put(tag);
  const auto buffers = bytes_of(questions);
  const auto asked = exchange_bytes(buffers, world_);

  std::vector<ByteWriter> answers(ranks);
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    for (ByteReader reader(asked[rank]); !reader.empty();) {
      const auto found = entries_.find(reader.get<int>());
      answers[rank].put(found == entries_.end() ? -1 : found->second);
    }
  }
  const auto replies = bytes_of(answers);
  const auto told = exchange_bytes(replies, world_);

  std::vector<ByteReader> readers;
  for (const auto& part : told) readers.emplace_back(part);
  std::vector<int> owner;
  owner.reserve(tags.size());
  for (int tag : tags) owner.push_back(readers[static_cast<std::size_t>(home(tag))].get<int>());
  return owner;
}

}  // namespace muckpile::engine
