// SPDX-License-Identifier: GPL-2.0-or-later
// Makes sure that a face between two blocks exists in both of them.
// Scope: collapsing a face may leave another with two corners; it goes too, until nothing changes.
#include "geometry/cut/conformity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace muckpile {
namespace {

bool has_neighbour(const Block& block, int other) {
  return std::find(block.neighbour.begin(), block.neighbour.end(), other) != block.neighbour.end();
}

double longest_diagonal(const Polyhedron& shape, const std::vector<int>& face) {
  double longest = 0.0;
  const Vec3& first = shape.vertices[static_cast<std::size_t>(face[0])];
  for (const int v : face) {
    longest = std::max(longest, (shape.vertices[static_cast<std::size_t>(v)] - first).norm());
  }
  return longest;
}

void drop_repeated_corners(std::vector<int>& face) {
  face.erase(std::unique(face.begin(), face.end()), face.end());
  while (face.size() > 1 && face.front() == face.back()) face.pop_back();
}

// Merges the corners of one face into its first one and removes faces with fewer than 3 corners.
void collapse_face(Block& block, std::size_t face_number) {
  const std::vector<int> gone = block.shape.faces[face_number];
  for (std::vector<int>& face : block.shape.faces) {
    for (int& v : face) {
      if (std::find(gone.begin(), gone.end(), v) != gone.end()) v = gone.front();
    }
    drop_repeated_corners(face);
  }
  for (std::size_t f = block.shape.faces.size(); f-- > 0;) {
    if (block.shape.faces[f].size() >= 3) continue;
    const auto offset = static_cast<std::ptrdiff_t>(f);
    block.shape.faces.erase(block.shape.faces.begin() + offset);
    block.neighbour.erase(block.neighbour.begin() + offset);
  }
  drop_unused_vertices(block.shape);
}

bool collapse_first_one_sided_face(std::vector<Block>& blocks, std::size_t b) {
  constexpr double kLargest = 1e-5;  // of the block size; voro++ decides at 1e-11 m
  Block& block = blocks[b];
  for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
    const int other = block.neighbour[f];
    if (other < 0) continue;
    if (has_neighbour(blocks[static_cast<std::size_t>(other)], static_cast<int>(b))) continue;
    if (longest_diagonal(block.shape, block.shape.faces[f]) >
        kLargest * std::cbrt(block.mass.volume)) {
      throw std::runtime_error("blocks " + std::to_string(b) + " and " + std::to_string(other) +
                               " do not share the face between them");
    }
    collapse_face(block, f);
    return true;
  }
  return false;
}

}  // namespace

std::size_t collapse_one_sided_faces(std::vector<Block>& blocks) {
  std::size_t collapsed = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      while (collapse_first_one_sided_face(blocks, b)) {
        changed = true;
        ++collapsed;
      }
    }
  }
  return collapsed;
}

}  // namespace muckpile
