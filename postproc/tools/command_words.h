// SPDX-License-Identifier: GPL-2.0-or-later
// Words that several sub-commands have: the folder of a run, how a pile is measured, colours.
// Scope: the strings and options handed over must outlive the command.
#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <string>

#include "report/options.h"

namespace muckpile {

/// A sub-command of a run, whose result folder is its first word.
CLI::App* add_command(CLI::App& app, const char* name, const char* help, std::string& folder);

/// Checks of a finite number, as CLI::PositiveNumber and CLI::NonNegativeNumber, whose messages
/// print the largest number there is instead.
CLI::Validator above_zero();
CLI::Validator at_least_zero();
CLI::Validator between(double least, double most);  ///< as CLI::Range, which lets NaN pass
CLI::Validator any_number();

/// Tells of a fault on the error stream: the beginning of its message, which may quote a file of
/// another kind, without what moves a cursor.
void tell(const std::exception& fault);

/// --moved and --cell.
void add_measure(CLI::App* command, MeasureOptions& options);

/// --colour, the name of a field (report/block_fields.h).
void add_colour(CLI::App* command, std::string& colour);

}  // namespace muckpile
