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
  exchange_messages(outgoing, world_, [this](ByteReader& in, std::size_t rank) {
    while (!in.empty()) entries_[in.get<int>()] = static_cast<int>(rank);
  });
}

std::vector<int> BlockDirectory::owners(const std::vector<int>& tags) const {
  const auto ranks = static_cast<std::size_t>(ranks_);
  std::vector<ByteWriter> questions(ranks);
  for (int tag : tags) questions[static_cast<std::size_t>(home(tag))].put(tag);
  std::vector<ByteWriter> answers(ranks);
  exchange_messages(questions, world_, [&](ByteReader& in, std::size_t rank) {
    while (!in.empty()) {
      const auto found = entries_.find(in.get<int>());
      answers[rank].put(found == entries_.end() ? -1 : found->second);
    }
  });

  std::vector<std::vector<std::size_t>> asked(ranks);  // places in `tags`, by the rank asked
  for (std::size_t k = 0; k < tags.size(); ++k)
    asked[static_cast<std::size_t>(home(tags[k]))].push_back(k);
  std::vector<int> owner(tags.size());
  exchange_messages(answers, world_, [&](ByteReader& in, std::size_t rank) {
    for (const std::size_t k : asked[rank]) owner[k] = in.get<int>();
  });
  return owner;
}

}  // namespace muckpile::engine
