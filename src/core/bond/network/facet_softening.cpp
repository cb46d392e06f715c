// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where it softens: what points that have reached their strength still hold, and
// strength, which grows with the rate of strain.
// Scope: laws in coulomb.h and cohesion.h.
#include <algorithm>

#include "bond/network/facet_lanes.h"
#include "bond/network/facet_network.h"

namespace muckpile {

/// Which points fail if they are bonded, at the speed at which their sides part.
LaneMask FacetNetwork::failing(std::size_t f, const Pull& pull, const LaneMask& slipping) const {
  const CoulombStrength<double>& at_rest = strengths_[facets_[f].joint_class].bonded;
  const CoulombStrength<Lanes> strength{at_rest.tension, at_rest.cohesion, at_rest.tan_friction};
  const LaneMask fails = pull.failing(strength, slipping);
  if (!depends_on_rate_ || none_of(fails)) return fails;
  const auto [depth_i, depth_j] = depths(f);
  const Lanes rate = sqrt(dot(pull.rate, pull.rate)) / (depth_i + depth_j);
  const Lanes faster([&](auto lane) { return rate_factor(rate[lane], material().parameters()); });
  return fails && (slipping || pull.failing(strength.scaled(faster), slipping));
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
