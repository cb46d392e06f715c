// SPDX-License-Identifier: GPL-2.0-or-later
// Whether all of an input script has run.
// Scope: see the header.
#include "input_end.h"

#include <fcntl.h>
#include <lammps.h>
#include <signal_handling.h>

#include <cctype>

namespace muckpile {
namespace {

constexpr const char* kWhole = "whole: the input has run to its end";

/// Whether what has not been read of an open script are blanks and comments.
bool holds_no_command(std::FILE* script) {
  bool comment = false;
  for (int c = std::fgetc(script); c != EOF; c = std::fgetc(script)) {
    if (c == '\n') comment = false;
    if (c == '#') comment = true;
    if (!comment && std::isspace(c) == 0) return false;
  }
  return true;
}

}  // namespace

InputEnd::InputEnd(const LAMMPS_NS::LAMMPS& lmp) : script_(lmp.infile) {
  if (script_ != nullptr) number_ = ::fileno(script_);
}

/// LIGGGHTS closes a script that it has read to its end, but not the standard input, and opens
/// nothing behind the outermost one.
bool InputEnd::nothing_left(const LAMMPS_NS::LAMMPS& lmp) const {
  if (script_ == nullptr || ::fcntl(number_, F_GETFD) == -1) return true;
  return lmp.infile == script_ && holds_no_command(script_);
}

/// LIGGGHTS writes its state as it leaves a run, and shortens the run to the steps that it has
/// done; behind the last run the state that was asked for stays unwritten.
std::string InputEnd::line(const LAMMPS_NS::LAMMPS& lmp) const {
  namespace signals = LAMMPS_NS::SignalHandler;
  if (!signals::request_quit) return kWhole;
  if (!signals::request_write_restart) return "interrupted: before the last step of a run";
  return nothing_left(lmp) ? kWhole : "interrupted: before the end of the input";
}

void tell_end(const LAMMPS_NS::LAMMPS& lmp, const std::string& line) {
  if (lmp.logfile != nullptr) std::fprintf(lmp.logfile, "%s\n", line.c_str());
  if (lmp.screen != nullptr && line != kWhole) std::fprintf(lmp.screen, "%s\n", line.c_str());
}

}  // namespace muckpile
