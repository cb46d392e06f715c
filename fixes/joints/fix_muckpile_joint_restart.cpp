// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint in restart files: what it has added up and how soft the rock is.
// Scope: facets and what they remember are fix muckpile/blocks' part.
#include <comm.h>
#include <modify.h>

#include <array>

#include "args/rounded_text.h"
#include "bond/network/stored_network.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/joints/fix_muckpile_joint.h"

namespace muckpile {
namespace {

/// Those of `totals` that are sums over ranks.
std::array<double*, 8> sums_of(NetworkTotals& totals) {
  return {&totals.losses.fracture, &totals.losses.friction, &totals.losses.crushing,
          &totals.losses.damping,  &totals.losses.quiet,    &totals.losses.radiated,
          &totals.pressure_work,   &totals.wave_work};
}

}  // namespace

void FixMuckpileJoint::write_restart(FILE* file) {
  NetworkTotals totals = network_.totals(team());
  for (double* mine : sums_of(totals)) *mine = sum(*mine);
  engine::write_state(*lmp, style, file, totals);
  network_.derive_anew();  // as the run that reads the file will
}

void FixMuckpileJoint::restart(char* state) {
  auto totals = engine::read_state<NetworkTotals>(*lmp, style, state);
  for (double* all : sums_of(totals)) *all = engine::share_of_total(*lmp, *all);
  network_.resume(totals);
}

/// Rock that an earlier fix has softened stays so: what its facets remember is of that stiffness.
void FixMuckpileJoint::go_on_as_soft(const RockSoftness& found) {
  if (found == network_.softness()) return;  // as it was given, or in its own restart data
  NetworkTotals totals;
  totals.softened = found.factor;
  totals.damping = found.damping;
  totals.softer_since = true;
  network_.resume(totals);
  engine::print_once(*lmp, engine::name_of(*this) + ": goes on with joints that were softened to " +
                               rounded_text(found.factor) + " of their stiffness\n");
}

/// What a fix of the run before did to the joints ends, as at an unfix, if it is not here again.
void FixMuckpileJoint::end_what_does_not_go_on() {
  if (!store_->restored() || goes_on_) return;
  goes_on_ = true;
  const auto gone = [this](const char* other) {
    return modify->find_fix_style_strict(other, 0) == nullptr;
  };
  if (gone("muckpile/quiet")) network_.stop_ground();
  if (gone("muckpile/gas")) network_.release_gas();
  if (!gone("muckpile/blast")) return;
  network_.take_off_pressures(true);
  network_.expect_pressure(false);
}

}  // namespace muckpile
