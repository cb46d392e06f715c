// SPDX-License-Identifier: GPL-2.0-or-later
// The shapes of all blocks of the run, as contact in their own shape needs them.
// Scope: an interface only; fix muckpile/shapes implements it.
#pragma once

#include <vector>

#include "contact/polyhedra/solid.h"
#include "state/encoding.h"

namespace muckpile {

/// A polyhedron in the axes of its body, about its centre.
struct BlockShape {
  int tag = 0;  ///< of the body
  int key = 0;  ///< tag of the sphere nearest to the centre
  Vec3 key_offset = Vec3::Zero();
  std::vector<Vec3> corners;
  std::vector<std::vector<int>> faces;
};
template <>
struct Stored<BlockShape> {
  static constexpr std::string_view kName = "block_shape";
  static constexpr int kVersion = 1;
  static auto fields(auto& shape) {
    return std::tie(shape.tag, shape.key, shape.key_offset, shape.corners, shape.faces);
  }
};

struct ShapedBlock {
  int key = 0;      ///< tag of the sphere that stands for the block
  Vec3 key_offset;  ///< of that sphere from the centre, in the body's axes [m]
  Solid solid;      ///< in the body's axes, about the centre
  double reach;     ///< of the farthest corner from the key [m]
};

class BlockShapes {
 public:
  virtual ~BlockShapes() = default;
  /// Takes those that rank 0 has made; of other ranks they do not count. Collective.
  virtual void share(const std::vector<BlockShape>& of_rank_0) = 0;
  /// Of a block by its tag; null: none is known.
  [[nodiscard]] virtual const ShapedBlock* shape(int tag) const = 0;
  [[nodiscard]] virtual double largest_reach() const = 0;  ///< of all [m]
};

}  // namespace muckpile
