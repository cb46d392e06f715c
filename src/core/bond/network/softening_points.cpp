// SPDX-License-Identifier: GPL-2.0-or-later
// Broken points that soften.
// Scope: see the header.
#include "bond/network/softening_points.h"

#include <algorithm>
#include <array>

namespace muckpile {

void add_cohesion(const FacetKinematics& facets, FacetHistory& history, JointLosses& losses,
                  std::size_t f, const FacetMotion& motion, FacetPull& pull, double dt) {
  if (!history.softens(f)) return;
  const ContactConstants contact = facets.tables.contact(f);
  const Mat3 axes = motion.axes();
  for (int p = 0; p < kFacetPoints; ++p) {
    Cohesion& c = history.cohesion_of_point(f, static_cast<std::size_t>(p));
    if (!c.holds()) continue;
    const Vec3 direction = axes * c.direction;
    const double path = direction.dot(pull.rate.at(p)) * dt;
    const double now = c.parting(axes.transpose() * pull.jump.at(p));
    // Where blocks turn as they pass each other the path of the step is not what the parting has
    // changed by; no parting before was beyond the worst.
    const double before = std::min(now - path, c.worst);
    const double traction_before = c.traction(before, c.worst), energy_before = c.energy(before);
    c.worst = std::max(c.worst, now);
    const double traction = c.traction(now, c.worst);
    losses.fracture += contact.weight * contact.point_area *
                       (0.5 * (traction_before + traction) * path + energy_before - c.energy(now));
    pull.add(p, traction * direction);
    if (c.worst >= c.end) c = {};
  }
  if (!history.softens(f) && facets.tables.is_joint(f)) history.stop_softening(f);
}

CohesionOf<Lanes> cohesion_at_points(const FacetHistory& history, std::size_t f) {
  const auto of = [&](double Cohesion::*number) {
    return Lanes([&](auto lane) {
      return lane < kFacetPoints ? history.cohesion(f, lane % kFacetPoints).*number : 0.0;
    });
  };
  std::array<Vec3, kFacetPoints> directions;
  for (std::size_t p = 0; p < kFacetPoints; ++p) directions[p] = history.cohesion(f, p).direction;
  return {lanes_of(directions), of(&Cohesion::strength), of(&Cohesion::first),
          of(&Cohesion::end),   of(&Cohesion::worst),    of(&Cohesion::shift)};
}

double cohesion_energy(const FacetKinematics& facets, std::size_t f, const FacetMotion& motion) {
  if (!facets.history.softens(f)) return 0.0;
  const CohesionOf<Lanes> c = cohesion_at_points(facets.history, f);
  const Lanes parting = c.parting(rotated_back(motion.axes(), motion.jump()));
  return facets.tables.area(f) / kFacetPoints * sum(c.energy(parting));
}

LaneVec cohesion_tractions(const FacetKinematics& facets, std::size_t f,
                           const FacetMotion& motion) {
  if (!facets.history.softens(f)) return {};
  const Mat3 axes = motion.axes();
  const CohesionOf<Lanes> c = cohesion_at_points(facets.history, f);
  const Lanes parting = c.parting(rotated_back(axes, motion.jump()));
  return c.traction(parting, max(parting, c.worst)) * rotated(axes, c.direction);
}

}  // namespace muckpile
