// SPDX-License-Identifier: GPL-2.0-or-later
// The dilatation-coupled facet network: two passes over the facets per step.
// Scope: see the header; formulas are there.
#include "bond/facet_network.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

constexpr double kHalfSqrt3 = 0.86602540378443865;

// A broken facet is a plane contact only while its two faces still match. It fades between these
// shares of its radius slid, and of radians turned, and retires once it has opened that far.
constexpr double kSlideStart = 0.1, kSlideEnd = 0.5;
constexpr double kTurnStart = 0.1, kTurnEnd = 0.5;
constexpr double kOpened = 0.1;
constexpr double kSurelyOpen = 0.01;  // opened further than its rotation explains: no point closed

double ramp_down(double x, double start, double end) {
  return std::clamp((end - x) / (end - start), 0.0, 1.0);
}

/// Weights of the two half axes at integration point p: three points at 120 degrees on the ellipse
/// of half axes sqrt(2) x gyration radii have the facet's second moments.
constexpr std::array<std::array<double, 2>, kFacetPoints> kPoints = {
    {{1.0, 0.0}, {-0.5, kHalfSqrt3}, {-0.5, -kHalfSqrt3}}};

/// m of block i. A block may slide along a mirror, and the ground of a fixed support may yield.
Vec3 opening_of(const Facet& facet) {
  if (facet.kind == FacetKind::joint) return facet.opening_i;
  if (facet.kind == FacetKind::fixed) return facet.normal;
  return facet.normal.dot(facet.opening_i) * facet.normal;
}

}  // namespace

FacetNetwork::FacetNetwork(const JointMaterial& material, const std::vector<JointClass>& natural)
    : materials_{material} {
  for (const JointClass& joint : natural) materials_.push_back(material.with_joints(joint));
  derive();
}

void FacetNetwork::set_blocks(std::vector<BlockConstants> blocks) {
  blocks_ = std::move(blocks);
  blocks_.push_back({kGroundTag, 1.0, 1.0, false, {}});
  state_.assign(blocks_.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Mat3::Identity()});
  sums_.assign(blocks_.size(), {});
  theta_.assign(blocks_.size(), 0.0);
  bulk_stress_.assign(blocks_.size(), 0.0);
  force_.assign(blocks_.size(), Vec3::Zero());
  torque_.assign(blocks_.size(), Vec3::Zero());
}

void FacetNetwork::set_facets(std::vector<Facet> facets, std::vector<FacetMemory> memory) {
  facets_ = std::move(facets);
  memory_ = std::move(memory);
  memory_.resize(facets_.size());
  kinematics_.assign(facets_.size(),
                     {Vec3::UnitX(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  states_.resize(facets_.size());
  asleep_.assign(facets_.size(), 0);
  for (std::size_t f = 0; f < facets_.size(); ++f) states_[f] = memory_[f].state;
  derive();
  list_active();
  list_yielding();
  count_unbonded();
}

void FacetNetwork::set_faces(std::vector<BoundaryFace> faces) {
  faces_ = std::move(faces);
  count_unbonded();
}

void FacetNetwork::derive() {
  damping_ = material().damping_coefficient();
  contact_damping_ = material().contact_damping_coefficient();
  const double sharpening =
      kSharpening * (2.0 * material().lame_lambda() + material().shear_modulus()) / 6.0;  // D [Pa]
  elastic_.resize(facets_.size());
  law_.resize(facets_.size());
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const Facet& facet = facets_[f];
    const bool grounded = facet.kind != FacetKind::joint;
    const double share_i = grounded ? 1.0 : 0.5, share_j = grounded ? 0.0 : 0.5;
    Law& law = law_[f];
    law.depth_i = facet.normal.dot(facet.arm_i);
    law.depth_j = grounded ? 0.0 : -facet.normal.dot(facet.arm_j);
    const JointMaterial& joint = materials_.at(facet.joint_class);
    const FacetStiffness k = joint.facet_stiffness(law.depth_i + law.depth_j);
    const bool smooth = facet.kind == FacetKind::mirror;
    law.half_1 = facet.half_axes[0];
    law.half_2 = facet.half_axes[1];
    law.per_half_1_squared = 1.0 / law.half_1.squaredNorm();
    law.per_half_2_squared = 1.0 / law.half_2.squaredNorm();
    law.weight = facet.weight;
    law.area = facet.area / kFacetPoints;
    law.shear = smooth ? 0.0 : k.shear;
    law.normal_extra = k.normal - law.shear;
    law.bulk_i = share_i * k.rock_share;
    law.bulk_j = share_j * k.rock_share;
    law.contact = k.contact;
    law.tan_residual = smooth ? 0.0 : joint.tan_residual_friction();
    law.radius = std::sqrt(facet.area / M_PI);
    law.joint_class = facet.joint_class;
    elastic_[f] = {facet.i,
                   facet.j,
                   facet.normal,
                   facet.arm_i,
                   facet.arm_j + memory_[f].ground.displacement,
                   opening_of(facet),
                   facet.opening_j,
                   share_i * k.rock_share * facet.area,
                   share_j * k.rock_share * facet.area,
                   facet.sharpened
                       ? sharpening * k.rock_share * facet.area * (law.depth_i + law.depth_j)
                       : 0.0};
  }
}

void FacetNetwork::list_active() {
  active_.clear();
  for (std::size_t f = 0; f < states_.size(); ++f) {
    if (states_[f] != FacetState::retired) active_.push_back(f);
  }
  retired_since_ = 0;
}

void FacetNetwork::count_unbonded() {
  for (std::size_t b = 0; b < blocks_.size(); ++b) sums_[b].unbonded = blocks_[b].retired.unbonded;
  for (const BoundaryFace& face : faces_) {
    const auto b = static_cast<std::size_t>(face.block);
    sums_[b].unbonded += face.area * face.normal.dot(face.arm) / blocks_[b].volume;
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const Facet& facet = facets_[f];
    const auto i = static_cast<std::size_t>(facet.i), j = static_cast<std::size_t>(facet.j);
    for (bool broken : memory_[f].broken) {
      if (!broken) continue;
      sums_[i].unbonded += law_[f].area * law_[f].depth_i / blocks_[i].volume;
      sums_[j].unbonded += law_[f].area * law_[f].depth_j / blocks_[j].volume;
    }
  }
}

void FacetNetwork::dilatation(double dt) {
  if (4 * retired_since_ > active_.size()) list_active();
  for (BlockSums& sums : sums_) sums.bonded = sums.loaded = sums.squeezed = 0.0;
  for (std::size_t f : active_) {
    if (states_[f] != FacetState::retired && asleep_[f] <= calls_) open_facet(f);
  }
  const double two_g = 2.0 * material().shear_modulus();
  for (const BoundaryFace& face : faces_) {
    if (face.pressure == 0.0) continue;
    BlockSums& sums = sums_[static_cast<std::size_t>(face.block)];
    const double squeezed = face.area * face.pressure * face.normal.dot(face.arm) / two_g;
    sums.loaded -= squeezed;
    sums.squeezed += 0.5 * squeezed * face.pressure;
  }
  if (!yielding_.empty()) yield_ground(dt);
  for (std::size_t b = 0; b < blocks_.size(); ++b) theta_[b] = theta_of(b);
  theta_.back() = 0.0;  // the ground
}

/// s of the header.
double FacetNetwork::stiffening(const BlockSums& sums) const {
  return 1.0 + sums.unbonded * material().lame_lambda() / (2.0 * material().shear_modulus());
}

double FacetNetwork::theta_of(std::size_t b) const {
  return (sums_[b].bonded + sums_[b].loaded) / (blocks_[b].volume * stiffening(sums_[b]));
}

/// D A h of the part of a facet that is bonded [J].
double FacetNetwork::sharpening(std::size_t f) const {
  if (states_[f] == FacetState::intact) return elastic_[f].sharpening;
  int bonded = 0;
  for (bool broken : memory_[f].broken) bonded += broken ? 0 : 1;
  return elastic_[f].sharpening * bonded / kFacetPoints;
}

void FacetNetwork::bulk_stresses() {
  for (BlockSums& sums : sums_) sums.uneven = 0.0;
  for (std::size_t f : active_) {
    const auto i = static_cast<std::size_t>(elastic_[f].i),
               j = static_cast<std::size_t>(elastic_[f].j);
    const double part = sharpening(f) * (theta_[i] - theta_[j]);
    sums_[i].uneven += part;
    sums_[j].uneven -= part;
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    bulk_stress_[b] = material().lame_lambda() * theta_[b] +
                      sums_[b].uneven / (blocks_[b].volume * stiffening(sums_[b]));
  }
  bulk_stress_.back() = 0.0;  // the ground
}

/// Kinematics of a facet, and its part in the dilatation of its blocks.
void FacetNetwork::open_facet(std::size_t f) {
  const Elastic& e = elastic_[f];
  const auto i = static_cast<std::size_t>(e.i), j = static_cast<std::size_t>(e.j);
  const BlockState &si = state_[i], &sj = state_[j];
  Kinematics& kin = kinematics_[f];
  const Mat3 both = si.rotation + sj.rotation;
  kin.normal.noalias() = both * e.normal;
  const double scale = 1.0 / std::sqrt(kin.normal.squaredNorm());
  kin.normal *= scale;
  kin.side.noalias() = si.rotation * e.arm_i;
  kin.jump.noalias() = sj.rotation * e.arm_j;
  kin.jump += sj.centre - si.centre - kin.side;
  if (all_broken(f)) return;
  kin.opening_i.noalias() = scale * (both * e.opening_i);
  kin.opening_j.noalias() = scale * (both * e.opening_j);
  Vec3 bonded = kin.jump;  // mean over the facet of the jump where it is bonded [m]
  if (states_[f] != FacetState::intact) {
    const Frame frame = frame_of(f);
    bonded.setZero();
    for (int p = 0; p < kFacetPoints; ++p) {
      if (memory_[f].broken[static_cast<std::size_t>(p)]) continue;
      bonded += point_of(f, frame, p).jump / kFacetPoints;
    }
  }
  sums_[i].bonded += e.area_i * kin.opening_i.dot(bonded);
  sums_[j].bonded += e.area_j * kin.opening_j.dot(bonded);
}

bool FacetNetwork::all_broken(std::size_t f) const {
  if (states_[f] == FacetState::intact) return false;
  const auto& broken = memory_[f].broken;
  return broken[0] && broken[1] && broken[2];
}

void FacetNetwork::tractions(double dt) {
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  std::fill(torque_.begin(), torque_.end(), Vec3::Zero());
  newly_cracked_ = false;
  for (std::size_t f : active_) {
    if (states_[f] == FacetState::retired || asleep_[f] > calls_) continue;
    if (states_[f] != FacetState::intact || damping_ > 0.0 || !hold_facet(f)) work_facet(f, dt);
  }
  ++calls_;
  load_faces();
  if (newly_cracked_) book_fracture();
}

FacetNetwork::Frame FacetNetwork::frame_of(std::size_t f) const {
  const Law& law = law_[f];
  const Mat3& ri = state_[static_cast<std::size_t>(elastic_[f].i)].rotation;
  const Mat3& rj = state_[static_cast<std::size_t>(elastic_[f].j)].rotation;
  Frame frame;
  frame.half_1.noalias() = ri * law.half_1;
  frame.half_2.noalias() = ri * law.half_2;
  frame.turn_1.noalias() = rj * law.half_1;
  frame.turn_2.noalias() = rj * law.half_2;
  frame.turn_1 -= frame.half_1;
  frame.turn_2 -= frame.half_2;
  return frame;
}

FacetNetwork::Point FacetNetwork::point_of(std::size_t f, const Frame& frame, int p) const {
  const auto [c, s] = kPoints[static_cast<std::size_t>(p)];
  Point point;
  point.jump = kinematics_[f].jump + c * frame.turn_1 + s * frame.turn_2;
  point.arm = kinematics_[f].side + c * frame.half_1 + s * frame.half_2 + 0.5 * point.jump;
  return point;
}

Vec3 FacetNetwork::bonded_traction(std::size_t f, const Point& point) const {
  const Law& law = law_[f];
  const Kinematics& kin = kinematics_[f];
  const double bulk_i = law.bulk_i * bulk_stress_[static_cast<std::size_t>(elastic_[f].i)];
  const double bulk_j = law.bulk_j * bulk_stress_[static_cast<std::size_t>(elastic_[f].j)];
  return law.shear * point.jump + law.normal_extra * kin.normal.dot(point.jump) * kin.normal +
         bulk_i * kin.opening_i + bulk_j * kin.opening_j;
}

Vec3 FacetNetwork::mean_traction(std::size_t f) const {
  return bonded_traction(f, {kinematics_[f].jump, Vec3::Zero()});
}

bool FacetNetwork::fails(std::size_t f, const Vec3& traction) const {
  const JointMaterial& joint = materials_[law_[f].joint_class];
  const double along = kinematics_[f].normal.dot(traction);
  const double shear = std::sqrt(std::max(0.0, traction.squaredNorm() - along * along));
  const JointParameters& p = joint.parameters();
  return joint_fails(along, shear, p.tension, p.cohesion, joint.tan_friction());
}

/// Forces of an intact, undamped facet; false, and nothing done, if a point of it fails.
bool FacetNetwork::hold_facet(std::size_t f) {
  const Frame frame = frame_of(f);
  Push push;
  for (int p = 0; p < kFacetPoints; ++p) {
    const Point point = point_of(f, frame, p);
    const Vec3 traction = bonded_traction(f, point);
    if (fails(f, traction)) return false;
    push.force += traction;
    push.moment += point.arm.cross(traction);
  }
  push.force *= law_[f].area;
  push.moment *= law_[f].area;
  apply(f, push);
  return true;
}

/// Forces of any facet: breaks points, and handles broken and damped ones.
void FacetNetwork::work_facet(std::size_t f, double dt) {
  const Frame frame = frame_of(f);
  if (states_[f] != FacetState::intact && !closes(f, frame, dt)) return;
  const bool torn =
      turned_squared(f, frame) > kTurnStart * kTurnStart;  // else a last point is a hinge
  const Slip slip = slip_of(f);
  const bool fresh = memory_[f].open;
  memory_[f].open = false;
  Push push;
  for (int p = 0; p < kFacetPoints; ++p) {
    const Point point = point_of(f, frame, p);
    Vec3 traction;
    if (!memory_[f].broken[static_cast<std::size_t>(p)]) {
      traction = bonded_traction(f, point);
      if (torn || fails(f, traction)) {
        break_point(f, p, point, slip, traction, dt);
      } else if (damping_ > 0.0 && !memory_[f].ground.yields) {  // the ground has a dashpot itself
        const Vec3 rate = slip.at(point.arm);
        traction += damping_ * rate;
        losses_.damping += facets_[f].weight * law_[f].area * damping_ * rate.squaredNorm() * dt;
      }
    }
    if (memory_[f].broken[static_cast<std::size_t>(p)])
      traction = contact_traction(f, p, point, slip, fresh, dt);
    push.force += law_[f].area * traction;
    push.moment += law_[f].area * point.arm.cross(traction);
  }
  apply(f, push);
}

void FacetNetwork::break_point(std::size_t f, int p, const Point& point, const Slip& slip,
                               const Vec3& traction, double dt) {
  const Law& law = law_[f];
  const Vec3& n = kinematics_[f].normal;
  const double normal = n.dot(traction);
  const double held = std::min(normal, 0.0);
  const Vec3 shear = traction - normal * n;
  const double limit = law.tan_residual * -held;
  const double shear_size = shear.norm();
  const double kept = shear_size > limit ? limit / shear_size : 1.0;
  // The contact starts with the compression that the joint carried and the shear that friction can.
  Vec3 spring = held / law.contact * n;
  if (law.shear > 0.0) spring += kept / law.shear * shear;

  FacetMemory& memory = memory_[f];
  const Mat3& turn = state_[static_cast<std::size_t>(elastic_[f].i)].rotation;
  memory.offset[static_cast<std::size_t>(p)] = turn.transpose() * (point.jump - spring);
  memory.broken[static_cast<std::size_t>(p)] = true;
  if (memory.state == FacetState::intact) memory.state = states_[f] = FacetState::cracked;
  newly_cracked_ = true;

  const double normal_jump = n.dot(point.jump);
  const double before =
      law.shear * point.jump.squaredNorm() + law.normal_extra * normal_jump * normal_jump;
  double after = held * held / law.contact;
  if (law.shear > 0.0) after += kept * kept * shear_size * shear_size / law.shear;
  // The half kick to the present step used the traction before, the one from it uses that after:
  // the blocks did the work of their mean over the step's path, the springs' account assumes the
  // first.
  const Vec3 dropped = traction - held * n - kept * shear;
  const double undone = dropped.dot(slip.at(point.arm)) * dt;
  const double uneven = theta_[static_cast<std::size_t>(elastic_[f].i)] -
                        theta_[static_cast<std::size_t>(elastic_[f].j)];
  losses_.fracture += 0.5 * facets_[f].weight *
                      (law.area * (before - after - undone) +
                       elastic_[f].sharpening / kFacetPoints * uneven * uneven);
  drop_from_dilatation(f, point.jump);
}

void FacetNetwork::drop_from_dilatation(std::size_t f, const Vec3& jump) {
  const Elastic& e = elastic_[f];
  const Law& law = law_[f];
  const auto drop = [&](int block, double area_share, const Vec3& opening, double depth) {
    const auto b = static_cast<std::size_t>(block);
    sums_[b].dropped += area_share * opening.dot(jump) / kFacetPoints;
    sums_[b].unbonded_added += law.area * depth / blocks_[b].volume;
  };
  drop(e.i, e.area_i, kinematics_[f].opening_i, law.depth_i);
  drop(e.j, e.area_j, kinematics_[f].opening_j, law.depth_j);
}

Vec3 FacetNetwork::contact_traction(std::size_t f, int p, const Point& point, const Slip& slip,
                                    bool fresh, double dt) {
  const Law& law = law_[f];
  FacetMemory& memory = memory_[f];
  Vec3& offset = memory.offset[static_cast<std::size_t>(p)];
  const Mat3& turn = state_[static_cast<std::size_t>(elastic_[f].i)].rotation;
  const Vec3& n = kinematics_[f].normal;
  Vec3 spring = point.jump - turn * offset;
  const double closed = n.dot(spring);
  if (closed >= 0.0 || fresh) {  // open until now: friction forgets where it stuck
    offset = turn.transpose() * (point.jump - closed * n);
    if (closed >= 0.0) return Vec3::Zero();
    spring = closed * n;
  }
  const double booked = law.weight * law.area;
  const double normal_rate = n.dot(slip.at(point.arm));
  const double elastic = memory.fade * law.contact * closed;
  const double damping = memory.fade * contact_damping_;
  const double normal = std::min(0.0, elastic + damping * normal_rate);
  losses_.damping += booked * (normal - elastic) * normal_rate * dt;

  const Vec3 stuck = spring - closed * n;
  Vec3 shear = memory.fade * law.shear * stuck;
  const double size = shear.norm(), limit = law.tan_residual * -normal;
  if (size > limit) {
    const double kept = limit / size;
    offset += turn.transpose() * ((1.0 - kept) * stuck);
    shear *= kept;
    losses_.friction += booked * limit * (1.0 - kept) * stuck.norm();
  }
  return normal * n + shear;
}

/// Square of the angle by which the two blocks have turned against each other [rad2], while small.
double FacetNetwork::turned_squared(std::size_t f, const Frame& frame) const {
  return frame.turn_1.squaredNorm() * law_[f].per_half_1_squared +
         frame.turn_2.squaredNorm() * law_[f].per_half_2_squared;
}

/// Lets a broken facet fade and retire; false if it carries nothing in this step.
bool FacetNetwork::closes(std::size_t f, const Frame& frame, double dt) {
  FacetMemory& memory = memory_[f];
  if (!all_broken(f)) return true;
  const Law& law = law_[f];
  const Kinematics& kin = kinematics_[f];
  const double opened = kin.normal.dot(kin.jump);
  const double slid_squared =
      (kin.jump.squaredNorm() - opened * opened) / (law.radius * law.radius);
  const double turn_squared = turned_squared(f, frame);
  if (slid_squared > kSlideStart * kSlideStart || turn_squared > kTurnStart * kTurnStart) {
    const double matching =
        ramp_down(std::sqrt(std::max(slid_squared, 0.0)), kSlideStart, kSlideEnd) *
        ramp_down(std::sqrt(turn_squared), kTurnStart, kTurnEnd);
    if (matching < memory.fade) {
      book_fading(f, frame, memory.fade - matching);
      memory.fade = matching;
      memory.state = states_[f] = FacetState::fading;
    }
  }
  if (memory.fade == 0.0 || opened > kOpened * law.radius) {
    memory.state = states_[f] = FacetState::retired;
    ++retired_since_;
    return false;
  }
  const double turned =
      std::sqrt(frame.turn_1.squaredNorm()) + std::sqrt(frame.turn_2.squaredNorm());
  const double tilted = std::sqrt(std::max(slid_squared, 0.0) * turn_squared);
  const double gap = opened - turned - (tilted + kSurelyOpen) * law.radius;
  if (gap <= 0.0) return true;
  memory.open = true;
  let_sleep(f, gap, dt);
  return false;
}

/// Leaves an open facet alone for as long as its gap lasts at twice the present speed of approach,
/// for a bounded time, because other forces may change that speed.
void FacetNetwork::let_sleep(std::size_t f, double gap, double dt) {
  const BlockState& si = state_[static_cast<std::size_t>(elastic_[f].i)];
  const BlockState& sj = state_[static_cast<std::size_t>(elastic_[f].j)];
  const double reach = kinematics_[f].side.norm() + law_[f].depth_j + 3.0 * law_[f].radius;
  const double speed =
      (sj.velocity - si.velocity).norm() + (si.spin.norm() + sj.spin.norm()) * reach;
  if (dt <= 0.0) return;
  const double steps = 0.5 * gap / (std::max(speed, 1e-30) * dt);
  asleep_[f] = calls_ + 1 +
               static_cast<std::int64_t>(std::min(steps, material().parameters().longest_sleep));
}

/// The spring energy that a facet gives up when its fade falls by `lost` is booked as friction.
void FacetNetwork::book_fading(std::size_t f, const Frame& frame, double lost) {
  const Law& law = law_[f];
  const Mat3& turn = state_[static_cast<std::size_t>(elastic_[f].i)].rotation;
  const Vec3& n = kinematics_[f].normal;
  double stored = 0.0;
  for (int p = 0; p < kFacetPoints; ++p) {
    const Vec3 spring =
        point_of(f, frame, p).jump - turn * memory_[f].offset[static_cast<std::size_t>(p)];
    const double closed = n.dot(spring);
    if (closed >= 0.0) continue;
    stored += law.contact * closed * closed + law.shear * (spring - closed * n).squaredNorm();
  }
  losses_.friction += 0.5 * facets_[f].weight * law.area * stored * lost;
}

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

/// Energy of a block's dilatation less the potential of the pressures on its faces [J].
double FacetNetwork::block_potential(std::size_t b, const BlockSums& sums) const {
  const double opened = sums.bonded + sums.loaded;
  return 0.5 * material().lame_lambda() * opened * opened / (blocks_[b].volume * stiffening(sums));
}

double FacetNetwork::block_energy(std::size_t b) const {
  const BlockSums& sums = sums_[b];
  return block_potential(b, sums) - bulk_stress_[b] * sums.loaded + sums.squeezed;
}

void FacetNetwork::book_fracture() {
  const std::vector<double> theta_before = theta_;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    BlockSums& sums = sums_[b];
    if (sums.unbonded_added == 0.0) continue;
    BlockSums after = sums;
    after.bonded -= sums.dropped;
    after.unbonded += sums.unbonded_added;
    if (blocks_[b].owned) losses_.fracture += block_potential(b, sums) - block_potential(b, after);
    sums.bonded = after.bonded;
    sums.unbonded = after.unbonded;
    sums.dropped = sums.unbonded_added = 0.0;
    if (blocks_[b].owned) theta_[b] = theta_of(b);
  }
  book_sharpening(theta_before);
  bulk_stresses();
}

/// Books what the energy of uneven dilatation loses as breaking changes theta. The part of a block
/// of another rank is booked there; only the product of both changes is left out.
void FacetNetwork::book_sharpening(const std::vector<double>& theta_before) {
  for (std::size_t f : active_) {
    const auto i = static_cast<std::size_t>(elastic_[f].i),
               j = static_cast<std::size_t>(elastic_[f].j);
    const double before = theta_before[i] - theta_before[j], after = theta_[i] - theta_[j];
    losses_.fracture += 0.5 * sharpening(f) * (before * before - after * after);
  }
}

void FacetNetwork::apply(std::size_t f, const Push& push) {
  const auto i = static_cast<std::size_t>(elastic_[f].i),
             j = static_cast<std::size_t>(elastic_[f].j);
  force_[i] += push.force;
  torque_[i] += push.moment;
  force_[j] -= push.force;
  torque_[j] -= push.moment + (state_[i].centre - state_[j].centre).cross(push.force);
}

/// The velocity that block j's rock would have at the centre of block i, less that of block i.
FacetNetwork::Slip FacetNetwork::slip_of(std::size_t f) const {
  const BlockState& si = state_[static_cast<std::size_t>(elastic_[f].i)];
  const BlockState& sj = state_[static_cast<std::size_t>(elastic_[f].j)];
  return {sj.velocity - si.velocity + sj.spin.cross(si.centre - sj.centre), sj.spin - si.spin};
}

double FacetNetwork::volume_swept(const BoundaryFace& face) const {
  const double two_g = 2.0 * material().shear_modulus();
  const double bulk_stress = bulk_stress_[static_cast<std::size_t>(face.block)];
  const double squeezed = (-face.pressure - bulk_stress) * face.normal.dot(face.arm) /
                          two_g;  // the face's own displacement
  return face.rigid_swept - face.area * squeezed;
}

double FacetNetwork::elastic_energy() const {
  double energy = 0.0;
  for (std::size_t f : active_) {
    const FacetMemory& memory = memory_[f];
    if (memory.state == FacetState::retired || memory.open) continue;
    const Law& law = law_[f];
    const double uneven = theta_[static_cast<std::size_t>(elastic_[f].i)] -
                          theta_[static_cast<std::size_t>(elastic_[f].j)];
    energy += 0.5 * facets_[f].weight * sharpening(f) * uneven * uneven;
    const Frame frame = frame_of(f);
    const Vec3& n = kinematics_[f].normal;
    const Mat3& turn = state_[static_cast<std::size_t>(elastic_[f].i)].rotation;
    double sum = 0.0;
    for (int p = 0; p < kFacetPoints; ++p) {
      const auto q = static_cast<std::size_t>(p);
      const Vec3 jump = point_of(f, frame, p).jump;
      if (!memory.broken[q]) {
        const double normal = n.dot(jump);
        sum += law.shear * jump.squaredNorm() + law.normal_extra * normal * normal;
        continue;
      }
      const Vec3 spring = jump - turn * memory.offset[q];
      const double closed = n.dot(spring);
      if (closed >= 0.0) continue;
      sum += memory.fade *
             (law.contact * closed * closed + law.shear * (spring - closed * n).squaredNorm());
    }
    energy += 0.5 * facets_[f].weight * law.area * sum;
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (blocks_[b].owned) energy += block_energy(b);
  }
  return energy;
}

double FacetNetwork::broken_count() const {
  double count = 0.0;
  for (const BlockConstants& block : blocks_) {
    if (block.owned) count += 0.5 * block.retired.count;  // each of the two blocks remembers it
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].kind == FacetKind::joint && states_[f] != FacetState::intact)
      count += facets_[f].weight;
  }
  return count;
}

double FacetNetwork::broken_area(bool all) const {
  double area = 0.0;
  for (const BlockConstants& block : blocks_) {
    if (block.owned) area += 0.5 * block.retired.area;
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (facets_[f].kind != FacetKind::joint) continue;
    for (bool broken : memory_[f].broken) {
      if (broken || all) area += facets_[f].weight * law_[f].area;
    }
  }
  return area;
}

void FacetNetwork::soften(double factor) {
  stop_ground();  // what is behind is not softened, and no wave is left to let out
  losses_.fracture += (1.0 - factor) * elastic_energy();
  for (JointMaterial& material : materials_) material = material.softened(factor);
  derive();
}

}  // namespace muckpile
