// SPDX-License-Identifier: GPL-2.0-or-later
// Which run wrote the files of a dump folder, by the run id that the engine puts into each of them.
// Scope: blocks.vtk, run.json, history.csv, gauges.csv, burden.csv, the snapshots, and scene.json
// where it has an id; files that are not there are no strangers.
#pragma once

#include <filesystem>
#include <string>

namespace muckpile {

// The id that all files carry; "" where none has one. Throws InputError, naming two files and what
// they carry, where ids differ or only some files have one: what two runs have left in one folder
// is not to be measured as one.
std::string run_id_of(const std::filesystem::path& dump);

// Of one JSON file; "" if it has none.
std::string run_id_in_json(const std::filesystem::path& path);

}  // namespace muckpile
