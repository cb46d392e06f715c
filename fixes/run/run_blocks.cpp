// SPDX-License-Identifier: GPL-2.0-or-later
// run_blocks: checks, and start of the phase.
// Scope: see the header.
#include "fixes/run/run_blocks.h"

#include <domain.h>
#include <force.h>
#include <pair.h>

#include <string>

#include "fixes/engine/style_args.h"
#include "fixes/interfaces/block_contact_view.h"
#include "fixes/run/script_engine.h"
#include "run/blocks_run.h"

namespace muckpile {

void RunBlocksCommand::command(int narg, char** arg) {
  if (domain->box_exist == 0) engine::stop(*lmp, std::string(kStyle) + ": needs blocks before it");
  const ArgValues words = engine::read_args(*lmp, run_blocks_table(), kStyle, narg, arg, 0);
  const auto* contacts = dynamic_cast<const BlockContactView*>(force->pair);
  if (contacts == nullptr || !contacts->hertz_contacts()) {
    engine::stop(*lmp, std::string(kStyle) +
                           ": needs a pair_style muckpile/block with model hertz before it");
  }
  engine::or_engine_error(*lmp, [&] {
    const BlocksPlan plan = blocks_plan(words, *contacts->hertz_contacts(), kStyle);
    ScriptEngine script(lmp, kStyle, words);
    if (BlocksRun(plan, script).go() == LapsEnd::interrupted) ScriptEngine::note_cut();
    return 0;
  });
}

}  // namespace muckpile
