// SPDX-License-Identifier: GPL-2.0-or-later
// A step of the contact between two polyhedral bodies.
// Scope: see the header.
#include "contact/polyhedra/solid_contact.h"

#include <algorithm>

namespace muckpile {
namespace {

constexpr int kBisections = 45;
constexpr double kSmallest = 0.5;  // share of their size to which two bodies are drawn in at most

}  // namespace

/// As the first body sees it.
void SolidContact::see(const SolidBody& first, const SolidBody& second) {
  const Mat3 back = first.pose.axes.transpose();
  turn_ = back * second.pose.axes;
  motion_.between = back * (second.pose.centre - first.pose.centre);
  motion_.velocity = back * (first.velocity - second.velocity);
  motion_.spin_first = back * first.spin;
  motion_.spin_second = back * second.spin;
  motion_.reduced_mass = first.mass * second.mass / (first.mass + second.mass);
  const double a = first.solid->least_depth(), b = second.solid->least_depth();
  motion_.twist_arm = 2.0 * a * b / (a + b);
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

/// Share of their sizes, above `low`, at which they just do not touch.
double SolidContact::touching_size(const SolidBody& first, const SolidBody& second, double low) {
  double high = 1.0;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (low + high);
    (overlap(first, second, middle) ? high : low) = middle;
  }
  return low;
}

/// What a new contact starts with; true: it lasts.
bool SolidContact::begin(const SolidBody& first, const SolidBody& second, double time_step,
                         ContactState& state) {
  state = {};
  if (!overlap(first, second, 1.0)) return false;
  if (overlapped_before(first, second, time_step))
    state.overlap_offset = 1.0 - touching_size(first, second, kSmallest);
  return true;
}

/// Two bodies that no longer touch in the size to which they are drawn in;
/// true: the contact lasts.
bool SolidContact::part(const SolidBody& first, const SolidBody& second, ContactState& state) {
  const double size = 1.0 - state.overlap_offset;
  state = {};
  if (size == 1.0 || !overlap(first, second, 1.0)) return false;
  state.overlap_offset = 1.0 - touching_size(first, second, size);
  return true;
}

SolidContact::Outcome SolidContact::step(const SolidContactLaw& law, const SolidBody& first,
                                         const SolidBody& second, double time_step,
                                         double memory_step, bool is_new, Vec3& axis,
                                         ContactState& state, SolidResponse& response) {
  if (axis.squaredNorm() > 0.0) {
    const double gap = gap_along(*first.solid, *second.solid, first.pose.axes.transpose() * axis,
                                 second.pose.axes.transpose() * axis,
                                 axis.dot(second.pose.centre - first.pose.centre));
    if (gap > 0.0) return {false, gap};
  }
  see(first, second);
  normal_ = motion_.between.normalized();
  response = {};
  bool lasts = !is_new || begin(first, second, time_step, state);
  if (lasts && !overlap(first, second, 1.0 - state.overlap_offset))
    lasts = !is_new ? part(first, second, state) : state.overlap_offset > 0.0;
  else if (lasts)
    response = respond(law, first.pose.axes, memory_step, state);
  if (lasts) return {true, 0.0};
  if (gap_ > 0.0) axis = first.pose.axes * normal_;
  return {false, gap_};
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
  see(first, second);
  (void)overlap(first, second, 1.0 - state.overlap_offset);
  SolidResistance r = law.resistance(finder_.overlap(), motion_.reduced_mass);
  r.normal = first.pose.axes * r.normal;
  r.point = first.pose.centre + first.pose.axes * r.point;
  return r;
}

double SolidContact::energy(const SolidContactLaw& law, const SolidBody& first,
                            const SolidBody& second, const ContactState& state) {
  see(first, second);
  if (!overlap(first, second, 1.0 - state.overlap_offset)) return 0.0;
  ContactState copy = state;
  return respond(law, first.pose.axes, 0.0, copy).elastic_energy;
}

}  // namespace muckpile
