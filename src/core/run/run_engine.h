// SPDX-License-Identifier: GPL-2.0-or-later
// What the phases of a run ask of the engine that takes the steps, and tell it.
// Scope: an interface only; fixes/run implements it on LIGGGHTS, tests on a fake. With several
// ranks every call is made by all of them and answered alike.
#pragma once

#include <optional>
#include <string>

namespace muckpile {

/// A phase, for those who watch the run.
struct PhaseNews {
  std::string name;
  double ends = 0.0;     ///< at the latest [s]
  long lines_every = 1;  ///< steps between two lines on the screen
};

/// How long the time step may be.
struct StepRule {
  double share = 1.0;                   ///< of the longest that joints and contacts bear [-]
  std::optional<double> longest{};      ///< [s]
  std::optional<double> collision{};    ///< that resolves a collision [s]
  double collision_speed = 0.0;         ///< of it [m/s]: follows the fastest block; 0: fixed
  std::optional<long> contact_every{};  ///< steps from one act of the contacts to the next, at most
};

class RunEngine {
 public:
  virtual ~RunEngine() = default;

  [[nodiscard]] virtual double time() const = 0;  ///< [s]
  [[nodiscard]] virtual double step() const = 0;  ///< present time step [s]
  [[nodiscard]] virtual bool still() const = 0;   ///< the rock has come to rest
  /// A signal has asked the engine to end: no further step is taken.
  [[nodiscard]] virtual bool interrupted() const = 0;

  /// Makes what the run needs and a user's script has not; before the first step.
  virtual void prepare(const PhaseNews& first, const StepRule& rule) = 0;
  /// Takes over what has changed, without a step.
  virtual void set_up() = 0;
  /// `afresh`: with a set-up, at which the ranks share the blocks anew.
  virtual void run(long steps, bool afresh) = 0;
  virtual void bound_step(const StepRule& rule) = 0;
  /// Beside the rule, until the next cap: the step does not become longer than that [s].
  virtual void cap_step(double longest) = 0;
  virtual void begin_phase(const PhaseNews& news) = 0;
  virtual void take_snapshots_every(long steps) = 0;
  virtual void say(const std::string& line) = 0;
  virtual void warn(const std::string& line) = 0;
};

}  // namespace muckpile
