// SPDX-License-Identifier: GPL-2.0-or-later
// Energy of the charges, term by term; see the header.
#include "explosive/energy_audit.h"

#include <algorithm>
#include <cmath>

#include "args/rounded_text.h"

namespace muckpile {

const std::array<EnergyAudit::Term, 12> EnergyAudit::kTerms = {
    {{"explosive", &EnergyAudit::explosive},
     {"not_released", &EnergyAudit::not_released},
     {"filling", &EnergyAudit::filling},
     {"crushing", &EnergyAudit::crushing},
     {"wall_work", &EnergyAudit::wall_work},
     {"joint_work", &EnergyAudit::joint_work},
     {"air_work", &EnergyAudit::air_work},
     {"rock_heat", &EnergyAudit::rock_heat},
     {"in_holes", &EnergyAudit::in_holes},
     {"in_joints", &EnergyAudit::in_joints},
     {"vented", &EnergyAudit::vented},
     {"stemming", &EnergyAudit::stemming}}};

EnergyAudit& EnergyAudit::operator+=(const EnergyAudit& more) {
  for (const Term& term : kTerms) this->*term.value += more.*term.value;
  return *this;
}

std::string warning_of_missing(const EnergyAudit& audit) {
  if (std::abs(audit.error()) <= kEnergyCloses * audit.explosive) return "";  // not where it is NaN
  const auto percent = [&](double energy) {
    return rounded_text(100.0 * energy / audit.explosive, 3) + " %";
  };
  return "the audit of the explosive's energy misses " + percent(audit.error()) +
         " of it and should close to " + rounded_text(100.0 * kEnergyCloses) +
         " %; wave and gas have done work of " + percent(audit.wall_work + audit.joint_work) +
         ". Where rock or joints are soft a shorter longest_step of fix muckpile/gas brings it "
         "down (inputs: -var gas_step)";
}

EnergyAudit audit_of_hole(const BlastLoad& load, double explosive, double in_hole,
                          const GasState& gas, const HoleBooks& books, double ambient) {
  const BlastLoad::StartEnergies start = load.start_energies();
  EnergyAudit audit;
  if (!(start.products > 0.0)) return audit;  // a pulse alone has no products
  audit.explosive = explosive > 0.0 ? explosive : start.products;
  audit.not_released = audit.explosive - start.products;
  audit.filling = start.filling;
  audit.wall_work = books.wall_work;
  audit.air_work = ambient * books.air_volume;
  audit.crushing =
      std::max(0.0, start.dense - (books.wall_work + audit.air_work - books.expansion));
  audit.in_holes = in_hole;
  // What is in joints now is booked there.
  audit.vented = gas.vented_energy + books.let_go;
  audit.stemming = gas.stemming_work;
  return audit;
}

}  // namespace muckpile
