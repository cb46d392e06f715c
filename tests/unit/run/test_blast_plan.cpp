// SPDX-License-Identifier: GPL-2.0-or-later
// Words of run_blast to the numbers of its phases, against numbers worked by hand.
// Scope: no engine; what the phases do with the numbers is in test_blast_run.cpp.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "args/input_error.h"
#include "run/blast_plan.h"

namespace muckpile {
namespace {

/// Of the default bench: charges that fire at once, gas that vents by 9.9 + 5 * 4.5 ms.
BlastScene bench() {
  return {
      .timing = {.rise_time = 1e-4, .pulse_end = 1e-3, .vent_time = 9.9e-3, .vent_decay = 4.5e-3},
      .rock = {2700.0, 55e9, 0.25, 4944.0, 2700.0 * 4944.0},
      .contacts = {2.5e7, 0.25, 0.5},
      .gas = Gas::in_joints};
}

BlastPlan plan_of(std::vector<std::string> words, const BlastScene& scene = bench(),
                  const std::string& block_min = "0.18") {
  words.insert(words.begin(), {"directory", "out", "block_min", block_min});
  return blast_plan(parse_args(run_blast_table(), "run_blast", words), scene, "run_blast");
}

std::string refusal_of(const std::vector<std::string>& words, const BlastScene& scene = bench()) {
  try {
    (void)plan_of(words, scene);
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "";
}

TEST(BlastPlan, TakesTheEndOfTheWaveFromTheCharges) {
  EXPECT_NEAR(plan_of({}).wave_end, 0.0324, 1e-12);  // 9.9 + 5 * 4.5 ms
  BlastScene scene = bench();
  scene.timing.last_firing = 0.1;
  EXPECT_NEAR(plan_of({}, scene).wave_end, 0.1324, 1e-12);
  EXPECT_EQ(plan_of({"wave_end", "0.2"}, scene).wave_end, 0.2);
}

TEST(BlastPlan, WaitsForThePulseWhereThereIsNoGas) {
  BlastScene scene = bench();
  scene.timing.vent_time = scene.timing.vent_decay = 0.0;
  EXPECT_EQ(plan_of({}, scene).wave_end, 1e-3);
}

TEST(BlastPlan, WaitsForAPulseLongerThanTheGas) {
  BlastScene scene = bench();
  scene.timing.pulse_end = 0.05;
  EXPECT_EQ(plan_of({}, scene).wave_end, 0.05);
  EXPECT_EQ(refusal_of({"wave_end", "0.04"}, scene),
            "run_blast: wave_end must be >= 0.05 s, when the pulse of the last charge has gone, "
            "got 0.04 s; rise_time of fix muckpile/blast decides how long it lasts");
}

TEST(BlastPlan, AsksForTheEndWhereGasFlowsAndHasNoTimes) {
  BlastScene scene = bench();
  scene.timing.vent_decay.reset();
  EXPECT_EQ(refusal_of({}, scene),
            "run_blast: wave_end must be a time [s] where the gas leaves by flow and fix "
            "muckpile/blast has no vent_time and vent_decay, got 'auto'; about 1.1e-2 s per metre "
            "of burden after the last firing");
  EXPECT_EQ(plan_of({"wave_end", "0.03"}, scene).wave_end, 0.03);
}

TEST(BlastPlan, StepsThePulseInFive) {
  EXPECT_NEAR(plan_of({}).pulse_step, 2e-5, 1e-18);  // a fifth of 1e-4 s
  EXPECT_NEAR(plan_of({}).between_step, 6e-5, 1e-18);
}

/// A wave takes 152 us across a block of 0.75 m, 193 and 388 across 0.95 and 1.92 m.
TEST(BlastPlan, StepsThePulseByTheTimeOfAWaveAcrossCoarseBlocks) {
  const auto step = [](const std::string& block_min, const std::string& share = "0.2",
                       const BlastScene& scene = bench()) {
    return plan_of({"crossing_share", share}, scene, block_min).pulse_step;
  };
  EXPECT_NEAR(step("0.49"), 2e-5, 1e-18);  // 19.8 us are below a fifth of the rise
  EXPECT_NEAR(step("0.75"), 0.2 * 0.75 / 4944.0, 1e-12);
  EXPECT_NEAR(step("0.95"), 0.2 * 0.95 / 4944.0, 1e-12);
  EXPECT_NEAR(step("1.92"), 4e-5, 1e-18);  // two fifths of the rise
  EXPECT_NEAR(step("0.95", "0"), 2e-5, 1e-18);
  BlastScene scene = bench();
  scene.gas_step = 3.5e-5;
  EXPECT_EQ(step("0.95", "0.2", scene), 3.5e-5);
}

/// 100 MPa move a wall at 100e6 / (2700 * 4944) = 7.49 m/s; a hundredth of its radius of 0.02 m in
/// 26.7 us, of 0.01 m in 13.3 us.
TEST(BlastPlan, StepsThePulseByAHundredthOfTheWallsRadius) {
  BlastScene scene = bench();
  scene.timing.wall_load = 100e6 / 0.02;
  EXPECT_NEAR(plan_of({}, scene, "0.95").pulse_step, 2.6698e-5, 1e-9);
  scene.timing.wall_load = 100e6 / 0.01;
  EXPECT_NEAR(plan_of({}, scene, "0.95").pulse_step, 2e-5, 1e-18);  // that of its rise
}

TEST(BlastPlan, StepsNoLongerThanGasInJointsBears) {
  BlastScene scene = bench();
  scene.gas_step = 6e-5;
  EXPECT_NEAR(plan_of({}, scene).pulse_step, 2e-5, 1e-18);
  EXPECT_EQ(plan_of({}, scene).between_step, 6e-5);
  scene.timing.rise_time = 1e-3;
  EXPECT_EQ(plan_of({}, scene).pulse_step, 6e-5);
  EXPECT_EQ(plan_of({}, scene).between_step, 6e-5);
  scene.timing.rise_time = 0.0;
  EXPECT_EQ(plan_of({}, scene).between_step, 6e-5);
}

TEST(BlastPlan, StepsThePulseFromTenStepsBeforeTheFiringUntilItHasGone) {
  BlastScene scene = bench();
  scene.timing.pulses = {{0.017, 0.020}, {0.0, 0.003}, {0.0032, 0.006}, {0.0180, 0.0195}};
  const std::vector<PulseSpan> spans = plan_of({}, scene).pulses;  // of two times two, as they meet
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_NEAR(spans[0].begin, -2e-4, 1e-15);
  EXPECT_NEAR(spans[0].end, 0.006, 1e-15);
  EXPECT_NEAR(spans[1].begin, 0.0168, 1e-15);
  EXPECT_NEAR(spans[1].end, 0.020, 1e-15);
  scene.timing.rise_time = 0.0;  // a jump, whatever the step
  EXPECT_TRUE(plan_of({}, scene).pulses.empty());
}

/// Less than 40 steps of the pulse and ten long ones: 1.4 ms.
TEST(BlastPlan, PulsesWithTooShortAGapForLongStepsAreOne) {
  BlastScene scene = bench();
  scene.timing.pulses = {{0.0, 0.003}, {0.0045, 0.006}, {0.0077, 0.009}};
  const std::vector<PulseSpan> spans = plan_of({}, scene).pulses;
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_NEAR(spans[0].end, 0.006, 1e-15);
  EXPECT_NEAR(spans[1].begin, 0.0075, 1e-15);
}

TEST(BlastPlan, ResolvesTheCollisionOfTwoSmallestBlocks) {
  // 8.604 ms at 20 m/s (CollisionTime.OfTheSmallestBlocksOfTheBench) in 8 steps.
  const BlastPlan plan = plan_of({"spheres_per_block", "5"});
  EXPECT_NEAR(plan.collision.step, 8.604e-3 / 8.0, 2e-7);
  EXPECT_TRUE(plan.collision.follows_fastest);
  const BlastPlan crowded = plan_of({"spheres_per_block", "40"});
  EXPECT_NEAR(crowded.collision.step, 0.5 * plan.collision.step, 1e-12);
  EXPECT_FALSE(crowded.collision.follows_fastest);
}

TEST(BlastPlan, DampsClosedJointsAsContactsAre) {
  EXPECT_EQ(closed_damping(1.0), 0.0);
  // sqrt(2) * 0.693147 / sqrt(9.869604 + 0.480453) = 0.980258 / 3.217151
  EXPECT_NEAR(closed_damping(0.5), 0.304698, 1e-6);
}

TEST(BlastPlan, KnowsHowStiffTheRockIs) {
  EXPECT_NEAR(plan_of({}).shear_modulus, 22e9, 1.0);  // 55 / 2.5 GPa
}

TEST(BlastPlan, RefusesAnEndBeforeThatOfTheWave) {
  EXPECT_EQ(refusal_of({"time_end", "0.02"}),
            "run_blast: time_end must be > wave_end, 0.0324 s, got 0.02 s");
}

TEST(BlastPlan, RefusesAWaveThatEndsBeforeThePulse) {
  EXPECT_EQ(refusal_of({"wave_end", "5e-4"}),
            "run_blast: wave_end must be >= 0.001 s, when the pulse of the last charge has gone, "
            "got 0.0005 s; rise_time of fix muckpile/blast decides how long it lasts");
}

TEST(BlastPlan, RefusesWordsThatAreNoTime) {
  EXPECT_EQ(refusal_of({"wave_end", "soon"}),
            "run_blast: wave_end must be a number in s, got 'soon'");
  EXPECT_EQ(refusal_of({"wave_end", "-1"}),
            "run_blast: wave_end must be > 0 and <= 1000 s, got '-1'");
}

TEST(BlastPlan, RefusesChargesThatFireLater) {
  BlastScene scene = bench();
  scene.timing.start = 0.5;
  EXPECT_EQ(refusal_of({}, scene),
            "run_blast: the charges must fire in the first run of all: they have not been in a run "
            "yet, and 0.5 s are over");
}

// A restart file of the throw is told from one of the wave by its softer joints.
TEST(BlastPlan, RefusesAThrowOnJointsAsStiffAsBefore) {
  EXPECT_EQ(refusal_of({"softening", "1"}),
            "run_blast: softening must be >= 1e-07 and < 1, got '1'");
}

TEST(BlastPlan, RefusesANameThatSplitsALineOfTheHistory) {
  EXPECT_EQ(refusal_of({"throw_name", "a,b"}),
            "run_blast: throw_name must be without commas and quotes, got 'a,b'");
}

}  // namespace
}  // namespace muckpile
