// SPDX-License-Identifier: GPL-2.0-or-later
// The energies of a run over time, from its dump/history.csv.
// Scope: see the header.
#include "io/energy_history.h"

#include <array>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

struct Columns {
  const char* name;
  bool source;
  std::array<const char*, 2> of;  // nullptr: none
};

// A group whose columns the file lacks is left out: files without quiet boundaries are older.
constexpr Columns kGroups[] = {{"blast work", true, {"blast_work_J", nullptr}},
                               {"given by block_motion", true, {"given_J", nullptr}},
                               {"kinetic", false, {"kinetic_J", nullptr}},
                               {"elastic: rock and joints", false, {"elastic_J", nullptr}},
                               {"elastic: contacts", false, {"contact_elastic_J", nullptr}},
                               {"gravity", false, {"gravity_J", nullptr}},
                               {"fracture", false, {"fracture_J", nullptr}},
                               {"friction", false, {"joint_friction_J", "contact_friction_J"}},
                               {"damping", false, {"joint_damping_J", "contact_damping_J"}},
                               {"quiet boundaries", false, {"quiet_J", nullptr}},
                               {"laid to rest", false, {"sleep_J", nullptr}},
                               {"walls", false, {"wall_J", nullptr}}};

}  // namespace

std::vector<double> EnergyHistory::missing() const {
  std::vector<double> sum(time.size(), 0.0);
  for (const EnergyGroup& group : groups) {
    for (size_t row = 0; row < sum.size(); ++row) {
      const double change = group.energy[row] - group.energy[0];
      sum[row] += group.source ? change : -change;
    }
  }
  return sum;
}

EnergyHistory read_energies(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  if (table.rows() == 0) throw InputError(path.string() + ": holds no rows");
  EnergyHistory history;
  const size_t time = table.column("time_s");
  for (size_t row = 0; row < table.rows(); ++row) history.time.push_back(table.number(row, time));
  for (const Columns& columns : kGroups) {
    EnergyGroup group{columns.name, columns.source, std::vector<double>(table.rows(), 0.0)};
    bool found = false;
    for (const char* name : columns.of) {
      const auto column = name == nullptr ? std::nullopt : table.find_column(name);
      if (!column) continue;
      found = true;
      for (size_t row = 0; row < table.rows(); ++row)
        group.energy[row] += table.number(row, *column);
    }
    if (found) history.groups.push_back(std::move(group));
  }
  return history;
}

}  // namespace muckpile
