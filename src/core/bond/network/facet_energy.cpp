// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic energy of facets in the present pose.
// Scope: see the header.
#include "bond/network/facet_energy.h"

#include "bond/network/border_relief.h"
#include "bond/network/nonlinear_points.h"

namespace muckpile {

double contact_energy(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  const ContactConstants contact = facets.tables.contact(f);
  if (facets.tables.nonlinear_law(f) != nullptr)
    return nonlinear_contact_energy(facets, f, motion, contact);
  const ContactMemory memory = facets.history.contacts().get(f);
  const Mat3 axes = motion.axes();
  const LaneVec jump = motion.jump();
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    const auto q = static_cast<std::size_t>(p);
    if (!facets.history.traces(f).is_contact(q)) continue;
    const Vec3 spring = jump.at(p) - axes * memory.offset[q];
    const double closed = motion.normal.dot(spring);
    if (closed >= 0.0) continue;
    const Vec3 sheared = spring - closed * motion.normal;
    stored += contact.closure.twice_energy(closed) + contact.shear * sheared.squaredNorm();
  }
  return 0.5 * contact.point_area * memory.fade * stored;
}

double cohesion_energy(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  if (!facets.history.softens(f)) return 0.0;
  const Mat3 axes = motion.axes();
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    const Cohesion& c = facets.history.cohesion(f, static_cast<std::size_t>(p));
    if (c.holds()) stored += c.energy(c.parting(axes.transpose() * motion.jump().at(p)));
  }
  return facets.tables.area(f) / kFacetPoints * stored;
}

double facet_energy(const FacetKinematics& facets, std::size_t f) {
  const FacetMotion motion = facets.motion(f);
  const LaneVec jumps = facets.elastic_jump(f, motion);
  const BondConstants bond = facets.tables.bond(f);
  const DilatationCoupling coupling = facets.tables.coupling(f);
  const std::vector<double>& theta = facets.blocks.theta;
  const double uneven =
      theta[static_cast<std::size_t>(coupling.i)] - theta[static_cast<std::size_t>(coupling.j)];
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    const auto q = static_cast<std::size_t>(p);
    if (facets.history.traces(f).is_contact(q)) continue;
    stored += bonded_energy_at(facets, f, q, motion.normal, jumps.at(p));
  }
  return 0.5 * (bond.point_area * stored + coupling.sharpening * uneven * uneven) +
         contact_energy(facets, f, motion) + border_energy(facets, f) +
         (facets.tables.laws().softens() ? cohesion_energy(facets, f, motion) : 0.0);
}

}  // namespace muckpile
