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
#include <limits>
#include <vector>

#include "math/types.h"

namespace muckpile {

/// Springs and dashpots of one contact.
struct ContactResistance {
  double normal_stiffness = 0.0, tangential_stiffness = 0.0;  ///< [N/m]
  double rolling_stiffness = 0.0;                             ///< [N m/rad]
  double normal_damping = 0.0, tangential_damping = 0.0;      ///< [N s/m]
  double torsional_stiffness = 0.0;  ///< against spin about the normal [N m/rad]
};

class ContactStepBound {
 public:
  struct Body {
    double mass;          ///< [kg]
    Vec3 inertia;         ///< principal moments [kg m2]
    Mat3 axes;            ///< columns: the principal axes in space
    bool joined = false;  ///< to be asked for apart from the others
  };
  /// Longest stable steps [s]; infinity without contacts.
  struct Steps {
    double springs = std::numeric_limits<double>::infinity();
    double with_dashpots = std::numeric_limits<double>::infinity();
  };

  explicit ContactStepBound(std::vector<Body> bodies);

  /// One contact of a body, at `arm` [m] from its centre, with a body of mass `other_mass`;
  /// infinity for what stands still.
  void add(std::size_t body, const ContactResistance& contact, const Vec3& normal, const Vec3& arm,
           double other_mass);

  /// Of the bodies that are joined, or of the others.
  [[nodiscard]] Steps steps(bool joined) const;

 private:
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  /// Of shift s and turn t: s.ss s + 2 s.st t + t.tt t.
  struct Form {
    Mat3 ss = Mat3::Zero(), st = Mat3::Zero(), tt = Mat3::Zero();

    void add(double normal, double tangential, const Vec3& direction, const Vec3& arm);
  };
  /// One of a body's, `resistance` as stiff as it counts.
  struct Contact {
    ContactResistance resistance;
    Vec3 normal, arm;
    int next;  // of the same body, -1: none
  };
  /// Traces of the two forms over the mass, no less than their greatest eigenvalue.
  struct Sum {
    double stiffness = 0.0, damping = 0.0;  // [1/s2], [1/s]
    int contact = -1;                       // the last one added
  };
  [[nodiscard]] static Mat6 over_mass(const Form& form, const Body& body);
  [[nodiscard]] Steps shorten(Steps steps, std::size_t body) const;
  [[nodiscard]] static double limit(const Mat6& stiffness, const Mat6& damping,
                                    double shorter_than);

  std::vector<Body> bodies_;
  std::vector<Sum> sums_;  // per body
  std::vector<Contact> contacts_;
};

}  // namespace muckpile
