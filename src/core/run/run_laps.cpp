// SPDX-License-Identifier: GPL-2.0-or-later
// Steps of a run: to a time, or in laps until the rock is still.
// Scope: see the header.
#include "run/run_laps.h"

#include <algorithm>
#include <cmath>

#include "args/rounded_text.h"

namespace muckpile {
namespace {

constexpr double kLap = 0.1;           // s, from one check of rest to the next
constexpr int kLapsASetUp = 4;         // the ranks share the blocks anew at every fourth
constexpr double kFirstGrowth = 2.0;   // of a step that has been let loose
constexpr double kMostSteps = 1e9;     // of one run: the engine counts them in an int
constexpr double kMostGrowth = 100.0;  // a step that has to grow by more to pass the end is let be
constexpr double kAnyStep = 1e30;      // s

/// The next whole number, but for rounding; what is beyond any run is left to the next one.
long whole_steps(double steps) {
  return static_cast<long>(std::min(std::ceil(steps - 1e-6), kMostSteps));
}

}  // namespace

long steps_until(const RunEngine& engine, double time) {
  return whole_steps((time - engine.time()) / engine.step());
}

long steps_of(const RunEngine& engine, double duration) {
  return std::max(1L, whole_steps(duration / engine.step()));
}

void run_towards(RunEngine& engine, double end, double duration, double growth, bool afresh) {
  const auto left = static_cast<double>(steps_until(engine, end));
  const long steps =
      std::min(std::lround(std::ceil(left / std::max(growth, 1.0))), steps_of(engine, duration));
  const double longest = (end - engine.time()) / static_cast<double>(steps);  // of them [s]
  const bool near = longest < kMostGrowth * engine.step();
  if (near) engine.cap_step(std::max(longest, engine.step()));
  engine.run(steps, afresh);
  if (near) engine.cap_step(kAnyStep);
}

LapsEnd run_laps(RunEngine& engine, double end, bool to_rest) {
  double growth = kFirstGrowth;
  for (int lap = 0;; lap = (lap + 1) % kLapsASetUp) {
    if (steps_until(engine, end) <= 0) return LapsEnd::time;
    const double begun = engine.time(), step = engine.step();
    run_towards(engine, end, kLap, growth, lap == 0);
    growth = engine.step() / step;
    if (to_rest && engine.still() && engine.time() > begun) return LapsEnd::still;
    // A signal behind the last step has left nothing out.
    if (engine.interrupted() && steps_until(engine, end) > 0) return LapsEnd::interrupted;
  }
}

void tell_of_rest(RunEngine& engine, double still_share) {
  const std::string after = " after " + rounded_text(engine.time()) + " s of physical time";
  engine.say(engine.still() ? "The rock rests" + after + "."
                            : "time_end is reached" + after + "; more than still_share " +
                                  rounded_text(still_share) + " of the rock still moves.");
}

}  // namespace muckpile
