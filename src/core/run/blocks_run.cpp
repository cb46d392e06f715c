// SPDX-License-Identifier: GPL-2.0-or-later
// One phase of a scene without charges.
// Scope: see the header.
#include "run/blocks_run.h"

#include <algorithm>

#include "args/numbers.h"
#include "run/phase_name.h"

namespace muckpile {
namespace {

constexpr const char* kStill = "still";

}  // namespace

ArgTable run_blocks_table() {
  ArgTable table("run_blocks");
  table
      .word("phase", {}, "run",
            "name of the phase, for screen and history.csv; without commas and quotes")
      .word("until", {}, kStill,
            "end of the phase on the clock of the run [s], > 0 and <= 1000; still: when the rock "
            "rests");
  add_end_words(table);
  table.real("density", "kg/m3", Range::closed(500.0, 10000.0), {},
             "as in create_blocks, for the step of loose blocks");
  add_collision_words(table);
  return table;
}

BlocksPlan blocks_plan(const ArgValues& words, const BlockContacts& contacts,
                       const std::string& where) {
  BlocksPlan plan;
  plan.phase = phase_name(where, "phase", words.word("phase"));
  const std::string& until = words.word("until");
  if (until != kStill)
    plan.until = parse_real(where, "until", until, "s", Range::left_open(0.0, 1000.0));
  plan.time_end = words.real("time_end");
  plan.still_share = words.real("still_share");
  plan.stable_share = words.real("stable_share");
  plan.collision = collision_step(words, words.real("density"), contacts);
  return plan;
}

LapsEnd BlocksRun::go() {
  if (engine_.interrupted()) {
    engine_.say("interrupted: before the first step of phase " + plan_.phase);
    return LapsEnd::interrupted;
  }
  const double end = std::min(plan_.until.value_or(plan_.time_end), plan_.time_end);  // [s]
  begin(end);
  const LapsEnd how = run_laps(engine_, end, !plan_.until);
  if (!plan_.until && how != LapsEnd::interrupted) tell_of_rest(engine_, plan_.still_share);
  return how;
}

void BlocksRun::begin(double end) {
  const PhaseNews news{plan_.phase, end, 1000};
  engine_.prepare(news, {.share = plan_.stable_share});
  engine_.begin_phase(news);
  // The step of a fast collision throughout: at rest in the air nothing else bounds it.
  engine_.bound_step(
      {.share = plan_.stable_share, .longest = 1e30, .collision = plan_.collision.step});
  engine_.set_up();
  engine_.take_snapshots_every(kNoSnapshots);
}

}  // namespace muckpile
