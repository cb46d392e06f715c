// SPDX-License-Identifier: GPL-2.0-or-later
// What every engine test begins and ends with: LIGGGHTS with our styles and without output, and
// numbers gathered from its ranks.
// Scope: one engine per communicator at a time.
#pragma once

#include <lammps.h>
#include <mpi.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace muckpile::test {

/// LIGGGHTS on the ranks of `comm`, printing nothing, with Muckpile's styles. Collective.
[[nodiscard]] std::unique_ptr<LAMMPS_NS::LAMMPS> silent_engine(MPI_Comm comm);

/// Runs the lines of an input script. Collective.
void run_lines(LAMMPS_NS::LAMMPS& lmp, std::initializer_list<std::string> lines);

/// The numbers of all ranks, rank after rank, on every rank. Collective.
[[nodiscard]] std::vector<double> gather(const std::vector<double>& mine, MPI_Comm comm);

}  // namespace muckpile::test
