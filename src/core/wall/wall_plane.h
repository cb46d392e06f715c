// SPDX-License-Identifier: GPL-2.0-or-later
// A plane with ground behind it, without end.
// Scope: a wall_surface.h.
#pragma once

#include "wall/wall_surface.h"

namespace muckpile {

class WallPlane : public WallSurface {
 public:
  /// `normal` points out of the ground, of any length but 0.
  WallPlane(const Vec3& point, const Vec3& normal);

  [[nodiscard]] double distance(const Vec3& place, double reach,
                                std::vector<std::size_t>& parts) const override;
  void find_touches(const Vec3& centre, double radius, std::span<const std::size_t> parts,
                    WallTouches& touches) const override;
  [[nodiscard]] bool lets_go() const override { return false; }
  [[nodiscard]] double depth(const Vec3& place) const override;

 private:
  Vec3 point_, normal_;
};

}  // namespace muckpile
