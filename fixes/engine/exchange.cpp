// SPDX-License-Identifier: GPL-2.0-or-later
// Exchange of byte buffers between all ranks.
// Scope: in rounds, because MPI counts with int.
#include "fixes/engine/exchange.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "fixes/engine/over_ranks.h"

namespace muckpile::engine {
namespace {

std::vector<int> offsets(const std::vector<int>& counts) {
  std::vector<int> first(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, first.begin() + 1);
  return first;
}

/// Numbers of bytes that each rank will send here.
std::vector<std::int64_t> sizes_to_come(const std::vector<std::vector<char>>& outgoing,
                                        MPI_Comm world) {
  std::vector<std::int64_t> sent, received(outgoing.size());
  for (const auto& part : outgoing) sent.push_back(static_cast<std::int64_t>(part.size()));
  MPI_Alltoall(sent.data(), 1, MPI_INT64_T, received.data(), 1, MPI_INT64_T, world);
  return received;
}

/// The part of a buffer of `size` bytes that goes in a round.
int share_of(std::size_t size, std::size_t begin, std::size_t most) {
  return size > begin ? static_cast<int>(std::min(most, size - begin)) : 0;
}

/// Exchanges at most `most` bytes of every buffer, from byte `begin` on.
void exchange_round(const std::vector<std::vector<char>>& outgoing, std::size_t begin,
                    std::size_t most, std::vector<std::vector<char>>& incoming, MPI_Comm world) {
  std::vector<int> sent, received;
  for (const auto& part : outgoing) sent.push_back(share_of(part.size(), begin, most));
  for (const auto& part : incoming) received.push_back(share_of(part.size(), begin, most));
  const std::vector<int> sent_at = offsets(sent), received_at = offsets(received);
  std::vector<char> send_buffer(static_cast<std::size_t>(sent_at.back() + sent.back()));
  std::vector<char> receive_buffer(static_cast<std::size_t>(received_at.back() + received.back()));
  for (std::size_t r = 0; r < outgoing.size(); ++r) {
    if (sent[r] > 0)
      std::copy_n(outgoing[r].data() + begin, sent[r], send_buffer.data() + sent_at[r]);
  }
  MPI_Alltoallv(send_buffer.data(), sent.data(), sent_at.data(), MPI_CHAR, receive_buffer.data(),
                received.data(), received_at.data(), MPI_CHAR, world);
  for (std::size_t r = 0; r < incoming.size(); ++r) {
    if (received[r] > 0)
      std::copy_n(receive_buffer.data() + received_at[r], received[r], incoming[r].data() + begin);
  }
}

std::string text_of_rank(int rank, std::string text, MPI_Comm world) {
  std::uint64_t length = text.size();
  MPI_Bcast(&length, 1, MPI_UINT64_T, rank, world);
  text.resize(length);
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, rank, world);
  return text;
}

/// Throws the fault of the first rank that has one, on all ranks.
void throw_on_all(const std::string& fault, MPI_Comm world) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(world, &rank);
  MPI_Comm_size(world, &ranks);
  const int first = least_over_ranks(fault.empty() ? ranks : rank, world);
  if (first == ranks) return;
  throw StateError("message between ranks, read on rank " + std::to_string(first) + ": " +
                   text_of_rank(first, fault, world));
}

}  // namespace

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

std::string of_first_rank(std::string text, MPI_Comm world) {
  return text_of_rank(0, std::move(text), world);
}

void exchange_messages(std::vector<ByteWriter>& outgoing, MPI_Comm world,
                       const std::function<void(ByteReader&, std::size_t)>& read) {
  std::vector<std::vector<char>> buffers;
  for (ByteWriter& writer : outgoing) buffers.push_back(std::move(writer.bytes()));
  const auto incoming = exchange_bytes(buffers, world);
  std::string fault;
  try {
    for (std::size_t rank = 0; rank < incoming.size(); ++rank) {
      ByteReader in(incoming[rank]);
      read(in, rank);
      in.require_end("message");
    }
  } catch (const StateError& error) {
    fault = error.what();
  }
  throw_on_all(fault, world);
}

std::vector<std::vector<char>> exchange_bytes(const std::vector<std::vector<char>>& outgoing,
                                              MPI_Comm world, std::size_t most_at_once) {
  const std::size_t ranks = outgoing.size();
  if (ranks == 1) return outgoing;
  std::vector<std::vector<char>> incoming;
  for (const std::int64_t size : sizes_to_come(outgoing, world))
    incoming.emplace_back(static_cast<std::size_t>(size));
  std::int64_t longest = 0;
  for (const auto& part : outgoing)
    longest = std::max(longest, static_cast<std::int64_t>(part.size()));
  longest = greatest_over_ranks(longest, world);
  const std::size_t most = std::max<std::size_t>(1, most_at_once / ranks);
  for (std::size_t begin = 0; begin < static_cast<std::size_t>(longest); begin += most)
    exchange_round(outgoing, begin, most, incoming, world);
  return incoming;
}

}  // namespace muckpile::engine
