// SPDX-License-Identifier: GPL-2.0-or-later
// The facets of a network: shape, ends, joint class and stiffness of each, in groups of lanes
// (facet_group.h) that the passes read side by side.
// Scope: owned by the network; to the passes they are read-only but for two numbers of a facet: its
// share of sharpening, which breaking takes (uncouple()), and where its far side lies, which
// yielding ground moves (set_arm_j()). One row per facet, SI units. A shape is rounded to single
// precision once, as it is placed; what is derived is derived of the rounded values, so that it is
// the same after a restart or a change of ranks.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "bond/facet.h"
#include "bond/law/linear_closure.h"
#include "bond/law/two_rocks.h"
#include "bond/network/facet_group.h"
#include "bond/network/joint_laws.h"

namespace muckpile {

/// Share of D (facet_network.h) that counts: 1 would be right for cuboids, 3/5 for facets that face
/// all directions. Wave speeds with it: tests/verification/waves.cpp, docs/verification.md.
inline constexpr double kSharpening = 2.0 / 3.0;

/// What the passes hardly read of a facet; the rest is in its group.
struct FacetName {
  float weight;        ///< as in Facet
  std::uint16_t face;  ///< cells from files have at most so many, cut ones far fewer
  std::uint8_t law;    ///< of JointLaws
  FacetKind kind : 2;
  bool sharpened : 1, slanted_i : 1, slanted_j : 1;

  [[nodiscard]] std::array<bool, 2> slanted() const { return {slanted_i, slanted_j}; }
};
static_assert(sizeof(FacetName) == 8);

/// Constants of a facet's bonded points.
struct BondConstants : LinearClosure<double> {
  Vec3 opening_i, opening_j;  ///< m of the two blocks in the start [-]
  double area_i, area_j;      ///< area x share of the jump that strains i and j [m2]
  double point_area;          ///< [m2]
  double bulk_i, bulk_j;      ///< share of the two bulk stresses in the traction [-]
};

/// Constants of a facet's broken points.
struct ContactConstants {
  double weight;      ///< as in Facet
  double point_area;  ///< [m2]
  LinearContact<double> closure;
  double shear;           ///< stiffness when closed [Pa/m]
  double radius_squared;  ///< of the circle of equal area [m2]
};

/// Of the dilatations of a facet's two blocks.
struct DilatationCoupling {
  int i, j;
  double sharpening;  ///< energy per square of the difference, twice; of the bonded points [J]
};

class FacetTables {
 public:
  FacetTables(const JointMaterial& material, const std::vector<JointClass>& natural,
              const std::vector<JointMaterial>& zones = {})
      : laws_(material, natural, zones) {}

  /// A facet between two rocks.
  struct Border {
    std::size_t facet;
    /// m of the two blocks as they were placed: in the groups each is that of the whole jump
    /// (TwoRocks::opening).
    Eigen::Vector3f opening_i, opening_j;
    std::array<float, 2> room;  ///< as in Facet [m]
    // Of border_relief.h: per jump [Pa/m], per theta [Pa]; 1/K [m/Pa], 0: no relief.
    double push = 0.0, pull_i = 0.0, pull_j = 0.0, give = 0.0;
  };
  /// In the order of the facets; none where there is one rock.
  [[nodiscard]] const std::vector<Border>& borders() const { return borders_; }
  /// Place of a border among them.
  [[nodiscard]] std::size_t border_of(std::size_t f) const;
  /// Of a group, bit per facet: those that are borders.
  [[nodiscard]] unsigned border_lanes(std::size_t g) const {
    return border_lanes_.empty() ? 0u : border_lanes_[g];
  }

  [[nodiscard]] const JointLaws& laws() const { return laws_; }
  /// `bonded_points`: per facet, how many of its points are in the dilatations.
  void soften(double factor, std::optional<double> damping,
              const std::vector<std::uint8_t>& bonded_points);

  void reset(std::size_t count);  ///< room for so many facets, all to be placed
  /// Returns where the far side lies, as rounded: the facet's arm_j [m].
  Vec3 place(std::size_t f, const Facet& facet);
  void derive(std::size_t f, int bonded_points);  ///< constants of a facet that is placed
  void derive_all(const std::vector<std::uint8_t>& bonded_points);
  void release();  ///< drops all facets and their memory

  [[nodiscard]] std::size_t size() const { return names_.size(); }
  /// As it was placed, but for the tags of its blocks.
  [[nodiscard]] Facet facet(std::size_t f) const;
  [[nodiscard]] const FacetName& name(std::size_t f) const { return names_[f]; }
  [[nodiscard]] const std::vector<FacetName>& names() const { return names_; }
  [[nodiscard]] bool is_joint(std::size_t f) const { return names_[f].kind == FacetKind::joint; }
  [[nodiscard]] bool is_mirror(std::size_t f) const { return names_[f].kind == FacetKind::mirror; }
  [[nodiscard]] const FacetGroup& group(std::size_t g) const { return groups_[g]; }
  void fetch_group(std::size_t g) const { prefetch_all(&groups_[g]); }  ///< ahead of its use
  [[nodiscard]] std::size_t groups() const { return groups_.size(); }
  [[nodiscard]] const FacetGroup& group_of(std::size_t f) const { return groups_[f / kGroup]; }
  [[nodiscard]] static std::size_t lane_of(std::size_t f) { return f % kGroup; }
  [[nodiscard]] int i_of(std::size_t f) const { return group_of(f).i[lane_of(f)]; }
  [[nodiscard]] int j_of(std::size_t f) const { return group_of(f).j[lane_of(f)]; }
  /// The blocks of a facet, as indices.
  [[nodiscard]] std::pair<std::size_t, std::size_t> blocks_of(std::size_t f) const {
    return {static_cast<std::size_t>(i_of(f)), static_cast<std::size_t>(j_of(f))};
  }
  [[nodiscard]] double area(std::size_t f) const { return group_of(f).area[lane_of(f)]; }  ///< [m2]
  [[nodiscard]] double weight(std::size_t f) const { return names_[f].weight; }            ///< [-]
  [[nodiscard]] Vec3 normal(std::size_t f) const { return at_lane(group_of(f).normal, lane_of(f)); }
  [[nodiscard]] Vec3 arm_i(std::size_t f) const { return at_lane(group_of(f).arm, lane_of(f)); }
  [[nodiscard]] Vec3 arm_j(std::size_t f) const { return at_lane(group_of(f).arm_j, lane_of(f)); }
  /// Distances of the facet from the two centres, 0 from the ground [m].
  [[nodiscard]] std::pair<double, double> depths(std::size_t f) const;
  [[nodiscard]] double rock_share(std::size_t f) const {
    return (is_joint(f) ? 2.0 : 1.0) * group_of(f).bulk[lane_of(f)];
  }
  /// The law of a facet's joint.
  [[nodiscard]] const JointLaw& joint(std::size_t f) const { return laws_.joint(names_[f].law); }
  /// Of a facet that is in a group: JointLaws::strength().
  [[nodiscard]] const CoulombStrength<double>& strength(std::size_t f) const {
    return laws_.strength(names_[f].law);
  }
  /// Of a group, bit per facet: those whose law is not grouped. They are worked on one by one.
  [[nodiscard]] unsigned alone_lanes(std::size_t g) const {
    return alone_.empty() ? 0u : alone_[g];
  }
  [[nodiscard]] bool alone(std::size_t f) const {
    return (alone_lanes(f / kGroup) >> lane_of(f) & 1u) != 0;
  }
  /// As in Facet [-].
  [[nodiscard]] double stiffening(std::size_t f) const {
    return stiffening_.empty() ? 1.0 : double{stiffening_[f]};
  }
  /// What the facet's own law takes: strengths, rates, fracture energies.
  [[nodiscard]] const JointParameters& parameters(std::size_t f) const {
    return laws_.of_law(names_[f].law).parameters();
  }
  /// Of the rock of its block i.
  [[nodiscard]] std::size_t zone_i(std::size_t f) const { return laws_.zone_i(names_[f].law); }
  /// It lies between two rocks.
  [[nodiscard]] bool is_border(std::size_t f) const { return laws_.is_border(names_[f].law); }
  /// Dashpots of bonded points and of closed broken ones, per speed of block j against block i
  /// [Pa s/m]. Behind a mirror the image moves as much the other way, so they are twice as strong.
  [[nodiscard]] double damping(std::size_t f) const {
    return sides(f) * laws_.damping(names_[f].law);
  }
  [[nodiscard]] double contact_damping(std::size_t f) const {
    return sides(f) * laws_.contact_damping(names_[f].law);
  }
  /// Stiffness of the rock between the two centres, (lambda + 2G)/h [Pa/m].
  [[nodiscard]] double uniaxial_stiffness(std::size_t f) const {
    if (laws_.zoned() && is_border(f)) return two_rocks(f).uniaxial;
    const auto [depth_i, depth_j] = depths(f);
    return laws_.rock(laws_.zoned() ? zone_i(f) : 0).p_wave_modulus() /
           ((depth_i + depth_j) / stiffening(f));
  }
  /// 2G/(lambda + 2G) of the rock there, of both in series [-].
  [[nodiscard]] double shear_over_p_wave(std::size_t f) const {
    if (!laws_.zoned()) return laws_.shear_over_p_wave();
    if (!is_border(f)) return laws_.shear_over_p_wave(zone_i(f));
    const TwoRocks both = two_rocks(f);
    return both.normal / both.uniaxial;
  }
  /// Pressure at which the walls of its broken points crush; infinite: they do not [Pa].
  [[nodiscard]] double wall_strength(std::size_t f) const {
    return laws_.wall_strength(names_[f].law);
  }
  /// Share of the law's friction that its broken points have: a mirror has none [-].
  [[nodiscard]] double grip(std::size_t f) const { return is_mirror(f) ? 0.0 : 1.0; }
  [[nodiscard]] DilatationCoupling coupling(std::size_t f) const {
    return {i_of(f), j_of(f), group_of(f).sharpening[lane_of(f)]};
  }
  [[nodiscard]] BondConstants bond(std::size_t f) const;
  [[nodiscard]] ContactConstants contact(std::size_t f) const;

  /// What is left of the facet's coupling [J].
  void set_sharpening(std::size_t f, double sharpening) {
    groups_[f / kGroup].sharpening[lane_of(f)] = sharpening;
  }
  void set_arm_j(std::size_t f, const Vec3& arm_j) {
    set_lane(groups_[f / kGroup].arm_j, lane_of(f), arm_j);
  }

  [[nodiscard]] double bytes_of_groups() const {
    return static_cast<double>(groups_.capacity() * sizeof(FacetGroup));
  }
  [[nodiscard]] double bytes_of_names() const {
    return static_cast<double>(names_.capacity() * sizeof(FacetName) +
                               stiffening_.capacity() * sizeof(float) +
                               borders_.capacity() * sizeof(Border));
  }

 private:
  [[nodiscard]] double sides(std::size_t f) const { return is_mirror(f) ? 2.0 : 1.0; }
  void stiffen(std::size_t f, double stiffening);
  void split_jump(std::size_t f, const Facet& facet);
  void derive_border(std::size_t f);
  [[nodiscard]] FacetStiffness stiffness(std::size_t f, const Facet& facet) const;
  [[nodiscard]] TwoRocks two_rocks(std::size_t f) const;

  JointLaws laws_;
  std::vector<Border> borders_;
  std::vector<std::uint8_t> border_lanes_;  // empty where there is one rock
  std::vector<FacetName> names_;
  std::vector<float> stiffening_;  // empty: 1 for all
  std::vector<FacetGroup> groups_;
  std::vector<std::uint8_t> alone_;  // see alone_lanes(); empty where all laws are grouped
};

[[gnu::always_inline]] inline BondConstants FacetTables::bond(std::size_t f) const {
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  const double area = group.area[k], bulk = group.bulk[k];
  const double bulk_j = is_joint(f) ? bulk : 0.0;
  return {{group.shear[k], group.normal_extra[k]},
          at_lane(group.opening_i, k),
          at_lane(group.opening_j, k),
          bulk * area,
          bulk_j * area,
          area / kFacetPoints,
          bulk,
          bulk_j};
}

[[gnu::always_inline]] inline ContactConstants FacetTables::contact(std::size_t f) const {
  const FacetGroup& group = group_of(f);
  const std::size_t k = lane_of(f);
  return {names_[f].weight,
          group.area[k] / kFacetPoints,
          {LinearClosure<double>{group.shear[k], group.normal_extra[k]}.contact(
              rock_share(f), shear_over_p_wave(f))},
          group.shear[k],
          M_1_PI * group.area[k]};
}

}  // namespace muckpile
