// SPDX-License-Identifier: GPL-2.0-or-later
// A network gives up the very facets that it was given, with what they have remembered since, and
// goes on with them as if nothing had been.
// Scope: broken, softening and supported facets.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "bond_scene.h"

namespace muckpile {
namespace {

using test::BondScene;

void expect_same(const Facet& a, const Facet& b) {
  EXPECT_EQ(a.tag_i, b.tag_i);
  EXPECT_EQ(a.tag_j, b.tag_j);
  EXPECT_EQ(a.face, b.face);
  EXPECT_EQ(a.i, b.i);
  EXPECT_EQ(a.j, b.j);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.joint_class, b.joint_class);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.arm_i, b.arm_i);
  EXPECT_EQ(a.arm_j, b.arm_j);
  EXPECT_EQ(a.opening_j, b.opening_j);
  EXPECT_EQ(a.half_axes, b.half_axes);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.sharpened, b.sharpened);
  EXPECT_EQ(a.weight, b.weight);
  EXPECT_EQ(a.opening_i, b.opening_i);
}

/// Rock on a fixed support that softens as it is stretched, so far that some of it has broken.
BondScene torn_rock() {
  JointParameters rock = test::rock(0.25);
  rock.tension = rock.cohesion = 1e6;
  rock.fracture_energy_tension = rock.fracture_energy_shear = 500.0;
  BondScene scene(test::voronoi_blocks(4.0, 3, 5), rock,
                  [](const Vec3& at) { return at.z() < 1e-6 ? Support::fixed : Support::free; });
  Mat3 stretch = Mat3::Zero();
  stretch(0, 0) = 3e-5;
  scene.deform(stretch);
  scene.compute(1e-6);
  stretch(0, 0) = 6e-5;
  scene.deform(stretch);
  scene.compute(1e-6);
  return scene;
}

/// As when fix muckpile/sleep is taken off before the first run.
TEST(FacetLists, WakingBeforeThereAreBlocksChangesNothing) {
  FacetNetwork network(JointMaterial(test::rock(0.25)));
  network.wake_all();
  EXPECT_TRUE(network.facets().empty());
}

TEST(FacetLists, AreGivenUpAsTheyWereSet) {
  BondScene scene = torn_rock();
  const std::vector<Facet> before = scene.network().facets();
  const std::size_t face_count = scene.network().faces().size();
  const auto [facets, memory, faces] = scene.network().give_up();
  EXPECT_TRUE(scene.network().facets().empty());
  EXPECT_TRUE(scene.network().memory().empty());
  EXPECT_EQ(faces.size(), face_count);
  ASSERT_EQ(facets.size(), before.size());
  ASSERT_EQ(memory.size(), before.size());
  for (std::size_t f = 0; f < facets.size(); ++f) expect_same(facets[f], before[f]);
}

TEST(FacetLists, TheNetworkGoesOnWithThemAsIfNothingHadBeen) {
  BondScene kept = torn_rock(), returned = torn_rock();
  FacetLists lists = returned.network().give_up();
  std::size_t softening = 0;
  for (const FacetMemory& one : lists.memory) softening += one.extra.exists() ? 1 : 0;
  EXPECT_GT(softening, 0u);
  EXPECT_LT(softening, lists.memory.size());
  returned.network().set_facets(std::move(lists));
  kept.compute(1e-6);
  returned.compute(1e-6);
  // phi is summed up anew, in another order: rounding.
  for (std::size_t b = 0; b < kept.size(); ++b) {
    const Vec3 force = kept.network().force()[b], torque = kept.network().torque()[b];
    EXPECT_LT((returned.network().force()[b] - force).norm(), 1e-9 * force.norm()) << b;
    EXPECT_LT((returned.network().torque()[b] - torque).norm(), 1e-9 * force.norm()) << b;
  }
}

/// A block at rest has its dilatation anew at each step where a hole's pressure may squeeze it.
TEST(FacetLists, BlocksAtRestBesideTheFacesOfAHoleAreStirredAtOnce) {
  BondScene scene(test::cuboids(3, 1, 1), test::rock(0.25));
  scene.network().let_rest(std::vector<int>{1, 1, 1, 1});
  FacetLists lists = scene.network().lists();
  for (BoundaryFace& face : lists.faces)
    if (face.block == 2 && face.normal.x() > 0.5) face.hole = 0;
  scene.network().set_facets(std::move(lists));
  EXPECT_FALSE(scene.network().schedule().stirred(0));
  EXPECT_TRUE(scene.network().schedule().stirred(2));
}

TEST(FacetLists, FewerBlocksMayFollow) {
  BondScene few(test::cuboids(2, 1, 1), test::rock(0.25));
  FacetNetwork network = BondScene(test::cuboids(3, 3, 3), test::rock(0.25)).network();
  std::vector<BlockConstants> blocks = few.network().blocks();
  blocks.pop_back();  // the ground, which set() appends
  network.set(std::move(blocks), few.network().lists());
  for (std::size_t b = 0; b < few.size(); ++b) network.state()[b] = few.block(b);
  few.block(1).centre.x() += 1e-5;
  network.state()[1].centre.x() += 1e-5;
  few.compute();
  network.step(0.0);
  for (std::size_t b = 0; b < few.size(); ++b)
    EXPECT_EQ(network.force()[b], few.network().force()[b]);
}

/// A corner of rock between tilted symmetry planes and ground that has yielded for some steps.
BondScene rock_on_yielding_ground() {
  std::vector<Block> blocks = test::voronoi_blocks(4.0, 5, 5);
  JointParameters rock = test::rock(0.25);
  BondScene scene(blocks, rock, [](const Vec3& at) {
    if (at.z() < 1e-6) return Support::fixed;
    return at.x() < 1e-6 ? Support::mirror : Support::free;
  });
  FacetLists lists = scene.network().lists();
  for (Facet& facet : lists.facets)  // no cut makes planes that lean so: as a file may have them
    if (facet.kind == FacetKind::mirror) {
      const Mat3 tilt = test::turn(Vec3(0.1, 0.37, 0.21));
      facet.normal = tilt * facet.normal;
      facet.opening_i = tilt * (facet.opening_i + Vec3(0.0, 0.03, 0.02));
    }
  scene.network().set_facets(std::move(lists));
  scene.compute();
  scene.network().let_ground_yield(QuietGround(scene.network().material(), 8.0),
                                   [](const Vec3&) { return true; });
  scene.shake(1e-5, 1e-6, 7);
  for (int k = 0; k < 20; ++k) scene.step(1e-5);
  return scene;
}

TEST(FacetLists, ComeBackToTheLastBitFromTiltedMirrorsAndYieldingGround) {
  BondScene scene = rock_on_yielding_ground();
  FacetNetwork& network = scene.network();
  ASSERT_GT(network.yielding_supports(), 0u);
  const std::vector<Facet> before = network.facets();
  const std::vector<FacetMemory> memory = network.memory();
  scene.compute();
  const std::vector<Vec3> force(network.force().begin(), network.force().end());
  for (int round = 0; round < 3; ++round) {
    network.set_facets(network.lists());
    const std::vector<Facet> after = network.facets();
    for (std::size_t f = 0; f < before.size(); ++f) expect_same(after[f], before[f]);
  }
  scene.compute();
  for (std::size_t b = 0; b < force.size(); ++b) EXPECT_EQ(network.force()[b], force[b]) << b;
}

TEST(FacetLists, OfARunAndOfItsRestartFileAgreeToTheLastBit) {
  BondScene scene = rock_on_yielding_ground();
  FacetNetwork& network = scene.network();
  FacetLists lists = network.lists();  // as a file has them: no notes of the network
  for (FacetMemory& one : lists.memory)
    if (one.extra.exists()) one.extra.get_or_create().ground.placed = false;
  BondScene read = scene;
  read.network().set_facets(std::move(lists));
  network.derive_anew();
  for (int k = 0; k < 5; ++k) {
    scene.step(1e-5);
    read.step(1e-5);
  }
  for (std::size_t b = 0; b < scene.size(); ++b) {
    EXPECT_EQ(read.network().force()[b], network.force()[b]) << b;
    EXPECT_EQ(read.block(b).centre, scene.block(b).centre) << b;
  }
}

TEST(Sparse, CopiesAreDeepAndWhatIsNotThereReadsAsTheDefault) {
  Sparse<ExtraMemory> one;
  EXPECT_FALSE(one.exists());
  EXPECT_FALSE(one.get().ground.yields);
  one.get_or_create().ground.yields = true;
  Sparse<ExtraMemory> copy = one;
  copy.get_or_create().ground.yields = false;
  EXPECT_TRUE(one.get().ground.yields);
  copy = one;
  EXPECT_TRUE(copy.get().ground.yields);
  copy = Sparse<ExtraMemory>();
  EXPECT_FALSE(copy.exists());
  EXPECT_TRUE(one.exists());
}

/// A squeezed cube on a fixed support, of which the uppermost layer is shaken; some joints break.
class TopOfCube {
 public:
  TopOfCube()
      : scene_(test::voronoi_blocks(5.0, 4, 5), rock(),
               [](const Vec3& at) { return at.z() < 1e-6 ? Support::fixed : Support::free; }) {
    for (std::size_t b = 0; b < scene_.size(); ++b)
      middle_ += scene_.start(b).z() / static_cast<double>(scene_.size());
    scene_.deform(-1e-4 * Mat3::Identity());
    compute();
  }
  void let_low_rest() {
    std::vector<int> rests(scene_.size() + 1, 1);
    for (std::size_t b = 0; b < scene_.size(); ++b) rests[b] = low(b) ? 1 : 0;
    scene_.network().let_rest(rests);
  }
  /// The uppermost layer moves on, the others stay.
  void shake(unsigned seed) {
    const std::vector<BlockState> before(scene_.network().state().begin(),
                                         scene_.network().state().end());
    scene_.shake(4e-4, 4e-4, seed);
    for (std::size_t b = 0; b < scene_.size(); ++b)
      if (low(b)) scene_.block(b) = before[b];
  }
  void compute() { scene_.compute(1e-6); }
  BondScene& scene() { return scene_; }
  [[nodiscard]] bool low(std::size_t b) const { return scene_.start(b).z() < middle_ + 1.5; }

 private:
  static JointParameters rock() {
    JointParameters rock = test::rock(0.25);
    rock.tension = rock.cohesion = 2e6;
    return rock;
  }
  BondScene scene_;
  double middle_ = 0.0;  // height of the cube's [m]
};

// Forces of sums in another order differ by 1e-16 of the parts.
void expect_alike(TopOfCube& some, TopOfCube& all, const char* when) {
  double largest = 0.0;
  for (const Vec3& force : all.scene().network().force()) largest = std::max(largest, force.norm());
  for (std::size_t b = 0; b < all.scene().size(); ++b) {
    EXPECT_NEAR(some.scene().network().theta()[b], all.scene().network().theta()[b], 1e-16)
        << when << b;
    if (all.low(b)) continue;
    const Vec3 apart = some.scene().network().force()[b] - all.scene().network().force()[b];
    EXPECT_LT(apart.norm(), 1e-11 * largest) << when << b;
  }
  const double energy = all.scene().network().elastic_energy();
  EXPECT_NEAR(some.scene().network().elastic_energy(), energy, 1e-11 * energy) << when;
  EXPECT_EQ(some.scene().network().broken_count(), all.scene().network().broken_count()) << when;
}

TEST(FacetLists, BlocksThatMoveFeelTheSameWhetherWhatRestsIsWorkedOutAgainOrNot) {
  TopOfCube some, all;
  const double whole = all.scene().network().broken_count();
  some.let_low_rest();
  for (const unsigned seed : {1u, 2u, 3u}) {
    some.shake(seed);
    all.shake(seed);
    some.compute();
    all.compute();
    expect_alike(some, all, "shaken ");
  }
  EXPECT_GT(all.scene().network().broken_count(), whole + 10.0);
  for (TopOfCube* scene : {&some, &all}) {
    scene->scene().network().soften(0.1);
    scene->compute();
  }
  expect_alike(some, all, "softened ");
  some.scene().network().wake_all();
  some.compute();
  all.compute();  // friction is limited anew in each
  expect_alike(some, all, "woken ");
}

}  // namespace
}  // namespace muckpile
