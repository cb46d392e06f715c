// SPDX-License-Identifier: GPL-2.0-or-later
// Makes the wall of a crushed zone as stiff as that of a round hole.
// Scope: see the header.
#include "bond/build/wall_facets.h"

#include <algorithm>

#include "geometry/holes/hole_surface.h"

namespace muckpile {
namespace {

// A ring that would have to be softened or stiffened by more is none: a few blocks at the rock's
// edge, or facets that hardly join them. Ours; rings of blocks up to six radii wide take 1.0
// to 5.
constexpr double kLeast = 0.5, kMost = 8.0;

/// Lame's displacement around one hole.
class HoleField {
 public:
  explicit HoleField(const Hole& hole)
      : hole_(hole), along_((hole.collar - hole.toe).normalized()) {}

  [[nodiscard]] const Vec3& along() const { return along_; }
  [[nodiscard]] double radius_squared() const { return hole_.radius * hole_.radius; }
  /// From the axis [m].
  [[nodiscard]] Vec3 across(const Vec3& point) const {
    const Vec3 from_toe = point - hole_.toe;
    return from_toe - from_toe.dot(along_) * along_;
  }
  /// Not beyond an end of the hole.
  [[nodiscard]] bool is_beside(const Vec3& point) const {
    const double height = (point - hole_.toe).dot(along_);
    return height >= 0.0 && height <= hole_length(hole_) &&
           across(point).squaredNorm() > radius_squared();
  }
  /// [1/m]; inside the radius, where a block beyond an end may be, it stays finite.
  [[nodiscard]] Vec3 psi(const Vec3& point) const {
    const Vec3 out = across(point);
    return out / std::max(out.squaredNorm(), radius_squared());
  }

 private:
  Hole hole_;
  Vec3 along_;
};

class WallRings {
 public:
  WallRings(const std::vector<Block>& blocks, int first_tag, std::span<const Hole> holes,
            FacetSet& set)
      : blocks_(blocks), first_tag_(first_tag), set_(set), ring_of_(blocks.size(), kNone) {
    for (const Hole& hole : holes) rings_.push_back({HoleField(hole)});
    std::vector<double> widest(blocks.size(), 0.0);  // face on a hole [m2]
    for (const BoundaryFace& face : set.faces) {
      const std::size_t b = index(face.tag);
      if (face.hole == kNone || face.area <= widest[b]) continue;
      if (!field(face.hole).is_beside(centre(face.tag))) continue;
      widest[b] = face.area;
      ring_of_[b] = face.hole;
    }
  }

  void share_depths() {
    for (BoundaryFace& face : set_.faces) {
      if (face.hole == kNone || ring_of(face.tag) != face.hole) continue;
      const HoleField& hole = field(face.hole);
      const double whole = face.normal.dot(face.arm), axial = face.normal.dot(hole.along());
      const double depth = hole.radius_squared() * face.normal.dot(hole.psi(centre(face.tag))) -
                           face.normal.dot(hole.across(face.start));
      const double share = std::clamp(depth / whole, 0.0, 1.0);
      face.depth_share = share + axial * axial * (1.0 - share);  // ends of a hole are plane
    }
  }

  void stiffen() {
    for (const Facet& facet : set_.facets) {
      const int ring = ring_of(facet);
      if (ring != kNone) rings_[static_cast<std::size_t>(ring)].inner += work(facet, ring);
      for (const int of_end : {ring_of(facet.tag_i), ring_of(facet.tag_j)}) {
        if (of_end != kNone && of_end != ring)
          rings_[static_cast<std::size_t>(of_end)].outer += work(facet, of_end);
      }
    }
    for (const BoundaryFace& face : set_.faces) {
      if (face.hole == kNone || ring_of(face.tag) != face.hole) continue;
      Ring& ring = rings_[static_cast<std::size_t>(face.hole)];
      ring.pressed -= face.area * face.normal.dot(ring.field.psi(centre(face.tag))) /
                      ring.field.radius_squared();
    }
    for (Facet& facet : set_.facets) {
      const int ring = ring_of(facet);
      if (ring != kNone) facet.stiffening = rings_[static_cast<std::size_t>(ring)].stiffening();
    }
  }

 private:
  static constexpr int kNone = -1;
  struct Ring {
    HoleField field;
    double inner = 0.0, outer = 0.0, pressed = 0.0;  // the three sums of the header, in order

    [[nodiscard]] double stiffening() const {
      return inner > 0.0 ? std::clamp((pressed - outer) / inner, kLeast, kMost) : 1.0;
    }
  };

  [[nodiscard]] std::size_t index(int tag) const {
    return static_cast<std::size_t>(tag - first_tag_);
  }
  [[nodiscard]] const Vec3& centre(int tag) const { return blocks_[index(tag)].mass.centroid; }
  [[nodiscard]] const HoleField& field(int hole) const {
    return rings_[static_cast<std::size_t>(hole)].field;
  }
  /// The hole on whose wall a block lies.
  [[nodiscard]] int ring_of(int tag) const {
    return tag == kGroundTag ? kNone : ring_of_[index(tag)];
  }
  /// That of both blocks. A mirror shows the block's image, which is in the ring too.
  [[nodiscard]] int ring_of(const Facet& facet) const {
    const int of_i = ring_of(facet.tag_i);
    return facet.kind == FacetKind::mirror || ring_of(facet.tag_j) == of_i ? of_i : kNone;
  }

  /// Of a facet on its blocks that are in the ring of `hole`, displaced by psi, over 2G [1/m].
  [[nodiscard]] double work(const Facet& facet, int hole) const {
    const auto psi = [&](int tag) {
      return tag == kGroundTag ? Vec3(Vec3::Zero()) : field(hole).psi(centre(tag));
    };
    const auto moved = [&](int tag) {
      return ring_of(tag) == hole ? psi(tag) : Vec3(Vec3::Zero());
    };
    const bool grounded = facet.kind != FacetKind::joint;
    const Vec3 between = grounded ? facet.arm_i : Vec3(facet.arm_i - facet.arm_j);
    const double stiffness = facet.area / facet.normal.dot(between);
    const Vec3 jump = psi(facet.tag_j) - psi(facet.tag_i),
               opened = moved(facet.tag_j) - moved(facet.tag_i);
    if (facet.kind != FacetKind::mirror) return stiffness * opened.dot(jump);
    return stiffness * opened.dot(facet.normal) * jump.dot(facet.normal);  // smooth
  }

  const std::vector<Block>& blocks_;
  int first_tag_;
  FacetSet& set_;
  std::vector<int> ring_of_;  // per block
  std::vector<Ring> rings_;   // per hole
};

}  // namespace

void fit_walls(const std::vector<Block>& blocks, int first_tag, std::span<const Hole> holes,
               FacetSet& set) {
  if (holes.empty()) return;
  WallRings rings(blocks, first_tag, holes, set);
  rings.share_depths();
  rings.stiffen();
}

}  // namespace muckpile
