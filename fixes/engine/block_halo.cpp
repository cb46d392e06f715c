// SPDX-License-Identifier: GPL-2.0-or-later
// Copies of other ranks' blocks: plan and point-to-point messages.
// Scope: see the header.
#include "fixes/engine/block_halo.h"

#include <unordered_map>

#include "fixes/engine/exchange.h"

namespace muckpile::engine {
namespace {
constexpr int kMessageTag = 7741;
}

BlockHalo::BlockHalo(const std::vector<int>& owned_tags, const std::vector<int>& needed_tags,
                     const BlockDirectory& directory, MPI_Comm world)
    : world_(world), owned_(owned_tags.size()), copies_(needed_tags.size()) {
  int ranks = 1;
  MPI_Comm_size(world_, &ranks);
  if (ranks == 1) return;
  const std::vector<int> owners = directory.owners(needed_tags);
  std::vector<ByteWriter> wishes(static_cast<std::size_t>(ranks));
  std::vector<std::vector<std::size_t>> places(static_cast<std::size_t>(ranks));
  for (std::size_t k = 0; k < needed_tags.size(); ++k) {
    if (owners[k] < 0) continue;  // a lost block; the store reports it
    wishes[static_cast<std::size_t>(owners[k])].put(needed_tags[k]);
    places[static_cast<std::size_t>(owners[k])].push_back(owned_ + k);
  }
  std::unordered_map<int, std::size_t> position;
  for (std::size_t b = 0; b < owned_tags.size(); ++b) position[owned_tags[b]] = b;
  exchange_messages(wishes, world_, [&](ByteReader& in, std::size_t rank) {
    const int of = static_cast<int>(rank);
    if (!places[rank].empty()) receives_.push_back({of, places[rank]});
    Partner partner{of, {}};
    while (!in.empty()) partner.positions.push_back(position.at(in.get<int>()));
    if (!partner.positions.empty()) sends_.push_back(std::move(partner));
  });
  send_buffers_.resize(sends_.size());
  receive_buffers_.resize(receives_.size());
}

void BlockHalo::forward(std::span<double> values, std::size_t width) const {
  requests_.clear();
  for (std::size_t k = 0; k < receives_.size(); ++k) {
    receive_buffers_[k].resize(receives_[k].positions.size() * width);
    MPI_Irecv(receive_buffers_[k].data(), static_cast<int>(receive_buffers_[k].size()), MPI_DOUBLE,
              receives_[k].rank, kMessageTag, world_, &requests_.emplace_back());
  }
  for (std::size_t k = 0; k < sends_.size(); ++k) {
    send_buffers_[k].clear();
    for (std::size_t b : sends_[k].positions) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(b * width);
      send_buffers_[k].insert(send_buffers_[k].end(), first,
                              first + static_cast<std::ptrdiff_t>(width));
    }
    MPI_Isend(send_buffers_[k].data(), static_cast<int>(send_buffers_[k].size()), MPI_DOUBLE,
              sends_[k].rank, kMessageTag, world_, &requests_.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
  for (std::size_t k = 0; k < receives_.size(); ++k) {
    const double* from = receive_buffers_[k].data();
    for (std::size_t b : receives_[k].positions) {
      std::copy(from, from + width, values.begin() + static_cast<std::ptrdiff_t>(b * width));
      from += width;
    }
  }
}

void BlockHalo::forward(std::span<int> values) const {
  std::vector<double> wide(values.begin(), values.end());
  forward(wide, 1);
  for (std::size_t b = owned_; b < wide.size(); ++b) values[b] = static_cast<int>(wide[b]);
}

}  // namespace muckpile::engine
