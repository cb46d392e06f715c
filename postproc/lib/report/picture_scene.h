// SPDX-License-Identifier: GPL-2.0-or-later
// What a picture of the rock holds: posed blocks, mirror images, the ground, edges of the rock
// before the blast; and a cut through it.
// Scope: geometry only; picture_view.h looks at it, draw/scene.h draws it.
#pragma once

#include <optional>
#include <vector>

#include "draw/scene.h"
#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "measure/columns.h"
#include "measure/plan_line.h"

namespace muckpile {

// Reflects y in the symmetry planes of a bench: copy 0 is the model, odd copies are mirror images.
class Reflection {
 public:
  Reflection(int copy, const Extent& extent)
      : odd_(copy % 2 != 0),
        shift_(copy * (extent.high.y() - extent.low.y())),
        twice_middle_(extent.low.y() + extent.high.y()) {}
  [[nodiscard]] Vec3 of(const Vec3& p) const {
    return {p.x(), (odd_ ? twice_middle_ - p.y() : p.y()) + shift_, p.z()};
  }
  [[nodiscard]] bool turns_over() const { return odd_; }

 private:
  bool odd_;
  double shift_, twice_middle_;
};

void add_blocks(const std::vector<StartBlock>& blocks, const Snapshot& snapshot,
                const std::vector<Colour>& colours, const Reflection& reflection, Scene& scene);

// The plane z = 0 outside the model's own ground plan, so that it does not hide rock below the
// floor.
void add_ground(const Extent& rock, double x_high, double margin, Scene& scene);

// Edges of the box around the rock before the blast, above the floor for a bench.
std::vector<SceneLine> edges_of(const Extent& rock);

// An upright plane through a line in plan.
struct CutPlane {
  PlanLine line;
  bool keep_left;  // the rock to the left of the line stays
};

// That which keeps what an eye in this direction sees behind the plane.
CutPlane cut_along(const PlanLine& line, const Vec3& to_eye);

// Leaves of the scene's polygons what lies on the side that stays.
void cut_away(const CutPlane& plane, Scene& scene);

// The faces of blocks in the plane of the cut, seen from the side that was cut away.
void add_cut_faces(const CutPlane& plane, const std::vector<StartBlock>& blocks,
                   const Snapshot& snapshot, const std::vector<Colour>& colours, Scene& scene);

}  // namespace muckpile
