// SPDX-License-Identifier: GPL-2.0-or-later
// The facets of a network: placing them in the tables and deriving their stiffness.
// Scope: see the header.
#include "bond/network/facet_tables.h"

#include <algorithm>

namespace muckpile {
namespace {

/// m of block i. A block may slide along a mirror, and the ground of a fixed support may yield.
Vec3 opening_of(const Facet& facet) {
  if (facet.kind == FacetKind::joint) return facet.opening_i;
  if (facet.kind == FacetKind::fixed) return facet.normal;
  const Vec3 part = facet.normal.dot(facet.opening_i) * facet.normal;
  // What is that part already stays as it was rounded.
  constexpr double kRounded = 1e-6;
  const bool is_part = (facet.opening_i - part).norm() <= kRounded * part.norm();
  return is_part ? facet.opening_i : part;
}

}  // namespace

void FacetTables::soften(double factor, std::optional<double> damping,
                         const std::vector<std::uint8_t>& bonded_points) {
  laws_.soften(factor, damping);
  derive_all(bonded_points);
}

void FacetTables::reset(std::size_t count) {
  names_.resize(count);
  FacetGroup empty;
  empty.normal[0].fill(1.0f);  // lanes without a facet are worked on as well
  groups_.assign((count + kGroup - 1) / kGroup, empty);
  stiffening_ = {};
  alone_.assign(laws_.any_alone() ? groups_.size() : 0, 0);
  borders_ = {};
  border_lanes_.assign(laws_.zoned() ? groups_.size() : 0, 0);
}

void FacetTables::release() {
  stiffening_ = {};
  names_ = {};
  groups_ = {};
  alone_ = {};
  borders_ = {};
  border_lanes_ = {};
}

void FacetTables::stiffen(std::size_t f, double stiffening) {
  if (stiffening == 1.0) return;
  if (stiffening_.empty()) stiffening_.assign(names_.size(), 1.0f);
  stiffening_[f] = static_cast<float>(stiffening);
}

Vec3 FacetTables::place(std::size_t f, const Facet& facet) {
  FacetName& name = names_[f];
  name.weight = static_cast<float>(facet.weight);
  name.face = static_cast<std::uint16_t>(facet.face);
  name.law = laws_.law_of(facet.joint_class, facet.zone_i, facet.zone_j);
  name.kind = facet.kind;
  name.sharpened = facet.sharpened;
  name.slanted_i = facet.slanted[0];
  name.slanted_j = facet.slanted[1];
  FacetGroup& group = groups_[f / kGroup];
  const std::size_t lane = lane_of(f);
  group.i[lane] = facet.i;
  group.j[lane] = facet.j;
  group.area[lane] = facet.area;
  stiffen(f, facet.stiffening);
  set_lane(group.arm, lane, facet.arm_i);
  set_lane(group.half_1, lane, facet.half_axes[0]);
  set_lane(group.half_2, lane, facet.half_axes[1]);
  set_lane(group.normal, lane, facet.normal);
  set_lane(group.opening_i, lane, opening_of(facet));
  set_lane(group.opening_j, lane,
           facet.kind == FacetKind::joint ? facet.opening_j : Vec3(Vec3::Zero()));
  const Vec3 rounded = at_lane(group.arm, lane) - facet.arm_i;  // the same place from j
  const Vec3 arm_j = facet.arm_j + rounded;
  set_lane(group.arm_j, lane, arm_j);
  if (is_border(f)) split_jump(f, facet);
  return arm_j;
}

/// Facets are placed in order.
void FacetTables::split_jump(std::size_t f, const Facet& facet) {
  FacetGroup& group = groups_[f / kGroup];
  const std::size_t k = lane_of(f);
  const Vec3 m_i = at_lane(group.opening_i, k), m_j = at_lane(group.opening_j, k), n = normal(f);
  borders_.push_back({f, m_i.cast<float>(), m_j.cast<float>(), facet.border_room});
  border_lanes_[f / kGroup] = static_cast<std::uint8_t>(border_lanes_[f / kGroup] | 1u << k);
  const TwoRocks both = two_rocks(f);
  set_lane(group.opening_i, k, both.opening(0, m_i, n));
  set_lane(group.opening_j, k, both.opening(1, m_j, n));
}

std::size_t FacetTables::border_of(std::size_t f) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(borders_, f, {}, &Border::facet) -
                                  borders_.begin());
}

/// Formulas are in border_relief.h.
void FacetTables::derive_border(std::size_t f) {
  Border& border = borders_[border_of(f)];
  if (border.room[0] == 0.0f || alone(f)) return;
  const auto [depth_i, depth_j] = depths(f);
  const double depth[2] = {depth_i / stiffening(f), depth_j / stiffening(f)};
  const double h = depth[0] + depth[1];
  const JointMaterial* const rock[2] = {&laws_.rock(laws_.zone_i(names_[f].law)),
                                        &laws_.rock(laws_.zone_j(names_[f].law))};
  const Vec3 m[2] = {border.opening_i.cast<double>(), border.opening_j.cast<double>()};
  const TwoRocks both = two_rocks(f);
  double stiffness = 0.0, pull[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const double g = 0.5 * h * m[k].dot(normal(f)) / depth[k];
    pull[k] = rock[k]->lame_lambda() * g;
    stiffness += 2.0 * rock[k]->shear_modulus() / depth[k] + pull[k] * g / double{border.room[k]};
  }
  border.push =
      2.0 * rock_share(f) / h *
      (rock[0]->shear_modulus() * both.along[0] - rock[1]->shear_modulus() * both.along[1]);
  border.pull_i = pull[0];
  border.pull_j = pull[1];
  border.give = 1.0 / stiffness;
}

TwoRocks FacetTables::two_rocks(std::size_t f) const {
  const std::size_t law = names_[f].law;
  const auto [depth_i, depth_j] = depths(f);
  return muckpile::two_rocks(laws_.rock(laws_.zone_i(law)), depth_i / stiffening(f),
                             laws_.rock(laws_.zone_j(law)), depth_j / stiffening(f));
}

Facet FacetTables::facet(std::size_t f) const {
  const FacetName& name = names_[f];
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  Facet facet;
  facet.i = group.i[k];
  facet.j = group.j[k];
  facet.face = name.face;
  facet.kind = name.kind;
  facet.joint_class = laws_.class_of(name.law);
  facet.zone_i = laws_.zone_i(name.law);
  facet.zone_j = laws_.zone_j(name.law);
  facet.normal = at_lane(group.normal, k);
  facet.arm_i = at_lane(group.arm, k);
  facet.arm_j = at_lane(group.arm_j, k);
  facet.opening_i = at_lane(group.opening_i, k);
  facet.opening_j = at_lane(group.opening_j, k);
  if (facet.zone_i != facet.zone_j) {
    const Border& border = borders_[border_of(f)];
    facet.opening_i = border.opening_i.cast<double>();
    facet.opening_j = border.opening_j.cast<double>();
    facet.border_room = border.room;
  }
  facet.half_axes = {at_lane(group.half_1, k), at_lane(group.half_2, k)};
  facet.area = group.area[k];
  facet.stiffening = stiffening(f);
  facet.sharpened = name.sharpened;
  facet.slanted = name.slanted();
  facet.weight = name.weight;
  return facet;
}

FacetStiffness FacetTables::stiffness(std::size_t f, const Facet& facet) const {
  const JointMaterial& law = laws_.of_law(names_[f].law);
  if (facet.zone_i != facet.zone_j) {
    const TwoRocks both = two_rocks(f);
    return joint_in_rock(both.normal, both.shear, both.uniaxial, law.parameters().normal_stiffness,
                         law.parameters().shear_stiffness);
  }
  const auto [depth_i, depth_j] = depths(f);
  return law.facet_stiffness((depth_i + depth_j) / facet.stiffening);
}

void FacetTables::derive(std::size_t f, int bonded_points) {
  const Facet facet = this->facet(f);
  const bool grounded = facet.kind != FacetKind::joint, smooth = facet.kind == FacetKind::mirror;
  const double depth_i = facet.normal.dot(facet.arm_i);
  const double depth_j = grounded ? 0.0 : -facet.normal.dot(facet.arm_j);
  const FacetStiffness k = stiffness(f, facet);
  const double shear = smooth ? 0.0 : k.shear, point_area = facet.area / kFacetPoints;
  const JointMaterial& rock = laws_.rock(facet.zone_i);
  const double d = kSharpening * (2.0 * rock.lame_lambda() + rock.shear_modulus()) / 6.0;  // [Pa]
  const double uneven = facet.sharpened ? d * k.rock_share * (depth_i + depth_j) : 0.0;

  if (!joint(f).grouped())
    alone_[f / kGroup] = static_cast<std::uint8_t>(alone_[f / kGroup] | 1u << lane_of(f));
  FacetGroup& group = groups_[f / kGroup];
  const std::size_t lane = lane_of(f);
  group.sharpening[lane] = uneven * point_area * bonded_points;
  group.shear[lane] = shear;
  group.normal_extra[lane] = k.normal - shear;
  group.bulk[lane] = (grounded ? 1.0 : 0.5) * k.rock_share;
  if (facet.zone_i != facet.zone_j) derive_border(f);
}

void FacetTables::derive_all(const std::vector<std::uint8_t>& bonded_points) {
  for (std::size_t f = 0; f < size(); ++f) derive(f, bonded_points[f]);
}

std::pair<double, double> FacetTables::depths(std::size_t f) const {
  const Vec3 n = normal(f);
  return {n.dot(arm_i(f)), is_joint(f) ? -n.dot(arm_j(f)) : 0.0};
}

}  // namespace muckpile
