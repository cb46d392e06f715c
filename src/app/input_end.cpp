// SPDX-License-Identifier: GPL-2.0-or-later
// Whether all of an input script has run.
// Scope: see the header.
#include "input_end.h"

#include <fcntl.h>
#include <lammps.h>
#include <signal_handling.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>

#include "fixes/run/script_engine.h"

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

/// The last command of a script, its lines joined; empty where the script is no file.
std::string last_command(int number) {
  struct stat about {};
  if (::fstat(number, &about) != 0 || !S_ISREG(about.st_mode)) return {};
  std::ifstream script("/proc/self/fd/" + std::to_string(number));
  std::string last, command, line;
  while (std::getline(script, line)) {
    line.erase(std::min(line.find('#'), line.size()));
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool goes_on = line.ends_with('&');
    command += goes_on ? line.substr(0, line.size() - 1) : line;
    if (goes_on) continue;
    if (!command.empty()) last = command;
    command.clear();
  }
  return last;
}

/// Whether a command runs others, of which LIGGGHTS leaves out the rest after a signal.
bool runs_commands(const std::string& command) {
  std::istringstream words(command);
  std::string word;
  words >> word;
  if (word == "if" || word == "include") return true;
  if (word != "run") return false;
  while (words >> word)
    if (word == "every") return true;
  return false;
}

}  // namespace

InputEnd::InputEnd(const LAMMPS_NS::LAMMPS& lmp) : script_(lmp.infile) {
  if (script_ == nullptr) return;
  number_ = ::fileno(script_);
  ends_plainly_ = !runs_commands(last_command(number_));
}

/// LIGGGHTS closes a script that it has read to its end, but not the standard input, and opens
/// nothing behind the outermost one. What a pipe still holds is not waited for.
bool InputEnd::nothing_left(const LAMMPS_NS::LAMMPS& lmp) const {
  if (!ends_plainly_) return false;
  if (script_ == stdin) return std::feof(stdin) != 0;
  if (script_ == nullptr || ::fcntl(number_, F_GETFD) == -1) return true;
  return lmp.infile == script_ && holds_no_command(script_);
}

/// LIGGGHTS writes its state as it leaves a run, and shortens the run to the steps that it has
/// done; behind the last run the state that was asked for stays unwritten. Where it may not write
/// one (write_restart_on_signal no) nothing tells the two apart.
std::string InputEnd::line(const LAMMPS_NS::LAMMPS& lmp) const {
  namespace signals = LAMMPS_NS::SignalHandler;
  constexpr const char* kCut = "interrupted: before the end of the input";
  const bool left_out = ScriptEngine::has_been_cut();  // a signal of another rank, too
  if (!signals::request_quit) return left_out ? kCut : kWhole;
  if (!signals::enable_restart_writing) return kCut;
  if (!signals::request_write_restart) return "interrupted: before the last step of a run";
  return nothing_left(lmp) && !left_out ? kWhole : kCut;
}

void tell_end(const LAMMPS_NS::LAMMPS& lmp, const std::string& line) {
  if (lmp.logfile != nullptr) std::fprintf(lmp.logfile, "%s\n", line.c_str());
  if (lmp.screen != nullptr && line != kWhole) std::fprintf(lmp.screen, "%s\n", line.c_str());
}

}  // namespace muckpile
