// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command overlay: a table of several runs as curves with a band, or as rows with their
// scatter. Scope: reads tables that other commands have left in result folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace muckpile {

struct OverlayOptions {
  std::vector<std::string> runs;      // result folders, two at least
  std::string table = "profile.csv";  // in each
  std::vector<std::string> columns;   // of it; none: all numbers
  std::string out = ".";              // folder for what is written
};

// Writes overlay_<table>.csv and, of a table of curves, overlay_<table>.png. Gives back what it has
// written. Throws InputError as sweep/overlay.h tells, for fewer than two runs and where there is
// no folder `out`.
std::vector<std::filesystem::path> report_overlay(const OverlayOptions& options);

}  // namespace muckpile
