// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/progress: warnings of rock in the ground, and of rock that has left.
// Scope: each once; the counts are the same on all ranks.
#include <comm.h>
#include <error.h>

#include <algorithm>
#include <limits>
#include <string>

#include "args/numbers.h"
#include "args/rounded_text.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/run/fix_muckpile_progress.h"

namespace muckpile {

void FixMuckpileProgress::warn_of_solid(const RunLook& now) {
  if (now.in_solid == 0.0 || warned_of_solid_) return;
  warned_of_solid_ = true;
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  int mine = std::numeric_limits<int>::max();
  for (int b = 0; b < bodies.count(); ++b)
    if (has_entered_solid(bodies, b)) mine = std::min(mine, bodies.tag(b));
  const int first = engine::least_over_ranks(mine, world);
  if (comm->me != 0) return;
  error->warning(
      FLERR, (where_ + ": blocks in region '" + solid_ +
              "', where no rock can be: " + number_text(now.in_solid) + ", block " +
              std::to_string(first) + " first, at t = " + number_text(now.time) +
              " s. No wall stops them, and they spoil what is measured of the pile; stop them with "
              "fix muckpile/ground, or with a larger contact modulus")
                 .c_str());
}

void FixMuckpileProgress::warn_of_gone(const RunLook& now) {
  if (now.gone == 0.0 || warned_of_gone_) return;
  warned_of_gone_ = true;
  if (comm->me != 0) return;
  error->warning(FLERR, (where_ + ": rock has left the scene, region '" + scene_ +
                         "': " + number_text(now.gone) + " blocks of " +
                         rounded_text(now.gone_mass) + " kg at t = " + rounded_text(now.time) +
                         " s. They may lie beyond the ground or fall for ever, and what is "
                         "measured of the pile has them; run.json counts them")
                            .c_str());
}

}  // namespace muckpile
