// SPDX-License-Identifier: GPL-2.0-or-later
// Ends a run that has gone wrong, and leaves its state where a fix knows a place for it.
// Scope: see the header.
#include "fixes/engine/stop_with_state.h"

#include <lammps.h>
#include <update.h>

#include "args/numbers.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/state_writer.h"

namespace muckpile::engine {

void stop_with_state(LAMMPS_NS::LAMMPS& lmp, const std::string& why) {
  if (auto* writer = find_view<StateWriter>(lmp))
    stop(lmp, why + ". State written to " + writer->write_state());
  stop(lmp, why);
}

std::string at_present(const LAMMPS_NS::LAMMPS& lmp) {
  return " at step " + std::to_string(lmp.update->ntimestep) +
         ", t = " + number_text(lmp.update->get_cur_time()) + " s";
}

}  // namespace muckpile::engine
