// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network where the lines between the centres do not cross the faces at right angles.
// Scope: bonded facets of cuts with Leaning::much (facet_builder.h); see facet_network.h.
//
// The springs 2G/h hold the jump u = F d of a homogeneous gradient F with 2G F d/h, which is the
// continuum's 2G F m only where the line of centres d has the direction of m. A block's own share
// of the energy that is exact for every F is that of its gradient and of what departs from it,
//   G V F:F + sum of A (G/2h) |u - F d|^2,   F = sum of A u (x) m/2 / V,
// never negative, and F exact as m makes it. With d/h = m + g that is the springs' energy plus
//   G V (F:F Q - 2 F:E),   E = sum of A u (x) g/2 / V,   Q = sym sum of A d (x) g/2 / V:
// nothing at all where g = 0. So t gets [T_i m_i - 2G F_i g_i + T_j m_j - 2G F_j g_j]/2 with
// T = 2G (F Q - E) of each block. In a homogeneous strain the whole traction is then the
// continuum's times the mean of m_i and m_j, which facet_openings.cpp makes n. Of a compliant joint
// only the part of u that strains rock counts, so that the energy stays above 0. m and g turn with
// the mean of the two blocks, Q with its block. Kin: the stabilised correspondence models of
// peridynamics (Silling 2017).
#include <algorithm>
#include <cmath>

#include "bond/network/facet_lanes.h"
#include "bond/network/facet_network.h"

namespace muckpile {
namespace {

std::span<double> numbers_of(std::vector<Mat3>& tensors, std::size_t blocks) {
  if (tensors.size() < blocks) tensors.resize(blocks, Mat3::Zero());
  return {blocks > 0 ? tensors.front().data() : nullptr, 9 * blocks};
}

}  // namespace

std::span<double> FacetNetwork::gradients(std::size_t blocks) {
  return numbers_of(gradients_, blocks);
}

std::span<double> FacetNetwork::slant_stresses(std::size_t blocks) {
  return numbers_of(slant_stresses_, blocks);
}

/// From the centre of block i to that of j in the start [m].
Vec3 FacetNetwork::line_of_centres(std::size_t f) const {
  return at_lane(group_of(f).arm, lane_of(f)) - arm_j_of(f);
}

void FacetNetwork::derive_slants() {
  slants_.clear();
  slant_traction_.clear();
  const auto is_slanted = [](const FacetName& facet) { return facet.slanted_i || facet.slanted_j; };
  if (std::none_of(facets_.begin(), facets_.end(), is_slanted)) return;
  slants_.resize(facets_.size());
  slant_traction_.assign(groups_.size() * kGroup, Vec3::Zero());
  gradients_.assign(blocks_.size(), Mat3::Zero());
  slant_stresses_.assign(blocks_.size(), Mat3::Zero());
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].kind != FacetKind::joint) {
      slants_[f].shear_share = facets_[f].kind == FacetKind::mirror ? 0.0 : 1.0;
      continue;
    }
    const Vec3 between = line_of_centres(f), normal = at_lane(group_of(f).normal, lane_of(f));
    const Vec3 along = between / normal.dot(between);
    const Bond bond = bond_of(f);
    slants_[f].lean = {along - bond.opening_i, along - bond.opening_j};
    const double rock = 2.0 * material().shear_modulus() / normal.dot(between);
    slants_[f].shear_share = bond.shear / rock / (bond.bulk_i + bond.bulk_j);
  }
}

/// The part of the bonded points of a facet in the moment Q of its block i (side 0) or j, times V.
Mat3 FacetNetwork::slant_moment(std::size_t f, int side) const {
  const Vec3 between = line_of_centres(f);
  const Mat3 m = between * slants_[f].lean[static_cast<std::size_t>(side)].transpose();
  return 0.25 * (area(f) / kFacetPoints) * (m + m.transpose());
}

void FacetNetwork::count_slants() {
  if (!slanted()) return;
  block_slants_.assign(blocks_.size(), {});
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].kind != FacetKind::joint) continue;
    const auto i = static_cast<std::size_t>(i_of(f)), j = static_cast<std::size_t>(j_of(f));
    const double points = bonded_points_[f];
    if (facets_[f].slanted_i)
      block_slants_[i].moment += points / blocks_[i].volume * slant_moment(f, 0);
    if (facets_[f].slanted_j)
      block_slants_[j].moment += points / blocks_[j].volume * slant_moment(f, 1);
  }
}

/// A direction that turns with the mean of the two blocks, as the openings do.
Vec3 FacetNetwork::turned(std::size_t f, const Vec3& start, double scale) const {
  return scale * (state_[static_cast<std::size_t>(i_of(f))].rotation * start +
                  state_[static_cast<std::size_t>(j_of(f))].rotation * start);
}

/// Gradients of all blocks, and the slant stresses of those that are owned.
void FacetNetwork::stretch_slanted() {
  std::fill(gradients_.begin(), gradients_.end(), Mat3::Zero());
  for (BlockSlant& block : block_slants_) block.excess.setZero();
  each_facet(bonded_, [&](std::size_t f) {
    const std::array<bool, 2> slanted = facets_[f].slanted();
    if (bonded_points_[f] == 0 || !(slanted[0] || slanted[1])) return;
    const Motion motion = motion_of(f);
    const Openings openings = openings_of(f, motion.scale);
    const Vec3 jump = slants_[f].strained(bonded_jump(f, motion), motion.normal);
    const auto add = [&](int block, double area, const Vec3& opening, const Vec3& lean) {
      const auto b = static_cast<std::size_t>(block);
      const Vec3 opened = area / blocks_[b].volume * jump;
      gradients_[b] += opened * opening.transpose();
      block_slants_[b].excess += opened * turned(f, lean, motion.scale).transpose();
    };
    if (slanted[0]) add(i_of(f), bond_of(f).area_i, openings.i, slants_[f].lean[0]);
    if (slanted[1]) add(j_of(f), bond_of(f).area_j, openings.j, slants_[f].lean[1]);
  });
  for (std::size_t b = 0; b < blocks_.size(); ++b) slant_stresses_[b] = slant_stress(b);
}

/// T [Pa].
Mat3 FacetNetwork::slant_stress(std::size_t b) const {
  const Mat3& r = state_[b].rotation;
  const BlockSlant& slant = block_slants_[b];
  return 2.0 * material().shear_modulus() *
         (gradients_[b] * (r * slant.moment * r.transpose()) - slant.excess);
}

/// [J]
double FacetNetwork::slant_energy(std::size_t b) const {
  if (!slanted()) return 0.0;
  // G (F:F Q - 2 F:E) = F:T/2 - G F:E.
  return blocks_[b].volume *
         (0.5 * gradients_[b].cwiseProduct(slant_stress(b)).sum() -
          material().shear_modulus() * gradients_[b].cwiseProduct(block_slants_[b].excess).sum());
}

/// On a block that turns its moment Q against its gradient [N m].
Vec3 FacetNetwork::moment_torque(std::size_t b) const {
  const Mat3& r = state_[b].rotation;
  const Mat3 q = r * block_slants_[b].moment * r.transpose();
  const Mat3 squared = gradients_[b].transpose() * gradients_[b];
  const Mat3 swirl = q * squared - squared * q;
  return 2.0 * blocks_[b].volume * material().shear_modulus() *
         Vec3(swirl(2, 1), swirl(0, 2), swirl(1, 0));
}

/// Tractions by the slant, and what turns blocks beside them: u, m and g of one facet may turn
/// without the block's other facets and its moment, which changes the energy.
void FacetNetwork::pull_slanted() {
  const double two_g = 2.0 * material().shear_modulus();
  each_facet(working_, [&](std::size_t f) {
    const std::array<bool, 2> slanted = facets_[f].slanted();
    if (bonded_points_[f] == 0 || !(slanted[0] || slanted[1])) return;
    const Motion motion = motion_of(f);
    const Openings openings = openings_of(f, motion.scale);
    const Vec3 jump = slants_[f].strained(bonded_jump(f, motion), motion.normal);
    Vec3 traction = Vec3::Zero(), turning = Vec3::Zero();
    const auto add = [&](int block, double share, const Vec3& opening, const Vec3& start) {
      const auto b = static_cast<std::size_t>(block);
      const Mat3& stress = slant_stresses_[b];
      const Mat3& gradient = gradients_[b];
      const Vec3 lean = two_g * turned(f, start, motion.scale);
      traction += share * (stress * opening - gradient * lean);
      turning += share * (opening.cross(Vec3(stress.transpose() * jump)) -
                          lean.cross(Vec3(gradient.transpose() * jump)));
    };
    if (slanted[0]) add(i_of(f), bond_of(f).bulk_i, openings.i, slants_[f].lean[0]);
    if (slanted[1]) add(j_of(f), bond_of(f).bulk_j, openings.j, slants_[f].lean[1]);
    slant_traction_[f] = slants_[f].strained(traction, motion.normal);
    turning = (-0.5 * area(f) * (turning + jump.cross(traction))).eval();
    torque_[static_cast<std::size_t>(i_of(f))] += turning;
    torque_[static_cast<std::size_t>(j_of(f))] += turning;
  });
  for (std::size_t b = 0; b < blocks_.size(); ++b) torque_[b] += moment_torque(b);
}

void FacetNetwork::drop_from_slant(std::size_t f, const Break& broken, const Remnant& left) {
  const double scale = motion_of(f).scale;
  const Vec3 jump = slants_[f].strained(left.lost, broken.normal);
  const auto drop = [&](int side, int block, double area, const Vec3& opening) {
    if (!facets_[f].slanted()[static_cast<std::size_t>(side)]) return;
    const auto b = static_cast<std::size_t>(block);
    const Vec3 opened = area / (kFacetPoints * blocks_[b].volume) * jump;
    const Vec3 lean = turned(f, slants_[f].lean[static_cast<std::size_t>(side)], scale);
    block_slants_[b].dropped_gradient += opened * opening.transpose();
    block_slants_[b].dropped_excess += opened * lean.transpose();
    if (facets_[f].kind == FacetKind::joint && !left.slips)
      block_slants_[b].dropped_moment += slant_moment(f, side) / blocks_[b].volume;
  };
  drop(0, i_of(f), bond_of(f).area_i, broken.openings.i);
  drop(1, j_of(f), bond_of(f).area_j, broken.openings.j);
}

/// Takes out what broke in this step and books what the slant's energy loses by it; what blocks of
/// other ranks lose is booked there.
void FacetNetwork::book_slant() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    BlockSlant& slant = block_slants_[b];
    if (blocks_[b].owned) {
      const double before = slant_energy(b);
      gradients_[b] -= slant.dropped_gradient;
      slant.excess -= slant.dropped_excess;
      slant.moment -= slant.dropped_moment;
      losses_.fracture += before - slant_energy(b);
      slant_stresses_[b] = slant_stress(b);
    }
    slant.dropped_gradient = slant.dropped_excess = slant.dropped_moment = Mat3::Zero();
  }
}

}  // namespace muckpile
