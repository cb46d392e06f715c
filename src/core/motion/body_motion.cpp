// SPDX-License-Identifier: GPL-2.0-or-later
// The step of rigid bodies made of spheres.
// Scope: see the header.
#include "motion/body_motion.h"

#include "motion/turn.h"

namespace muckpile {
namespace {

using Constants = std::array<double, kBodyLanes>;

[[gnu::always_inline]] inline BodyLanes lanes(const Constants& row) {
  return {row.data(), std::experimental::element_aligned};
}
[[gnu::always_inline]] inline BodyVectors lanes(const std::array<Constants, 3>& rows) {
  return {lanes(rows[0]), lanes(rows[1]), lanes(rows[2])};
}

/// `changed` where the bit is 1.
[[gnu::always_inline]] inline void keep_where(unsigned bits, BodyLanes& number,
                                              const BodyLanes& changed) {
  where(mask_of<BodyLanes>(bits), number) = changed;
}
void keep_where(const std::array<std::uint8_t, 3>& bits, BodyVectors& vector,
                const BodyVectors& changed) {
  keep_where(bits[0], vector.x, changed.x);
  keep_where(bits[1], vector.y, changed.y);
  keep_where(bits[2], vector.z, changed.z);
}

[[gnu::always_inline]] inline QuaternionOf<BodyLanes> load_quaternions(const double* from) {
  const std::array<BodyLanes, 4> q = load_fours(from);
  return {q[0], {q[1], q[2], q[3]}};
}

[[gnu::always_inline]] inline MatrixOf<BodyLanes> axes_at(const BodyRows& at) {
  return {load_threes(at.x_axis), load_threes(at.y_axis), load_threes(at.z_axis)};
}

/// Threes of a body's row.
constexpr std::array kVectors = {
    &BodyRows::centre,           &BodyRows::velocity, &BodyRows::force,
    &BodyRows::angular_momentum, &BodyRows::torque,   &BodyRows::spin,
    &BodyRows::x_axis,           &BodyRows::y_axis,   &BodyRows::z_axis};

BodyRows behind(const BodyRows& bodies, std::size_t first) {
  BodyRows at = bodies;
  for (const auto vector : kVectors) at.*vector += 3 * first;
  at.quaternion += 4 * first;
  return at;
}

/// Copies of the rows of a group of bodies, for groups of which not all may be written.
class Copies {
 public:
  Copies(const BodyRows& originals, std::size_t count) : originals_(originals) {
    double* next = numbers_.data();
    for (const auto vector : kVectors) {
      std::copy_n(originals.*vector, 3 * count, next);
      copies_.*vector = next;
      next += 3 * kBodyLanes;
    }
    std::copy_n(originals.quaternion, 4 * count, next);
    copies_.quaternion = next;
  }
  [[nodiscard]] const BodyRows& rows() const { return copies_; }
  void write_back(std::size_t k) const {
    for (const auto vector : kVectors)
      std::copy_n(copies_.*vector + 3 * k, 3, originals_.*vector + 3 * k);
    std::copy_n(copies_.quaternion + 4 * k, 4, originals_.quaternion + 4 * k);
  }

 private:
  alignas(64) std::array<double, (3 * kVectors.size() + 4) * kBodyLanes> numbers_{};
  BodyRows originals_, copies_;
};

}  // namespace

BodyMotion::BodyMotion(std::span<const BodyConstants> bodies, std::span<const BodySphere> spheres)
    : count_(bodies.size()), groups_((count_ + kBodyLanes - 1) / kBodyLanes) {
  for (Group& group : groups_) {
    group = {};
    group.mass.fill(1.0);
  }
  for (std::size_t b = 0; b < count_; ++b) {
    Group& group = groups_[b / kBodyLanes];
    const std::size_t k = b % kBodyLanes;
    group.mass[k] = bodies[b].mass;
    for (std::size_t d = 0; d < 3; ++d) {
      const double inertia = bodies[b].inertia[static_cast<Eigen::Index>(d)];
      group.inverse_inertia[d][k] = inertia == 0.0 ? 0.0 : 1.0 / inertia;
      group.moves[d] = static_cast<Bits>(group.moves[d] | (bodies[b].moves[d] ? 1u : 0u) << k);
      group.turns[d] = static_cast<Bits>(group.turns[d] | (bodies[b].turns[d] ? 1u : 0u) << k);
      group.constrained = group.constrained || !bodies[b].moves[d] || !bodies[b].turns[d];
    }
  }
  sort_spheres(spheres);
}

/// Body by body, those that count first, else in their order.
void BodyMotion::sort_spheres(std::span<const BodySphere> spheres) {
  const auto drawer = [](const BodySphere& s) {
    return 2 * static_cast<std::size_t>(s.body) + (s.counts ? 0u : 1u);
  };
  std::vector<std::uint32_t> ends(2 * count_ + 1, 0);
  for (const BodySphere& s : spheres) ++ends[drawer(s) + 1];
  for (std::size_t k = 1; k < ends.size(); ++k) ends[k] += ends[k - 1];
  parts_.reserve(count_ + 1);
  for (std::size_t b = 0; b < count_; ++b) parts_.push_back({ends[2 * b], ends[2 * b + 1]});
  parts_.push_back({ends.back(), ends.back()});
  spheres_.resize(spheres.size());
  const bool images =
      std::ranges::any_of(spheres, [](const BodySphere& s) { return s.image.squaredNorm() > 0.0; });
  if (images) images_.resize(spheres.size());
  for (const BodySphere& s : spheres) {
    const std::size_t place = ends[drawer(s)]++;
    spheres_[place] = {{s.displacement.x(), s.displacement.y(), s.displacement.z()}, s.sphere};
    if (images) images_[place] = s.image;
  }
}

void BodyMotion::let_rest(std::span<const char> rests) {
  resting_.assign(rests.empty() ? 0 : groups_.size(), 0);
  for (std::size_t b = 0; b < rests.size(); ++b) {
    Bits& bits = resting_[b / kBodyLanes];
    bits = static_cast<Bits>(bits | (rests[b] != 0 ? 1u : 0u) << b % kBodyLanes);
  }
}

/// A whole group in its place; of others a copy, whose lanes of bodies that do not rest go back.
template <class Work>
void BodyMotion::on_group(std::size_t group, const BodyRows& bodies, const Work& work) const {
  const BodyRows at = behind(bodies, kBodyLanes * group);
  const std::size_t count = bodies_of(group);
  if (count == kBodyLanes && resting_of(group) == 0) {
    work(at);
    return;
  }
  const Copies copies(at, count);
  work(copies.rows());
  for (std::size_t k = 0; k < count; ++k)
    if (!rests(kBodyLanes * group + k)) copies.write_back(k);
}

/// Half a kick.
[[gnu::always_inline]] inline BodyMotion::Moving BodyMotion::kick(const Group& group,
                                                                  const BodyRows& at,
                                                                  const Acting& acting,
                                                                  double half_kick) {
  Moving moving{load_threes(at.velocity), load_threes(at.angular_momentum)};
  const BodyVectors velocity =
      moving.velocity + BodyLanes(half_kick) / lanes(group.mass) * acting.force;
  const BodyVectors momentum = moving.momentum + BodyLanes(half_kick) * acting.torque;
  if (group.constrained) {
    keep_where(group.moves, moving.velocity, velocity);
    keep_where(group.turns, moving.momentum, momentum);
  } else {
    moving = {velocity, momentum};
  }
  store_threes(moving.velocity, at.velocity);
  store_threes(moving.momentum, at.angular_momentum);
  return moving;
}

void BodyMotion::move(const Group& group, const BodyRows& at, const BodyStep& step) {
  const Moving moving =
      kick(group, at, {load_threes(at.force), load_threes(at.torque)}, step.half_kick);
  store_threes(load_threes(at.centre) + BodyLanes(step.time) * moving.velocity, at.centre);
  const TurnedOf<BodyLanes> after = turned(load_quaternions(at.quaternion), moving.momentum,
                                           lanes(group.inverse_inertia), step.time);
  store_fours({after.pose.w, after.pose.v.x, after.pose.v.y, after.pose.v.z}, at.quaternion);
  store_threes(after.axes.x, at.x_axis);
  store_threes(after.axes.y, at.y_axis);
  store_threes(after.axes.z, at.z_axis);
  store_threes(after.spin, at.spin);
}

void BodyMotion::place(std::size_t first, std::size_t end, const BodyRows& bodies,
                       const SphereRows& to, bool place_resting) const {
  // Copies: a store of lanes could change what a pointer points to, for all that the compiler
  // knows.
  const BodyRows from = bodies;
  double *const positions = to.positions, *const velocities = to.velocities,
                *const spins = to.spins;
  const Placed* placed = spheres_.data() + parts_[first].first;
  for (std::size_t b = first; b < end; ++b) {
    const Placed* const behind = spheres_.data() + parts_[b + 1].first;
    if (!place_resting && rests(b)) {
      placed = behind;
      continue;
    }
    const auto three = [at = 3 * b](const double* rows) { return load_three(rows + at); };
    const Lanes x = three(from.x_axis), y = three(from.y_axis), z = three(from.z_axis);
    const Lanes centre = three(from.centre), velocity = three(from.velocity);
    const Lanes spin = three(from.spin);
    const Lanes dx = cross(spin, x), dy = cross(spin, y), dz = cross(spin, z);
    for (; placed < behind; ++placed) {
      const std::ptrdiff_t at = 3 * placed->sphere;
      const double* const d = placed->displacement.data();
      store_three(centre + d[0] * x + d[1] * y + d[2] * z, positions + at);
      store_three(velocity + d[0] * dx + d[1] * dy + d[2] * dz, velocities + at);
      store_three(spin, spins + at);
    }
  }
}

void BodyMotion::advance(const BodyRows& bodies, const SphereRows& spheres, const BodyStep& step,
                         bool place_resting) const {
  for (std::size_t first = 0; first < groups_.size(); first += kStretch) {
    const std::size_t end = std::min(first + kStretch, groups_.size());
    for (std::size_t g = first; g < end; ++g) {
      if (all_rest(g)) continue;
      on_group(g, bodies, [&](const BodyRows& at) { move(groups_[g], at, step); });
    }
    place(kBodyLanes * first, std::min(kBodyLanes * end, count_), bodies, spheres,
          place_resting || !images_.empty());
  }
  for (std::size_t m = 0; m < images_.size(); ++m)
    Vec3::Map(spheres.positions + 3 * spheres_[m].sphere) += images_[m];
}

void BodyMotion::sum(std::size_t group, const SphereRows& spheres, Sums& sums) const {
  const Placed* const all = spheres_.data();
  for (std::size_t k = 0; k < kBodyLanes; ++k) {
    const std::size_t body = kBodyLanes * group + k;
    Lanes force = 0.0, torque = 0.0, along_x = 0.0, along_y = 0.0, along_z = 0.0;
    if (body < count_ && !rests(body)) {
      const Placed* const end = all + parts_[body].uncounted;
      for (const Placed* placed = all + parts_[body].first; placed < end; ++placed) {
        const std::ptrdiff_t at = 3 * placed->sphere;
        const Lanes pull = load_three(spheres.forces + at);
        force += pull;
        torque += load_three(spheres.torques + at);
        along_x += placed->displacement[0] * pull;
        along_y += placed->displacement[1] * pull;
        along_z += placed->displacement[2] * pull;
      }
    }
    store_four(force, sums.force.data() + 4 * k);
    store_four(torque, sums.own_torque.data() + 4 * k);
    store_four(along_x, sums.along[0].data() + 4 * k);
    store_four(along_y, sums.along[1].data() + 4 * k);
    store_four(along_z, sums.along[2].data() + 4 * k);
  }
}

/// The moment of the spheres' forces about the body's centre, sum of (d_x x + d_y y + d_z z) times
/// force, is x times sum of d_x force and so on: no sphere needs its arm.
[[gnu::always_inline]] inline BodyMotion::Acting BodyMotion::add_forces(const Group& group,
                                                                        const BodyRows& at,
                                                                        const Sums& sums,
                                                                        const Vec3& gravity) {
  const auto three = [](const std::array<double, 4 * kBodyLanes>& rows) {
    const std::array<BodyLanes, 4> v = load_fours(rows.data());
    return BodyVectors(v[0], v[1], v[2]);
  };
  const MatrixOf<BodyLanes> axes = axes_at(at);
  const BodyVectors moment = cross(axes.x, three(sums.along[0])) +
                             cross(axes.y, three(sums.along[1])) +
                             cross(axes.z, three(sums.along[2]));
  const BodyVectors weight = lanes(group.mass) * BodyVectors(gravity);
  const Acting acting{load_threes(at.force) + (three(sums.force) + weight),
                      load_threes(at.torque) + (three(sums.own_torque) + moment)};
  store_threes(acting.force, at.force);
  store_threes(acting.torque, at.torque);
  return acting;
}

void BodyMotion::add_and_kick(const Group& group, const BodyRows& at, const Sums& sums,
                              const Vec3& gravity, double half_kick) {
  const Moving moving = kick(group, at, add_forces(group, at, sums, gravity), half_kick);
  store_threes(spin_of(axes_at(at), moving.momentum, lanes(group.inverse_inertia)), at.spin);
}

void BodyMotion::sum_forces(const BodyRows& bodies, const SphereRows& spheres,
                            const Vec3& gravity) const {
  Sums sums;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (all_rest(g)) continue;
    sum(g, spheres, sums);
    on_group(g, bodies, [&](const BodyRows& at) { add_forces(groups_[g], at, sums, gravity); });
  }
}

void BodyMotion::finish(const BodyRows& bodies, const SphereRows& spheres, const Vec3& gravity,
                        const BodyStep& step) const {
  Sums sums;
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    if (all_rest(g)) continue;
    sum(g, spheres, sums);
    on_group(g, bodies, [&](const BodyRows& at) {
      add_and_kick(groups_[g], at, sums, gravity, step.half_kick);
    });
  }
}

}  // namespace muckpile
