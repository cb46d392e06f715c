// SPDX-License-Identifier: GPL-2.0-or-later
// Broken points of facets: plane contact while the two faces still match, and what ends it. A facet
// fades as it slides or turns away, carries nothing while it is open, and retires once it is wide.
// Scope: a pass over the parts of a network, made for one step of dt [s]; one facet at a time, or
// those of a group that hold at no point. What happens once to a facet is done one by one. The law
// is bond/law/plane_contact.h, the formulas are in docs/styles/fix_muckpile_joint.md. SI units.
#pragma once

#include "bond/network/facet_pull.h"
#include "bond/network/facet_schedule.h"
#include "bond/network/facet_wide.h"
#include "bond/network/joint_books.h"

namespace muckpile {

/// Of one facet's two sides.
[[nodiscard]] FacetParting<double> parting_of(const FacetMotion& motion,
                                              const ContactConstants& contact);

/// Of the points that have left the dilatations, on block i: what their springs carry, without
/// dashpots; 0 at the others [Pa].
[[nodiscard]] LaneVec contact_tractions(const FacetKinematics& facets, std::size_t f,
                                        const FacetMotion& motion);

class BrokenContact {
 public:
  BrokenContact(const FacetKinematics& facets, FacetHistory& history, FacetSchedule& schedule,
                JointBooks& books, double dt)
      : facets_(facets), history_(history), schedule_(schedule), books_(books), dt_(dt) {}

  /// Lets a broken facet fade or retire; false if it carries nothing in this step.
  [[nodiscard]] bool remains(std::size_t f, const FacetMotion& motion,
                             const ContactConstants& contact);
  /// Tractions of the points that have left the dilatations.
  void add_tractions(std::size_t f, const FacetMotion& motion, const ContactConstants& contact,
                     FacetPull& pull);

  /// Those of a group's facets that are broken at all points, of a grouped law, and do not soften.
  [[nodiscard]] unsigned apart_lanes(const LaneSet& working) const;
  /// Forces of those of `lanes`, which are apart, that touch; returns which.
  [[nodiscard]] unsigned find_forces(std::size_t g, unsigned lanes, const WidePose& pose,
                                     WideForces& forces);

 private:
  struct Remembered;  // what the contact of a group's facets remembers

  void fade(std::size_t f, const FacetMotion& motion, double matching);
  void retire(std::size_t f);
  [[nodiscard]] Remembered remembered(std::size_t g, unsigned lanes);
  void fade_lanes(std::size_t g, unsigned lanes, const FacetParting<Wide>& parting,
                  const ContactGroup& memory);
  [[nodiscard]] unsigned remaining_lanes(std::size_t g, unsigned lanes, const WidePose& pose,
                                         const ContactGroup& memory);
  template <template <class> class Closure>
  void touch(std::size_t g, unsigned lanes, const WidePose& pose, const Remembered& contact,
             WideForces& forces);

  FacetKinematics facets_;
  FacetHistory& history_;
  FacetSchedule& schedule_;
  JointBooks& books_;
  double dt_;
};

}  // namespace muckpile
