// SPDX-License-Identifier: GPL-2.0-or-later
// The dilatation-coupled facet network: two passes over the facets per step.
// Scope: see the header; formulas are there.
#include "bond/facet_network.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muckpile {
namespace {

constexpr double kHalfSqrt3 = 0.86602540378443865;

// A broken facet is a plane contact only while its two faces still match. It fades between these
// shares of its radius slid, and of radians turned, and retires once it has opened that far.
constexpr double kSlideStart = 0.1, kSlideEnd = 0.5;
constexpr double kTurnStart = 0.1, kTurnEnd = 0.5;
constexpr double kOpened = 0.1;

double ramp_down(double x, double start, double end) {
  return std::clamp((end - x) / (end - start), 0.0, 1.0);
}

/// In-plane position of integration point p, in the start orientation. Three points at 120 degrees
/// on the ellipse of half axes sqrt(2) x gyration radii have the facet's second moments.
Vec3 point_offset(const Facet& facet, int p) {
  if (p == 0) return facet.half_axes[0];
  const double side = p == 1 ? kHalfSqrt3 : -kHalfSqrt3;
  return -0.5 * facet.half_axes[0] + side * facet.half_axes[1];
}

}  // namespace

void FacetNetwork::set_blocks(std::vector<BlockConstants> blocks) {
  blocks_ = std::move(blocks);
  blocks_.push_back({kGroundTag, 1.0, 1.0, false});
  state_.assign(blocks_.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Mat3::Identity()});
  sums_.assign(blocks_.size(), {});
  theta_.assign(blocks_.size(), 0.0);
  force_.assign(blocks_.size(), Vec3::Zero());
  torque_.assign(blocks_.size(), Vec3::Zero());
}

void FacetNetwork::set_facets(std::vector<Facet> facets, std::vector<FacetMemory> memory) {
  facets_ = std::move(facets);
  memory_ = std::move(memory);
  memory_.resize(facets_.size());
  kinematics_.resize(facets_.size());
  derive();
  count_unbonded();
}

void FacetNetwork::set_faces(std::vector<BoundaryFace> faces) {
  faces_ = std::move(faces);
  count_unbonded();
}

void FacetNetwork::derive() {
  derived_.resize(facets_.size());
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const Facet& facet = facets_[f];
    Derived& d = derived_[f];
    const bool grounded = facet.kind != FacetKind::joint;
    d.depth_i = facet.normal.dot(facet.arm_i);
    d.depth_j = grounded ? 0.0 : -facet.normal.dot(facet.arm_j);
    d.share_i = grounded ? 1.0 : 0.5;
    d.share_j = grounded ? 0.0 : 0.5;
    d.k = material_.facet_stiffness(d.depth_i + d.depth_j);
    d.radius = std::sqrt(facet.area / M_PI);
    d.tan_friction = material_.tan_friction();
    d.tan_residual = material_.tan_residual_friction();
    d.cohesion = material_.parameters().cohesion;
    if (facet.kind == FacetKind::mirror) d.k.shear = d.tan_residual = 0.0;
  }
}

void FacetNetwork::count_unbonded() {
  for (BlockSums& sums : sums_) sums.unbonded = 0.0;
  for (const BoundaryFace& face : faces_) {
    const auto b = static_cast<std::size_t>(face.block);
    sums_[b].unbonded += face.area * face.normal.dot(face.arm) / blocks_[b].volume;
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const Facet& facet = facets_[f];
    const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
    for (bool broken : memory_[f].broken) {
      if (!broken) continue;
      const double area = facet.area / kFacetPoints;
      sums_[i].unbonded += area * derived_[f].depth_i / blocks_[i].volume;
      sums_[j].unbonded += area * derived_[f].depth_j / blocks_[j].volume;
    }
  }
}

void FacetNetwork::dilatation() {
  for (BlockSums& sums : sums_) sums.bonded = sums.loaded = sums.squeezed = 0.0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (memory_[f].retired) continue;
    const Facet& facet = facets_[f];
    const Derived& d = derived_[f];
    const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
    const BlockState &si = state_[i], &sj = state_[j];
    Kinematics& kin = kinematics_[f];
    kin.normal.noalias() = (si.rotation * facet.normal + sj.rotation * facet.normal).normalized();
    kin.jump.noalias() = sj.centre + sj.rotation * facet.arm_j - si.centre - si.rotation * facet.arm_i;
    double opened = 0.0;  // integral of the bonded normal jump over the facet [m3]
    if (!memory_[f].cracked) {
      opened = facet.area * kin.normal.dot(kin.jump);
    } else {
      for (int p = 0; p < kFacetPoints; ++p) {
        if (memory_[f].broken[static_cast<std::size_t>(p)]) continue;
        opened += facet.area / kFacetPoints * kin.normal.dot(point_of(f, p).jump);
      }
    }
    sums_[i].bonded += d.share_i * d.k.rock_share * opened;
    sums_[j].bonded += d.share_j * d.k.rock_share * opened;
  }
  const double two_g = 2.0 * material_.shear_modulus();
  for (const BoundaryFace& face : faces_) {
    if (face.pressure == 0.0) continue;
    BlockSums& sums = sums_[static_cast<std::size_t>(face.block)];
    const double squeezed = face.area * face.pressure * face.normal.dot(face.arm) / two_g;
    sums.loaded -= squeezed;
    sums.squeezed += 0.5 * squeezed * face.pressure;
  }
  const double ratio = material_.lame_lambda() / two_g;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    theta_[b] = (sums_[b].bonded + sums_[b].loaded) /
                (blocks_[b].volume * (1.0 + sums_[b].unbonded * ratio));
  }
  theta_.back() = 0.0;  // the ground
}

void FacetNetwork::tractions(double dt) {
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  std::fill(torque_.begin(), torque_.end(), Vec3::Zero());
  newly_cracked_ = false;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (memory_[f].retired) continue;
    if (memory_[f].cracked) {
      cracked_facet(f, dt);
    } else {
      intact_facet(f, dt);
    }
  }
  load_faces();
  if (newly_cracked_) book_fracture();
}

FacetNetwork::Point FacetNetwork::point_of(std::size_t f, int p) const {
  const Facet& facet = facets_[f];
  const BlockState& si = state_[static_cast<std::size_t>(facet.i)];
  const BlockState& sj = state_[static_cast<std::size_t>(facet.j)];
  const Vec3 offset = point_offset(facet, p);
  const Vec3 side_i = si.rotation * (facet.arm_i + offset);
  Point point;
  point.jump = kinematics_[f].jump + sj.rotation * offset - si.rotation * offset;
  point.at = si.centre + side_i + 0.5 * point.jump;
  return point;
}

void FacetNetwork::intact_facet(std::size_t f, double dt) {
  for (int p = 0; p < kFacetPoints; ++p) bonded_point(f, p, point_of(f, p), dt);
}

void FacetNetwork::cracked_facet(std::size_t f, double dt) {
  update_fade(f);
  if (memory_[f].retired) return;
  for (int p = 0; p < kFacetPoints; ++p) {
    const Point point = point_of(f, p);
    if (memory_[f].broken[static_cast<std::size_t>(p)]) {
      contact_point(f, p, point, dt);
    } else {
      bonded_point(f, p, point, dt);
    }
  }
}

void FacetNetwork::bonded_point(std::size_t f, int p, const Point& point, double dt) {
  const Facet& facet = facets_[f];
  const Derived& d = derived_[f];
  const Vec3& n = kinematics_[f].normal;
  const double theta = d.share_i * theta_[static_cast<std::size_t>(facet.i)] +
                       d.share_j * theta_[static_cast<std::size_t>(facet.j)];
  const double normal_jump = n.dot(point.jump);
  const double normal_extra =
      (d.k.normal - d.k.shear) * normal_jump + d.k.rock_share * material_.lame_lambda() * theta;
  Vec3 traction = d.k.shear * point.jump + normal_extra * n;
  const double normal = n.dot(traction);
  const double shear = (traction - normal * n).norm();
  if (joint_fails(normal, shear, material_.parameters().tension, d.cohesion, d.tan_friction)) {
    break_point(f, p, point, traction);
    contact_point(f, p, point, dt);
    return;
  }
  const double area = facet.area / kFacetPoints;
  const double damping = material_.damping_coefficient();
  if (damping > 0.0) {
    const Vec3 rate = relative_velocity(facet, point.at);
    traction += damping * rate;
    losses_.damping += facet.weight * area * damping * rate.squaredNorm() * dt;
  }
  push(facet, point.at, area * traction);
}

void FacetNetwork::break_point(std::size_t f, int p, const Point& point, const Vec3& traction) {
  const Facet& facet = facets_[f];
  const Derived& d = derived_[f];
  const Vec3& n = kinematics_[f].normal;
  const double normal = n.dot(traction);
  const double held = std::min(normal, 0.0);
  const Vec3 shear = traction - normal * n;
  const double limit = d.tan_residual * -held;
  const double shear_size = shear.norm();
  const double kept = shear_size > limit ? limit / shear_size : 1.0;
  // The contact starts with the compression that the joint carried and the shear that friction can.
  Vec3 spring = held / d.k.contact * n;
  if (d.k.shear > 0.0) spring += kept / d.k.shear * shear;

  FacetMemory& memory = memory_[f];
  const BlockState& si = state_[static_cast<std::size_t>(facet.i)];
  memory.offset[static_cast<std::size_t>(p)] = si.rotation.transpose() * (point.jump - spring);
  memory.broken[static_cast<std::size_t>(p)] = true;
  memory.cracked = true;
  newly_cracked_ = true;

  const double area = facet.area / kFacetPoints;
  const double normal_jump = n.dot(point.jump);
  const double before = d.k.shear * (point.jump.squaredNorm() - normal_jump * normal_jump) +
                        d.k.normal * normal_jump * normal_jump;
  const double after = held * held / d.k.contact + (d.k.shear > 0.0 ? kept * kept * shear_size * shear_size / d.k.shear : 0.0);
  losses_.fracture += 0.5 * facet.weight * area * (before - after);
  drop_from_dilatation(f, point.jump);
}

void FacetNetwork::drop_from_dilatation(std::size_t f, const Vec3& jump) {
  const Facet& facet = facets_[f];
  const Derived& d = derived_[f];
  const double area = facet.area / kFacetPoints;
  const double opened = area * d.k.rock_share * kinematics_[f].normal.dot(jump);
  const auto drop = [&](int block, double share, double depth) {
    const auto b = static_cast<std::size_t>(block);
    sums_[b].dropped += share * opened;
    sums_[b].unbonded_added += area * depth / blocks_[b].volume;
  };
  drop(facet.i, d.share_i, d.depth_i);
  drop(facet.j, d.share_j, d.depth_j);
}

void FacetNetwork::contact_point(std::size_t f, int p, const Point& point, double dt) {
  const Facet& facet = facets_[f];
  const Derived& d = derived_[f];
  FacetMemory& memory = memory_[f];
  Vec3& offset = memory.offset[static_cast<std::size_t>(p)];
  const Mat3& turn = state_[static_cast<std::size_t>(facet.i)].rotation;
  const Vec3& n = kinematics_[f].normal;
  const Vec3 spring = point.jump - turn * offset;
  const double closed = n.dot(spring);
  if (closed >= 0.0) {  // open: friction forgets where it stuck
    offset = turn.transpose() * (point.jump - closed * n);
    return;
  }
  const double area = facet.area / kFacetPoints;
  const double damping = memory.fade * material_.contact_damping_coefficient();
  const Vec3 rate = relative_velocity(facet, point.at);
  const double normal_rate = n.dot(rate);
  const double elastic = memory.fade * d.k.contact * closed;
  const double normal = std::min(0.0, elastic + damping * normal_rate);
  losses_.damping += facet.weight * area * (normal - elastic) * normal_rate * dt;

  Vec3 stuck = spring - closed * n;
  Vec3 shear = memory.fade * d.k.shear * stuck;
  const double size = shear.norm(), limit = d.tan_residual * -normal;
  if (size > limit) {
    const Vec3 slip = (1.0 - limit / size) * stuck;
    shear *= limit / size;
    offset += turn.transpose() * slip;
    losses_.friction += facet.weight * area * shear.dot(slip);
    const double rest = size * size - limit * limit;  // spring energy given up, less the work of slip
    losses_.friction += facet.weight * area *
                        (0.5 * rest / (memory.fade * d.k.shear) - shear.norm() * slip.norm());
  }
  push(facet, point.at, area * (normal * n + shear));
}

void FacetNetwork::update_fade(std::size_t f) {
  const Facet& facet = facets_[f];
  const Derived& d = derived_[f];
  FacetMemory& memory = memory_[f];
  const Vec3& n = kinematics_[f].normal;
  const Vec3& jump = kinematics_[f].jump;
  const double opened = n.dot(jump);
  const double slid = (jump - opened * n).norm() / d.radius;
  const Mat3& turn_i = state_[static_cast<std::size_t>(facet.i)].rotation;
  const Mat3& turn_j = state_[static_cast<std::size_t>(facet.j)].rotation;
  const double turned = (turn_j * facet.half_axes[0] - turn_i * facet.half_axes[0]).norm() / facet.half_axes[0].norm() +
                        (turn_j * facet.normal - turn_i * facet.normal).norm();
  const double matching = ramp_down(slid, kSlideStart, kSlideEnd) * ramp_down(turned, kTurnStart, kTurnEnd);
  const bool all_broken = memory.broken[0] && memory.broken[1] && memory.broken[2];
  if (!all_broken) return;
  if (matching < memory.fade) {
    double stored = 0.0;  // spring energy at full strength
    for (int p = 0; p < kFacetPoints; ++p) {
      const Vec3 spring = point_of(f, p).jump - turn_i * memory.offset[static_cast<std::size_t>(p)];
      const double closed = std::min(0.0, n.dot(spring));
      stored += d.k.contact * closed * closed;
      if (closed < 0.0) stored += d.k.shear * (spring - closed * n).squaredNorm();
    }
    losses_.friction += 0.5 * facet.weight * facet.area / kFacetPoints * stored * (memory.fade - matching);
    memory.fade = matching;
  }
  if (memory.fade == 0.0 || opened > kOpened * d.radius) memory.retired = true;
}

void FacetNetwork::load_faces() {
  for (BoundaryFace& face : faces_) {
    if (face.pressure == 0.0 && face.last_pressure == 0.0) continue;
    const auto b = static_cast<std::size_t>(face.block);
    const BlockState& s = state_[b];
    const Vec3 arm = s.rotation * face.arm;
    const Vec3 force = -face.pressure * face.area * (s.rotation * face.normal);
    force_[b] += force;
    torque_[b] += arm.cross(force);
    const double swept = volume_swept(face);
    if (blocks_[b].owned) {
      pressure_work_ += 0.5 * (face.pressure + face.last_pressure) * (swept - face.last_swept);
    }
    face.last_pressure = face.pressure;
    face.last_swept = swept;
  }
}

/// Energy of a block's dilatation less the potential of the pressures on its faces [J].
double FacetNetwork::block_potential(std::size_t b, const BlockSums& sums) const {
  const double lambda = material_.lame_lambda();
  const double opened = sums.bonded + sums.loaded;
  const double stiffening = 1.0 + sums.unbonded * lambda / (2.0 * material_.shear_modulus());
  return 0.5 * lambda * opened * opened / (blocks_[b].volume * stiffening);
}

double FacetNetwork::block_energy(std::size_t b) const {
  const BlockSums& sums = sums_[b];
  return block_potential(b, sums) - material_.lame_lambda() * theta_[b] * sums.loaded + sums.squeezed;
}

void FacetNetwork::book_fracture() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    BlockSums& sums = sums_[b];
    if (sums.unbonded_added == 0.0) continue;
    BlockSums after = sums;
    after.bonded -= sums.dropped;
    after.unbonded += sums.unbonded_added;
    if (blocks_[b].owned) losses_.fracture += block_potential(b, sums) - block_potential(b, after);
    sums.unbonded = after.unbonded;
    sums.dropped = sums.unbonded_added = 0.0;
  }
}

void FacetNetwork::push(const Facet& facet, const Vec3& at, const Vec3& force) {
  const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
  force_[i] += force;
  torque_[i] += (at - state_[i].centre).cross(force);
  force_[j] -= force;
  torque_[j] -= (at - state_[j].centre).cross(force);
}

Vec3 FacetNetwork::relative_velocity(const Facet& facet, const Vec3& at) const {
  const BlockState& si = state_[static_cast<std::size_t>(facet.i)];
  const BlockState& sj = state_[static_cast<std::size_t>(facet.j)];
  return sj.velocity + sj.spin.cross(at - sj.centre) - si.velocity - si.spin.cross(at - si.centre);
}

double FacetNetwork::volume_swept(const BoundaryFace& face) const {
  const auto b = static_cast<std::size_t>(face.block);
  const BlockState& s = state_[b];
  const Vec3 moved = s.centre + s.rotation * face.arm - face.start;
  const double two_g = 2.0 * material_.shear_modulus();
  const double squeezed = (-face.pressure - material_.lame_lambda() * theta_[b]) *
                          face.normal.dot(face.arm) / two_g;  // the face's own displacement
  return -face.area * ((s.rotation * face.normal).dot(moved) + squeezed);
}

double FacetNetwork::elastic_energy() const {
  double energy = 0.0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const FacetMemory& memory = memory_[f];
    if (memory.retired) continue;
    const Facet& facet = facets_[f];
    const Derived& d = derived_[f];
    const Vec3& n = kinematics_[f].normal;
    const Mat3& turn = state_[static_cast<std::size_t>(facet.i)].rotation;
    double sum = 0.0;
    for (int p = 0; p < kFacetPoints; ++p) {
      const auto q = static_cast<std::size_t>(p);
      Vec3 spring = point_of(f, p).jump;
      if (memory.broken[q]) spring -= turn * memory.offset[q];
      const double normal = n.dot(spring);
      if (memory.broken[q] && normal >= 0.0) continue;
      const double stiffness = memory.broken[q] ? d.k.contact : d.k.normal;
      const double shear = spring.squaredNorm() - normal * normal;
      sum += (memory.broken[q] ? memory.fade : 1.0) * (stiffness * normal * normal + d.k.shear * shear);
    }
    energy += 0.5 * facet.weight * facet.area / kFacetPoints * sum;
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].owned) energy += block_energy(b);
  }
  return energy;
}

double FacetNetwork::broken_count() const {
  double count = 0.0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (memory_[f].cracked) count += facets_[f].weight;
  }
  return count;
}

double FacetNetwork::broken_area(bool all) const {
  double area = 0.0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    for (bool broken : memory_[f].broken) {
      if (broken || all) area += facets_[f].weight * facets_[f].area / kFacetPoints;
    }
  }
  return area;
}

double FacetNetwork::stable_step() const {
  std::vector<double> stiffness(blocks_.size(), 0.0);
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (memory_[f].retired) continue;
    const double k = facets_[f].area * derived_[f].k.contact;
    stiffness[static_cast<std::size_t>(facets_[f].i)] += k;
    stiffness[static_cast<std::size_t>(facets_[f].j)] += k;
  }
  double fastest = 0.0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].owned) fastest = std::max(fastest, 2.0 * stiffness[b] / blocks_[b].mass);
  }
  return fastest > 0.0 ? 2.0 / std::sqrt(fastest) : std::numeric_limits<double>::infinity();
}

void FacetNetwork::soften(double factor) {
  dilatation();
  losses_.fracture += (1.0 - factor) * elastic_energy();
  material_ = material_.softened(factor);
  derive();
}

}  // namespace muckpile
