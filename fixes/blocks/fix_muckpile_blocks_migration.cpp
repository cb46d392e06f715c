// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blocks: records, facets and faces follow their bodies from rank to rank.
// Scope: collective; called when the bodies of some rank have changed.
#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/style_args.h"

namespace muckpile {

/// A block that left the simulation box takes its joints with it: its neighbours lose them, and
/// nothing pulls at a block that is no longer there. fix muckpile/progress reports the loss.
void FixMuckpileBlocks::drop_orphans(const std::vector<int>& tags,
                                     const engine::BlockDirectory& directory) {
  const std::unordered_set<int> here(tags.begin(), tags.end());
  std::vector<int> ends;
  for (const Facet& facet : facets_) {
    for (int tag : {facet.tag_i, facet.tag_j}) {
      if (tag != kGroundTag && here.count(tag) == 0) ends.push_back(tag);
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const std::vector<int> owners = directory.owners(ends);
  std::unordered_set<int> lost;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    if (owners[k] < 0) lost.insert(ends[k]);
  }
  if (lost.empty()) return;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (lost.count(facets_[f].tag_i) + lost.count(facets_[f].tag_j) > 0) {
      memory_[f].state = FacetState::retired;
      memory_[f].gas = false;
    }
  }
  drop_retired();
}

void FixMuckpileBlocks::migrate(const std::vector<int>& tags,
                                const engine::BlockDirectory& directory) {
  std::vector<ByteWriter> leaving = pack_leaving(tags, directory);
  std::vector<BlocksShare> arrived;
  engine::or_engine_error(*lmp, "fix muckpile/blocks", [&] {
    engine::exchange_messages(leaving, world, [&arrived](ByteReader& in, std::size_t) {
      while (!in.empty()) arrived.push_back(in.get<BlocksShare>());
    });
  });
  merge(tags, arrived);
}

/// Per destination rank: the blocks that went there, with their faces and facets.
std::vector<ByteWriter> FixMuckpileBlocks::pack_leaving(const std::vector<int>& tags,
                                                        const engine::BlockDirectory& directory) {
  const std::unordered_set<int> here(tags.begin(), tags.end());
  std::vector<int> leaving;
  for (const BlockRecord& record : records_) {
    if (here.count(record.tag) == 0) leaving.push_back(record.tag);
  }
  const std::vector<int> owners = directory.owners(leaving);
  std::unordered_map<int, int> destination;
  for (std::size_t k = 0; k < leaving.size(); ++k) destination[leaving[k]] = owners[k];

  std::unordered_map<int, std::vector<BoundaryFace>> faces_of;
  for (const BoundaryFace& face : faces_) {
    if (destination.count(face.tag) != 0) faces_of[face.tag].push_back(face);
  }
  std::unordered_map<int, std::vector<std::size_t>> facets_of;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    for (int tag : {facets_[f].tag_i, facets_[f].tag_j}) {
      if (destination.count(tag) != 0) facets_of[tag].push_back(f);
    }
  }
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  std::vector<ByteWriter> outgoing(static_cast<std::size_t>(ranks));
  for (const BlockRecord& record : records_) {
    const auto to = destination.find(record.tag);
    if (to == destination.end() || to->second < 0) continue;
    BlocksShare share{{record}, faces_of[record.tag], {}};
    for (const std::size_t f : facets_of[record.tag])
      share.facets.push_back({facets_[f], memory_[f]});
    outgoing[static_cast<std::size_t>(to->second)].put(share);
  }
  return outgoing;
}

/// Adds what arrived, drops what no block here needs, and keeps all in canonical order.
void FixMuckpileBlocks::merge(const std::vector<int>& tags, std::vector<BlocksShare>& arrived) {
  const std::unordered_set<int> here(tags.begin(), tags.end());
  std::unordered_map<int, BlockRecord> known;
  for (const BlockRecord& record : records_) known[record.tag] = record;
  std::vector<FacetEntry> facets;
  for (BlocksShare& share : arrived) {
    for (const BlockRecord& record : share.records) known[record.tag] = record;
    faces_.insert(faces_.end(), share.faces.begin(), share.faces.end());
    std::ranges::move(share.facets, std::back_inserter(facets));
  }
  std::erase_if(faces_, [&](const BoundaryFace& face) { return here.count(face.tag) == 0; });
  std::sort(faces_.begin(), faces_.end(), [](const BoundaryFace& a, const BoundaryFace& b) {
    return std::pair(a.tag, a.face) < std::pair(b.tag, b.face);
  });
  keep_facets([&](std::size_t f) {
    return here.count(facets_[f].tag_i) + here.count(facets_[f].tag_j) > 0;
  });
  add_facets(std::move(facets));

  records_.clear();
  for (int tag : tags) {
    const auto found = known.find(tag);  // absent for a body that create_blocks did not make
    records_.push_back(found == known.end() ? BlockRecord{.tag = tag} : found->second);
  }
}

}  // namespace muckpile
