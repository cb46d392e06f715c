// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts that act at every n-th step, n times as strongly.
// Scope: the counting, and what it makes of a spring; contacts themselves in
// tests/styles/pair_muckpile_block.
#include <gtest/gtest.h>

#include <cstdint>

#include "contact/contact_pace.h"

namespace muckpile {
namespace {

TEST(ContactPace, AtEachStepChangesNothing) {
  ContactPace pace;
  std::int64_t now = 0;
  EXPECT_EQ(pace.strength(), 1.0);  // a run begins
  for (const double step : {1e-5, 1e-5, 3e-5, 7e-6, 7e-6}) {
    const ContactPace::Act act = pace.go_on(++now, step);
    EXPECT_EQ(act.strength, 1.0);
    EXPECT_EQ(act.elapsed, step);
    EXPECT_EQ(pace.strength(), 1.0);
  }
}

TEST(ContactPace, ActsForTheStepsBetween) {
  ContactPace pace;
  pace.act_every(4);
  for (std::int64_t now = 1; now <= 12; ++now) {
    const ContactPace::Act act = pace.go_on(now, 0.5);
    const bool acts = now % 4 == 1,
               first = now == 1;  // half of one step before, and of four to come
    EXPECT_EQ(act.strength, first ? 2.5 : acts ? 4.0 : 0.0) << now;
    EXPECT_EQ(act.elapsed, first ? 0.5 : acts ? 2.0 : 0.0) << now;
    EXPECT_EQ(pace.strength(), act.strength) << now;  // a run that begins there
  }
}

/// A run that begins where contacts did not act leaves it so, whatever the pace is then; the next
/// act makes up for all of the gap.
TEST(ContactPace, GapIsMadeUpForAfterAChangeOfPace) {
  ContactPace pace;
  pace.act_every(8);
  for (std::int64_t now = 1; now <= 14; ++now) (void)pace.go_on(now, 1e-5);  // acts at 1 and 9
  pace.act_every(1);
  EXPECT_EQ(pace.strength(), 0.0);
  EXPECT_NEAR(pace.go_on(15, 1e-5).strength, 0.5 * (6.0 + 1.0), 1e-12);
  EXPECT_EQ(pace.go_on(16, 1e-5).strength, 1.0);
}

/// A spring that acts at every eighth of steps dt moves as in the leapfrog of steps 8 dt: the same
/// to rounding at each act, and bounded for as long as that is.
TEST(ContactPace, IsTheLeapfrogOfTheLongerStep) {
  constexpr int kEvery = 8;
  constexpr double kStiffness = 1.0, kStep = 0.2;  // over the mass [1/s2]; long step 1.6 of 2 s
  ContactPace pace;
  pace.act_every(kEvery);
  double x = 1.0, v = 0.3, long_x = x + kStep * v, long_v = v;
  for (std::int64_t now = 1; now <= 8000; ++now) {
    x += kStep * v;
    const bool acts = (now - 1) % kEvery == 0;
    if (acts && now > 1) long_x += kEvery * kStep * long_v;
    const double kick = pace.go_on(now, kStep).strength * kStep * kStiffness;
    v -= kick * x;
    if (!acts) continue;
    long_v -= (now == 1 ? kick : kEvery * kStep * kStiffness) * long_x;
    ASSERT_NEAR(x, long_x, 1e-9) << now;
    ASSERT_NEAR(v, long_v, 1e-9) << now;
  }
  EXPECT_LT(x * x, 10.0);
}

/// Whatever step and pace do on the way, the kicks last as long as the run, but for half a gap.
TEST(ContactPace, KicksLastAsLongAsTheRun) {
  ContactPace pace;
  std::int64_t now = 0;
  double time = 0.0, kicks = 0.0, gap = 0.0;
  const auto run = [&](int every, double step, int steps) {
    pace.act_every(every);
    gap = every * step;
    for (int k = 0; k < steps; ++k) {
      time += step;
      kicks += pace.go_on(++now, step).strength * step;
    }
    EXPECT_NEAR(kicks, time, gap) << every << " steps of " << step;
  };
  run(1, 1e-5, 7);
  run(16, 1e-5, 103);
  run(4, 4e-5, 30);
  run(1, 7e-4, 5);
  run(16, 1e-5, 5);
}

TEST(ContactPace, GoesOnFromWhatWasKept) {
  ContactPace first;
  first.act_every(8);
  std::int64_t now = 0;
  while (now < 13) (void)first.go_on(++now, 1e-5);
  ContactPace second;
  second.resume(first.state());
  while (now < 40) {
    const ContactPace::Act one = first.go_on(++now, 2e-5), other = second.go_on(now, 2e-5);
    EXPECT_EQ(one.strength, other.strength);
    EXPECT_EQ(one.elapsed, other.elapsed);
  }
}

}  // namespace
}  // namespace muckpile
