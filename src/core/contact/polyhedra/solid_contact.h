// SPDX-License-Identifier: GPL-2.0-or-later
// A step of the contact between two polyhedral bodies in space: whether they
// touch, what it does, and how the contact begins. Scope: work space for one
// pair at a time; SI units.
#pragma once

#include "contact/polyhedra/solid_contact_law.h"

namespace muckpile {

struct SolidBody {
  const Solid* solid;
  Pose pose;
  Vec3 velocity, spin;  ///< [m/s], [rad/s]
  double mass;          ///< [kg]
};

class SolidContact {
 public:
  struct Outcome {
    bool lasts;  ///< there is a contact, whose state is to be kept
    double gap;  ///< between the two, if above 0 [m]
  };

  /// `axis`: unit, in space, along which they were apart or pressed before, or zero; a new one
  /// is put there. `state` counts unless the contact is new. `response`: in
  /// space, of a contact that lasts.
  ///
  /// Where two bodies overlapped already one step before their contact begins,
  /// both are drawn in about their centres until they only touch, for this
  /// contact: it starts without force. As they part they get their size back.
  [[nodiscard]] Outcome step(const SolidContactLaw& law, const SolidBody& first,
                             const SolidBody& second, double time_step, double memory_step,
                             bool is_new, Vec3& axis, ContactState& state, SolidResponse& response);
  /// Force, springs and energy of a contact as it stands, as by the last
  /// step().
  [[nodiscard]] SolidResistance resistance(const SolidContactLaw& law, const SolidBody& first,
                                           const SolidBody& second, const ContactState& state);
  /// Stored [J].
  [[nodiscard]] double energy(const SolidContactLaw& law, const SolidBody& first,
                              const SolidBody& second, const ContactState& state);
  /// Of the last step [-].
  [[nodiscard]] double largest_strain() const { return finder_.overlap().largest_strain; }

 private:
  void see(const SolidBody& first, const SolidBody& second, const Vec3& axis);
  /// As OverlapFinder::work; true: they share volume.
  bool overlap(const SolidBody& first, const SolidBody& second, double size);
  [[nodiscard]] bool overlapped_before(const SolidBody& first, const SolidBody& second,
                                       double time_step);
  double touching_size(const SolidBody& first, const SolidBody& second);
  [[nodiscard]] Outcome part(const SolidBody& first, const SolidBody& second, Vec3& axis,
                             ContactState& state);
  [[nodiscard]] SolidResponse respond(const SolidContactLaw& law, const Mat3& axes,
                                      double memory_step, ContactState& state) const;

  OverlapFinder finder_;
  SolidMotion motion_;
  Mat3 turn_ = Mat3::Identity();
  Vec3 normal_ = Vec3::UnitX();  ///< of the gap that was found, in the first's axes
  double gap_ = 0.0;
};

}  // namespace muckpile
