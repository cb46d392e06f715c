// SPDX-License-Identifier: GPL-2.0-or-later
// The energies of a run over time, from its dump/history.csv, in the groups that are drawn.
// Scope: rows at the start (time 0) included; what each column means:
// docs/styles/fix_muckpile_ledger.md.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace muckpile {

struct EnergyGroup {
  std::string name;
  bool source;                 // counts as put in, not as stored or lost
  std::vector<double> energy;  // per row [J]
};

struct EnergyHistory {
  std::vector<double> time;  // per row [s]
  std::vector<EnergyGroup> groups;

  // Put in less stored and lost, less its value in the first row [J].
  [[nodiscard]] std::vector<double> missing() const;
};

// Throws InputError, naming file and line, if a row is malformed or there is none.
EnergyHistory read_energies(const std::filesystem::path& path);

}  // namespace muckpile
