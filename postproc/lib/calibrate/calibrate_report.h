// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-commands calibrate fit and calibrate check.
// Scope: tables, a picture and the site file; the runs are read only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace muckpile {

struct FitOptions {
  std::string measured;        // file of measured figures
  std::string sweep;           // folder of the sweep; the results go there
  std::string site;            // name of the site file, site_<name>.in
  std::string order = "auto";  // of the surfaces: auto, linear, quadratic
};

// Writes calibrate.csv, calibrate_figures.csv, calibrate_directions.csv, calibrate_covariance.csv,
// calibrate.png and the site file into the sweep's folder. Gives back what to tell the user, a line
// each. Throws InputError as read_sweep and read_measured do; on a constant that is swept over
// fewer than two values or over one that is not a positive number; on a figure that no run has;
// and, after the tables, where the measures resolve no combination of constants: a site file of
// that name is then removed.
std::vector<std::string> report_calibration(const FitOptions& options);

struct CheckOptions {
  std::string measured;
  std::vector<std::string> runs;  // result folders of the second blast, seeds, say
  std::string site;               // file whose constants the runs must have; "": not looked at
  double within = 2.0;            // deviations that a figure may be off
  std::string csv;                // table of the comparison; "": none
};

struct CheckResult {
  std::vector<std::string> lines;
  bool agrees;  // all figures are within
};

// Throws InputError where a file cannot be read, a run lacks a figure or has other constants.
CheckResult check_calibration(const CheckOptions& options);

}  // namespace muckpile
