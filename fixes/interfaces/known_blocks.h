// SPDX-License-Identifier: GPL-2.0-or-later
// What is known of the blocks beyond their bodies.
// Scope: an interface only, for reading; fix muckpile/blocks implements it.
#pragma once

#include <string>
#include <vector>

#include "bond/network/network_block.h"
#include "bond/network/stored_network.h"
#include "geometry/block_model.h"
#include "math/types.h"

namespace muckpile {

/// A block as it was made; volume and mass are 0 of a body that create_blocks did not make.
struct BlockRecord {
  int tag = 0;
  double volume = 0.0;        ///< of the polyhedron [m3]
  double mass = 0.0;          ///< [kg]
  Vec3 start = Vec3::Zero();  ///< centroid in the start configuration [m]
  Mat3 start_axes =
      Mat3::Identity();  ///< principal axes of inertia in the start configuration, columns
  RetiredFacets retired{};
  std::uint8_t zone = 0;  ///< of rock: 0 or, from 1 on, a place in FacetStore::zones()
};
template <>
struct Stored<BlockRecord> {
  static constexpr std::string_view kName = "block_record";
  static constexpr int kVersion = 2;
  static auto fields(auto& record) {
    return std::tie(record.tag, record.volume, record.mass, record.start, record.start_axes,
                    record.retired, record.zone);
  }
};

class KnownBlocks {
 public:
  virtual ~KnownBlocks() = default;
  /// Of this rank, in the order of the multisphere bodies.
  [[nodiscard]] virtual const std::vector<BlockRecord>& records() const = 0;
  /// Of the whole model, the same on every rank.
  [[nodiscard]] virtual const std::vector<Hole>& holes() const = 0;
  [[nodiscard]] virtual const std::string& run_id() const = 0;
  [[nodiscard]] virtual int blocks_created() const = 0;  ///< of all ranks
  /// Blocks among blocks_created() that were lost before the restart file was written.
  [[nodiscard]] virtual int blocks_lost_before() const = 0;
  [[nodiscard]] virtual int facets_created() const = 0;  ///< joints, of all ranks
};

}  // namespace muckpile
