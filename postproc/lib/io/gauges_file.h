// SPDX-License-Identifier: GPL-2.0-or-later
// What fix muckpile/gauges wrote: histories at points of the rock.
// Scope: the file as a whole, gauge by gauge; docs/styles/fix_muckpile_gauges.md has its columns.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "math/types.h"

namespace muckpile {

struct GaugeHistory {
  int number = 0;                // from 1
  int block = 0;                 // that carries it
  Vec3 place = Vec3::Zero();     // at the start [m]
  std::vector<double> time;      // rising [s]
  std::vector<Vec3> velocity;    // [m/s]
  std::vector<double> pressure;  // mean, compression positive [Pa]
  std::vector<Vec3> principal;   // stresses, compression positive, the largest first [Pa]
};

// In the order of their numbers. Throws InputError, naming file and line, if the file is absent or
// empty, of another run than `run_id` ("": any), or a gauge changes its place or goes back in time.
std::vector<GaugeHistory> read_gauges(const std::filesystem::path& path, const std::string& run_id);

}  // namespace muckpile
