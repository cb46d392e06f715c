// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic constants of the rock and strength of the joints, with the numbers derived from them.
// Scope: one isotropic rock; strengths are per area and act on the continuum traction of a facet.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "bond/law/linear_closure.h"

namespace muckpile {

/// What the user gives. Compression is negative in tractions, strengths are positive.
struct JointParameters {
  double youngs_modulus = 0.0;                                        ///< [Pa]
  double poisson_ratio = 0.0;                                         ///< [-], 0 <= nu < 0.5
  double density = 0.0;                                               ///< of the rock [kg/m3]
  double tension = 0.0;                                               ///< cut-off [Pa]
  double cohesion = 0.0;                                              ///< [Pa]
  double friction_angle = 0.0;                                        ///< before breaking [rad]
  double residual_friction_angle = 0.0;                               ///< after breaking [rad]
  double normal_stiffness = std::numeric_limits<double>::infinity();  ///< joint alone [Pa/m]
  double shear_stiffness = std::numeric_limits<double>::infinity();   ///< joint alone [Pa/m]
  double damping = 0.0;                  ///< of intact joints, share of rho c_P per area [-]
  double contact_damping = 0.0;          ///< of closed broken facets, share of rho c_P per area [-]
  double fracture_energy_tension = 0.0;  ///< [J/m2]; 0: tension drops at once
  double fracture_energy_shear = 0.0;    ///< beside friction [J/m2]; 0: cohesion drops at once
  double rate_exponent = 0.0;            ///< of strength [-]; 0: it does not depend on rate
  double reference_rate = 1e-6;          ///< up to which tension is that at rest [1/s]
  double reference_rate_shear = 1e-6;    ///< the same of cohesion [1/s]
  double weakening_speed = 0.0;          ///< of slip, above which friction falls; 0: never [m/s]
  double weakened_friction_angle = 0.0;  ///< towards which it falls [rad]
  /// Pressure at which the walls of closed broken points crush [Pa]; infinite: they do not.
  double wall_strength = std::numeric_limits<double>::infinity();
};

class JointLaw;
class JointMaterial;
/// The law of a class of joints in a rock with those joints: some of its numbers may be the rock's.
using JointLawMaker = std::function<std::shared_ptr<const JointLaw>(const JointMaterial& joints)>;
/// Linear closure and Coulomb's strength, of the material's numbers.
[[nodiscard]] JointLawMaker coulomb_law();

/// A natural joint: stiffness and strength of its own; the rock on both sides is the same.
struct JointClass {
  double tension = 0.0;                                               ///< cut-off [Pa]
  double cohesion = 0.0;                                              ///< [Pa]
  double friction_angle = 0.0;                                        ///< before breaking [rad]
  double residual_friction_angle = 0.0;                               ///< after breaking [rad]
  double normal_stiffness = std::numeric_limits<double>::infinity();  ///< [Pa/m]
  double shear_stiffness = std::numeric_limits<double>::infinity();   ///< [Pa/m]
  double wall_strength = 0.0;  ///< as in JointParameters [Pa]; 0: that of the rock
  /// Coulomb's is made of the numbers above. Beside another law the stiffnesses count (normal: that
  /// without pressure) and whether there is tension, or no fracture energy. No walls crush then.
  JointLawMaker law = coulomb_law();
};

/// Derived constants; throws InputError if a parameter is out of range.
class JointMaterial {
 public:
  explicit JointMaterial(const JointParameters& parameters);

  [[nodiscard]] const JointParameters& parameters() const { return parameters_; }
  [[nodiscard]] double shear_modulus() const { return shear_modulus_; }  ///< G [Pa]
  [[nodiscard]] double lame_lambda() const { return lame_lambda_; }      ///< lambda [Pa]
  [[nodiscard]] double p_wave_modulus() const;                           ///< lambda + 2G [Pa]
  [[nodiscard]] double p_wave_speed() const;                             ///< c_P [m/s]
  [[nodiscard]] double s_wave_speed() const;                             ///< c_S [m/s]
  [[nodiscard]] double tan_friction() const { return tan_friction_; }
  [[nodiscard]] double tan_residual_friction() const { return tan_residual_friction_; }
  [[nodiscard]] double damping_coefficient() const;          ///< [Pa s/m]
  [[nodiscard]] double contact_damping_coefficient() const;  ///< [Pa s/m]

  /// Joint compliances act in series with the rock between the centres, h apart [m].
  [[nodiscard]] FacetStiffness facet_stiffness(double h) const;

  /// The same rock with other joints in it.
  [[nodiscard]] JointMaterial with_joints(const JointClass& joint) const;

  /// Rock softened by `factor` (all moduli and stiffnesses), strengths unchanged; `damping`, of
  /// intact joints and closed broken ones, as a share of the softer rock's impedance.
  [[nodiscard]] JointMaterial softened(double factor, std::optional<double> damping = {}) const;

 private:
  JointParameters parameters_;
  double shear_modulus_;
  double lame_lambda_;
  double tan_friction_;
  double tan_residual_friction_;
};

}  // namespace muckpile
