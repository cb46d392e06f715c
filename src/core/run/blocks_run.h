// SPDX-License-Identifier: GPL-2.0-or-later
// Takes a scene without charges through one phase: to a time, or until the rock is still.
// Scope: the words of run_blocks, and when its phase ends. The end is a time on the clock of the
// run, so that a script goes on after a restart file where it was.
#pragma once

#include <optional>
#include <string>

#include "args/parse_args.h"
#include "run/run_engine.h"
#include "run/run_laps.h"
#include "run/run_words.h"

namespace muckpile {

[[nodiscard]] ArgTable run_blocks_table();

struct BlocksPlan {
  std::string phase = "run";      ///< for screen and history.csv
  std::optional<double> until{};  ///< end of the phase [s]; without: when the rock is still
  double time_end = 0.0;          ///< the run ends then at the latest [s]
  double still_share = 0.0;       ///< of the mass, that may still move at rest [-]
  double stable_share = 1.0;      ///< step over the longest stable one [-]
  CollisionStep collision{};
};

/// `where` starts every message; InputError where `until` is no time.
[[nodiscard]] BlocksPlan blocks_plan(const ArgValues& words, const BlockContacts& contacts,
                                     const std::string& where);

class BlocksRun {
 public:
  BlocksRun(const BlocksPlan& plan, RunEngine& engine) : plan_(plan), engine_(engine) {}

  LapsEnd go();

 private:
  void begin(double end);

  BlocksPlan plan_;
  RunEngine& engine_;
};

}  // namespace muckpile
