// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network's free and loaded faces: pressure on them and the volume that they sweep.
// Scope: see facet_network.h.
#include "bond/facet_network.h"

namespace muckpile {

void FacetNetwork::load_faces() {
  for (BoundaryFace& face : faces_) {
    if (face.hole < 0) continue;
    sweep(face);
    const auto b = static_cast<std::size_t>(face.block);
    const Vec3 force = -face.pressure * face.area * face.last_normal;
    force_[b] += force;
    torque_[b] += (face.last_centroid - state_[b].centre).cross(force);
    const double swept = volume_swept(face);
    if (blocks_[b].owned) {
      const double work = 0.5 * (face.pressure + face.last_pressure) * (swept - face.last_swept);
      pressure_work_ += work;
      wave_work_ += face.wave_share * work;
    }
    face.last_pressure = face.pressure;
    face.last_swept = swept;
  }
}

/// Adds the volume that the block's motion has swept since the last step: mean normal times the
/// path of the centroid (a turn about the centroid sweeps nothing).
void FacetNetwork::sweep(BoundaryFace& face) const {
  const BlockState& s = state_[static_cast<std::size_t>(face.block)];
  const Vec3 centroid = s.centre + s.rotation * face.arm;
  const Vec3 normal = s.rotation * face.normal;
  face.rigid_swept -=
      0.5 * face.area * (normal + face.last_normal).dot(centroid - face.last_centroid);
  face.last_centroid = centroid;
  face.last_normal = normal;
}

double FacetNetwork::volume_swept(const BoundaryFace& face) const {
  const double two_g = 2.0 * material().shear_modulus();
  const double bulk_stress = bulk_stress_[static_cast<std::size_t>(face.block)];
  const double squeezed = (-face.pressure - bulk_stress) * face.normal.dot(face.arm) /
                          two_g;  // the face's own displacement
  return face.rigid_swept - face.area * squeezed;
}

}  // namespace muckpile
