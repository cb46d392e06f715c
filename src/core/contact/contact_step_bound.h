// SPDX-License-Identifier: GPL-2.0-or-later
// How long a time step the contacts of rigid bodies bear.
// Scope: linearised about the present overlaps, all contacts sticking; contacts yet to come are not
// known here.
//
// The springs of all contacts are at most, for any motion, the sum over bodies of each body's own
// contacts, each of them (1 + sqrt(m/m_other)) times as stiff: (a - b)^2 <= w a^2 + v b^2 wherever
// 1/w + 1/v = 1. So the fastest vibration is at most that of a single body on its contacts, six by
// six; the dashpots likewise. A leapfrog step dt whose dashpots lag half a step is stable while
// dt^2 K + 2 dt C <= 4 M.
#pragma once

#include <cstddef>
#include <map>

#include "math/types.h"

namespace muckpile {

/// Springs and dashpots of one contact.
struct ContactResistance {
  double normal_stiffness = 0.0, tangential_stiffness = 0.0;  ///< [N/m]
  double rolling_stiffness = 0.0;                             ///< [N m/rad]
  double normal_damping = 0.0, tangential_damping = 0.0;      ///< [N s/m]
};

class ContactStepBound {
 public:
  struct Body {
    double mass;   ///< [kg]
    Mat3 inertia;  ///< in space, about the centre [kg m2]
  };

  /// One contact of body `number`, at `arm` [m] from its centre, with a body of mass `other_mass`.
  void add(std::size_t number, const Body& body, const ContactResistance& contact,
           const Vec3& normal, const Vec3& arm, double other_mass);

  /// Longest stable step [s]; infinity without contacts.
  [[nodiscard]] double step() const { return shortest(true); }
  /// The same without the dashpots.
  [[nodiscard]] double spring_step() const { return shortest(false); }

 private:
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  struct Sum {
    Mat6 stiffness = Mat6::Zero(), damping = Mat6::Zero();
    Mat6 slim = Mat6::Zero();  // M^(-1/2)
  };
  [[nodiscard]] double shortest(bool damped) const;
  [[nodiscard]] static double limit(const Mat6& stiffness, const Mat6& damping,
                                    double shorter_than);

  std::map<std::size_t, Sum> sums_;
};

}  // namespace muckpile
