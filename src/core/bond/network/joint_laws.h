// SPDX-License-Identifier: GPL-2.0-or-later
// The rocks and the joint classes of a network, with the constants that the passes over facets
// read. A law is what a facet has by its joint class and by the zones of rock of its two blocks.
// Scope: constants; they change only as the rock is softened. SI units. The laws themselves are in
// bond/law.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bond/law/coulomb.h"
#include "bond/law/joint_law.h"
#include "bond/law/joint_material.h"
#include "bond/law/slip_friction.h"

namespace muckpile {

class JointLaws {
 public:
  /// `natural`: the joint classes from 1; class 0 is that of `material`. `zones`: the rocks of the
  /// zones from 1; `material` is that of zone 0. Throws InputError if there are more laws than
  /// kMost.
  JointLaws(const JointMaterial& material, const std::vector<JointClass>& natural,
            const std::vector<JointMaterial>& zones = {});

  static constexpr std::size_t kMost = 256;  ///< classes, with that of rock, times zones squared

  [[nodiscard]] const JointMaterial& rock() const { return rocks_.front(); }
  [[nodiscard]] const JointMaterial& rock(std::size_t zone) const { return rocks_.at(zone); }
  [[nodiscard]] std::size_t zones() const { return rocks_.size(); }
  /// There is more than one rock.
  [[nodiscard]] bool zoned() const { return rocks_.size() > 1; }
  [[nodiscard]] std::size_t natural_classes() const { return natural_classes_; }

  /// A facet of that class between those zones.
  [[nodiscard]] std::uint8_t law_of(std::size_t joint_class, std::size_t zone_i,
                                    std::size_t zone_j) const {
    return static_cast<std::uint8_t>((joint_class * zones() + zone_i) * zones() + zone_j);
  }
  [[nodiscard]] std::uint8_t class_of(std::size_t law) const {
    return static_cast<std::uint8_t>(law / (zones() * zones()));
  }
  [[nodiscard]] std::uint8_t zone_i(std::size_t law) const {
    return static_cast<std::uint8_t>(law / zones() % zones());
  }
  [[nodiscard]] std::uint8_t zone_j(std::size_t law) const {
    return static_cast<std::uint8_t>(law % zones());
  }
  /// A facet between two rocks.
  [[nodiscard]] bool is_border(std::size_t law) const { return zone_i(law) != zone_j(law); }
  /// Of a border the strengths, damping and fracture energies alone (weaker_of()).
  [[nodiscard]] const JointMaterial& of_law(std::size_t law) const { return laws_.at(law); }
  [[nodiscard]] const JointLaw& joint(std::size_t law) const { return *joints_[law]; }
  /// Of a law that is grouped: for groups of facets, in lanes beside each other.
  [[nodiscard]] const CoulombStrength<double>& strength(std::size_t law) const {
    return strengths_[law];
  }
  /// There is a law whose facets are worked on one by one.
  [[nodiscard]] bool any_alone() const;

  /// Every stiffness times `factor`; `damping`, a share of the impedance, replaces that of all
  /// classes.
  void soften(double factor, std::optional<double> damping);

  /// A point that has reached its strength sheds its traction gradually.
  [[nodiscard]] bool softens() const { return softens_; }
  /// The walls of some broken points crush.
  [[nodiscard]] bool crushes() const { return crushes_; }
  /// Pressure at which they do; infinite: they do not [Pa].
  [[nodiscard]] double wall_strength(std::size_t law) const {
    return laws_[law].parameters().wall_strength;
  }
  /// Strength grows with the rate of strain.
  [[nodiscard]] bool depends_on_rate() const { return depends_on_rate_; }
  /// There are dashpots at bonded points.
  [[nodiscard]] bool damps() const { return damps_; }
  /// Of rock that is the same everywhere, at bonded points and at closed broken ones [Pa s/m].
  [[nodiscard]] double damping() const { return damping_.front(); }
  [[nodiscard]] double contact_damping() const { return contact_damping_.front(); }
  /// The same of any law; of a border the lesser share of the lesser impedance.
  [[nodiscard]] double damping(std::size_t law) const { return damping_[law]; }
  [[nodiscard]] double contact_damping(std::size_t law) const { return contact_damping_[law]; }
  [[nodiscard]] const SlipWeakening& slip_weakening() const { return slip_weakening_; }
  /// 2G/(lambda + 2G) of a zone [-].
  [[nodiscard]] double shear_over_p_wave(std::size_t zone = 0) const {
    return shear_over_p_wave_[zone];
  }

 private:
  void derive();

  std::size_t natural_classes_;
  std::vector<JointMaterial> rocks_;  // of the zones
  std::vector<JointMaterial> laws_;
  std::vector<std::shared_ptr<const JointLaw>> joints_;  // of the laws
  std::vector<CoulombStrength<double>> strengths_;       // of the laws
  bool softens_ = false, crushes_ = false, depends_on_rate_ = false, damps_ = false;
  std::vector<double> damping_, contact_damping_;  // of the laws [Pa s/m]
  std::vector<double> shear_over_p_wave_;          // of the zones, 2G/(lambda + 2G) [-]
  SlipWeakening slip_weakening_;
};

}  // namespace muckpile
