// SPDX-License-Identifier: GPL-2.0-or-later
// The words of a sub-command that say how a pile is measured.
#pragma once

#include <CLI/CLI.hpp>

#include "report/reports.h"

namespace muckpile {

/// --moved and --cell; `options` must outlive the command.
inline void add_measure(CLI::App* command, MeasureOptions& options) {
  command
      ->add_option("--moved", options.least_move,
                   "a block that moved less than this stayed [m] (default: mean block size; of a "
                   "crater: 0, its own size alone counts)")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--cell", options.cell,
                   "width of the measuring columns [m] (default: 1/4 of mean block size)")
      ->check(CLI::PositiveNumber);
}

}  // namespace muckpile
