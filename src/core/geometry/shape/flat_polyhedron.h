// SPDX-License-Identifier: GPL-2.0-or-later
// Polyhedra whose corners lie in one list: hundreds of thousands of them in a few pieces of memory.
// Scope: views; what they show belongs to somebody else and must outlive them.
#pragma once

#include <cstddef>
#include <iterator>
#include <span>

#include "geometry/shape/polyhedron.h"

namespace muckpile {

// The faces of a polyhedron, each the numbers of its vertices.
class FaceList {
 public:
  class Iterator {
   public:
    using value_type = std::span<const int>;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(const FaceList& list, std::size_t face) : list_(&list), face_(face) {}
    [[nodiscard]] value_type operator*() const { return (*list_)[face_]; }
    Iterator& operator++() { return ++face_, *this; }
    Iterator operator++(int) { return {*list_, face_++}; }
    [[nodiscard]] bool operator==(const Iterator& other) const { return face_ == other.face_; }

   private:
    const FaceList* list_ = nullptr;
    std::size_t face_ = 0;
  };

  FaceList() = default;
  // `corners` of all faces one behind the other; `ends`: where each face ends among them.
  FaceList(std::span<const int> corners, std::span<const int> ends)
      : corners_(corners), ends_(ends) {}

  [[nodiscard]] std::size_t size() const { return ends_.size(); }
  [[nodiscard]] std::span<const int> operator[](std::size_t face) const {
    const int begin = face == 0 ? 0 : ends_[face - 1];
    return corners_.subspan(static_cast<std::size_t>(begin),
                            static_cast<std::size_t>(ends_[face] - begin));
  }
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

 private:
  std::span<const int> corners_, ends_;
};

struct FlatPolyhedron {
  std::span<const Vec3> vertices;  // [m]
  FaceList faces;                  // counter-clockwise seen from outside
};

// With memory of its own.
[[nodiscard]] inline Polyhedron polyhedron_of(const FlatPolyhedron& shape) {
  Polyhedron own{{shape.vertices.begin(), shape.vertices.end()}, {}};
  for (const std::span<const int> face : shape.faces)
    own.faces.emplace_back(face.begin(), face.end());
  return own;
}

}  // namespace muckpile
