// SPDX-License-Identifier: GPL-2.0-or-later
// Typed view of the rigid bodies that fix multisphere owns on this rank.
// Scope: pointers are valid until bodies are added, removed or exchanged; make a view, use it, drop
// it.
#pragma once

#include <error.h>
#include <fix_multisphere.h>
#include <lammps.h>
#include <modify.h>
#include <multisphere.h>

#include <Eigen/Core>

#include "math/types.h"
#include "motion/body_motion.h"

namespace muckpile::engine {

/// The one fix multisphere of the run, nullptr if there is none.
inline LAMMPS_NS::FixMultisphere* find_multisphere(LAMMPS_NS::LAMMPS& lmp) {
  return static_cast<LAMMPS_NS::FixMultisphere*>(lmp.modify->find_fix_style("multisphere", 0));
}

class Bodies {
 public:
  explicit Bodies(LAMMPS_NS::FixMultisphere& fix) : data_(fix.data()), count_(data_.n_body()) {
    using Vectors = LAMMPS_NS::VectorContainer<double, 3>;
    const auto vectors = [&](const char* name) {
      return data_.prop().template getElementProperty<Vectors>(name)->begin();
    };
    centre_ = vectors("xcm");
    velocity_ = vectors("vcm");
    spin_ = vectors("omega");
    momentum_ = vectors("angmom");
    force_ = vectors("fcm");
    torque_ = vectors("torque");
    inertia_ = vectors("inertia");
    ex_ = vectors("ex_space");
    ey_ = vectors("ey_space");
    ez_ = vectors("ez_space");
    quaternion_ = data_.prop()
                      .template getElementProperty<LAMMPS_NS::VectorContainer<double, 4>>("quat")
                      ->begin();
  }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int tag(int b) const { return data_.tag(b); }
  [[nodiscard]] double mass(int b) const { return data_.mass(b); }
  [[nodiscard]] Eigen::Map<Vec3> centre(int b) const { return Eigen::Map<Vec3>(centre_[b]); }
  [[nodiscard]] Eigen::Map<Vec3> velocity(int b) const { return Eigen::Map<Vec3>(velocity_[b]); }
  [[nodiscard]] Eigen::Map<Vec3> spin(int b) const { return Eigen::Map<Vec3>(spin_[b]); }
  [[nodiscard]] Eigen::Map<Vec3> angular_momentum(int b) const {
    return Eigen::Map<Vec3>(momentum_[b]);
  }
  [[nodiscard]] Eigen::Map<Vec3> force(int b) const { return Eigen::Map<Vec3>(force_[b]); }
  [[nodiscard]] Eigen::Map<Vec3> torque(int b) const { return Eigen::Map<Vec3>(torque_[b]); }
  /// Principal moments [kg m2].
  [[nodiscard]] Eigen::Map<const Vec3> inertia(int b) const {
    return Eigen::Map<const Vec3>(inertia_[b]);
  }
  /// Columns are the principal axes of inertia in space.
  [[nodiscard]] Mat3 axes(int b) const {
    Mat3 axes;
    axes << Eigen::Map<Vec3>(ex_[b]), Eigen::Map<Vec3>(ey_[b]), Eigen::Map<Vec3>(ez_[b]);
    return axes;
  }
  [[nodiscard]] Mat3 inertia_in_space(int b) const {
    const Mat3 turned = axes(b);
    return turned * inertia(b).asDiagonal() * turned.transpose();
  }
  /// LIGGGHTS keeps the rows of an array one behind the other.
  [[nodiscard]] BodyRows rows() const {
    return {*centre_, *velocity_, *force_, *momentum_, *torque_,
            *spin_,   *ex_,       *ey_,    *ez_,       *quaternion_};
  }
  /// Stops the body, and takes away the forces that would set it going.
  void hold(int b) {
    velocity(b).setZero();
    spin(b).setZero();
    angular_momentum(b).setZero();
    force(b).setZero();
    torque(b).setZero();
  }
  /// Translation and rotation [J].
  [[nodiscard]] double kinetic_energy(int b) const {
    return 0.5 * (mass(b) * velocity(b).squaredNorm() + angular_momentum(b).dot(spin(b)));
  }

 private:
  LAMMPS_NS::Multisphere& data_;
  int count_;
  double **centre_, **velocity_, **spin_, **momentum_, **force_, **torque_, **inertia_, **ex_,
      **ey_, **ez_, **quaternion_;
};

}  // namespace muckpile::engine
