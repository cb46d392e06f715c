// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command calibrate of muckpile-post.
// Scope: see the header.
#include "calibrate_command.h"

#include <cstdio>
#include <exception>
#include <memory>

#include "calibrate/calibrate_report.h"
#include "command_words.h"

namespace muckpile {
namespace {

constexpr const char* kMeasuredHelp =
    "CSV of figure (a key of summary.json), value and uncertainty (standard deviation), both in "
    "the key's unit";

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::printf("muckpile-post: %s\n", line.c_str());
}

int status_of(const CheckOptions& options) {
  try {
    const CheckResult result = check_calibration(options);
    print(result.lines);
    return result.agrees ? 0 : 1;
  } catch (const std::exception& error) {
    tell(error);
    return 2;
  }
}

void add_fit(CLI::App& calibrate) {
  const auto options = std::make_shared<FitOptions>();
  CLI::App* fit = calibrate.add_subcommand(
      "fit",
      "swept constants from the figures measured at a blast: calibrate.csv and other tables, "
      "calibrate.png, site_NAME.in, all in the sweep's folder");
  fit->add_option("measured", options->measured, kMeasuredHelp)->required();
  fit->add_option("sweep", options->sweep,
                  "folder of ./muckpile sweep over the uncertain constants, of the blast that was "
                  "measured")
      ->required();
  fit->add_option("--site", options->site, "name of the site file, site_NAME.in")->required();
  fit->add_option("--order", options->order,
                  "of the surfaces in the logarithms of the constants; auto: quadratic where each "
                  "has three values and three runs are to spare")
      ->check(CLI::IsMember({"auto", "linear", "quadratic"}));
  fit->callback([options] { print(report_calibration(*options)); });
}

void add_check(CLI::App& calibrate, int& status) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* check = calibrate.add_subcommand(
      "check",
      "runs of another blast against the figures measured there; exit status 0 if all are within, "
      "1 if not, 2 if a file cannot be read or the runs are not of one blast");
  check->add_option("measured", options->measured, kMeasuredHelp)->required();
  check->add_option("runs", options->runs, "result folders of one blast, with other seeds at most")
      ->required();
  check->add_option("--site", options->site,
                    "site file; runs with other constants are refused (default: not looked at)");
  check
      ->add_option("--within", options->within,
                   "deviations that a figure may be off, of the measure's uncertainty and the "
                   "runs' scatter together")
      ->check(above_zero());
  check->add_option("--csv", options->csv, "write the comparison to this file, too");
  check->callback([options, &status] { status = status_of(*options); });
}

}  // namespace

void add_calibrate_command(CLI::App& app, int& status) {
  CLI::App* calibrate = app.add_subcommand(
      "calibrate",
      "uncertain constants fitted to the figures measured at one blast, and checked on another");
  calibrate->require_subcommand(1);
  add_fit(*calibrate);
  add_check(*calibrate, status);
}

}  // namespace muckpile
