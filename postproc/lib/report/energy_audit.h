// SPDX-License-Identifier: GPL-2.0-or-later
// Where the explosive's energy is at the end of a run, by the terms of its audit.
// Scope: energy_audit_J of run.json.
#pragma once

#include <string>
#include <vector>

#include "io/result_folder.h"

namespace muckpile {

struct AuditTerm {
  std::string key, label;
  double energy;  // [J]
  double share;   // of the explosive's energy
};

// In the order in which they are drawn; nothing where no charge has fired or the run has no audit.
std::vector<AuditTerm> energy_audit(const ResultFolder& folder);
// What all of them, one at least, leave of the explosive's energy; below 0: they are more.
AuditTerm missing_of(const std::vector<AuditTerm>& audit);

}  // namespace muckpile
