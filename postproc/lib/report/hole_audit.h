// SPDX-License-Identifier: GPL-2.0-or-later
// Where the energy of each hole's charge is at the end of a run, and what became of its stemming.
// Scope: the holes of run.json that have an audit.
#pragma once

#include "io/result_folder.h"

namespace muckpile {

// energy_audit_error_worst_hole [-]: what the audit of one hole misses at most, over the energy of
// its charge. stemming_out_s: since its firing, when the stemming of the first hole to lose it had
// left, null if none has; stemming_speed_m_s, the greatest of what has left. Nothing where no hole
// has an audit.
nlohmann::ordered_json hole_audit_keys(const nlohmann::ordered_json& run);

// energy_holes.csv: a row per hole. Removed where no hole has an audit.
void write_hole_audits(const ResultFolder& folder);

}  // namespace muckpile
