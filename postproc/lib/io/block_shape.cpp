// SPDX-License-Identifier: GPL-2.0-or-later
// The polyhedron of a block.
// Scope: see the header.
#include "io/block_shape.h"

#include <vector>

namespace muckpile {
namespace {

struct OwnShape {
  explicit OwnShape(const Polyhedron& shape) : vertices(shape.vertices) {
    for (const std::vector<int>& face : shape.faces) {
      corners.insert(corners.end(), face.begin(), face.end());
      ends.push_back(static_cast<int>(corners.size()));
    }
  }
  std::vector<Vec3> vertices;
  std::vector<int> corners, ends;
};

}  // namespace

BlockShape::BlockShape(const Polyhedron& shape) {
  const auto own = std::make_shared<const OwnShape>(shape);
  vertices = own->vertices;
  faces = {own->corners, own->ends};
  memory_ = own;
}

}  // namespace muckpile
