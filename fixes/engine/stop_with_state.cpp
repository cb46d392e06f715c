// SPDX-License-Identifier: GPL-2.0-or-later
// Ends a run that has gone wrong, and leaves its state where a fix knows a place for it.
// Scope: see the header.
#include "fixes/engine/stop_with_state.h"

#include <fix.h>
#include <lammps.h>
#include <modify.h>
#include <update.h>

#include "args/numbers.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/state_writer.h"

namespace muckpile::engine {

void stop_with_state(LAMMPS_NS::LAMMPS& lmp, const std::string& why) {
  for (int i = 0; i < lmp.modify->nfix; ++i) {
    if (auto* writer = dynamic_cast<StateWriter*>(lmp.modify->fix[i]))
      stop(lmp, why + ". State written to " + writer->write_state());
  }
  stop(lmp, why);
}

std::string at_present(const LAMMPS_NS::LAMMPS& lmp) {
  return " at step " + std::to_string(lmp.update->ntimestep) +
         ", t = " + number_text(lmp.update->get_cur_time()) + " s";
}

}  // namespace muckpile::engine
