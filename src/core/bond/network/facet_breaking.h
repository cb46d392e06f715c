// SPDX-License-Identifier: GPL-2.0-or-later
// Points of facets that break: what they still carry, what leaves the dilatations, and what that
// costs.
// Scope: a pass over the parts of a network, made for one step. Reads poses, theta and bulk stress;
// changes the history and the couplings of facets, and books losses [J]. Laws are in bond/law.
#pragma once

#include <optional>
#include <vector>

#include "bond/network/facet_kinematics.h"
#include "bond/network/facet_schedule.h"
#include "bond/network/joint_books.h"
#include "bond/network/leaning_faces.h"

namespace muckpile {

/// What a point carried as it broke.
struct PointBreak {
  int point;
  Vec3 normal, jump, elastic, traction, rate;  ///< [-], [m], less what it slipped, [Pa], [m/s]
  FacetOpenings openings;
  Mat3 axes;  ///< of the facet
  bool torn;  ///< turned too far, or slid
};

/// How stiff a facet is against slip through its blocks, over its spring [-].
struct SlipThroughBlocks {
  double dilatations;  ///< by the part of m in the facet's plane
  double leaning;      ///< where faces lean (leaning_faces.h), at most
  [[nodiscard]] double most() const { return dilatations + leaning; }
};
[[nodiscard]] SlipThroughBlocks slip_through_blocks(const FacetKinematics& facets,
                                                    const LeaningFaces* leaning, std::size_t f);

class FacetBreaking {
 public:
  /// What breaking changes. `leaning` is nullptr where no facet leans.
  struct Parts {
    FacetTables& tables;
    FacetHistory& history;
    BlockFields& blocks;
    FacetSchedule& schedule;
    JointBooks& books;
    LeaningFaces* leaning;
    bool keeps_gas;  ///< joints that break keep gas
  };
  explicit FacetBreaking(const Parts& parts)
      : parts_(parts), facets_{parts.tables, parts.history, parts.blocks} {}

  /// Returns what the point no longer carries [Pa].
  Vec3 break_point(std::size_t f, const PointBreak& broken, double dt);
  /// Takes what broke in this step from the sums of its blocks and books what that costs; theta of
  /// owned blocks is right after it, bulk stresses are not. What is due to the changes of both
  /// thetas of a facet whose blocks belong to two ranks is left to book_shared_changes().
  void book_step();
  /// Both ranks know BlockFields::theta_lost of all their blocks and copies.
  void book_shared_changes();

 private:
  struct Remnant;  // what a point that broke still carries

  [[nodiscard]] bool may_slip(std::size_t f) const;
  [[nodiscard]] Remnant remnant_of(std::size_t f, const PointBreak& broken) const;
  [[nodiscard]] Vec3 strain_lost(std::size_t f, const PointBreak& broken,
                                 const Remnant& left) const;
  [[nodiscard]] Cohesion cohesion_of(std::size_t f, const PointBreak& broken,
                                     const Vec3& dropped) const;
  void book_break(std::size_t f, const PointBreak& broken, const Remnant& left, double dt);
  void drop_from_dilatation(std::size_t f, const PointBreak& broken, const Remnant& left);
  void book_sharpening(const std::vector<double>& theta_before);
  void note_losses(const std::vector<double>& theta_before);

  Parts parts_;
  FacetKinematics facets_;
};

}  // namespace muckpile
