// SPDX-License-Identifier: GPL-2.0-or-later
// Exchange of byte buffers between all ranks.
// Scope: at most 2 GiB per rank and call, MPI's int counts.
#include "engine/exchange.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace muckpile::engine {
namespace {

std::vector<int> offsets(const std::vector<int>& counts) {
  std::vector<int> first(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, first.begin() + 1);
  return first;
}

void refuse_too_much(const std::vector<std::vector<char>>& outgoing, MPI_Comm world) {
  std::vector<std::int64_t> sent, received(outgoing.size());
  for (const auto& part : outgoing) sent.push_back(static_cast<std::int64_t>(part.size()));
  MPI_Alltoall(sent.data(), 1, MPI_INT64_T, received.data(), 1, MPI_INT64_T, world);
  const auto total = [](const std::vector<std::int64_t>& v) {
    return std::accumulate(v.begin(), v.end(), std::int64_t{0});
  };
  std::int64_t mine = std::max(total(sent), total(received)), most = 0;
  MPI_Allreduce(&mine, &most, 1, MPI_INT64_T, MPI_MAX, world);
  if (most > std::numeric_limits<int>::max()) {
    throw std::length_error("an exchange between ranks needs 2 GiB or more on one rank");
  }
}

}  // namespace

std::vector<std::vector<char>> bytes_of(std::vector<ByteWriter>& writers) {
  std::vector<std::vector<char>> buffers;
  for (ByteWriter& writer : writers) buffers.push_back(std::move(writer.bytes()));
  return buffers;
}

std::vector<double> gather_all(const std::vector<double>& mine, MPI_Comm world) {
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks));
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  const std::vector<int> first = offsets(counts);
  std::vector<double> all(static_cast<std::size_t>(first.back() + counts.back()));
  MPI_Allgatherv(mine.data(), count, MPI_DOUBLE, all.data(), counts.data(), first.data(),
                 MPI_DOUBLE, world);
  return all;
}

std::vector<std::vector<char>> exchange_bytes(const std::vector<std::vector<char>>& outgoing,
                                              MPI_Comm world) {
  const std::size_t ranks = outgoing.size();
  if (ranks == 1) return outgoing;
  refuse_too_much(outgoing, world);
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
