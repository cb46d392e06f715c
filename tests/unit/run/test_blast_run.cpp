// SPDX-License-Identifier: GPL-2.0-or-later
// The phases of a blast on an engine that only keeps time: each change from one to the next, the
// end of time and a signal in each, and going on in the middle of each. Scope: what BlastRun tells
// the engine, in order; the physics is the tests' own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "fake_engine.h"
#include "run/blast_run.h"

namespace muckpile {
namespace {

using Phase = BlastRun::Phase;

/// `happens` sets the state of engine and rock after each run.
class FakeBlast : public test::FakeEngine, public BlastedRock {
 public:
  double joints = 1.0;
  double elastic = 1.0, kinetic = 1.0, work = 1.0, on_walls = 0.0, in_joints = 0.0;
  std::function<void(FakeBlast&)> happens = [](FakeBlast&) {};

  FakeBlast() {
    after_run = [this] { happens(*this); };
  }

  double stiffness() const override { return joints; }
  double elastic_energy() const override { return elastic; }
  double kinetic_energy() const override { return kinetic; }
  double blast_work() const override { return work; }
  double wall_pressure() const override { return on_walls; }
  double joint_pressure() const override { return in_joints; }

  void soften(double factor, std::optional<double> damping) override {
    joints *= factor;
    told.push_back(damping ? "soften and damp" : "soften");
  }
  void let_blocks_rest() override { told.push_back("sleep"); }
};

/// Wave until 35 ms, push until 100 ms, throw until 1 s.
BlastPlan plan() {
  BlastPlan plan;
  plan.wave_end = 0.1;
  plan.time_end = 1.0;
  plan.still_share = 0.01;
  plan.pulse_step = 2e-5;
  plan.pulses = {{-2e-4, 0.01}};
  plan.push_softening = 0.1;
  plan.push_elastic = 0.005;
  plan.push_from = 0.35;
  plan.shear_modulus = 22e9;
  plan.hole_rest = 3e5;
  plan.gas_rest = 5e-4;
  plan.gas_patience = 4.02;  // between two looks at the gas
  plan.softening = 2e-4;
  return plan;
}

Phase go(const BlastPlan& plan, FakeBlast& engine) {
  return BlastRun(plan, engine, engine, "run_blast").go();
}

TEST(BlastRun, GoesThroughItsPhases) {
  FakeBlast engine;
  engine.happens = [](FakeBlast& e) {
    if (e.now > 0.05) e.elastic = 1e-3;  // the waves have gone
    e.at_rest = e.now > 0.25;
  };
  EXPECT_EQ(go(plan(), engine), Phase::rest);
  // Laps of the throw from 0.1 s: to 0.2 and 0.3 s.
  const std::vector<std::string> expected{"prepare wave_and_gas",
                                          "step for pulse",
                                          "set up",
                                          "snapshots 10",
                                          "run 10",
                                          "step for joints",
                                          "run 10",
                                          "snapshots 10",
                                          "run 15",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "soften",
                                          "step for joints",
                                          "set up",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "run 5",
                                          "soften and damp",
                                          "phase throw",
                                          "step for collisions",
                                          "set up",
                                          "sleep",
                                          "snapshots 1000000",
                                          "run afresh 100",
                                          "run 100"};
  EXPECT_EQ(engine.told, expected);
  EXPECT_EQ(engine.rule.contact_every, 1);  // in the throw contacts act at each step
  EXPECT_NEAR(engine.joints, 2e-4, 1e-12);
  ASSERT_EQ(engine.lines.size(), 1u);
  EXPECT_EQ(engine.lines[0].substr(0, 20), "The rock rests after");
}

/// Charges fire at 0 and 20 ms; outside of their pulses the joints bear twice the step.
TEST(BlastRun, StepsArePulsesOnlyWhileThoseAct) {
  FakeBlast engine;
  BlastPlan two = plan();
  two.pulses = {{-2e-4, 0.01}, {0.02, 0.025}};
  std::vector<std::pair<double, double>> bounds;  // time, longest step
  engine.happens = [&](FakeBlast& e) {
    bounds.emplace_back(e.now, *e.rule.longest);
    e.dt = *e.rule.longest < 1.0 ? 1e-3 : 2e-3;
    e.at_rest = e.now > 0.25;
  };
  go(two, engine);
  // After each run: the pulse, ten steps that may grow, the rest until the next, its pulse, again.
  ASSERT_GT(bounds.size(), 5u);
  EXPECT_NEAR(bounds[0].first, 0.010, 1e-9);
  EXPECT_EQ(bounds[0].second, 2e-5);
  EXPECT_NEAR(bounds[1].first, 0.020, 1e-9);
  EXPECT_EQ(bounds[1].second, 1e30);
  EXPECT_NEAR(bounds[2].first, 0.026, 1e-9);  // steps of 2 ms until the engine is told in its run
  EXPECT_EQ(bounds[2].second, 2e-5);
  EXPECT_EQ(bounds[3].second, 1e30);
  EXPECT_NEAR(bounds[3].first, 0.035, 1e-9);
}

/// The step grows as rock comes apart, in the middle of a gap between pulses.
TEST(BlastRun, AStepThatGrowsDoesNotRunIntoTheNextPulse) {
  FakeBlast engine;
  BlastPlan two = plan();
  two.between_step = 1.5e-3;
  two.pulses = {{-2e-4, 0.001}, {0.03, 0.031}};
  double entered = 0.0;
  engine.happens = [&](FakeBlast& e) {
    if (e.now > 0.015) e.dt = 1.4e-3;
    if (e.now > 0.029 && entered == 0.0) entered = e.now;
    e.at_rest = e.now > 0.25;
  };
  go(two, engine);
  EXPECT_GE(entered, 0.03 - 1e-9);
  EXPECT_LE(entered, 0.03 + 1.4e-3);
}

/// Ten times the pulse's step, in the last of which it grows by itself.
TEST(BlastRun, AStepThatGrowsLateDoesNotRunIntoTheNextPulse) {
  for (const double grows_at : {1e-3, 2e-3, 2.9e-3, 2.97e-3}) {
    FakeBlast engine;
    engine.dt = 2e-5;
    BlastPlan two = plan();
    two.between_step = 2e-4;
    two.pulses = {{-2e-4, 0.001}, {0.003, 0.004}};
    double entered = 0.0;
    engine.after_step = [&] {
      if (entered == 0.0 && engine.now >= 0.003 - 1e-9) entered = engine.now;
      engine.dt = engine.now < grows_at ? 2e-5 : std::min(*engine.rule.longest, 2e-4);
    };
    engine.happens = [](FakeBlast& e) { e.quit = e.now > 0.005; };
    EXPECT_EQ(go(two, engine), Phase::interrupted);
    EXPECT_GE(entered, 0.003 - 1e-9);
    EXPECT_LT(entered, 0.003 + two.between_step) << grows_at;
  }
}

/// Until 60 ms, though the push may begin at 35 ms and nothing is elastic: softer joints would not
/// bear it, nor would a longer step resolve it.
TEST(BlastRun, APulseThatOutlastsTheWaveIsBorneByStiffJoints) {
  for (const double elastic : {0.0, 1.0}) {
    FakeBlast engine;
    engine.elastic = elastic;
    BlastPlan slow = plan();
    slow.pulses = {{-2e-4, 0.06}};
    double softened_at = 1.0;
    engine.happens = [&](FakeBlast& e) {
      const double longest = *e.rule.longest;
      EXPECT_EQ(longest, e.now < 0.0601 ? 2e-5 : 1e30) << e.now;
      if (e.joints < 1.0) softened_at = std::min(softened_at, e.now);
      e.quit = e.now > 0.095;
    };
    EXPECT_EQ(go(slow, engine), Phase::interrupted);
    EXPECT_NEAR(softened_at, elastic > 0.0 ? 1.0 : 0.065, 1e-9);  // a look after it
  }
}

/// One pulse, after which the step may be 30 us.
BlastPlan plan_with_pulse_until(double end) {
  BlastPlan slow = plan();
  slow.between_step = 3e-5;
  slow.pulses = {{-2e-4, end}};
  return slow;
}

/// They are looked for after every twentieth of the time, 5 ms, whatever the step: here it is a
/// third of what pulses would bear, and grows as the pulse ends, and the elastic energy falls by a
/// fifth in each look.
TEST(BlastRun, WavesAreNotTakenForGoneBetweenLooks) {
  FakeBlast engine;
  engine.elastic = 0.09;
  engine.dt = 1e-5;
  const BlastPlan slow = plan_with_pulse_until(0.06);
  double softened_at = 1.0;
  engine.happens = [&](FakeBlast& e) {
    e.elastic = 0.09 * std::pow(0.8, (e.now - 0.06) / 5e-3);
    if (e.joints < 1.0) softened_at = std::min(softened_at, e.now);
    e.quit = e.now > 0.099;
  };
  EXPECT_EQ(go(slow, engine), Phase::interrupted);
  EXPECT_EQ(softened_at, 1.0);  // at 99 ms it is still 0.016 of the kinetic energy
}

/// No step can overshoot anything there, so each look is reached at once, however much the step may
/// grow.
TEST(BlastRun, LooksWhetherWavesHaveGoneAreOneRunEach) {
  FakeBlast engine;
  engine.elastic = 1.0;
  engine.dt = 1e-5;
  const BlastPlan plain = plan_with_pulse_until(0.01);
  std::vector<double> looks;
  engine.happens = [&](FakeBlast& e) {
    if (e.now > 0.0401 && e.now < 0.0901) looks.push_back(e.now);
    e.quit = e.now > 0.095;
  };
  EXPECT_EQ(go(plain, engine), Phase::interrupted);
  ASSERT_EQ(looks.size(), 10u);  // of 5 ms
  for (std::size_t k = 0; k < looks.size(); ++k)
    EXPECT_NEAR(looks[k], 0.045 + 5e-3 * static_cast<double>(k), 1e-9);
}

TEST(BlastRun, StressesLockedInTheRockAreNoWaves) {
  for (const double locked : {0.08, 0.12}) {
    FakeBlast engine;
    double softened_at = 1.0;
    engine.happens = [&](FakeBlast& e) {
      e.elastic = locked + 10.0 * std::max(0.0, 0.06 - e.now);
      if (e.joints < 1.0) softened_at = std::min(softened_at, e.now);
      e.at_rest = e.now > 0.25;
    };
    go(plan(), engine);
    // Steady from 60 ms on, which the look at 65 ms sees; else the throw softens, at 100 ms.
    EXPECT_NEAR(softened_at, locked < 0.1 ? 0.07 : 0.2, 1e-9) << locked;
  }
}

TEST(BlastRun, WaitsForTheLastChargeBeforeThePush) {
  FakeBlast engine;
  engine.elastic = 0.0;
  BlastPlan with_delays = plan();
  with_delays.last_firing = 0.06;
  engine.happens = [](FakeBlast& e) { e.quit = e.joints < 1.0; };
  EXPECT_EQ(go(with_delays, engine), Phase::interrupted);
  EXPECT_NEAR(engine.now, 0.076, 1e-9);  // softened after 60 + 0.35 * 40 ms, and two steps
}

TEST(BlastRun, KeepsStiffJointsWhileWavesGo) {
  FakeBlast engine;
  engine.at_rest = true;
  EXPECT_EQ(go(plan(), engine), Phase::rest);
  EXPECT_FALSE(engine.was_told("soften"));
  EXPECT_TRUE(engine.was_told("soften and damp"));
}

TEST(BlastRun, SoftensForThePushNoFurtherThanTheGasAllows) {
  FakeBlast engine;
  engine.elastic = 0.0;
  engine.on_walls = 1e7;
  engine.in_joints = 4e7;  // 110 * 4e7 / 22e9 = 0.2
  engine.happens = [](FakeBlast& e) { e.quit = e.joints < 1.0; };
  EXPECT_EQ(go(plan(), engine), Phase::interrupted);
  EXPECT_NEAR(engine.joints, 0.2, 1e-12);
}

TEST(BlastRun, DoesNotSoftenForAPushThatGainsLittle) {
  FakeBlast engine;
  engine.elastic = 0.0;
  engine.on_walls = 1.1e8;  // 110 * 1.1e8 / 22e9 = 0.55
  engine.at_rest = true;
  EXPECT_EQ(go(plan(), engine), Phase::rest);
  EXPECT_FALSE(engine.was_told("soften"));
}

TEST(BlastRun, DoesNotSoftenThePushBelowTheThrow) {
  FakeBlast engine;
  engine.elastic = 0.0;
  engine.at_rest = true;
  BlastPlan stiff_throw = plan();
  stiff_throw.softening = 0.2;
  EXPECT_EQ(go(stiff_throw, engine), Phase::rest);
  EXPECT_FALSE(engine.was_told("soften"));
}

TEST(BlastRun, WaitsUntilGasInJointsHasDoneItsWork) {
  FakeBlast engine;
  BlastPlan gassy = plan();
  gassy.gas = Gas::in_joints;
  engine.happens = [](FakeBlast& e) {
    e.work += e.now < 0.15 ? 1.0 : 1e-4;
    e.at_rest = true;
  };
  EXPECT_EQ(go(gassy, engine), Phase::rest);
  ASSERT_EQ(engine.lines.size(), 2u);
  // Twentieths of 0.1 s; the first that begins at or after 0.145 s adds 1e-4 of some 20.
  EXPECT_EQ(engine.lines[0].substr(0, 35), "The first phase ends after 0.15 s: ");
  EXPECT_TRUE(engine.warnings.empty());
}

TEST(BlastRun, LetsGasGoThatNeverEnds) {
  FakeBlast engine;
  BlastPlan gassy = plan();
  gassy.gas = Gas::in_joints;
  engine.happens = [](FakeBlast& e) {
    e.work *= 1.1;
    e.at_rest = true;
  };
  EXPECT_EQ(go(gassy, engine), Phase::rest);
  EXPECT_EQ(engine.warnings.size(), 1u);
  EXPECT_TRUE(engine.was_told("soften and damp"));
  EXPECT_NEAR(engine.now, 0.4 + 0.005 + 0.1, 1e-9);  // the look after 4.02 * 0.1 s, and a lap
}

TEST(BlastRun, DoesNotWaitForGasThatDoesNoWork) {
  FakeBlast engine;
  engine.work = 0.0;
  BlastPlan gassy = plan();
  gassy.gas = Gas::in_joints;
  engine.at_rest = true;
  EXPECT_EQ(go(gassy, engine), Phase::rest);
  EXPECT_NEAR(engine.now, 0.1 + 0.005 + 0.1, 1e-9);
}

TEST(BlastRun, WaitsUntilHolesAreEmpty) {
  FakeBlast engine;
  engine.on_walls = 1e6;
  BlastPlan venting = plan();
  venting.gas = Gas::in_holes;
  engine.happens = [](FakeBlast& e) {
    if (e.now > 0.202) e.on_walls = 2e5;
    e.at_rest = e.joints < 0.1;
  };
  EXPECT_EQ(go(venting, engine), Phase::rest);
  EXPECT_NEAR(engine.now, 0.205 + 0.1, 1e-9);
  EXPECT_TRUE(engine.warnings.empty());
}

TEST(BlastRun, LetsHolesGoThatNeverEmpty) {
  FakeBlast engine;
  engine.on_walls = 1e6;
  engine.at_rest = true;
  BlastPlan venting = plan();
  venting.gas = Gas::in_holes;
  EXPECT_EQ(go(venting, engine), Phase::rest);
  EXPECT_EQ(engine.warnings.size(), 1u);
  EXPECT_NEAR(engine.now, 0.405 + 0.1, 1e-9);
}

TEST(BlastRun, EndsWhereTimeRunsOutWhileGasWorks) {
  for (const Gas gas : {Gas::in_joints, Gas::in_holes}) {
    FakeBlast engine;
    engine.on_walls = 1e6;
    engine.happens = [](FakeBlast& e) { e.work *= 1.1; };
    BlastPlan gassy = plan();
    gassy.gas = gas;
    gassy.time_end = 0.12;
    EXPECT_EQ(go(gassy, engine), Phase::rest);
    EXPECT_NEAR(engine.now, 0.12, 1e-9);
    EXPECT_FALSE(engine.was_told("phase throw"));
    ASSERT_EQ(engine.lines.size(), 1u);
    EXPECT_EQ(engine.lines[0].substr(0, 25), "time_end is reached after");
  }
}

/// The rock comes apart and bears twice the step, in the middle of the last look at the gas.
TEST(BlastRun, AStepThatGrowsWhileGasWorksDoesNotRunBeyondTheEnd) {
  for (const Gas gas : {Gas::in_joints, Gas::in_holes}) {
    FakeBlast engine;
    engine.dt = 1e-4;
    engine.on_walls = 1e6;
    engine.happens = [](FakeBlast& e) { e.work *= 1.1; };
    engine.after_step = [&] {
      if (engine.now > 0.116) engine.dt = 2e-4;
    };
    BlastPlan gassy = plan();
    gassy.gas = gas;
    gassy.time_end = 0.12;
    EXPECT_EQ(go(gassy, engine), Phase::rest);
    EXPECT_GE(engine.now, 0.12 - 1e-9);
    EXPECT_LE(engine.now, 0.12 + 2e-4);
  }
}

TEST(BlastRun, EndsWhereTimeRunsOutInTheThrow) {
  FakeBlast engine;
  EXPECT_EQ(go(plan(), engine), Phase::rest);
  EXPECT_NEAR(engine.now, 1.0, 1e-9);
  EXPECT_EQ(engine.lines.back().substr(0, 25), "time_end is reached after");
}

TEST(BlastRun, EndsWithTheWaveWhereThePlanSaysSo) {
  for (const Gas gas : {Gas::vents_by_time, Gas::in_joints, Gas::in_holes}) {
    FakeBlast engine;
    engine.on_walls = 1e6;
    BlastPlan short_one = plan();
    short_one.gas = gas;
    short_one.ends_with_wave = true;
    EXPECT_EQ(go(short_one, engine), Phase::wave_over);
    EXPECT_NEAR(engine.now, 0.1, 1e-9);
    EXPECT_EQ(engine.joints, 1.0);
    EXPECT_FALSE(engine.was_told("phase throw"));
    EXPECT_EQ(engine.told.back(), "snapshots 1000000");  // for a command that goes on
    EXPECT_EQ(engine.lines, std::vector<std::string>{"Wave and gas push end after 0.1 s."});
  }
}

TEST(BlastRun, DoesNotEndWithAWaveThatIsOver) {
  FakeBlast engine;
  engine.joints = 2e-4;
  BlastPlan short_one = plan();
  short_one.ends_with_wave = true;
  try {
    go(short_one, engine);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "run_blast: end must be rest, as the joints have been softened for the throw "
              "already, got 'wave'");
  }
  EXPECT_TRUE(engine.told.empty());
}

TEST(BlastRun, SetsUpEveryFourthLap) {
  FakeBlast engine;
  EXPECT_EQ(go(plan(), engine), Phase::rest);
  const std::vector<std::string> laps(engine.told.end() - 9, engine.told.end());
  const std::vector<std::string> expected{"run afresh 100", "run 100",        "run 100",
                                          "run 100",        "run afresh 100", "run 100",
                                          "run 100",        "run 100",        "run afresh 100"};
  EXPECT_EQ(laps, expected);
}

TEST(BlastRun, GoesOnInTheMiddleOfTheThrow) {
  FakeBlast engine;
  engine.now = 0.95;
  engine.joints = 2e-4;
  EXPECT_EQ(go(plan(), engine), Phase::rest);
  const std::vector<std::string> expected{"prepare throw",       "sleep",  "phase throw",
                                          "step for collisions", "set up", "snapshots 1000000",
                                          "run afresh 25",       "run 25"};
  EXPECT_EQ(engine.told, expected);
  EXPECT_EQ(engine.joints, 2e-4);
}

TEST(BlastRun, GoesOnInTheMiddleOfThePush) {
  FakeBlast engine;
  engine.now = 0.08;
  engine.joints = 0.1;
  engine.elastic = 0.0;
  engine.happens = [](FakeBlast& e) { e.quit = e.now > 0.085; };
  EXPECT_EQ(go(plan(), engine), Phase::interrupted);
  const std::vector<std::string> expected{"prepare wave_and_gas", "set up", "snapshots 10", "run 5",
                                          "run 5"};
  EXPECT_EQ(engine.told, expected);
}

TEST(BlastRun, GoesOnWhileGasIsWaitedFor) {
  FakeBlast engine;
  engine.now = 0.2;
  engine.joints = 0.1;
  engine.at_rest = true;
  BlastPlan gassy = plan();
  gassy.gas = Gas::in_joints;
  EXPECT_EQ(go(gassy, engine), Phase::rest);
  EXPECT_NEAR(engine.now, 0.2 + 0.005 + 0.1, 1e-9);  // a look at the gas, a lap
}

TEST(BlastRun, TakesNoStepAfterASignal) {
  for (const double at : {0.01, 0.05, 0.11, 0.3}) {  // wave, push, gas, throw
    FakeBlast engine;
    engine.on_walls = 1e6;
    BlastPlan venting = plan();
    venting.gas = Gas::in_holes;
    long runs_after = 0;
    engine.happens = [&](FakeBlast& e) {
      if (e.quit) ++runs_after;
      e.quit = e.now >= at;
      if (e.now > 0.2) e.on_walls = 0.0;
    };
    EXPECT_EQ(go(venting, engine), Phase::interrupted);
    EXPECT_EQ(runs_after, 0);
    for (const std::string& line : engine.lines)
      EXPECT_EQ(line.find("time_end"), std::string::npos);
  }
}

TEST(BlastRun, LeavesBlocksAwakeWhereNoneMaySleep) {
  FakeBlast engine;
  engine.at_rest = true;
  BlastPlan sleepless = plan();
  sleepless.sleep = false;
  EXPECT_EQ(go(sleepless, engine), Phase::rest);
  EXPECT_FALSE(engine.was_told("sleep"));
}

TEST(BlastRun, RefusesJointsThatAreSofterAlready) {
  FakeBlast engine;
  engine.joints = 1e-4;
  try {
    (void)go(plan(), engine);
    FAIL() << "not refused";
  } catch (const InputError& refused) {
    EXPECT_STREQ(refused.what(),
                 "run_blast: softening must be <= 0.0001, to which the joints have been softened "
                 "already, got 0.0002; joints cannot become stiffer again");
  }
  EXPECT_EQ(engine.steps, 0);
}

}  // namespace
}  // namespace muckpile
