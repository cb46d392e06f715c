// SPDX-License-Identifier: GPL-2.0-or-later
// An engine that only keeps time and notes what it is told.
// Scope: RunEngine for tests; `after_run` sets the state after each run, `after_step` after
// each step.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "run/run_engine.h"

namespace muckpile::test {

/// Steps of one millisecond.
class FakeEngine : public RunEngine {
 public:
  double now = 0.0, dt = 1e-3, cap = 1e30;
  bool at_rest = false, quit = false;
  std::function<void()> after_run = [] {};
  std::function<void()> after_step;  ///< none: all steps of a run are alike
  std::vector<std::string> told, lines, warnings;
  StepRule rule{};  ///< the last one
  long steps = 0;

  double time() const override { return now; }
  double step() const override { return dt; }
  bool still() const override { return at_rest; }
  bool interrupted() const override { return quit; }

  void prepare(const PhaseNews& first, const StepRule&) override {
    told.push_back("prepare " + first.name);
  }
  void set_up() override { told.push_back("set up"); }
  void run(long count, bool afresh) override {
    EXPECT_GT(count, 0);
    told.push_back((afresh ? "run afresh " : "run ") + std::to_string(count));
    steps += count;
    pass(count);
    after_run();
  }
  void bound_step(const StepRule& bound) override {
    rule = bound;
    told.push_back(rule.collision ? "step for collisions"
                                  : (*rule.longest < 1.0 ? "step for pulse" : "step for joints"));
  }
  void cap_step(double longest) override { cap = longest; }
  void begin_phase(const PhaseNews& news) override { told.push_back("phase " + news.name); }
  void take_snapshots_every(long count) override {
    told.push_back("snapshots " + std::to_string(count));
  }
  void say(const std::string& line) override { lines.push_back(line); }
  void warn(const std::string& line) override { warnings.push_back(line); }

  void pass(long count) {
    if (!after_step) now += static_cast<double>(count) * dt;
    for (long k = 0; after_step && k < count; ++k) {
      now += dt;
      after_step();
      dt = std::min(dt, cap);
    }
  }
  [[nodiscard]] bool was_told(const std::string& what) const {
    return std::ranges::find(told, what) != told.end();
  }
};

}  // namespace muckpile::test
