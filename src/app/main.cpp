// SPDX-License-Identifier: GPL-2.0-or-later
// liggghts-muckpile: LIGGGHTS with Muckpile's styles; takes every flag of liggghts.
// Scope: start, signals and stop; everything else is LIGGGHTS' input script.
#include <input.h>
#include <lammps.h>
#include <mpi.h>
#include <signal_handling.h>

#include <csignal>
#include <cstdio>
#include <cstring>

#include "engine/registry.h"

namespace {

bool asks_for_help(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "-h") == 0 || std::strcmp(argv[i], "-help") == 0) return true;
  }
  return false;
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
  action.sa_handler = LAMMPS_NS::SignalHandler::usr1_handler;
  sigaction(SIGUSR1, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // Error::one aborts without flushing
  install_signal_handlers();
  MPI_Init(&argc, &argv);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0 && asks_for_help(argc, argv)) print_styles();

  auto* lmp = new LAMMPS_NS::LAMMPS(argc, argv,
                                    MPI_COMM_WORLD);  // prints LIGGGHTS' help and exits on -help
  muckpile::engine::register_styles(*lmp);
  lmp->input->file();
  delete lmp;
  MPI_Finalize();
  return 0;
}
