// SPDX-License-Identifier: GPL-2.0-or-later
// run_blast: checks, and start of the phases.
// Scope: see the header.
#include "fixes/run/run_blast.h"

#include <comm.h>
#include <domain.h>
#include <error.h>
#include <force.h>
#include <modify.h>
#include <pair.h>

#include <string>

#include "args/input_error.h"
#include "explosive/energy_audit.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/blast_energies.h"
#include "fixes/interfaces/block_contact_view.h"
#include "fixes/interfaces/charge_timing.h"
#include "fixes/interfaces/joint_pressure.h"
#include "fixes/interfaces/rock_view.h"
#include "fixes/run/script_engine.h"
#include "fixes/run/script_rock.h"
#include "run/blast_plan.h"
#include "run/blast_run.h"

namespace muckpile {

void RunBlastCommand::command(int narg, char** arg) {
  if (domain->box_exist == 0) engine::stop(*lmp, std::string(kStyle) + ": needs blocks before it");
  const ArgValues words = engine::read_args(*lmp, run_blast_table(), kStyle, narg, arg, 0);
  const BlastScene found = scene();
  if (words.word("end") == "rest") warn_without_gravity();
  engine::or_engine_error(*lmp, [&] {
    const BlastPlan plan = blast_plan(words, found, kStyle);
    engine::find_view<ChargeTiming>(*lmp)->expect_step(plan.pulse_step);
    ScriptEngine script(lmp, kStyle, words);
    ScriptRock rock(lmp, words.real("sleep_distance"));
    if (BlastRun(plan, script, rock, kStyle).go() == BlastRun::Phase::interrupted)
      ScriptEngine::note_cut();
    return 0;
  });
  warn_of_missing_energy();
}

void RunBlastCommand::warn_of_missing_energy() const {
  const auto* blast = engine::find_view<BlastEnergies>(*lmp);
  if (blast == nullptr) return;
  const std::string missing = warning_of_missing(blast->audit());
  if (!missing.empty() && comm->me == 0)
    error->warning(FLERR, (std::string(kStyle) + ": " + missing).c_str());
}

void RunBlastCommand::warn_without_gravity() const {
  if (comm->me == 0 && modify->find_fix_style_strict("gravity", 0) == nullptr)
    error->warning(FLERR, "run_blast: no fix gravity before it: what is thrown stays in the air");
}

/// The styles of the script, of which each has its own part of it.
BlastScene RunBlastCommand::scene() const {
  const auto find = [this](const char* style) { return modify->find_fix_style_strict(style, 0); };
  const auto* rock = dynamic_cast<const RockView*>(find("muckpile/joint"));
  const auto* charges = dynamic_cast<const ChargeTiming*>(find("muckpile/blast"));
  const auto* contacts = dynamic_cast<const BlockContactView*>(force->pair);
  const auto need = [this](bool there, const char* style) {
    if (!there) engine::stop(*lmp, std::string(kStyle) + ": needs a " + style + " before it");
  };
  need(rock != nullptr, "fix muckpile/joint");
  need(charges != nullptr, "fix muckpile/blast");
  need(contacts != nullptr && contacts->hertz_contacts().has_value(),
       "pair_style muckpile/block with model hertz");
  BlastScene found{charges->timing(), rock->rock(), *contacts->hertz_contacts()};
  if (const auto* gas = dynamic_cast<const JointPressure*>(find("muckpile/gas"))) {
    found.gas = Gas::in_joints;
    found.gas_step = gas->longest_step();
  } else if (charges->vents_by_flow()) {
    found.gas = Gas::in_holes;
  }
  return found;
}

}  // namespace muckpile
