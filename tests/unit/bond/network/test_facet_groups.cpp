// SPDX-License-Identifier: GPL-2.0-or-later
// Facets that are worked on side by side: forces are those of points summed one by one, and a
// facet's are the same bits wherever it lies and whatever lies beside it.
// Scope: pairs of blocks cut out of Voronoi rock, so that a facet's forces are all that its blocks
// feel.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "bond/network/leaning_group.h"
#include "bond_scene.h"

namespace muckpile {
namespace {

constexpr double kStep = 1e-6;  // [s]

/// Blocks of their own for every facet: 2 f and 2 f + 1 for facet f.
class Pairs {
 public:
  /// `chosen`: for each facet, which one of the template's it copies.
  Pairs(const std::vector<Facet>& of, const std::vector<std::size_t>& chosen, double damping,
        std::vector<FacetMemory> memory = {},
        double wall_strength = std::numeric_limits<double>::infinity())
      : network_(material(damping, wall_strength)) {
    std::vector<BlockConstants> blocks;
    std::vector<Facet> facets;
    for (std::size_t f = 0; f < chosen.size(); ++f) {
      Facet facet = of[chosen[f]];
      facet.i = static_cast<int>(2 * f);
      facet.j = facet.i + 1;
      facet.tag_i = facet.i + 1;
      facet.tag_j = facet.j + 1;
      facets.push_back(facet);
      for (const int tag : {facet.tag_i, facet.tag_j})
        blocks.push_back({tag, true, 1.0, 2600.0, {}});
    }
    network_.set(blocks, {facets, std::move(memory), {}});
    for (std::size_t f = 0; f < chosen.size(); ++f) pose(f, facets[f], chosen[f]);
  }
  void compute() { network_.step(kStep); }
  [[nodiscard]] FacetNetwork& network() { return network_; }
  void expect_same(std::size_t f, const Pairs& other, std::size_t g) const {
    for (std::size_t side = 0; side < 2; ++side) {
      EXPECT_EQ(network_.force()[2 * f + side], other.network_.force()[2 * g + side]) << f;
      EXPECT_EQ(network_.torque()[2 * f + side], other.network_.torque()[2 * g + side]) << f;
    }
  }

 private:
  static JointMaterial material(double damping, double wall_strength) {
    JointParameters rock = test::rock(0.25);
    rock.residual_friction_angle = 0.6;
    rock.damping = damping;
    rock.contact_damping = 0.05;
    rock.wall_strength = wall_strength;
    return JointMaterial(rock);
  }
  /// Closed a little, turned and moving, by its number in the template.
  void pose(std::size_t f, const Facet& facet, std::size_t number) {
    const double a = 1.0 + static_cast<double>(number);
    BlockState& i = network_.state()[2 * f];
    BlockState& j = network_.state()[2 * f + 1];
    i = {test::turn(Vec3(0.3, 0.1, a)), Vec3::Zero(), Vec3(0.1, 0.2, -0.1) * a,
         Vec3(0.3, -0.2, 0.1)};
    j = {test::turn(Vec3(1e-5, -2e-5, 1e-5 * a)) * i.rotation,
         i.rotation * Vec3(facet.arm_i - facet.arm_j - 1e-5 * facet.normal), Vec3(0.2, -0.1, 0.1),
         Vec3(-0.1, 0.4, 0.2)};
  }
  FacetNetwork network_;
};

/// Joints of Voronoi rock.
std::vector<Facet> joints() {
  test::BondScene scene(test::voronoi_blocks(3.0, 2, 5), test::rock(0.25));
  return scene.network().facets();
}

TEST(FacetGroups, AFacetHasTheSameForcesInEveryLaneAndBesideAnyNumberOfOthers) {
  const std::vector<Facet> of = joints();
  for (const double damping : {0.0, 0.05}) {
    Pairs alone(of, {3}, damping);
    alone.compute();
    EXPECT_GT(alone.network().force()[0].norm(), 1.0);
    for (const std::size_t count : {1u, 7u, 8u, 9u, 15u, 16u}) {
      for (std::size_t lane = 0; lane < count; ++lane) {
        std::vector<std::size_t> chosen;
        for (std::size_t f = 0; f < count; ++f) chosen.push_back(f == lane ? 3 : 4 + f % 7);
        Pairs group(of, chosen, damping);
        group.compute();
        group.expect_same(lane, alone, 0);
      }
    }
  }
}

/// Intact, with one and two points broken, all broken, retired, in turn.
FacetMemory remembered(std::size_t f) {
  FacetMemory memory;
  const std::size_t broken = f % 5;
  for (std::size_t p = 0; p < std::min<std::size_t>(broken, kFacetPoints); ++p)
    memory.broken.set(p);
  if (broken > 0) {
    memory.state = broken == 4 ? FacetState::retired : FacetState::cracked;
    memory.contact.get_or_create().offset[0] = Vec3(1e-6, 2e-6, -1e-6);
  }
  return memory;
}

TEST(FacetGroups, IntactBrokenAndRetiredFacetsOfAGroupHaveTheForcesThatEachHasAlone) {
  const std::vector<Facet> of = joints();
  for (const double damping : {0.0, 0.05}) {
    std::vector<std::size_t> chosen;
    std::vector<FacetMemory> memory;
    for (std::size_t f = 0; f < 21; ++f) {
      chosen.push_back(f);
      memory.push_back(remembered(f));
    }
    Pairs together(of, chosen, damping, memory);
    together.compute();
    for (std::size_t f = 0; f < chosen.size(); ++f) {
      Pairs alone(of, {chosen[f]}, damping, {memory[f]});
      alone.compute();
      together.expect_same(f, alone, 0);
      const bool retired = memory[f].state == FacetState::retired;
      EXPECT_EQ(together.network().force()[2 * f].norm() > 0.0, !retired) << f;
    }
  }
}

// However strong: a soft joint would follow a turn that its forces do not know.
/// Broken at all points: closed and stuck, closed and slipping, open until now, faded a
/// little, slid far enough to fade.
FacetMemory broken_in_one_way(std::size_t f) {
  FacetMemory memory;
  memory.broken = PointSet::all();
  memory.state = f % 6 == 4 ? FacetState::fading : FacetState::cracked;
  memory.open = f % 6 == 3;
  ContactMemory& contact = memory.contact.get_or_create();
  const double away[] = {1e-7, 3e-3, -5e-5, 1e-6, 1e-6, 0.1};
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    contact.offset[p] = Vec3(f % 6 == 2 ? -5e-5 : 1e-6 * static_cast<double>(p), away[f % 6], 0.0);
  if (f % 6 == 4) contact.fade = 0.7;
  return memory;
}

/// Of 24 facets on the whole.
struct Seen {
  int rub = 0, push = 0, crush = 0;
};

Seen work_in_groups_and_one_by_one(double wall_strength) {
  const std::vector<Facet> of = joints();
  Seen seen;
  for (std::size_t f = 0; f < 24; ++f) {
    FacetMemory memory = broken_in_one_way(f);
    Pairs together(of, {f}, 0.0, {memory}, wall_strength);
    memory.extra.get_or_create() = {};  // facets that soften are worked on one by one
    Pairs alone(of, {f}, 0.0, {memory}, wall_strength);
    for (int step = 0; step < 3; ++step) {
      for (Pairs* pairs : {&together, &alone}) {
        pairs->network().state()[1].centre += Vec3(2e-6, -1e-6, 3e-6);
        pairs->compute();
      }
      const FacetNetwork &a = together.network(), &b = alone.network();
      const double rounding = 1e-10 * (1.0 + b.force()[0].norm());
      for (std::size_t side = 0; side < 2; ++side) {
        EXPECT_LT((a.force()[side] - b.force()[side]).norm(), rounding) << f;
        EXPECT_LT((a.torque()[side] - b.torque()[side]).norm(), rounding) << f;
      }
      EXPECT_EQ(a.states()[0], b.states()[0]) << f;
      EXPECT_EQ(a.traces()[0].open, b.traces()[0].open) << f;
      EXPECT_NEAR(a.losses().friction, b.losses().friction, 1e-12 + 1e-10 * b.losses().friction);
      EXPECT_NEAR(a.losses().damping, b.losses().damping, 1e-12 + 1e-10 * b.losses().damping);
      EXPECT_NEAR(a.losses().crushing, b.losses().crushing, 1e-12 + 1e-10 * b.losses().crushing);
      const ContactMemory kept = a.memory(0).contact.get(), other = b.memory(0).contact.get();
      EXPECT_EQ(kept.fade, other.fade) << f;
      for (std::size_t p = 0; p < kFacetPoints; ++p)
        EXPECT_LT((kept.offset[p] - other.offset[p]).norm(), 1e-14) << f;
    }
    seen.rub += together.network().losses().friction > 0.0 ? 1 : 0;
    seen.push += together.network().force()[0].norm() > 1.0 ? 1 : 0;
    seen.crush += together.network().losses().crushing > 0.0 ? 1 : 0;
  }
  return seen;
}

TEST(FacetGroups, BrokenFacetsHaveTheForcesAndLossesOfFacetsWorkedOnOneByOne) {
  const Seen seen = work_in_groups_and_one_by_one(std::numeric_limits<double>::infinity());
  EXPECT_GE(seen.rub, 12);
  EXPECT_GE(seen.push, 12);  // the others are open, or open as they move
  EXPECT_EQ(seen.crush, 0);
}

TEST(FacetGroups, CrushingWallsDoToo) {
  EXPECT_GE(work_in_groups_and_one_by_one(3e5).crush, 12);  // of 0.6 MPa and more
}

/// Points that were open by different widths when they broke, as the facet closes through them: by
/// shares of its radius beyond which others are surely open (0.01) or retire (0.1).
TEST(FacetGroups, FacetsThatBrokeWideOpenCloseAsOneByOne) {
  const std::vector<Facet> of = joints();
  int pressed = 0, open = 0, retired = 0;
  for (const double share : {0.03, 0.15}) {
    for (std::size_t f = 0; f < 8; ++f) {
      const double widest = share * std::sqrt(of[f].area / M_PI);  // [m]
      FacetMemory memory;
      memory.broken = PointSet::all();
      memory.state = FacetState::cracked;
      for (std::size_t p = 0; p < kFacetPoints; ++p)
        memory.contact.get_or_create().offset[p] =
            Vec3(widest * (1.0 - 0.2 * static_cast<double>(p)), 0.0, 0.0);
      Pairs together(of, {f}, 0.0, {memory});
      memory.extra.get_or_create() = {};  // facets that soften are worked on one by one
      Pairs alone(of, {f}, 0.0, {memory});
      for (const double opening : {1.3, 0.2, -0.2}) {  // in turn, of the widest, more than before
        for (Pairs* pairs : {&together, &alone}) {
          const BlockState& i = pairs->network().state()[0];
          pairs->network().state()[1].centre += opening * widest * (i.rotation * of[f].normal);
          pairs->compute();
        }
        const FacetNetwork &a = together.network(), &b = alone.network();
        const double rounding = 1e-10 * (1.0 + b.force()[0].norm());
        EXPECT_LT((a.force()[0] - b.force()[0]).norm(), rounding) << f;
        EXPECT_EQ(a.states()[0], b.states()[0]) << f;
        EXPECT_EQ(a.traces()[0].open, b.traces()[0].open) << f;
        (a.force()[0].norm() > 1.0 ? pressed : open) += 1;
      }
      retired += together.network().states()[0] == FacetState::retired ? 1 : 0;
    }
  }
  EXPECT_EQ(pressed, 0);
  EXPECT_EQ(open, 48);
  EXPECT_EQ(retired, 8);
}

/// Blocks whose faces lean, moved a little.
test::BondScene leaning_and_shaken() {
  test::BondScene scene = test::leaning_scene(4.0, test::rock(0.25));
  scene.shake(1e-5, 1e-5, 1);
  return scene;
}

/// Cracks every n-th facet, at no point yet: it is worked on by itself.
void crack_every(std::size_t n, test::BondScene& scene) {
  FacetLists lists = scene.network().give_up();
  for (std::size_t f = 0; f < lists.memory.size(); f += n)
    lists.memory[f].state = FacetState::cracked;
  scene.network().set_facets(std::move(lists));
}

void expect_alike(test::BondScene& one, test::BondScene& other) {
  const FacetNetwork &a = one.network(), &b = other.network();
  for (std::size_t k = 0; k < one.size(); ++k) {
    const double rounding = 1e-9 * (1.0 + b.force()[k].norm() + b.torque()[k].norm());
    EXPECT_LT((a.force()[k] - b.force()[k]).norm(), rounding) << k;
    EXPECT_LT((a.torque()[k] - b.torque()[k]).norm(), rounding) << k;
  }
  for (std::size_t f = 0; f < a.facet_count(); ++f) {
    const Vec3& traction = a.leaning()->traction(f);
    EXPECT_LT((traction - b.leaning()->traction(f)).norm(), 1e-9 * traction.norm());
    EXPECT_GT(traction.norm(), 1.0) << f;
  }
}

TEST(FacetGroups, LeaningFacetsHaveTheForcesOfFacetsWorkedOnOneByOne) {
  test::BondScene together = leaning_and_shaken(), mixed = leaning_and_shaken(),
                  alone = leaning_and_shaken();
  crack_every(3, mixed);  // beside intact ones in their groups
  crack_every(1, alone);
  for (test::BondScene* scene : {&together, &mixed, &alone}) scene->compute(kStep);
  ASSERT_NE(together.network().leaning(), nullptr);
  expect_alike(together, alone);
  expect_alike(mixed, alone);
}

/// Facets that LeaningLanes takes side by side, among those that a pass visits.
int taken_side_by_side(const FacetNetwork& network) {
  int count = 0;
  for (const LaneSet& set : network.schedule().bonded())
    count += std::popcount(LeaningLanes(network.kinematics(), set).at_once);
  return count;
}

/// The leaning faces of a scene, apart from its network, and the same one facet after the other.
class Faces {
 public:
  explicit Faces(const FacetNetwork& network)
      : network_(network), torque_(network.block_fields().size(), Vec3::Zero()) {
    faces_.set(network.tables(), torque_.size());
    faces_.count_moments(network.tables(), network.history(), network.block_fields());
    faces_.stretch(network.kinematics(), network.schedule().bonded());
    faces_.pull(network.kinematics(), network.schedule().working(), torque_);
  }
  [[nodiscard]] std::vector<Mat3> gradients() { return tensors(faces_.gradients(torque_.size())); }
  [[nodiscard]] std::vector<Mat3> gradients_one_by_one() const {
    std::vector<Mat3> gradients(torque_.size(), Mat3::Zero()), excess = gradients;
    for (std::size_t f = 0; f < network_.facet_count(); ++f) {
      const LeaningFacet one = facet(f);
      one.each_side([&](int, const LeaningFacet::Side& side) {
        add_opened(opened_on(one, side, network_.block_fields()), side, gradients[side.block],
                   excess[side.block]);
      });
    }
    return gradients;
  }
  [[nodiscard]] std::vector<Vec3> tractions() const {
    std::vector<Vec3> tractions;
    for (std::size_t f = 0; f < network_.facet_count(); ++f)
      tractions.push_back(faces_.traction(f));
    return tractions;
  }
  [[nodiscard]] std::vector<Vec3> tractions_one_by_one() {
    const std::vector<Mat3> gradients = this->gradients(),
                            stresses = tensors(faces_.stresses(torque_.size()));
    std::vector<Vec3> tractions;
    for (std::size_t f = 0; f < network_.facet_count(); ++f)
      tractions.push_back(
          pull_on(facet(f), {gradients, stresses}, network_.block_fields()).traction());
    return tractions;
  }

 private:
  [[nodiscard]] LeaningFacet facet(std::size_t f) const {
    const FacetMotion motion = kinematics_.motion(f);
    return {faces_.facet(f), kinematics_, f, motion, kinematics_.bonded_jump(f, motion)};
  }
  static std::vector<Mat3> tensors(std::span<const double> numbers) {
    std::vector<Mat3> of(numbers.size() / 9);
    for (std::size_t b = 0; b < of.size(); ++b) of[b] = Eigen::Map<const Mat3>(&numbers[9 * b]);
    return of;
  }

  const FacetNetwork& network_;
  FacetKinematics kinematics_ = network_.kinematics();
  LeaningFaces faces_;
  std::vector<Vec3> torque_;
};

/// Which share of them differ in the last bits; none by more.
template <class Tensor>
double rounded_otherwise(const std::vector<Tensor>& some, const std::vector<Tensor>& others) {
  double count = 0.0;
  for (std::size_t k = 0; k < some.size(); ++k) {
    EXPECT_LT((some[k] - others[k]).norm(), 1e-9 * others[k].norm() + 1e-300) << k;
    count += some[k] != others[k] ? 1.0 : 0.0;
  }
  return count / static_cast<double>(some.size());
}

TEST(FacetGroups, IntactLeaningFacetsAreWorkedOnInGroupsAndOthersOneByOne) {
  test::BondScene together = leaning_and_shaken(), mixed = leaning_and_shaken(),
                  alone = leaning_and_shaken();
  const auto facets = static_cast<int>(together.network().facet_count());
  crack_every(3, mixed);
  crack_every(1, alone);
  for (test::BondScene* scene : {&together, &mixed, &alone}) scene->compute(kStep);
  EXPECT_EQ(taken_side_by_side(together.network()), facets);
  EXPECT_EQ(taken_side_by_side(mixed.network()), facets - (facets + 2) / 3);
  EXPECT_EQ(taken_side_by_side(alone.network()), 0);

  // A group sums in another order than one facet does, which shows in the last bits of nearly all.
  // Were the passes to take one after the other, at most half would differ, by what the compiler
  // rounds together.
  Faces faces(together.network());
  EXPECT_GT(rounded_otherwise(faces.gradients(), faces.gradients_one_by_one()), 0.75);
  EXPECT_GT(rounded_otherwise(faces.tractions(), faces.tractions_one_by_one()), 0.75);
}

TEST(FacetGroups, AnIntactFacetLetsGoOnceItHasTurnedTooFar) {
  const std::vector<Facet> of = joints();
  const Facet& facet = of[5];
  for (const double damping : {0.0, 0.05}) {
    for (const double angle : {0.09, 0.11}) {
      Pairs pair(of, {5}, damping);
      const Mat3 turned = test::turn(angle * facet.half_axes[0].normalized());
      const Vec3 still = Vec3::Zero();
      pair.network().state()[0] = {Mat3::Identity(), still, still, still};
      pair.network().state()[1] = {turned, facet.arm_i - turned * facet.arm_j, still, still};
      pair.compute();
      EXPECT_EQ(pair.network().broken_count() > 0.0, angle > 0.1) << angle;
    }
  }
}

/// The forces of one facet, point by point, and what its dashpots take [J]: the formulas of
/// facet_network.h without lanes.
struct OneByOne {
  Vec3 force = Vec3::Zero(), torque_i = Vec3::Zero();
  double damped = 0.0;

  OneByOne(FacetNetwork& network, const Facet& facet) {
    const auto& material = network.material();
    const BlockState& i = network.state()[0];
    const BlockState& j = network.state()[1];
    const Vec3 n = (i.rotation * facet.normal + j.rotation * facet.normal).normalized();
    const double depth = facet.normal.dot(facet.arm_i - facet.arm_j);
    const FacetStiffness k = material.facet_stiffness(depth);
    const double scale = 1.0 / (i.rotation * facet.normal + j.rotation * facet.normal).norm();
    const auto turned = [&](const Vec3& m) {
      return Vec3(scale * ((i.rotation + j.rotation) * m));
    };

    const Vec3 bulk = 0.5 * k.rock_share *
                      (network.bulk_stress()[0] * turned(facet.opening_i) +
                       network.bulk_stress()[1] * turned(facet.opening_j));
    for (int p = 0; p < kFacetPoints; ++p) {
      const double angle = 2.0 * M_PI * p / kFacetPoints;
      const Vec3 at = std::cos(angle) * facet.half_axes[0] + std::sin(angle) * facet.half_axes[1];
      const Vec3 on_i = i.rotation * Vec3(facet.arm_i + at);
      const Vec3 jump = j.centre + j.rotation * Vec3(facet.arm_j + at) - i.centre - on_i;
      const Vec3 arm = on_i + 0.5 * jump, place = i.centre + arm;
      const Vec3 rate =
          j.velocity + j.spin.cross(place - j.centre) - i.velocity - i.spin.cross(arm);
      const double area = facet.area / kFacetPoints, c = material.damping_coefficient();
      const Vec3 pull = k.shear * jump + (k.normal - k.shear) * n.dot(jump) * n + bulk + c * rate;
      force += area * pull;
      torque_i += area * arm.cross(pull);
      damped += area * c * rate.squaredNorm() * kStep;
    }
  }
};

TEST(FacetGroups, ForcesAreThoseOfThePointsSummedOneByOne) {
  const std::vector<Facet> of = joints();
  for (const double damping : {0.0, 0.05}) {
    Pairs pair(of, {5}, damping);
    pair.compute();
    FacetNetwork& network = pair.network();
    const OneByOne expected(network, network.facet(0));
    EXPECT_LT((network.force()[0] - expected.force).norm(), 1e-9 * expected.force.norm());
    EXPECT_LT((network.torque()[0] - expected.torque_i).norm(), 1e-9 * expected.torque_i.norm());
    EXPECT_NEAR(network.losses().damping, expected.damped, 1e-9 * expected.damped);
    EXPECT_EQ(network.losses().damping > 0.0, damping > 0.0);
  }
}

/// Gas in one facet, point by point: how far the broken ones are open, and what it presses.
struct GasOneByOne {
  double opening = 0.0, closure = 0.0, apart = 0.0;  // [m]
  Vec3 force = Vec3::Zero(), torque_i = Vec3::Zero(), torque_j = Vec3::Zero();

  GasOneByOne(FacetNetwork& network, std::size_t f, double pressure) {
    const Facet facet = network.facet(f);
    const FacetMemory memory = network.memory(f);
    const BlockState& i = network.state()[2 * f];
    const BlockState& j = network.state()[2 * f + 1];
    const Vec3 n = ((i.rotation + j.rotation) * facet.normal).normalized();
    int broken = 0;
    for (int p = 0; p < kFacetPoints; ++p) {
      const auto q = static_cast<std::size_t>(p);
      if (!memory.broken[q]) continue;
      ++broken;
      const double angle = 2.0 * M_PI * p / kFacetPoints;
      const Vec3 at = std::cos(angle) * facet.half_axes[0] + std::sin(angle) * facet.half_axes[1];
      const Vec3 on_i = i.rotation * Vec3(facet.arm_i + at);
      const Vec3 jump = j.centre + j.rotation * Vec3(facet.arm_j + at) - i.centre - on_i;
      const double parted = n.dot(jump), open = parted - memory.contact.get().offset[q].x();
      apart += parted;
      opening += std::max(0.0, open);
      closure += std::max(0.0, -open);
      const Vec3 push = -pressure * facet.area / kFacetPoints * n, arm = on_i + 0.5 * jump;
      force += push;
      torque_i += arm.cross(push);
      torque_j -= (arm + i.centre - j.centre).cross(push);
    }
    apart /= std::max(broken, 1);
    opening /= std::max(broken, 1);
    closure /= std::max(broken, 1);
  }
};

TEST(FacetGroups, GasPressesOnTheBrokenPointsOfEachFacetAndFindsThemAsFarOpenAsTheyAre) {
  constexpr double kPressure = 3e6;  // in one of the two blocks of every facet [Pa]
  const std::vector<Facet> of = joints();
  std::vector<std::size_t> chosen;
  std::vector<FacetMemory> memory;
  for (std::size_t f = 0; f < 21; ++f) {
    chosen.push_back(f);
    memory.push_back(remembered(f));
    memory[f].gas = f != 9;  // that one has retired and let its gas go
    if (f % 5 == 0) continue;
    for (std::size_t p = 0; p < kFacetPoints; ++p)  // the faces are 1e-5 m closer than at first
      memory[f].contact.get_or_create().offset[p].x() =
          p == 1 ? 1e-5 : -3e-5 - 1e-6 * static_cast<double>(p);
  }
  Pairs pairs(of, chosen, 0.0, memory);
  FacetNetwork& network = pairs.network();
  std::vector<double> pressure(network.blocks().size(), 0.0);
  for (std::size_t f = 0; f < chosen.size(); ++f)
    pressure[2 * f + f % 2] = f == 11 ? 0.0 : 2.0 * kPressure;
  network.set_gas_pressure(pressure);
  pairs.compute();
  OpenJoints open;
  const std::vector<std::size_t> asked = {1, 2, 3, 5, 7, 8, 13, 16, 20};
  std::vector<LaneSet> sets;
  for (const std::size_t f : asked) add_facet(sets, f);
  network.open_joints(sets, open);
  ASSERT_EQ(open.area.size(), asked.size());
  int pressed = 0;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const std::size_t f = asked[k], broken = std::min<std::size_t>(f % 5, kFacetPoints);
    const GasOneByOne expected(network, f, kPressure);
    EXPECT_NEAR(open.area[k], static_cast<double>(broken) / 3.0 * network.area(f), 1e-12) << f;
    EXPECT_NEAR(open.opening[k], expected.opening, 1e-12) << f;  // rounding of centres metres away
    EXPECT_EQ(open.opening[k] > 1e-6, broken > 0) << f;
    EXPECT_NEAR(open.apart[k], expected.apart, 1e-12) << f;
    EXPECT_EQ(std::popcount(open.points[k]), 2 * static_cast<int>(broken)) << f;  // none slips
    const double stiffness = network.tables().contact(f).closure.normal;
    EXPECT_NEAR(open.pressure[k], stiffness * expected.closure, 1e-12 * stiffness) << f;
    pressed += open.pressure[k] > 1e-6 * stiffness ? 1 : 0;
    EXPECT_LT(open.parted_squared[k], 1.0) << f;
  }
  EXPECT_GT(pressed, 0);  // some are closed
  for (std::size_t f = 0; f < chosen.size(); ++f) {
    const bool none = f % 5 == 0 || f == 9 || f == 11;
    const GasOneByOne expected(network, f, none ? 0.0 : kPressure);
    const double rounding = 1e-12 * kPressure;  // of areas and arms of the order of one
    EXPECT_LT((network.gas_force()[2 * f] - expected.force).norm(), rounding) << f;
    EXPECT_LT((network.gas_force()[2 * f + 1] + expected.force).norm(), rounding) << f;
    EXPECT_LT((network.gas_torque()[2 * f] - expected.torque_i).norm(), rounding) << f;
    EXPECT_LT((network.gas_torque()[2 * f + 1] - expected.torque_j).norm(), rounding) << f;
    EXPECT_EQ(network.gas_force()[2 * f].norm() > 1.0, !none) << f;
  }
  // Between blocks at rest, too.
  const std::vector<Vec3> before(network.gas_force().begin(), network.gas_force().end());
  network.let_rest(std::vector<int>(network.blocks().size(), 1));
  pairs.compute();
  EXPECT_TRUE(std::ranges::equal(network.gas_force(), before));
}

TEST(FacetGroups, ARetiredFacetGivesUpItsContact) {
  const std::vector<Facet> of = joints();
  Pairs pair(of, {5}, 0.0, {remembered(3)});
  pair.compute();
  EXPECT_TRUE(pair.network().memory(0).contact.exists());
  pair.network().state()[1].centre += 2.0 * pair.network().state()[0].rotation * of[5].normal;
  pair.compute();
  EXPECT_EQ(pair.network().states()[0], FacetState::retired);
  EXPECT_FALSE(pair.network().memory(0).contact.exists());
}

}  // namespace
}  // namespace muckpile
