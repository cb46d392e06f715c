// SPDX-License-Identifier: GPL-2.0-or-later
// The free and loaded faces of a facet network: forces, work and swept volumes.
// Scope: see the header.
#include "bond/network/face_load.h"

#include <algorithm>
#include <utility>

namespace muckpile {
namespace {

/// As its block was last placed [N].
Vec3 force_on(const BoundaryFace& face) { return -face.pressure * face.area * face.last_normal; }

/// By the face's own displacement [m3].
double squeezed(const BoundaryFace& face, const BlockFields& blocks) {
  const auto b = static_cast<std::size_t>(face.block);
  const double two_g = blocks.rock[b].two_g;
  const double bulk_stress = blocks.bulk_stress[b];
  return face.area * (face.pressure + bulk_stress) * face.depth_share * face.normal.dot(face.arm) /
         two_g;
}

/// The volume that the block's motion has swept since the last step: mean normal times the path of
/// the centroid (a turn about the centroid sweeps nothing). The gas fills the loaded share.
double sweep(BoundaryFace& face, const BlockFields& blocks) {
  const BlockState& s = blocks.state_of(face.block);
  const Vec3 centroid = s.centre + s.rotation * face.arm;
  const Vec3 normal = s.rotation * face.normal;
  const double swept =
      -0.5 * face.area * (normal + face.last_normal).dot(centroid - face.last_centroid);
  face.rigid_swept += face.load_share * swept;
  face.last_centroid = centroid;
  face.last_normal = normal;
  return swept;
}

/// Softer rock gives way to a pressure by more. The gas neither gets that volume nor works for it.
void keep_swept_volume(BoundaryFace& face, double squeezed_now) {
  face.rigid_swept += face.last_squeezed - squeezed_now;
  face.last_squeezed = squeezed_now;
}

}  // namespace

void FaceLoad::set(std::vector<BoundaryFace> faces, const FacetTables& tables,
                   const FacetHistory& history) {
  faces_ = std::move(faces);
  faces_.shrink_to_fit();
  walls_.emplace(tables, faces_);
  if (walls_->empty()) walls_.reset();
  share_load(history);
}

std::vector<BoundaryFace> FaceLoad::give_up() {
  walls_.reset();
  return std::exchange(faces_, {});
}

void FaceLoad::expect_pressure(bool expected) {
  pressure_expected_ = expected;
  if (expected && watch_ == Watch::off) watch_ = Watch::anew;
}

void FaceLoad::squeeze(BlockFields& blocks) {
  energy_ = 0.0;
  for (const BoundaryFace& face : faces_) {
    if (face.pressure == 0.0) continue;
    const auto b = static_cast<std::size_t>(face.block);
    const double squeezed = face.area * face.pressure * face.depth_share *
                            face.normal.dot(face.arm) / blocks.rock[b].two_g;
    blocks.sums[b].loaded -= squeezed;
    // Until it is loaded anew a face in softer rock has not given way to the pressure of before.
    if (blocks.owned(b) && !softer_since_) energy_ += 0.5 * squeezed * face.pressure;
  }
}

/// What faces have moved while no pressure was expected is not swept.
void FaceLoad::look_anew(const BlockFields& blocks) {
  for (BoundaryFace& face : faces_) {
    const double swept = face.rigid_swept;
    sweep(face, blocks);
    face.rigid_swept = swept;
    face.last_squeezed = squeezed(face, blocks);
  }
}

void FaceLoad::load(const FacetKinematics& facets, BlockFields& blocks, JointBooks& books) {
  std::fill(hole_work_.begin(), hole_work_.end(), 0.0);
  if (watch_ == Watch::off) return;
  if (watch_ == Watch::anew) look_anew(blocks);
  watch_ = pressure_expected_ ? Watch::on : Watch::off;
  for (BoundaryFace& face : faces_) {
    if (face.hole < 0) continue;
    const double rigid = sweep(face, blocks);
    const auto b = static_cast<std::size_t>(face.block);
    const Vec3 force = force_on(face);
    blocks.force[b] += force;
    blocks.torque[b] += (face.last_centroid - blocks.state[b].centre).cross(force);
    const double squeezed_now = squeezed(face, blocks);
    if (softer_since_) keep_swept_volume(face, squeezed_now);
    if (blocks.owned(b)) {
      const double work =
          0.5 * (face.pressure + face.last_pressure) * (rigid + squeezed_now - face.last_squeezed);
      books.pressure_work += work;
      books.wave_work += face.wave_share * work;
      book_of_hole(static_cast<std::size_t>(face.hole), work);
    }
    if (face.pressure != 0.0) watch_ = Watch::on;
    face.last_pressure = face.pressure;
    face.last_squeezed = squeezed_now;
  }
  softer_since_ = false;
  share_load(facets.history);
}

void FaceLoad::add_forces(std::span<Vec3> wave, std::span<Vec3> gas) const {
  for (const BoundaryFace& face : faces_) {
    if (face.hole < 0 || face.pressure == 0.0) continue;
    const auto b = static_cast<std::size_t>(face.block);
    const Vec3 force = force_on(face);
    wave[b] += face.wave_share * force;
    gas[b] += (1.0 - face.wave_share) * force;
  }
}

double FaceLoad::volume_swept(const BoundaryFace& face, const BlockFields& blocks) {
  return face.rigid_swept + squeezed(face, blocks);
}

}  // namespace muckpile
