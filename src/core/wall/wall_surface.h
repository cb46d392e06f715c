// SPDX-License-Identifier: GPL-2.0-or-later
// Where spheres touch a wall: a plane, or triangles with ground behind them.
// Scope: geometry of one sphere and a wall that stands still.
//
// A touch is a place where the distance from the sphere's centre to the surface is least among all
// places around it. So the inner edges of a flat mesh are none, and an outer edge is one however
// many triangles meet there.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "math/types.h"

namespace muckpile {

struct WallTouch {
  Vec3 normal = Vec3::Zero();  ///< out of the ground, of unit length
  double overlap = 0.0;        ///< [m]
};

/// Touches of one sphere, the deepest first; the normals of any two are more than kSameTouch apart.
class WallTouches {
 public:
  /// Cosine of 20 degrees. Where faces meet in a valley that is flatter, a sphere is on the nearer
  /// one: contacts with both would make the ground stiffer there.
  static constexpr double kSameTouch = 0.93969262;

  void clear() { count_ = 0; }
  /// Left out if a touch with nearly the same normal is there.
  void add(const WallTouch& touch) {
    for (const WallTouch& other : all())
      if (other.normal.dot(touch.normal) > kSameTouch) return;
    if (count_ < kMost) touches_[count_++] = touch;
  }
  [[nodiscard]] std::span<const WallTouch> all() const { return {touches_.data(), count_}; }

  static constexpr std::size_t kMost = 8;  ///< more than a sphere can have but in a cave

 private:
  std::array<WallTouch, kMost> touches_;
  std::size_t count_ = 0;
};

class WallSurface {
 public:
  WallSurface() = default;
  WallSurface(const WallSurface&) = delete;
  WallSurface& operator=(const WallSurface&) = delete;
  virtual ~WallSurface() = default;

  /// Distance of a place from the wall, for a plane negative behind it [m]; infinity where that is
  /// more than `reach` [m]. `parts` become what find_touches() must look at within that reach.
  [[nodiscard]] virtual double distance(const Vec3& place, double reach,
                                        std::vector<std::size_t>& parts) const = 0;
  /// Of a sphere, all of whose parts are in `parts`.
  virtual void find_touches(const Vec3& centre, double radius, std::span<const std::size_t> parts,
                            WallTouches& touches) const = 0;
  /// Whether a sphere can get so deep behind it that the wall stops it no more.
  [[nodiscard]] virtual bool lets_go() const = 0;
  /// How deep a place lies in the ground right behind the wall [m]; 0: before it or beside it.
  [[nodiscard]] virtual double depth(const Vec3& place) const = 0;
};

}  // namespace muckpile
