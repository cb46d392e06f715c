// SPDX-License-Identifier: GPL-2.0-or-later
// A step of the contact between two polyhedral bodies.
// Scope: see the header.
#include "contact/polyhedra/solid_contact.h"

#include <algorithm>

namespace muckpile {
namespace {

constexpr int kMostLooks = 30;   // for the size at which two bodies just touch
constexpr double kNoGap = 1e-9;  // of the depth of a body

/// How two bodies lie along a direction.
struct Along {
  double between;  ///< their centres [m]
  double reach;    ///< sum of how far both reach towards each other [m]
};

/// `n` in the axes of the first, `n_second` in those of the second.
Along along(const Solid& first, const Solid& second, const Vec3& n, const Vec3& n_second,
            double between) {
  return {between, first.reach(n) + second.reach(-n_second)};
}

}  // namespace

/// As the first body sees it.
void SolidContact::see(const SolidBody& first, const SolidBody& second, const Vec3& axis) {
  const Mat3 back = first.pose.axes.transpose();
  turn_ = back * second.pose.axes;
  motion_.between = back * (second.pose.centre - first.pose.centre);
  motion_.velocity = back * (first.velocity - second.velocity);
  motion_.spin_first = back * first.spin;
  motion_.spin_second = back * second.spin;
  motion_.reduced_mass = first.mass * second.mass / (first.mass + second.mass);
  const double a = first.solid->least_depth(), b = second.solid->least_depth();
  motion_.twist_arm = 2.0 * a * b / (a + b);
  normal_ = axis.squaredNorm() > 0.0 ? Vec3(back * axis) : motion_.between.normalized();
}

bool SolidContact::overlap(const SolidBody& first, const SolidBody& second, double size) {
  finder_.place(*first.solid, *second.solid, turn_, motion_.between, size);
  gap_ = finder_.work(normal_);
  return finder_.touching();
}

/// A step ago, in the axes that the first had then.
bool SolidContact::overlapped_before(const SolidBody& first, const SolidBody& second,
                                     double time_step) {
  const Vec3 spin = motion_.spin_first - motion_.spin_second;
  const double speed = spin.norm();
  Mat3 turn = turn_;
  if (speed > 0.0)
    turn = Eigen::AngleAxisd(speed * time_step, spin / speed).toRotationMatrix() * turn;
  const Vec3 between =
      motion_.between + time_step * (motion_.velocity + motion_.spin_first.cross(motion_.between));
  finder_.place(*first.solid, *second.solid, turn, between, 1.0);
  Vec3 normal = normal_;
  (void)finder_.work(normal);
  return finder_.touching();
}

/// Share of their sizes up to which they are apart, at most a little above 1; along normal_ they
/// touch in that size. It follows from the present pose alone, so that all ranks have the same.
/// Each turn takes the largest gap in the size that the last one has found (Dinkelbach 1967: the
/// greatest of all quotients of distance and reach).
double SolidContact::touching_size(const SolidBody& first, const SolidBody& second) {
  const double least = std::min(first.solid->least_depth(), second.solid->least_depth());
  double size = 0.0;
  Vec3 n = motion_.between.normalized();
  for (int k = 0; k < kMostLooks && n.squaredNorm() > 0.0; ++k) {
    const Along there =
        along(*first.solid, *second.solid, n, turn_.transpose() * n, n.dot(motion_.between));
    size = std::max(size, there.between / there.reach);
    gap_ = there.between - there.reach;
    normal_ = n;
    if (size >= 1.0) break;
    finder_.place(*first.solid, *second.solid, turn_, motion_.between, size);
    if (!(finder_.search_gap(n) > kNoGap * least)) break;
  }
  return size;
}

/// Two bodies that do not touch, in the size to which they are drawn in: they get their size back.
SolidContact::Outcome SolidContact::part(const SolidBody& first, const SolidBody& second,
                                         Vec3& axis, ContactState& state) {
  const double before = 1.0 - state.overlap_offset;
  state = {};
  const double size = before < 1.0 ? std::max(before, touching_size(first, second)) : 1.0;
  if (gap_ > 0.0 || size < 1.0) axis = first.pose.axes * normal_;
  if (size >= 1.0) return {false, std::max(gap_, 0.0)};
  state.overlap_offset = 1.0 - size;
  return {true, 0.0};
}

SolidContact::Outcome SolidContact::step(const SolidContactLaw& law, const SolidBody& first,
                                         const SolidBody& second, double time_step,
                                         double memory_step, bool is_new, Vec3& axis,
                                         ContactState& state, SolidResponse& response) {
  if (is_new) state = {};
  const double size = 1.0 - state.overlap_offset;
  response = {};
  if (is_new && axis.squaredNorm() > 0.0) {
    const Along there = along(*first.solid, *second.solid, first.pose.axes.transpose() * axis,
                              second.pose.axes.transpose() * axis,
                              axis.dot(second.pose.centre - first.pose.centre));
    const double gap = there.between - there.reach;
    if (gap > 0.0) return {false, gap};
  }
  see(first, second, axis);
  if (!overlap(first, second, size)) return part(first, second, axis, state);
  if (is_new) {
    if (overlapped_before(first, second, time_step)) {
      state.overlap_offset = std::max(0.0, 1.0 - touching_size(first, second));
      return {true, 0.0};
    }
    (void)overlap(first, second, size);
  }
  response = respond(law, first.pose.axes, memory_step, state);
  axis = -(first.pose.axes * finder_.overlap().push).normalized();
  return {true, 0.0};
}

/// Of the overlap found last, in space.
SolidResponse SolidContact::respond(const SolidContactLaw& law, const Mat3& axes,
                                    double memory_step, ContactState& state) const {
  state.slide = axes.transpose() * state.slide;
  state.roll = axes.transpose() * state.roll;
  SolidResponse r = law.evaluate(finder_.overlap(), motion_, memory_step, state);
  state.slide = axes * state.slide;
  state.roll = axes * state.roll;
  for (Vec3* vector : {&r.force, &r.moment, &r.dashpot_force, &r.dashpot_moment})
    *vector = axes * *vector;
  return r;
}

SolidResistance SolidContact::resistance(const SolidContactLaw& law, const SolidBody& first,
                                         const SolidBody& second, const ContactState& state) {
  see(first, second, Vec3::Zero());
  (void)overlap(first, second, 1.0 - state.overlap_offset);
  SolidResistance r = law.resistance(finder_.overlap(), motion_);
  r.normal = first.pose.axes * r.normal;
  r.point = first.pose.centre + first.pose.axes * r.point;
  return r;
}

double SolidContact::energy(const SolidContactLaw& law, const SolidBody& first,
                            const SolidBody& second, const ContactState& state) {
  see(first, second, Vec3::Zero());
  if (!overlap(first, second, 1.0 - state.overlap_offset)) return 0.0;
  ContactState copy = state;
  return respond(law, first.pose.axes, 0.0, copy).elastic_energy;
}

}  // namespace muckpile
