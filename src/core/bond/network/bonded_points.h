// SPDX-License-Identifier: GPL-2.0-or-later
// The points of a facet that are in the dilatations: tractions, breaking, dashpots, slip,
// walls that crush.
// Scope: a pass over one facet at a time, made for one step; facets that hold at every point go
// through it only if one of theirs fails (traction_pass.h). SI units.
#pragma once

#include "bond/network/facet_breaking.h"
#include "bond/network/facet_pull.h"

namespace muckpile {

/// Part of a facet's traction that is the same at all points: of bulk stresses and leaning [Pa].
[[nodiscard]] Vec3 bulk_traction(const FacetKinematics& facets, const LeaningFaces* leaning,
                                 std::size_t f, const FacetOpenings& openings);
/// Of the points, as if all of them were bonded, on block i, without dashpots [Pa].
[[nodiscard]] LaneVec bonded_tractions(const FacetKinematics& facets, const LeaningFaces* leaning,
                                       std::size_t f, const FacetMotion& motion);
/// Of an intact facet on its block i [Pa].
[[nodiscard]] Vec3 mean_traction(const FacetKinematics& facets, const LeaningFaces* leaning,
                                 std::size_t f);

class BondedPoints {
 public:
  explicit BondedPoints(const FacetBreaking::Parts& parts)
      : parts_(parts), facets_{parts.tables, parts.history, parts.blocks}, breaking_(parts) {}

  /// Tractions of the points as if all of them were bonded.
  [[nodiscard]] FacetPull pull(std::size_t f, const FacetMotion& motion) const;
  /// Breaks points that fail, damps the others over a step dt [s]; the traction of points that have
  /// left the dilatations is no longer true.
  void work(std::size_t f, const FacetMotion& motion, const ContactConstants& contact,
            FacetPull& pull, double dt);

 private:
  void crush(std::size_t f, const FacetMotion& motion, const ContactConstants& contact,
             FacetPull& pull, double dt);
  [[nodiscard]] double crush_blocks(std::size_t f, const FacetMotion& motion, double closer);
  void rub(std::size_t f, const FacetMotion& motion, const ContactConstants& contact,
           FacetPull& pull, double dt);

  FacetBreaking::Parts parts_;
  FacetKinematics facets_;
  FacetBreaking breaking_;
};

}  // namespace muckpile
