// SPDX-License-Identifier: GPL-2.0-or-later
// One phase of a scene without charges, on an engine that only keeps time: what it is told, in
// order, and where the phase ends; and the words of run_blocks.
// Scope: no engine.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "args/input_error.h"
#include "fake_engine.h"
#include "run/blocks_run.h"

namespace muckpile {
namespace {

using test::FakeEngine;

BlocksPlan plan_of(std::vector<std::string> words) {
  words.insert(words.begin(), {"directory", "out", "density", "2700", "block_min", "0.18",
                               "spheres_per_block", "5", "time_end", "1"});
  return blocks_plan(parse_args(run_blocks_table(), "run_blocks", words), {2.5e7, 0.25, 0.5},
                     "run_blocks");
}

TEST(BlocksRun, RunsToATimeInLaps) {
  FakeEngine engine;
  engine.at_rest = true;  // does not matter
  EXPECT_EQ(BlocksRun(plan_of({"phase", "shake", "until", "0.45"}), engine).go(), LapsEnd::time);
  const std::vector<std::string> expected{
      "prepare shake", "phase shake",       "step for collisions",
      "set up",        "snapshots 1000000", "run afresh 100",
      "run 100",       "run 100",           "run 100",
      "run afresh 50"};
  EXPECT_EQ(engine.told, expected);
  EXPECT_TRUE(engine.lines.empty());
}

TEST(BlocksRun, AStepThatGrowsDoesNotRunBeyondTheEnd) {
  FakeEngine engine;
  double begun = 0.0;
  engine.after_run = [&] {  // it has grown by 1.8 after the first half of the steps
    engine.now += 0.5 * 0.8 * (engine.now - begun);
    begun = engine.now;
    if (engine.dt < 0.02) engine.dt *= 1.8;
  };
  EXPECT_EQ(BlocksRun(plan_of({"until", "0.45"}), engine).go(), LapsEnd::time);
  EXPECT_GE(engine.now, 0.45 - 1e-6 * engine.dt);
  EXPECT_LE(engine.now, 0.45 + engine.dt);
}

/// In the middle of the last lap, long after the first; all at once, as when a fast block is gone.
TEST(BlocksRun, AStepThatIsLetLooseLateDoesNotRunBeyondTheEnd) {
  for (const double grown : {1.5e-3, 2e-3}) {
    FakeEngine engine;
    engine.after_step = [&] {
      if (engine.now > 0.42) engine.dt = grown;
    };
    EXPECT_EQ(BlocksRun(plan_of({"until", "0.5"}), engine).go(), LapsEnd::time);
    EXPECT_GE(engine.now, 0.5 - 1e-9);
    EXPECT_LE(engine.now, 0.5 + grown);
    EXPECT_GE(engine.cap, 1e30);  // for what comes next
  }
}

TEST(BlocksRun, EndsWhenTheRockIsStill) {
  FakeEngine engine;
  engine.after_run = [&engine] { engine.at_rest = engine.now > 0.25; };
  EXPECT_EQ(BlocksRun(plan_of({}), engine).go(), LapsEnd::still);
  EXPECT_NEAR(engine.now, 0.3, 1e-9);
  ASSERT_EQ(engine.lines.size(), 1u);
  EXPECT_EQ(engine.lines[0], "The rock rests after 0.3 s of physical time.");
}

/// Before anything moves the rock is still, too.
TEST(BlocksRun, TakesALapBeforeItAsksForRest) {
  FakeEngine engine;
  engine.at_rest = true;
  EXPECT_EQ(BlocksRun(plan_of({}), engine).go(), LapsEnd::still);
  EXPECT_EQ(engine.steps, 100);
}

TEST(BlocksRun, EndsAtTimeEndAtTheLatest) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"until", "5"}, {"until", "still"}}) {
    FakeEngine engine;
    EXPECT_EQ(BlocksRun(plan_of(words), engine).go(), LapsEnd::time);
    EXPECT_NEAR(engine.now, 1.0, 1e-9);
  }
}

TEST(BlocksRun, SaysThatTimeIsOver) {
  FakeEngine engine;
  BlocksRun(plan_of({"still_share", "0.02"}), engine).go();
  ASSERT_EQ(engine.lines.size(), 1u);
  EXPECT_EQ(engine.lines[0],
            "time_end is reached after 1 s of physical time; more than still_share 0.02 of the "
            "rock still moves.");
}

/// Nothing else bounds the step of blocks that start from rest in the air.
TEST(BlocksRun, KeepsTheStepOfAFastCollision) {
  FakeEngine engine;
  BlocksRun(plan_of({}), engine).go();
  EXPECT_NEAR(*engine.rule.collision, 8.604e-3 / 8.0, 2e-7);  // at 20 m/s, in 8 steps
  EXPECT_EQ(engine.rule.collision_speed, 0.0);
}

TEST(BlocksRun, ASignalBehindTheLastStepLeavesNothingOut) {
  FakeEngine engine;
  engine.after_run = [&engine] { engine.quit = engine.now > 0.95; };
  EXPECT_EQ(BlocksRun(plan_of({"until", "1"}), engine).go(), LapsEnd::time);
  FakeEngine still;
  still.after_run = [&still] { still.at_rest = still.quit = still.now > 0.25; };
  EXPECT_EQ(BlocksRun(plan_of({}), still).go(), LapsEnd::still);
}

TEST(BlocksRun, ASignalBeforeTheFirstStepCutsItShort) {
  class Quitting : public FakeEngine {
   public:
    void run(long /*count*/, bool /*afresh*/) override { quit = true; }
  } engine;
  engine.at_rest = true;
  EXPECT_EQ(BlocksRun(plan_of({}), engine).go(), LapsEnd::interrupted);
}

/// As a script does that goes on after a restart file.
TEST(BlocksRun, TakesNoStepsInAPhaseThatIsOver) {
  FakeEngine engine;
  engine.now = 0.5;
  EXPECT_EQ(BlocksRun(plan_of({"until", "0.5"}), engine).go(), LapsEnd::time);
  EXPECT_EQ(engine.steps, 0);
}

/// `./muckpile` takes a run that says so for one that is not whole.
TEST(BlocksRun, TakesNoStepAfterASignal) {
  FakeEngine engine;
  engine.after_run = [&engine] { engine.quit = true; };
  EXPECT_EQ(BlocksRun(plan_of({}), engine).go(), LapsEnd::interrupted);
  EXPECT_EQ(BlocksRun(plan_of({}), engine).go(), LapsEnd::interrupted);
  EXPECT_EQ(engine.steps, 100);
  EXPECT_EQ(engine.lines,
            std::vector<std::string>{"interrupted: before the first step of phase run"});
}

TEST(BlocksPlan, ResolvesTheCollisionOfTwoSmallestBlocks) {
  // 8.604 ms at 20 m/s (CollisionTime.OfTheSmallestBlocksOfTheBench) in 15 steps.
  const BlocksPlan plan = plan_of({"steps_per_contact", "15"});
  EXPECT_NEAR(plan.collision.step, 8.604e-3 / 15.0, 1e-7);
}

TEST(BlocksPlan, RefusesAnEndThatIsNoTime) {
  const auto refusal_of = [](const std::string& until) -> std::string {
    try {
      (void)plan_of({"until", until});
    } catch (const InputError& refused) {
      return refused.what();
    }
    return "";
  };
  EXPECT_EQ(refusal_of("rest"), "run_blocks: until must be a number in s, got 'rest'");
  EXPECT_EQ(refusal_of("0"), "run_blocks: until must be > 0 and <= 1000 s, got '0'");
}

TEST(BlocksPlan, RefusesANameThatSplitsALineOfTheHistory) {
  for (const char* name : {"a,b", "a\"b", "a'b"})
    EXPECT_THROW(plan_of({"phase", name}), InputError);
}

}  // namespace
}  // namespace muckpile
