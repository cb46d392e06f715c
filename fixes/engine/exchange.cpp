// SPDX-License-Identifier: GPL-2.0-or-later
// Exchange of byte buffers between all ranks.
// Scope: at most 2 GiB per rank and call, MPI's int counts.
#include "engine/exchange.h"

#include <numeric>

namespace muckpile::engine {
namespace {

std::vector<int> offsets(const std::vector<int>& counts) {
  std::vector<int> first(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, first.begin() + 1);
  return first;
}

}  // namespace

std::vector<std::vector<char>> exchange_bytes(const std::vector<std::vector<char>>& outgoing, MPI_Comm world) {
  const std::size_t ranks = outgoing.size();
  if (ranks == 1) return outgoing;
  std::vector<int> sent(ranks), received(ranks);
  for (std::size_t r = 0; r < ranks; ++r) sent[r] = static_cast<int>(outgoing[r].size());
  MPI_Alltoall(sent.data(), 1, MPI_INT, received.data(), 1, MPI_INT, world);

  const std::vector<int> sent_at = offsets(sent), received_at = offsets(received);
  std::vector<char> send_buffer;
  for (const auto& part : outgoing) send_buffer.insert(send_buffer.end(), part.begin(), part.end());
  std::vector<char> receive_buffer(static_cast<std::size_t>(received_at.back() + received.back()));
  MPI_Alltoallv(send_buffer.data(), sent.data(), sent_at.data(), MPI_CHAR, receive_buffer.data(),
                received.data(), received_at.data(), MPI_CHAR, world);

  std::vector<std::vector<char>> incoming(ranks);
  for (std::size_t r = 0; r < ranks; ++r) {
    const auto first = receive_buffer.begin() + received_at[r];
    incoming[r].assign(first, first + received[r]);
  }
  return incoming;
}

}  // namespace muckpile::engine
