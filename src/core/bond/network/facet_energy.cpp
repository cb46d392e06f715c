// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic energy of facets in the present pose.
// Scope: see the header.
#include "bond/network/facet_energy.h"

#include "bond/network/border_relief.h"
#include "bond/network/joint_points.h"
#include "bond/network/softening_points.h"

namespace muckpile {

double contact_energy(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const LaneMask apart = where_contact(facets.history.traces(f));
  if (none_of(apart)) return 0.0;
  const ContactConstants contact = facets.tables.contact(f);
  const Lanes stored = contact_energy_of(facets, f, contact, facets.history.contacts().fade(f),
                                         LaneVec(motion.normal), contact_spring(facets, f, motion));
  return 0.5 * contact.point_area * sum(choose(apart, stored, 0.0));
}

double facet_energy(const FacetKinematics& facets, std::size_t f) {
  const FacetMotion motion = facets.motion(f);
  const LaneVec jumps = facets.elastic_jump(f, motion);
  const BondConstants bond = facets.tables.bond(f);
  const DilatationCoupling coupling = facets.tables.coupling(f);
  const std::vector<double>& theta = facets.blocks.theta;
  const double uneven =
      theta[static_cast<std::size_t>(coupling.i)] - theta[static_cast<std::size_t>(coupling.j)];
  const LaneMask holds = is_point() && !where_contact(facets.history.traces(f));
  const Lanes stored = bonded_energy(facets, f, LaneVec(motion.normal), jumps);
  return 0.5 * (bond.point_area * sum(choose(holds, stored, 0.0)) +
                coupling.sharpening * uneven * uneven) +
         contact_energy(facets, f, motion) + border_energy(facets, f) +
         (facets.tables.laws().softens() ? cohesion_energy(facets, f, motion) : 0.0);
}

}  // namespace muckpile
