// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where it softens: what points that have reached their strength still hold, and
// strength that grows with the rate of strain.
// Scope: only with fracture energies or a rate exponent; laws in cohesion.h.
#include <algorithm>

#include "bond/network/facet_lanes.h"
#include "bond/network/facet_network.h"

namespace muckpile {

/// Whether a point that would fail at rest holds at the speed at which its sides part.
bool FacetNetwork::holds_at_its_rate(std::size_t f, const Vec3& normal, const Vec3& traction,
                                     const Vec3& rate) const {
  const auto [depth_i, depth_j] = depths(f);
  const double factor = rate_factor(rate.norm() / (depth_i + depth_j), material().parameters());
  const double along = normal.dot(traction);
  const double shear_squared = (traction - along * normal).squaredNorm();
  const Bond bond = bond_of(f);
  return !joint_fails(along, shear_squared, factor * bond.tension, factor * bond.cohesion,
                      bond.tan_friction);
}

bool FacetNetwork::holds_on(std::size_t f) const {
  return std::ranges::any_of(rare_.get(f).cohesion, &Cohesion::holds);
}

/// Adds what broken points still hold. The work that leapfrog takes, less what is stored, is booked
/// as fracture.
void FacetNetwork::add_cohesion(std::size_t f, const Motion& motion, Pull& pull, double dt) {
  if (!holds_on(f)) return;
  const Contact contact = contact_of(f);
  const Mat3 axes = motion.axes();
  for (int p = 0; p < kFacetPoints; ++p) {
    Cohesion& c = rare_.made(f).cohesion[static_cast<std::size_t>(p)];
    if (!c.holds()) continue;
    const Vec3 direction = axes * c.direction;
    const double path = direction.dot(pull.rate.at(p)) * dt;
    const double now = c.parting(axes.transpose() * pull.jump.at(p)), before = now - path;
    const double traction_before = c.traction(before, c.worst), energy_before = c.energy(before);
    c.worst = std::max(c.worst, now);
    const double traction = c.traction(now, c.worst);
    losses_.fracture += contact.weight * contact.point_area *
                        (0.5 * (traction_before + traction) * path + energy_before - c.energy(now));
    pull.add(p, traction * direction);
    if (c.worst >= c.end) c = {};
  }
  if (!holds_on(f) && facets_[f].kind == FacetKind::joint) rare_.drop(f);
}

/// Of the points that soften [J].
double FacetNetwork::cohesion_energy(std::size_t f, const Motion& motion) const {
  if (!holds_on(f)) return 0.0;
  const Mat3 axes = motion.axes();
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    const Cohesion& c = rare_.get(f).cohesion[static_cast<std::size_t>(p)];
    if (c.holds()) stored += c.energy(c.parting(axes.transpose() * motion.jump().at(p)));
  }
  return area(f) / kFacetPoints * stored;
}

}  // namespace muckpile
