// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of a step between the spheres of near blocks: sifting, gathering, the law, adding up.
// Scope: see the header.
#include "contact/contact_forces.h"

#include <algorithm>

#include "math/prefetch.h"

namespace muckpile {
namespace {

const double* of(const double* vectors, int sphere) {
  return vectors + 3 * static_cast<std::ptrdiff_t>(sphere);
}

}  // namespace

int ContactStates::add(const ContactState& state) {
  if (free_.empty()) {
    states_.push_back(state);
    return static_cast<int>(states_.size()) - 1;
  }
  const int place = free_.back();
  free_.pop_back();
  (*this)[place] = state;
  return place;
}

void ContactForces::begin(const ContactLaw& law, const MovingSpheres& spheres,
                          ContactStates& contacts, double time_step, double memory_step) {
  law_ = &law;
  spheres_ = spheres;
  contacts_ = &contacts;
  time_step_ = time_step;
  memory_step_ = memory_step;
  sums_ = {};
  count_ = 0;
}

/// Which candidates touch no processor can foretell: the loop over them has no branch that asks.
bool ContactForces::add(std::span<SpherePair> candidates) {
  std::size_t before = count_;
  bool any = false;
  while (!candidates.empty()) {
    const std::size_t part = std::min(candidates.size(), kRoom - count_);
    for (SpherePair& pair : candidates.first(part)) {
      const double* a = of(spheres_.positions, pair.first);
      const double* b = of(spheres_.positions, pair.second);
      const double x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
      const double squared = x * x + y * y + z * z;
      near_[count_] = {&pair, x, y, z, squared};
      count_ += static_cast<std::size_t>(squared < pair.reach * pair.reach) |
                static_cast<std::size_t>(pair.contact >= 0);
    }
    candidates = candidates.subspan(part);
    any = any || count_ > before;
    if (count_ == kRoom) work();
    before = count_;
  }
  return any;
}

/// Notes the blocks of contact k, and calls for what is added to.
void ContactForces::call_loads(std::size_t k) {
  for (const std::size_t side : {0, 1}) {
    const SpherePair& touch = *near_[k].pair;
    const int block = spheres_.blocks[side == 0 ? touch.first : touch.second];
    block_[side][k] = block;
    prefetch_to_write(&spheres_.loads[block]);
    prefetch_to_write(spheres_.loads[block].numbers.data() + 8);
  }
}

/// Leaves in near_ those that touch, each with its contact, and calls for what is needed of them.
void ContactForces::admit() {
  std::size_t touching = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const Near n = near_[k];
    SpherePair& pair = *n.pair;
    if (!(n.squared < pair.reach * pair.reach)) {
      contacts_->free().push_back(pair.contact);
      pair.contact = -1;
      continue;
    }
    is_new_.values[touching] = pair.contact < 0 ? 1.0 : 0.0;
    if (pair.contact < 0) pair.contact = contacts_->add({});
    near_[touching] = n;
    if (spheres_.loads != nullptr) call_loads(touching);
    ++touching;
    prefetch_to_write(&(*contacts_)[pair.contact]);
    for (const int sphere : {pair.first, pair.second}) {
      prefetch(of(spheres_.velocities, sphere));
      prefetch(of(spheres_.spins, sphere));
      prefetch_to_write(of(spheres_.forces, sphere));
      prefetch_to_write(of(spheres_.torques, sphere));
    }
  }
  count_ = touching;
}

ContactSums ContactForces::finish() {
  work();
  return sums_;
}

void ContactForces::work() {
  admit();
  gather();
  for (std::size_t at = 0; at < count_; at += kLanes) work_on(at);
  scatter();
  count_ = 0;
}

/// Lanes behind the last contact repeat it, and their forces go to no sphere.
void ContactForces::gather() {
  const auto put = [](const double* from, Rows& to, std::size_t k) {
    for (std::size_t d = 0; d < 3; ++d) to[d].values[k] = from[d];
  };
  const std::size_t end = (count_ + kLanes - 1) / kLanes * kLanes;
  for (std::size_t k = count_; k < end; ++k) {
    near_[k] = near_[count_ - 1];
    is_new_.values[k] = is_new_.values[count_ - 1];
  }
  for (std::size_t k = 0; spheres_.loads != nullptr && k < end; ++k)
    put(of(spheres_.positions, near_[k].pair->first), first_, k);
  for (std::size_t k = 0; k < end; ++k) {
    const Near& near = near_[k];
    to_second_[0].values[k] = near.x;
    to_second_[1].values[k] = near.y;
    to_second_[2].values[k] = near.z;
    squared_.values[k] = near.squared;
    for (const bool second : {false, true}) {
      const int sphere = second ? near.pair->second : near.pair->first;
      Side& side = side_[second ? 1 : 0];
      put(of(spheres_.velocities, sphere), side.velocity, k);
      put(of(spheres_.spins, sphere), side.spin, k);
      side.radius.values[k] = spheres_.radii[sphere];
      side.mass.values[k] = spheres_.masses[sphere];
      side.owned.values[k] = k < count_ && sphere < spheres_.owned ? 1.0 : 0.0;
    }
    const ContactState& state = (*contacts_)[near.pair->contact];
    put(state.slide.data(), slide_, k);
    put(state.roll.data(), roll_, k);
    offset_.values[k] = state.overlap_offset;
    stiffness_.values[k] = state.tangential_stiffness;
  }
}

void ContactForces::work_on(std::size_t at) {
  const auto one = [at](const Row& row) {
    return Lanes(row.values.data() + at, std::experimental::vector_aligned);
  };
  const auto three = [&](const Rows& rows) {
    return Vectors(one(rows[0]), one(rows[1]), one(rows[2]));
  };
  const auto keep = [at](const Lanes& lanes, Row& row) {
    lanes.copy_to(row.values.data() + at, std::experimental::vector_aligned);
  };
  const auto keep_three = [&](const Vectors& lanes, Rows& rows) {
    keep(lanes.x, rows[0]);
    keep(lanes.y, rows[1]);
    keep(lanes.z, rows[2]);
  };
  const Side &a = side_[0], &b = side_[1];
  const Lanes inverse = inverse_root(one(squared_)), distance = one(squared_) * inverse;
  const Vectors between = three(to_second_);
  const Vectors normal = choose(distance > 0.0, inverse * between, Vectors(Vec3::UnitX()));
  const Lanes radius_a = one(a.radius), radius_b = one(b.radius);
  const Lanes overlap = (radius_a + radius_b) - distance;
  const Lanes arm_a = radius_a - 0.5 * overlap, arm_b = radius_b - 0.5 * overlap;
  const Vectors velocity_a = three(a.velocity), velocity_b = three(b.velocity);
  const Vectors spin_a = three(a.spin), spin_b = three(b.spin);
  const Lanes mass_a = one(a.mass), mass_b = one(b.mass);
  const ContactMotionOf<Lanes> motion{
      normal,
      overlap,
      radius_a,
      radius_b,
      mass_a * mass_b / (mass_a + mass_b),
      velocity_a - velocity_b + cross(arm_a * spin_a + arm_b * spin_b, normal),
      spin_a - spin_b};
  ContactStateOf<Lanes> state{three(slide_), three(roll_), one(offset_), one(stiffness_)};
  state.overlap_offset = choose(one(is_new_) > 0.0, ContactLaw::first_offset(motion, time_step_),
                                state.overlap_offset);
  ContactResponseOf<Lanes> response = law_->evaluate(motion, memory_step_, state);
  const Lanes factor(factor_);
  response.force_on_first = factor * response.force_on_first;
  response.torque_on_first = factor * response.torque_on_first;
  keep_three(state.slide, slide_);
  keep_three(state.roll, roll_);
  keep(state.overlap_offset, offset_);
  keep(state.tangential_stiffness, stiffness_);

  const Vectors lever = cross(normal, response.force_on_first);
  const Vectors torque_a = arm_a * lever + response.torque_on_first;
  const Vectors torque_b = arm_b * lever - response.torque_on_first;
  keep_three(response.force_on_first, force_);
  keep_three(torque_a, torque_[0]);
  keep_three(torque_b, torque_[1]);

  const Lanes owned_a = one(a.owned), owned_b = one(b.owned);
  const Lanes share = 0.5 * (owned_a + owned_b);
  sums_.contacts += reduce(share);
  sums_.elastic += reduce(share * response.elastic_energy);
  sums_.friction += reduce(share * response.friction_loss);
  sums_.damping += reduce(share * response.damping_loss);
  sums_.largest_overlap_ratio =
      std::max(sums_.largest_overlap_ratio, hmax(overlap / min(radius_a, radius_b)));
  if (spheres_.loads != nullptr) keep_load(at, response, normal, arm_a);
}

/// Force and torque at the point of contact, as seen from the origin.
void ContactForces::keep_load(std::size_t at, const ContactResponseOf<Lanes>& response,
                              const Vectors& normal, const Lanes& arm) {
  const auto one = [at](const Row& row) {
    return Lanes(row.values.data() + at, std::experimental::vector_aligned);
  };
  const auto keep = [&](const Vectors& lanes, std::size_t row) {
    lanes.x.copy_to(load_[row].values.data() + at, std::experimental::vector_aligned);
    lanes.y.copy_to(load_[row + 1].values.data() + at, std::experimental::vector_aligned);
    lanes.z.copy_to(load_[row + 2].values.data() + at, std::experimental::vector_aligned);
  };
  const Vectors point = Vectors(one(first_[0]), one(first_[1]), one(first_[2])) + arm * normal;
  keep(response.force_on_first, 0);
  keep(cross(point, response.force_on_first) + response.torque_on_first, 3);
  keep(response.dashpot_on_first, 6);
  keep(cross(point, response.dashpot_on_first), 9);
}

void ContactForces::scatter() {
  const auto at = [](const Rows& rows, std::size_t k) {
    return Vec3(rows[0].values[k], rows[1].values[k], rows[2].values[k]);
  };
  const auto add = [](const Vec3& change, double* to, int sphere) {
    Vec3::Map(to + 3 * static_cast<std::ptrdiff_t>(sphere)) += change;
  };
  for (std::size_t k = 0; k < count_; ++k) {
    const SpherePair& touch = *near_[k].pair;
    const Vec3 pull = at(force_, k);
    if (touch.first < spheres_.owned) {
      add(pull, spheres_.forces, touch.first);
      add(at(torque_[0], k), spheres_.torques, touch.first);
    }
    if (touch.second < spheres_.owned) {
      add(-pull, spheres_.forces, touch.second);
      add(at(torque_[1], k), spheres_.torques, touch.second);
    }
    (*contacts_)[touch.contact] = {at(slide_, k), at(roll_, k), offset_.values[k],
                                   stiffness_.values[k]};
  }
  if (spheres_.loads != nullptr) scatter_loads();
}

/// The blocks that contact k loads; those whose sphere is another rank's it does not: -1.
std::array<int, 2> ContactForces::load_key(std::size_t k) const {
  const SpherePair& touch = *near_[k].pair;
  return {touch.first < spheres_.owned ? block_[0][k] : -1,
          touch.second < spheres_.owned ? block_[1][k] : -1};
}

/// Contacts of the same two blocks follow each other: they are summed before they are added.
void ContactForces::scatter_loads() {
  std::array<double, 12> sum;
  const auto add = [&](int block, double sign) {
    if (block < 0) return;
    ContactLoad& load = spheres_.loads[block];
    for (std::size_t d = 0; d < sum.size(); ++d) load.numbers[d] += sign * sum[d];
    if (!load.listed) loaded_.push_back(block);
    load.listed = true;
  };
  for (std::size_t k = 0; k < count_;) {
    const std::array<int, 2> blocks = load_key(k);
    sum.fill(0.0);
    for (; k < count_ && load_key(k) == blocks; ++k)
      for (std::size_t d = 0; d < sum.size(); ++d) sum[d] += load_[d].values[k];
    add(blocks[0], 1.0);
    add(blocks[1], -1.0);
  }
}

}  // namespace muckpile
