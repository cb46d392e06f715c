// SPDX-License-Identifier: GPL-2.0-or-later
// What the phases of a blast ask of the engine that computes them, and tell it.
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
  double share = 1.0;                 ///< of the longest that joints and contacts bear [-]
  std::optional<double> longest{};    ///< [s]
  std::optional<double> collision{};  ///< that resolves a collision [s]
  double collision_speed = 0.0;       ///< of it [m/s]: follows the fastest block; 0: fixed
};

class BlastEngine {
 public:
  virtual ~BlastEngine() = default;

  [[nodiscard]] virtual double time() const = 0;  ///< [s]
  [[nodiscard]] virtual double step() const = 0;  ///< present time step [s]
  /// Stiffness of the joints over that at the start [-]; 1 until they are softened.
  [[nodiscard]] virtual double stiffness() const = 0;
  [[nodiscard]] virtual double elastic_energy() const = 0;  ///< of the joints [J]
  [[nodiscard]] virtual double kinetic_energy() const = 0;  ///< [J]
  [[nodiscard]] virtual double blast_work() const = 0;      ///< done on the rock so far [J]
  [[nodiscard]] virtual double wall_pressure() const = 0;   ///< greatest on a hole's wall [Pa]
  [[nodiscard]] virtual double joint_pressure() const = 0;  ///< of gas in any joint, or 0 [Pa]
  [[nodiscard]] virtual bool still() const = 0;             ///< the rock has come to rest
  /// A signal has asked the engine to end: no further step is taken.
  [[nodiscard]] virtual bool interrupted() const = 0;

  /// Makes what the run needs and a user's script has not; before the first step.
  virtual void prepare(const PhaseNews& first, const StepRule& rule) = 0;
  /// Takes over what has changed, without a step.
  virtual void set_up() = 0;
  /// `afresh`: with a set-up, at which the ranks share the blocks anew.
  virtual void run(long steps, bool afresh) = 0;
  virtual void bound_step(const StepRule& rule) = 0;
  /// Multiplies the stiffness of the joints; `damping` of closed ones as a share of the softer
  /// rock's impedance [-].
  virtual void soften(double factor, std::optional<double> damping) = 0;
  virtual void begin_phase(const PhaseNews& news) = 0;
  virtual void take_snapshots_every(long steps) = 0;
  virtual void let_blocks_rest() = 0;  ///< blocks at rest are left alone from now on
  virtual void say(const std::string& line) = 0;
  virtual void warn(const std::string& line) = 0;
};

}  // namespace muckpile
