// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in the broken joints of the facet network: how far they are open, and the forces of its
// pressure.
// Scope: see facet_network.h; how much gas is where is gas/joint_gas.h.
#include <algorithm>

#include "bond/facet_lanes.h"
#include "bond/facet_network.h"

namespace muckpile {
namespace {

// A joint that has retired still holds gas between its two blocks. It is in the open once it has
// opened or slid by its radius, or turned by a radian: there is more void than joint then.
constexpr double kWide = 1.0;

}  // namespace

std::span<double> FacetNetwork::gas_pressure() {
  if (gas_pressure_.size() != blocks_.size()) {
    gas_pressure_.assign(blocks_.size(), 0.0);
    gas_force_.assign(blocks_.size(), Vec3::Zero());
    gas_torque_.assign(blocks_.size(), Vec3::Zero());
  }
  return gas_pressure_;
}

FacetNetwork::OpenJoint FacetNetwork::open_joint(std::size_t f) const {
  const int broken = kFacetPoints - bonded_points_[f];
  if (broken == 0) return {};
  const Motion motion = motion_of(f);
  const Lanes gaps = dot(LaneVec(motion.normal), motion.jump());
  double opening = 0.0;
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    if (memory_[f].broken[p])
      opening += std::max(0.0, gaps[p] - memory_[f].contact.get().offset[p].x());
  }
  const Contact contact = contact_of(f);
  const bool wide = motion.mean_jump().squaredNorm() > kWide * kWide * contact.radius_squared ||
                    motion.turned(kWide);
  return {broken * area(f) / kFacetPoints, opening / broken, wide};
}

void FacetNetwork::release_gas() {
  gas_pressure_.clear();
  keeps_gas_ = false;
  for (FacetMemory& memory : memory_) memory.gas = false;
}

/// The gas pushes the two blocks apart at every broken point; its forces are kept for its work. It
/// does not enter the dilatations, as the contact of broken points does not.
void FacetNetwork::press_joints() {
  if (gas_pressure_.size() != blocks_.size()) return;
  std::fill(gas_force_.begin(), gas_force_.end(), Vec3::Zero());
  std::fill(gas_torque_.begin(), gas_torque_.end(), Vec3::Zero());
  each_facet(active_, [&](std::size_t f) {
    if (bonded_points_[f] == kFacetPoints || memory_[f].over()) return;
    const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
    const bool joint = facets_[f].kind == FacetKind::joint;
    const double pressure = joint ? 0.5 * (gas_pressure_[i] + gas_pressure_[j]) : gas_pressure_[i];
    if (pressure == 0.0) return;
    const Pull pull(motion_of(f));
    const LaneMask broken = bonded_points_[f] == 0 ? is_point() : where_true(memory_[f].broken);
    const LaneVec at_points =
        choose(broken, Lanes(-pressure * area(f) / kFacetPoints), 0.0) * pull.normal;
    const Vec3 force = sum(at_points), moment = sum(cross(pull.arm, at_points));
    gas_force_[i] += force;
    gas_torque_[i] += moment;
    gas_force_[j] -= force;
    gas_torque_[j] -= moment + (state_[i].centre - state_[j].centre).cross(force);
  });
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    force_[b] += gas_force_[b];
    torque_[b] += gas_torque_[b];
  }
}

}  // namespace muckpile
