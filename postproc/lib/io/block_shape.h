// SPDX-License-Identifier: GPL-2.0-or-later
// The polyhedron of a block in memory that blocks of one file share.
// Scope: not changed once made; a copy shows the same memory, which lasts as long as any of them.
#pragma once

#include <memory>
#include <utility>

#include "geometry/shape/flat_polyhedron.h"

namespace muckpile {

struct BlockShape : FlatPolyhedron {
  BlockShape() = default;
  // What lies in `memory`.
  BlockShape(const FlatPolyhedron& shape, std::shared_ptr<const void> memory)
      : FlatPolyhedron(shape), memory_(std::move(memory)) {}
  // In memory of its own.
  BlockShape(const Polyhedron& shape);  // NOLINT(google-explicit-constructor): the same polyhedron

 private:
  std::shared_ptr<const void> memory_;
};

}  // namespace muckpile
