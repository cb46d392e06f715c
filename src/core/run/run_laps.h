// SPDX-License-Identifier: GPL-2.0-or-later
// Steps of a run: to a time, or in laps until the rock is still.
// Scope: what the phases of all runs share.
#pragma once

#include "run/run_engine.h"

namespace muckpile {

constexpr long kNoSnapshots = 1000000;  ///< steps between snapshots: each run ends with one

/// Steps from now until `time` [s]. 0 or less: the time has come, or it has but for rounding.
[[nodiscard]] long steps_until(const RunEngine& engine, double time);
/// Steps that last at least `duration` [s], but for rounding; 1 or more.
[[nodiscard]] long steps_of(const RunEngine& engine, double duration);
/// One run towards `end` [s], which is still to come: it lasts about `duration` [s], and less where
/// the step is expected to grow by `growth`. However it grows, the run does not pass the end by
/// more than a step: near the end the step is kept short enough for that.
void run_towards(RunEngine& engine, double end, double duration, double growth = 1.0,
                 bool afresh = false);

enum class LapsEnd { still, time, interrupted };

/// Laps of 0.1 s until `end` [s]; with `to_rest` the rock may be still after each, which ends them.
/// The first of every four begins with a set-up, at which the ranks share the blocks anew.
LapsEnd run_laps(RunEngine& engine, double end, bool to_rest);

/// That the rock rests; or that time is over and more than `still_share` [-] of it moves.
void tell_of_rest(RunEngine& engine, double still_share);

}  // namespace muckpile
