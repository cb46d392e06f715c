// SPDX-License-Identifier: GPL-2.0-or-later
// At which steps contacts act where the step of a run is far shorter than they need, and how
// strongly: n times their force at every n-th step.
// Scope: counts of steps and times. Multiple time stepping by impulses (Tuckerman, Berne & Martyna
// 1992, J. Chem. Phys. 97:1990-2001): for the contacts it is the leapfrog of the longer step, and
// two blocks still get opposite kicks.
#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>

#include "state/encoding.h"

namespace muckpile {

class ContactPace {
 public:
  /// What a restart file holds.
  struct State {
    int every = 1;          ///< steps from one act to the next
    double strength = 1.0;  ///< of the last act, or of a run's first set-up [-]
    double gap = 0.0;       ///< since then [s]
  };
  /// Of a step.
  struct Act {
    double strength = 0.0;  ///< times their force [-]; 0: they do not act
    double elapsed = 0.0;   ///< since they acted last [s]
  };

  /// From the next step on. 1: at each, with their force.
  void act_every(int steps) { state_.every = steps; }
  [[nodiscard]] int every() const { return state_.every; }

  /// Takes the run one step on, to step `now` over `step` [s]. Acts are at steps 1, 1 + every, ...,
  /// and each stands for half of the gap before it and half of the one to come.
  [[nodiscard]] Act go_on(std::int64_t now, double step) {
    state_.gap += step;
    if ((now - 1) % state_.every != 0) return {};
    const double elapsed = state_.gap, ahead = state_.every * step;
    state_ = {state_.every, 0.5 * (elapsed + ahead) / step, 0.0};
    return {state_.strength, elapsed};
  }
  /// Of the present step once more: a run begins there.
  [[nodiscard]] double strength() const { return state_.gap == 0.0 ? state_.strength : 0.0; }

  [[nodiscard]] const State& state() const { return state_; }
  void resume(const State& state) { state_ = state; }

 private:
  State state_;
};

template <>
struct Stored<ContactPace::State> {
  static constexpr std::string_view kName = "contact_pace";
  static constexpr int kVersion = 1;
  static auto fields(auto& pace) { return std::tie(pace.every, pace.strength, pace.gap); }
};

}  // namespace muckpile
