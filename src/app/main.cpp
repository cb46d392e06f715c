// SPDX-License-Identifier: GPL-2.0-or-later
// liggghts-muckpile: LIGGGHTS with Muckpile's styles; takes every flag of liggghts.
// Scope: start, signals and stop; everything else is LIGGGHTS' input script.
#include <input.h>
#include <lammps.h>
#include <mpi.h>
#include <signal_handling.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "fixes/engine/registry.h"
#include "input_end.h"
#include "unused_variables.h"

namespace {

bool is_given(const char* option, int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc,
                     [option](const char* word) { return std::strcmp(word, option) == 0; });
}

/// LIGGGHTS knows -help only.
void spell_as_liggghts_does(int argc, char** argv) {
  static char help[] = "-help";
  for (int i = 1; i < argc; ++i)
    if (std::strcmp(argv[i], "--help") == 0) argv[i] = help;
}

/// LIGGGHTS leaves its help with status 1, as if that were an error.
void end_help_well() {
  std::fflush(nullptr);
  std::_Exit(0);
}

/// LIGGGHTS' mesh reader prints without asking whether there is a screen. With -screen none, and on
/// all ranks but the first with -screen FILE, there is none.
void give_screen(LAMMPS_NS::LAMMPS& lmp) {
  if (lmp.screen == nullptr) lmp.screen = std::fopen("/dev/null", "w");
}

void warn(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::printf("WARNING: %s\n", line.c_str());
}

void print_styles() {
  std::printf("Muckpile " MUCKPILE_VERSION " adds to LIGGGHTS' styles (listed below):\n");
  for (const auto& style : muckpile::engine::style_names()) {
    std::printf("  %-8s %s\n", style.kind.c_str(), style.name.c_str());
  }
  std::fflush(stdout);
}

void install_signal_handlers() {
  struct sigaction action = {};
  action.sa_handler = LAMMPS_NS::SignalHandler::int_handler;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // mpirun hands this one on as it is; after a SIGINT it kills.
  sigaction(SIGUSR2, &action, nullptr);
  action.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // Error::one aborts without flushing
  install_signal_handlers();
  if (is_given("-version", argc, argv) || is_given("--version", argc, argv)) {
    std::printf("Muckpile " MUCKPILE_VERSION "\n");
    return 0;
  }
  spell_as_liggghts_does(argc, argv);
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (is_given("-h", argc, argv) || is_given("-help", argc, argv)) {
    if (rank == 0) print_styles();
    std::atexit(end_help_well);
  }
  std::vector<std::string> unused;
  if (rank == 0) unused = muckpile::unused_variables({argv + 1, argv + argc});

  auto* lmp = new LAMMPS_NS::LAMMPS(argc, argv,
                                    MPI_COMM_WORLD);  // prints LIGGGHTS' help and exits on -help
  give_screen(*lmp);
  muckpile::engine::register_styles(*lmp);
  warn(unused);
  const muckpile::InputEnd end(*lmp);
  lmp->input->file();
  if (rank == 0) muckpile::tell_end(*lmp, end.line(*lmp));
  warn(unused);  // once more, where it is seen
  delete lmp;
  MPI_Finalize();
  return 0;
}
