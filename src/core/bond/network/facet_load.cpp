// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network's free and loaded faces: pressure on them and the volume that they sweep.
// Scope: see facet_network.h. The gas of a crushed zone presses on the faces there until it flows
// round their blocks; what it then presses behind them is not followed here (core/gas does).
#include <algorithm>
#include <map>
#include <utility>

#include "bond/network/facet_network.h"

namespace muckpile {
namespace {

// Normals of facets are kept in single precision: of a block's surface, what their sum is off at
// most.
constexpr double kRounding = 1e-6;

}  // namespace

void FacetNetwork::expect_pressure(bool expected) {
  pressure_expected_ = expected;
  if (!expected || !unloaded_) return;
  unloaded_ = false;
  moved_unseen_ = true;
}

/// What faces have moved while no pressure was expected is not swept.
void FacetNetwork::look_at_faces_anew() {
  moved_unseen_ = false;
  for (BoundaryFace& face : faces_) {
    const double swept = face.rigid_swept;
    sweep(face);
    face.rigid_swept = swept;
    face.last_squeezed = squeezed(face);
  }
}

void FacetNetwork::load_faces() {
  if (unloaded_) return;
  if (moved_unseen_) look_at_faces_anew();
  unloaded_ = !pressure_expected_;
  for (BoundaryFace& face : faces_) {
    if (face.hole < 0) continue;
    const double rigid = sweep(face);
    const auto b = static_cast<std::size_t>(face.block);
    const Vec3 force = -face.pressure * face.area * face.last_normal;
    force_[b] += force;
    torque_[b] += (face.last_centroid - state_[b].centre).cross(force);
    const double squeezed_now = squeezed(face);
    if (softer_since_) keep_swept_volume(face, squeezed_now);
    if (blocks_[b].owned) {
      const double work =
          0.5 * (face.pressure + face.last_pressure) * (rigid + squeezed_now - face.last_squeezed);
      pressure_work_ += work;
      wave_work_ += face.wave_share * work;
    }
    if (face.pressure != 0.0) unloaded_ = false;
    face.last_pressure = face.pressure;
    face.last_squeezed = squeezed_now;
  }
  softer_since_ = false;
  hold_faces();
}

/// Softer rock gives way to a pressure by more. The gas neither gets that volume nor works for it.
void FacetNetwork::keep_swept_volume(BoundaryFace& face, double squeezed_now) {
  face.rigid_swept += face.last_squeezed - squeezed_now;
  face.last_squeezed = squeezed_now;
}

/// The volume that the block's motion has swept since the last step: mean normal times the path of
/// the centroid (a turn about the centroid sweeps nothing). The gas fills the held share.
double FacetNetwork::sweep(BoundaryFace& face) const {
  const BlockState& s = state_[static_cast<std::size_t>(face.block)];
  const Vec3 centroid = s.centre + s.rotation * face.arm;
  const Vec3 normal = s.rotation * face.normal;
  const double swept =
      -0.5 * face.area * (normal + face.last_normal).dot(centroid - face.last_centroid);
  face.rigid_swept += face.held * swept;
  face.last_centroid = centroid;
  face.last_normal = normal;
  return swept;
}

/// By the face's own displacement [m3].
double FacetNetwork::squeezed(const BoundaryFace& face) const {
  const double two_g = 2.0 * material().shear_modulus();
  const double bulk_stress = bulk_stress_[static_cast<std::size_t>(face.block)];
  return face.area * (face.pressure + bulk_stress) * face.normal.dot(face.arm) / two_g;
}

double FacetNetwork::volume_swept(const BoundaryFace& face) const {
  return face.rigid_swept + squeezed(face);
}

void FacetNetwork::list_wall() {
  std::map<std::pair<int, int>, Vec3> of;  // by block and hole
  std::map<int, double> surface;           // of blocks that have a wall [m2]
  for (const BoundaryFace& face : faces_) {
    if (face.hole < 0) continue;
    of.try_emplace({face.block, face.hole}, Vec3::Zero()).first->second += face.area * face.normal;
    surface.try_emplace(face.block, 0.0);
  }
  const auto add = [&surface](int block, double area) {
    const auto found = surface.find(block);
    if (found != surface.end()) found->second += area;
    return found != surface.end();
  };
  wall_.clear();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const bool at_i = add(i_of(f), area(f)), at_j = add(j_of(f), area(f));
    if (at_i || at_j) wall_.push_back(static_cast<std::uint32_t>(f));
  }
  for (const BoundaryFace& face : faces_) add(face.block, face.area);
  walls_.clear();
  backs_.clear();
  if (wall_.empty()) return;
  walls_.resize(faces_.size());
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    const BoundaryFace& face = faces_[k];
    if (face.hole < 0) continue;
    const Vec3& wall = of.at({face.block, face.hole});
    walls_[k] = {wall, kRounding * surface.at(face.block) * wall.norm()};
  }
  backs_.assign(blocks_.size(), Vec3::Zero());
  hold_faces();
}

/// Gas of one pressure p on the wall N that a block has to a crushed zone, and on those of its
/// faces that have come loose from their neighbours, presses the block by p times the sum of A n of
/// all its other faces, as A n over a whole block adds up to nothing. Of that, what acts against
/// the wall is
///     held = -(sum of fade A n of the others) . N / N^2 = 1 - (sum of fade A n of all) . N / N^2.
/// A facet has come loose once it is retired: open by a tenth of its radius, far more than gas
/// needs to fill it. Free faces have the atmosphere, walls to other crushed zones the gas there.
/// Facets are as they were cut, so no pose enters.
void FacetNetwork::hold_faces() {
  if (wall_.empty()) return;
  for (const std::uint32_t f : wall_) {
    backs_[static_cast<std::size_t>(i_of(f))].setZero();
    backs_[static_cast<std::size_t>(j_of(f))].setZero();
  }
  for (const BoundaryFace& face : faces_) backs_[static_cast<std::size_t>(face.block)].setZero();
  for (const BoundaryFace& face : faces_)
    backs_[static_cast<std::size_t>(face.block)] += face.area * face.normal;
  for (const std::uint32_t f : wall_) {
    // Gas in a joint is followed and presses by itself: there the load is not reduced.
    const bool followed = traces_[f].gas;
    if (states_[f] == FacetState::retired && !followed) continue;
    const double share = followed ? 1.0 : contacts_.fade(f);
    const Vec3 part = share * area(f) * at_lane(group_of(f).normal, lane_of(f));
    backs_[static_cast<std::size_t>(i_of(f))] += part;
    backs_[static_cast<std::size_t>(j_of(f))] -= part;
  }
  for (std::size_t k = 0; k < faces_.size(); ++k) {
    BoundaryFace& face = faces_[k];
    if (face.hole < 0) continue;
    const Vec3& wall = walls_[k].sum;
    const double lost = backs_[static_cast<std::size_t>(face.block)].dot(wall);
    face.held = lost <= walls_[k].rounding ? 1.0 : std::max(0.0, 1.0 - lost / wall.squaredNorm());
  }
}

}  // namespace muckpile
