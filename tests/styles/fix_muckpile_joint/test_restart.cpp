// SPDX-License-Identifier: GPL-2.0-or-later
// Rock from a restart file: a run that goes on from one is the run that went on without.
// Scope: joints, blocks, contacts and the ledger's sums; on as many ranks as wrote the file, and on
// one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kStep = 1e-5;  // [s]
constexpr int kBefore = 100, kSoon = 100, kLate = 300;
const std::string kStrength = " cohesion 4e6 friction_angle 50 tension 2e6";

void add_contacts(RockScene& scene) {
  scene.command("pair_style muckpile/block youngs_modulus 5e8 restitution 0.3 friction 0.6");
  scene.command("pair_coeff * *");
}

/// Joints and contacts, as an input has to give them again after read_restart.
void add_laws(RockScene& scene, const std::string& strength) {
  add_contacts(scene);
  scene.command("fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600" +
                strength);
}

/// A lump that is pressed together on one side and spins to pieces.
void make_breaking_lump(RockScene& scene, const std::string& strength,
                        const std::string& cut = "") {
  scene.cut("-1 1 -1 1 -1 1",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 4 "
            "sphere_growth 1.1 seed 3" +
                cut);
  add_laws(scene, strength);
  scene.set_motion([](int, const Vec3& at) {
    const Vec3 spin(2.0, 5.0, 20.0), inward(at.x() > 0.0 ? -0.4 * at.x() : 0.0, 0.0, 0.0);
    return Motion{spin.cross(at) + inward, spin};
  });
}

struct Totals {
  double broken, elastic, fracture, friction, damping, crushing;
};

Totals totals_of(const RockScene& scene) {
  return {scene.output("joint", 2), scene.output("joint", 4), scene.output("joint", 5),
          scene.output("joint", 6), scene.output("joint", 7), scene.output("joint", 11)};
}

/// Largest difference of centres [m], velocities [m/s] and spins [rad/s].
double difference(const RockScene& a, const RockScene& b) {
  const auto one = a.blocks(), two = b.blocks();
  EXPECT_EQ(one.size(), two.size());
  double most = 0.0;
  for (const auto& [tag, block] : one) {
    const BlockNow& other = two.at(tag);
    for (const Vec3& apart :
         {Vec3(block.centre - other.centre), Vec3(block.velocity - other.velocity),
          Vec3(block.spin - other.spin)}) {
      most = std::max(most, apart.norm());
    }
  }
  return most;
}

/// `books`: allowed share of the fracture energy.
void expect_same(const RockScene& went_on, const RockScene& restarted, double allowed,
                 double books) {
  EXPECT_LE(difference(went_on, restarted), allowed);
  const Totals one = totals_of(went_on), two = totals_of(restarted);
  EXPECT_EQ(one.broken, two.broken);
  for (const auto& [a, b] :
       {std::pair(one.elastic, two.elastic), std::pair(one.fracture, two.fracture),
        std::pair(one.friction, two.friction), std::pair(one.damping, two.damping),
        std::pair(one.crushing, two.crushing)})
    EXPECT_NEAR(a, b, books * one.fracture);
}

/// Largest difference [m], [m/s], [rad/s] on as many ranks as before, and on another number. On
/// more than two ranks the spheres are read in another order, so that sums round otherwise, and a
/// contact that slips as a run starts lies on the friction limit to rounding: its dashpot acts for
/// one step or not.
struct Bounds {
  double same_ranks, other_ranks;
};
Bounds bounds() {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks <= 2 ? Bounds{0.0, 1e-9} : Bounds{1e-7, 1e-3};
}

/// `between` is for the first run only: what a restart has to know of it is in the file. Returns
/// what walls that crush have taken [J].
double go_on_and_restart(const std::string& strength, const std::string& between = "",
                         double books = 1e-3, const std::string& cut = "") {
  const ScratchFolder folder("restart");
  const std::string file = folder / "lump.restart";
  RockScene went_on(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1", "multisphere/muckpile");
  make_breaking_lump(went_on, strength, cut);
  went_on.run(kBefore, kStep);
  if (!between.empty()) went_on.command(between);
  const double broken = went_on.output("joint", 2);
  EXPECT_GT(broken, 5.0);  // rock is breaking as the file is written
  went_on.command("write_restart " + file);
  went_on.run(kSoon, kStep);

  // On another number of ranks sums round otherwise, and breaking rock magnifies that.
  RockScene alone = RockScene::restarted(MPI_COMM_SELF, file);
  add_laws(alone, strength);
  alone.run(kSoon, kStep);
  // Where neighbours on two ranks crack in one step it also changes the books.
  expect_same(went_on, alone, bounds().other_ranks, books);

  went_on.run(kLate, kStep);
  EXPECT_GT(went_on.output("joint", 2), broken);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_laws(restarted, strength);
  restarted.run(kSoon, kStep);
  restarted.run(kLate, kStep);
  expect_same(went_on, restarted, bounds().same_ranks, 1e-12 + bounds().same_ranks);
  return totals_of(went_on).crushing;
}

TEST(Restart, BreakingRockOnRanksGoesOnAsIfNothingHadHappened) { go_on_and_restart(kStrength); }

TEST(Restart, LeaningBlocksStaySlanted) {
  // Spheres of joined blocks on a rank that moves neither must not touch there: 5e-4.
  go_on_and_restart(kStrength, "", 2e-3,
                    " cut joint_sets joint_set 75 90 joint_set 85 0 joint_set 10 270");
}

TEST(Restart, CracksKeepWhatTheyHold) {
  go_on_and_restart(kStrength + " fracture_energy_tension 40 fracture_energy_shear 160", "", 5e-3);
}

TEST(Restart, JointsOfBartonAndBandisKeepTheirHistory) {
  go_on_and_restart(
      kStrength +
          " joint_class 1 law barton_bandis initial_stiffness 1e10 closure_limit 1e-4 "
          "roughness 10 wall_strength 1e8 residual_friction_angle 30 "
          "irrecoverable_closure 0.4 peak_slip 1e-3",
      "", 1e-3, " joint_plane 0 0 0 30 90 1");
}

TEST(Restart, CrushedWallsStayCrushed) {
  EXPECT_GT(go_on_and_restart(kStrength + " wall_strength 2e5"), 0.0);
}

TEST(Restart, ZonesKeepTheirRock) {
  go_on_and_restart(
      kStrength + " zone soft youngs_modulus 10e9 poisson_ratio 0.35 density 2200 cohesion 2e6", "",
      2e-3, " zone soft 2200 above 0 0 0.1 10 90");
}

TEST(Restart, SoftenedRockStaysSoft) {
  go_on_and_restart(kStrength, "fix_modify joint soften 0.1");
}

/// Without joints: what sphere contacts remember of their sliding.
TEST(Restart, LooseBlocksGoOnAsIfNothingHadHappened) {
  const ScratchFolder folder("restart");
  const std::string file = folder / "loose.restart";
  RockScene went_on(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1", "multisphere/muckpile");
  went_on.cut("-1 1 -1 1 -1 1",
              "density 2600 size uniform 0.6 block_min 0.6 block_max 0.6 spheres_per_block 5 "
              "sphere_growth 1.2 seed 3");
  add_contacts(went_on);
  went_on.set_motion([](int, const Vec3& at) {
    const Vec3 spin(2.0, 5.0, 8.0);
    return Motion{spin.cross(at) - 4.0 * at, Vec3(3.0, -4.0, 1.0)};
  });
  const double start = went_on.kinetic_energy();
  went_on.run(50, 4 * kStep);
  const double middle = went_on.kinetic_energy();
  went_on.command("write_restart " + file);
  went_on.run(400, 4 * kStep);
  EXPECT_LT(middle, 0.99 * start);  // they are in contact when the file is written, and after
  EXPECT_GT(std::abs(went_on.kinetic_energy() / middle - 1.0), 0.01);

  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_contacts(restarted);
  restarted.run(400, 4 * kStep);
  EXPECT_LE(difference(went_on, restarted), 1e-10);  // contacts are summed in another order
}

/// A charge whose gas flows into the joints, on ground that yields at one side; its wave, which
/// falls as a shock, leaves the rock there joined to the ground.
void add_blast(RockScene& scene) {
  add_laws(scene, kStrength);
  for (const char* line :
       {"region far block -2 -0.89 -2 2 -2 2 units box",
        "fix load all muckpile/blast explosive_density 1100 vod 4500 hole_diameter 0.1 "
        "attenuation shock poisson_ratio 0.25 venting flow stemming_length 100 crack_delay 0",
        "fix gas all muckpile/gas", "fix quiet all muckpile/quiet region far rock_behind 5",
        "fix ledger all muckpile/ledger"})
    scene.command(line);
}

constexpr double kBlastStep = 5e-6;  // [s]

RockScene blasted_rock(MPI_Comm comm) {
  RockScene scene(comm, "-6 6 -6 6 -6 6", "* * 1", "multisphere/muckpile");
  scene.command("region held block -2 -0.89 -2 2 -2 2 units box");
  scene.cut("-0.9 0.9 -0.9 0.9 -0.9 0.9",
            "density 2600 size uniform 0.3 block_min 0.3 block_max 0.3 spheres_per_block 3 "
            "sweeps 5 seed 3 hole 0 0 -0.4 0 0 0.4 0.15 support fixed held");
  add_blast(scene);
  return scene;
}

/// Of the ledger: blast work, fracture, friction, damping, given to quiet ground [J].
constexpr std::array kBooks{5, 6, 7, 8, 9, 10, 12};

/// Worst difference of any entry, as a share of the blast work.
double apart_in_books(const RockScene& a, const RockScene& b) {
  double worst = 0.0;
  for (int entry : kBooks)
    worst = std::max(worst, std::abs(a.output("ledger", entry) - b.output("ledger", entry)));
  return worst / a.output("ledger", 5);
}

TEST(Restart, BlastGoesOnWithItsGasItsGroundAndItsBooks) {
  const ScratchFolder folder("restart");
  const std::string file = folder / "blast.restart";
  RockScene went_on = blasted_rock(MPI_COMM_WORLD);
  went_on.run(
      201, kBlastStep);  // 1 ms: gas in the joints, between two of its steps; waves in the ground
  EXPECT_GT(went_on.output("gas", 1), 0.01);
  EXPECT_GT(went_on.output("quiet", 1), 0.0);
  went_on.command("write_restart " + file);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_blast(restarted);
  for (RockScene* scene : {&went_on, &restarted}) scene->run(0, kBlastStep);
  EXPECT_LT(difference(went_on, restarted), 1e-12);
  EXPECT_LT(apart_in_books(went_on, restarted), 1e-12);
  for (const auto& [fix, entries] : {std::pair("gas", 7), std::pair("load", 11)}) {
    for (int n = 1; n <= entries; ++n)
      EXPECT_NEAR(went_on.output(fix, n), restarted.output(fix, n),
                  1e-9 * std::abs(went_on.output(fix, n)))
          << fix << ' ' << n;
  }
  went_on.run(200, kBlastStep);
  restarted.run(200, kBlastStep);
  const double apart = difference(went_on, restarted), books = apart_in_books(went_on, restarted);
  std::cout << "1 ms later: " << apart << " m/s apart, books " << books << " of the blast work\n";
  EXPECT_LT(apart, 1e-7);  // breaking rock magnifies rounding
  EXPECT_LT(books, 1e-9);
  EXPECT_LT(restarted.output("ledger", 0), 0.01);
}

/// A blast that is over stays so, and its walls are not looked for where their blocks have left.
TEST(Restart, BlastThatIsOverIsNotFiredAgain) {
  constexpr int kOver = 6;  // entry of fix muckpile/blast
  const ScratchFolder folder("restart");
  const std::string file = folder / "over.restart";
  const auto add = [](RockScene& scene) {
    add_laws(scene, kStrength);
    scene.command("thermo_modify lost ignore");
    scene.command(
        "fix load all muckpile/blast explosive_density 1100 vod 4500 hole_diameter 0.1 "
        "poisson_ratio 0.25 rise_time 2e-5 vent_time 1e-4 vent_decay 1e-5");
  };
  RockScene scene(MPI_COMM_WORLD, "-6 6 -6 6 -6 6", "* * 1", "multisphere/muckpile");
  scene.cut("-0.9 0.9 -0.9 0.9 -0.9 0.9",
            "density 2600 size uniform 0.3 block_min 0.3 block_max 0.3 spheres_per_block 3 "
            "sweeps 5 seed 3 hole 0 0 -0.4 0 0 0.4 0.15");
  add(scene);
  scene.run(300, kBlastStep);
  EXPECT_EQ(scene.output("load", kOver), 1.0);
  const std::size_t before = scene.blocks().size();
  scene.set_motion([](int, const Vec3& at) {
    return Motion{Vec3(at.x() > -0.3 ? 2000.0 : 0.0, 0.0, 0.0), Vec3::Zero()};
  });
  scene.run(800, kBlastStep);
  EXPECT_LT(scene.blocks().size(), before);
  scene.command("write_restart " + file);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add(restarted);
  restarted.run(1, kBlastStep);  // an engine that stops ends the program
  EXPECT_EQ(restarted.output("load", kOver), 1.0);
  EXPECT_EQ(restarted.output("load", 1), 0.0);  // [Pa] on any wall
}

/// A wall that flies after a blast sweeps nothing for the next one, whether the flight was read
/// from a file or not, and whether the first blast was given again before.
TEST(Restart, SecondBlastSweepsNoFlight) {
  constexpr int kSwept = 3, kOver = 6;  // entries of fix muckpile/blast
  const ScratchFolder folder("restart");
  const std::string file = folder / "flight.restart";
  const auto load = [](RockScene& scene) {
    scene.command(
        "fix load all muckpile/blast explosive_density 1100 vod 4500 hole_diameter 0.1 "
        "poisson_ratio 0.25 rise_time 2e-5 vent_time 1e-4 vent_decay 1e-5");
  };
  const auto fire_again = [&](RockScene& scene) {
    scene.command("unfix load");
    load(scene);
    scene.run(20, kBlastStep);
    return scene.output("load", kSwept);
  };
  RockScene went_on(MPI_COMM_WORLD, "-6 6 -6 6 -6 6", "* * 1", "multisphere/muckpile");
  went_on.cut("-0.9 0.9 -0.9 0.9 -0.9 0.9",
              "density 2600 size uniform 0.3 block_min 0.3 block_max 0.3 spheres_per_block 3 "
              "sweeps 5 seed 3 hole 0 0 -0.4 0 0 0.4 0.15");
  add_laws(went_on, kStrength);
  load(went_on);
  went_on.run(300, kBlastStep);
  EXPECT_EQ(went_on.output("load", kOver), 1.0);
  went_on.set_motion([](int, const Vec3& at) {
    return Motion{20.0 * Vec3(at.x(), at.y(), 0.0), Vec3::Zero()};
  });
  went_on.run(200, kBlastStep);  // 1 ms: walls fly 2 % of their distance
  went_on.command("write_restart " + file);
  RockScene given_again = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_laws(given_again, kStrength);
  load(given_again);
  RockScene left_out = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_laws(left_out, kStrength);
  for (RockScene* scene : {&went_on, &given_again, &left_out}) scene->run(200, kBlastStep);
  load(left_out);
  const double swept = fire_again(went_on);
  EXPECT_GT(swept, 1e-5);
  EXPECT_NEAR(fire_again(given_again), swept,
              1e-6 * swept);                               // the books of the first blast are not
  EXPECT_NEAR(fire_again(left_out), swept, 1e-6 * swept);  // those of the second
}

/// Rock softened between a restart file and the first run that goes on from it: neither the fixes
/// nor the walls have seen a step.
void soften_after_restart(const std::string& charge, bool gas) {
  constexpr int kWall = 1, kOver = 6;                         // entries of fix muckpile/blast
  constexpr int kHeld = 1, kTaken = 2, kAway = 3, kGone = 7;  // of fix muckpile/gas
  const ScratchFolder folder("restart");
  const std::string file = folder / "hard.restart", other = folder / "other.restart";
  const auto load = [&](RockScene& scene) {
    scene.command(
        "fix load all muckpile/blast explosive_density 1100 vod 4500 hole_diameter 0.1 "
        "poisson_ratio 0.25 " +
        charge);
    if (gas) scene.command("fix gas all muckpile/gas");
  };
  RockScene scene(MPI_COMM_WORLD, "-6 6 -6 6 -6 6", "* * 1", "multisphere/muckpile");
  scene.cut("-0.9 0.9 -0.9 0.9 -0.9 0.9",
            "density 2600 size uniform 0.3 block_min 0.3 block_max 0.3 spheres_per_block 3 "
            "sweeps 5 seed 3 hole 0 0 -0.4 0 0 0.4 0.15");
  add_laws(scene, kStrength);
  load(scene);
  scene.run(50, kBlastStep);
  EXPECT_GT(scene.output("load", kWall), 1e7);  // [Pa]
  scene.command("write_restart " + file);

  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_laws(restarted, kStrength);
  load(restarted);
  restarted.command("write_restart " + other);  // sets up the joints as a run does
  restarted.command("fix_modify joint soften 1e-6");
  restarted.run(20, kBlastStep);
  EXPECT_EQ(restarted.output("load", kOver), 1.0);
  EXPECT_EQ(restarted.output("load", kWall), 0.0);
  if (!gas) return;
  EXPECT_EQ(restarted.output("gas", kGone), 1.0);
  EXPECT_EQ(restarted.output("gas", kHeld), 0.0);
  EXPECT_GT(restarted.output("gas", kAway), 0.01);  // [kg]
  EXPECT_NEAR(restarted.output("gas", kAway) / restarted.output("gas", kTaken), 1.0, 1e-9);
}

TEST(Restart, JointsSoftenedBeforeTheFirstStepLetTheGasOfHolesGo) {
  soften_after_restart("rise_time 2e-5 vent_time 0.01 vent_decay 0.01", false);
}

TEST(Restart, JointsSoftenedBeforeTheFirstStepLetTheirGasGo) {
  soften_after_restart("venting flow stemming_length 100 crack_delay 0", true);
}

/// As when the command restart is followed by a second start before anything has moved.
TEST(Restart, FileThatIsWrittenAgainBeforeARunKeepsTheGas) {
  const ScratchFolder folder("restart");
  const std::string first = folder / "first.restart", second = folder / "second.restart";
  RockScene scene = blasted_rock(MPI_COMM_WORLD);
  scene.run(200, kBlastStep);
  scene.command("write_restart " + first);
  RockScene again = RockScene::restarted(MPI_COMM_WORLD, first, "* * 1");
  add_blast(again);
  again.command("write_restart " + second);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, second, "* * 1");
  add_blast(restarted);
  for (RockScene* each : {&scene, &restarted}) each->run(0, kBlastStep);
  EXPECT_GT(scene.output("gas", 1), 0.01);
  EXPECT_NEAR(restarted.output("gas", 1), scene.output("gas", 1), 1e-9 * scene.output("gas", 1));
}

TEST(Restart, JointsCanBeTakenOffAndGivenAgainAfterwards) {
  const ScratchFolder folder("restart");
  const std::string file = folder.own("lump.restart");
  RockScene scene(MPI_COMM_SELF, "-4 4 -4 4 -4 4", "* * 1", "multisphere/muckpile");
  make_breaking_lump(scene, kStrength);
  scene.run(kBefore, kStep);
  scene.command("write_restart " + file);
  const double broken = scene.output("joint", 2);
  RockScene restarted = RockScene::restarted(MPI_COMM_SELF, file);
  add_laws(restarted, kStrength);
  restarted.run(1, kStep);
  restarted.command("unfix joint");
  add_laws(restarted, kStrength);
  restarted.run(1, kStep);  // an engine that stops ends the program
  EXPECT_GE(restarted.output("joint", 2), broken);
}

/// Unfixed and given again, before and after a restart file of the time between: the softening and
/// its damping go on, or the facets' memory would be that of another rock.
TEST(Restart, SoftenedJointsStaySoftWhenAnotherFixTakesThemOver) {
  constexpr int kElastic = 4, kSoftened = 10;
  const ScratchFolder folder("restart");
  const std::string file = folder / "between.restart";
  RockScene went_on(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1", "multisphere/muckpile");
  make_breaking_lump(went_on, kStrength);
  went_on.run(kBefore, kStep);
  went_on.command("fix_modify joint soften 0.25 damping 0.2");
  went_on.run(0, kStep);
  const double elastic = went_on.output("joint", kElastic);
  ASSERT_GT(elastic, 0.0);
  went_on.command("unfix joint");
  went_on.command("write_restart " + file);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  for (RockScene* scene : {&went_on, &restarted}) {
    add_laws(*scene, kStrength);
    EXPECT_EQ(scene->output("joint", kSoftened), 0.25);  // run_blast asks before its first run
    scene->run(0, kStep);
    EXPECT_EQ(scene->output("joint", kSoftened), 0.25);
    EXPECT_NEAR(scene->output("joint", kElastic), elastic, 1e-9 * elastic);
    scene->run(kSoon, kStep);
  }
  EXPECT_LT(difference(went_on, restarted), 1e-3);
}

TEST(Restart, LaterSnapshotsGoAndOtherFilesStay) {
  const ScratchFolder folder("restart");
  const std::string file = folder.own("lump.restart"), out = folder.own("out");
  RockScene scene(MPI_COMM_SELF, "-4 4 -4 4 -4 4", "* * 1", "multisphere/muckpile");
  make_breaking_lump(scene, kStrength);
  scene.command("fix dump all muckpile/dump every 10 directory " + out);
  scene.run(1, kStep);
  scene.command("write_restart " + file);
  for (const char* name : {"/blocks_000000900.csv", "/blocks_900_notes.txt", "/blocks_900.csv.old"})
    std::filesystem::copy_file(out + "/blocks_000000001.csv", out + name);
  RockScene restarted = RockScene::restarted(MPI_COMM_SELF, file);
  add_laws(restarted, kStrength);
  restarted.command("fix dump all muckpile/dump every 10 directory " + out);
  restarted.run(0, kStep);
  EXPECT_FALSE(std::filesystem::exists(out + "/blocks_000000900.csv"));
  EXPECT_TRUE(std::filesystem::exists(out + "/blocks_900_notes.txt"));
  EXPECT_TRUE(std::filesystem::exists(out + "/blocks_900.csv.old"));
}

double time_of(RockScene& scene) {
  scene.command("variable now equal time");
  return scene.variable("now");
}

/// fix muckpile/progress writes such a file when a run goes wrong, the command restart now and
/// then.
TEST(Restart, FileFromTheMiddleOfARunIsGoodToo) {
  const ScratchFolder folder("restart");
  const std::string file = folder / "middle.restart";
  RockScene went_on(MPI_COMM_WORLD, "-4 4 -4 4 -4 4", "* * 1", "multisphere/muckpile");
  make_breaking_lump(went_on, kStrength);
  went_on.command("restart 150 " + file);
  went_on.run(200, kStep);
  const double time = time_of(went_on);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file + ".150", "* * 1");
  add_laws(restarted, kStrength);
  restarted.run(50, kStep);
  EXPECT_NEAR(time_of(restarted), time, 1e-12);
  // The run that begins works out its forces at full steps, the other has them from half a step
  // before: contacts that slip feel that.
  const double apart = difference(went_on, restarted);
  std::cout << "50 steps later: " << apart << " m/s apart\n";
  EXPECT_LT(apart, 1e-3);
  EXPECT_NEAR(restarted.output("joint", 2), went_on.output("joint", 2), 1.0);
}

TEST(Restart, WhatIsNotGivenAgainEnds) {
  const ScratchFolder folder("restart");
  const std::string file = folder / "blast.restart";
  RockScene went_on = blasted_rock(MPI_COMM_WORLD);
  went_on.run(200, kBlastStep);
  went_on.command("write_restart " + file);
  for (const char* fix : {"gas", "quiet", "load"}) went_on.command(std::string("unfix ") + fix);
  went_on.run(100, kBlastStep);
  RockScene restarted = RockScene::restarted(MPI_COMM_WORLD, file, "* * 1");
  add_laws(restarted, kStrength);
  restarted.command("fix ledger all muckpile/ledger");
  restarted.run(100, kBlastStep);
  EXPECT_LT(difference(went_on, restarted), 1e-3);
  EXPECT_LT(apart_in_books(went_on, restarted), 1e-6);
}

/// fix muckpile/progress stops a run that loses blocks; the one that goes on does without them.
TEST(Restart, BlocksLostBeforeAreNotMissed) {
  const ScratchFolder folder("restart");
  const std::string file = folder.own("lost.restart");
  RockScene scene(MPI_COMM_SELF, "-4 4 -4 4 -4 4", "* * 1", "multisphere/muckpile");
  make_breaking_lump(scene, " cohesion 1e3 friction_angle 50 tension 1e3");
  const std::size_t before = scene.blocks().size();
  scene.set_motion([](int tag, const Vec3&) {
    return Motion{tag <= 2 ? Vec3(100.0, 0.0, 0.0) : Vec3::Zero(), Vec3::Zero()};
  });
  scene.command("thermo_modify lost ignore");
  for (int k = 0; k < 10; ++k) scene.run(1000, kStep);
  const std::size_t left = scene.blocks().size();
  EXPECT_LT(left, before);
  scene.command("write_restart " + file);

  RockScene restarted = RockScene::restarted(MPI_COMM_SELF, file, "* * 1");
  add_laws(restarted, " cohesion 1e3 friction_angle 50 tension 1e3");
  restarted.command("fix ledger all muckpile/ledger");
  restarted.command("fix progress all muckpile/progress every 10 directory " +
                    folder.own("out").string());
  restarted.run(100, kStep);  // an engine that stops ends the program
  EXPECT_EQ(restarted.blocks().size(), left);
}

}  // namespace
}  // namespace muckpile::test
