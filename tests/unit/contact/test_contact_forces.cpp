// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts worked on side by side are those of the law one by one, whatever shares their vector
// instructions.
// Scope: random spheres that come and go; compared with the law of one contact to rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "contact/contact_forces.h"

namespace muckpile {
namespace {

constexpr double kStep = 1e-4;       // [s]
constexpr double kRounding = 1e-11;  // of sums of some 10 contacts' forces, over the largest

/// Spheres in a box, of which the last quarter is another rank's; each turns and moves on its own.
struct Cloud {
  std::vector<double> positions, velocities, spins, radii, masses, forces, torques;
  std::vector<int> blocks;  ///< each sphere is one
  std::vector<ContactLoad> loads;
  int owned = 0;

  Cloud(int count, unsigned seed) : owned(3 * count / 4) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int k = 0; k < 3 * count; ++k) {
      positions.push_back(0.5 * unit(random));
      velocities.push_back(5.0 * unit(random));
      spins.push_back(20.0 * unit(random));
    }
    for (int k = 0; k < count; ++k) {
      radii.push_back(0.1 + 0.05 * unit(random));
      masses.push_back(3.0 + unit(random));
      blocks.push_back(k);
    }
    still();
  }
  void still() {
    forces.assign(positions.size(), 0.0);
    torques.assign(positions.size(), 0.0);
    loads.assign(positions.size() / 3, {});
  }
  [[nodiscard]] MovingSpheres view() {
    return {positions.data(), velocities.data(), spins.data(), radii.data(),  masses.data(),
            forces.data(),    torques.data(),    owned,        blocks.data(), loads.data()};
  }
  void fly() {
    for (std::size_t k = 0; k < positions.size(); ++k) positions[k] += 20 * kStep * velocities[k];
  }
  [[nodiscard]] std::vector<SpherePair> pairs() const {
    std::vector<SpherePair> all;
    const int count = static_cast<int>(radii.size());
    for (int i = 0; i < owned; ++i)
      for (int j = i + 1; j < count; ++j)
        all.push_back(
            {i, j, -1, radii[static_cast<std::size_t>(i)] + radii[static_cast<std::size_t>(j)]});
    return all;
  }
  [[nodiscard]] Vec3 vector(const std::vector<double>& of, int k) const {
    return Vec3::Map(of.data() + 3 * k);
  }
};

/// The same, contact by contact, from the formulas' own functions.
class OneByOne {
 public:
  explicit OneByOne(const ContactLaw& law) : law_(law) {}

  ContactSums step(Cloud& c, const std::vector<SpherePair>& pairs, double memory_step) {
    ContactSums sums;
    for (const SpherePair& pair : pairs) {
      const int i = pair.first, j = pair.second;
      const Vec3 between = c.vector(c.positions, j) - c.vector(c.positions, i);
      const std::pair key(i, j);
      if (between.norm() >= pair.reach) {
        states_.erase(key);
        continue;
      }
      const double r_i = c.radii[static_cast<std::size_t>(i)];
      const double r_j = c.radii[static_cast<std::size_t>(j)];
      const double m_i = c.masses[static_cast<std::size_t>(i)];
      const double m_j = c.masses[static_cast<std::size_t>(j)];
      const double overlap = pair.reach - between.norm();
      const Vec3 n = between.normalized(), w_i = c.vector(c.spins, i), w_j = c.vector(c.spins, j);
      const double arm_i = r_i - 0.5 * overlap, arm_j = r_j - 0.5 * overlap;
      const Vec3 v = c.vector(c.velocities, i) - c.vector(c.velocities, j) +
                     (arm_i * w_i + arm_j * w_j).cross(n);
      const ContactMotion motion{n, overlap, r_i, r_j, m_i * m_j / (m_i + m_j), v, w_i - w_j};
      auto [place, is_new] = states_.try_emplace(key);
      if (is_new) place->second = ContactLaw::begin_contact(motion, kStep);
      const ContactResponse r = law_.evaluate(motion, memory_step, place->second);
      const Vec3 lever = n.cross(r.force_on_first);
      const double share = j < c.owned ? 1.0 : 0.5;
      push(c, i, r.force_on_first, arm_i * lever + r.torque_on_first);
      if (j < c.owned) push(c, j, -r.force_on_first, arm_j * lever - r.torque_on_first);
      sums.contacts += share;
      sums.elastic += share * r.elastic_energy;
      sums.friction += share * r.friction_loss;
      sums.damping += share * r.damping_loss;
      sums.largest_overlap_ratio =
          std::max(sums.largest_overlap_ratio, overlap / std::min(r_i, r_j));
    }
    return sums;
  }

 private:
  static void push(Cloud& c, int k, const Vec3& force, const Vec3& torque) {
    Vec3::Map(c.forces.data() + 3 * k) += force;
    Vec3::Map(c.torques.data() + 3 * k) += torque;
  }
  const ContactLaw& law_;
  std::map<std::pair<int, int>, ContactState> states_;
};

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// The load of a block, about its sphere's centre, is what acts on the sphere.
void expect_loads_are_forces(const Cloud& c) {
  for (int k = 0; k < static_cast<int>(c.loads.size()); ++k) {
    const ContactLoad& load = c.loads[static_cast<std::size_t>(k)];
    const Vec3 torque = load.moment() - c.vector(c.positions, k).cross(load.force());
    EXPECT_LT((load.force() - c.vector(c.forces, k)).norm(), kRounding * (1.0 + largest(c.forces)));
    EXPECT_LT((torque - c.vector(c.torques, k)).norm(), kRounding * (1.0 + largest(c.forces)));
  }
}

class ContactForcesOf : public testing::TestWithParam<NormalModel> {};

TEST_P(ContactForcesOf, ManyContactsAreThoseOfEachByItself) {
  ContactParameters p;
  p.model = GetParam();
  const ContactLaw law(p);
  Cloud lanes(120, 3), single(120, 3);
  const std::vector<SpherePair> pairs = lanes.pairs();
  std::vector<SpherePair> listed = pairs;
  ContactStates memory;
  ContactForces forces;
  OneByOne reference(law);
  for (int step = 0; step < 12; ++step) {
    const double memory_step = step == 0 ? 0.0 : kStep;
    lanes.still();
    single.still();
    forces.begin(law, lanes.view(), memory, kStep, memory_step);
    // In portions of any length, as block pairs have them.
    std::size_t length = 1;
    for (std::size_t at = 0; at < listed.size(); at += length, length = length % 97 + 1)
      forces.add(std::span(listed).subspan(at, std::min(length, listed.size() - at)));
    const ContactSums got = forces.finish();
    const ContactSums expected = reference.step(single, pairs, memory_step);
    ASSERT_GT(expected.contacts, 100.0);
    EXPECT_EQ(got.contacts, expected.contacts);
    EXPECT_NEAR(got.elastic, expected.elastic, kRounding * expected.elastic);
    expect_loads_are_forces(lanes);
    EXPECT_NEAR(got.largest_overlap_ratio, expected.largest_overlap_ratio,
                1e-13);  // rounding of the distance over the radius
    if (memory_step > 0.0) {
      EXPECT_NEAR(got.friction, expected.friction, 1e-9 * std::abs(expected.friction));
      EXPECT_NEAR(got.damping, expected.damping, 1e-9 * std::abs(expected.damping));
    }
    for (std::size_t k = 0; k < lanes.forces.size(); ++k) {
      EXPECT_NEAR(lanes.forces[k], single.forces[k], kRounding * largest(single.forces));
      EXPECT_NEAR(lanes.torques[k], single.torques[k], kRounding * largest(single.torques));
    }
    lanes.fly();
    single.fly();
  }
}

INSTANTIATE_TEST_SUITE_P(BothModels, ContactForcesOf,
                         testing::Values(NormalModel::hertz, NormalModel::linear));

// Both ranks of a contact compute the same force, whatever else each of them has to do.
TEST(ContactForces, ACompanionInTheSameInstructionChangesNoBit) {
  const ContactLaw law{ContactParameters{}};
  Cloud cloud(60, 5);
  std::vector<SpherePair> touching;
  for (const SpherePair& pair : cloud.pairs())
    if ((cloud.vector(cloud.positions, pair.second) - cloud.vector(cloud.positions, pair.first))
                .norm() < pair.reach &&
        pair.second < cloud.owned)
      touching.push_back(pair);
  ASSERT_GT(touching.size(), 20u);
  const auto forces_of = [&](std::vector<SpherePair> pairs, int sphere) {
    ContactStates memory;
    ContactForces forces;
    cloud.still();
    for (const double memory_step : {kStep, kStep}) {
      cloud.still();
      forces.begin(law, cloud.view(), memory, kStep, memory_step);
      forces.add(pairs);
      (void)forces.finish();
    }
    return cloud.vector(cloud.forces, sphere);
  };
  for (std::size_t k = 0; k < 20; ++k) {
    const SpherePair& pair = touching[k];
    std::vector<SpherePair> some{pair};
    for (const SpherePair& other : touching)
      if (other.first != pair.first && other.second != pair.first) some.push_back(other);
    std::rotate(some.begin(), some.begin() + 1, some.end());
    EXPECT_EQ(forces_of({pair}, pair.first), forces_of(some, pair.first)) << "contact " << k;
  }
}

TEST(ContactForces, SpheresThatPartForgetAndTheirPlaceIsUsedAgain) {
  const ContactLaw law{ContactParameters{}};
  Cloud cloud(2, 1);
  cloud.owned = 2;
  cloud.radii = {0.1, 0.1};
  cloud.positions = {0.0, 0.0, 0.0, 0.19, 0.0, 0.0};
  std::vector<SpherePair> pairs{{0, 1, -1, 0.2}};
  ContactStates memory;
  ContactForces forces;
  const auto step = [&](double distance) {
    cloud.positions[3] = distance;
    cloud.still();
    forces.begin(law, cloud.view(), memory, kStep, kStep);
    forces.add(pairs);
    return forces.finish().contacts;
  };
  EXPECT_EQ(step(0.19), 1.0);
  EXPECT_EQ(pairs[0].contact, 0);
  EXPECT_EQ(step(0.19), 1.0);
  EXPECT_GT(memory[0].slide.norm(), 0.0);
  EXPECT_EQ(step(0.21), 0.0);
  EXPECT_EQ(pairs[0].contact, -1);
  EXPECT_EQ(memory.free(), std::vector<int>{0});
  EXPECT_EQ(cloud.vector(cloud.forces, 0).norm(), 0.0);
  EXPECT_EQ(step(0.19), 1.0);
  EXPECT_EQ(pairs[0].contact, 0);
}

}  // namespace
}  // namespace muckpile
