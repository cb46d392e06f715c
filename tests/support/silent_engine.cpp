// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS inside a test: start, lines, gathering.
// Scope: see the header.
#include "silent_engine.h"

#include <input.h>

#include <array>

#include "fixes/engine/registry.h"

namespace muckpile::test {

std::unique_ptr<LAMMPS_NS::LAMMPS> silent_engine(MPI_Comm comm) {
  // Not "-screen none": reading a mesh then writes to a null pointer.
  std::array<std::string, 7> words{"test", "-screen", "/dev/null", "-log", "none", "-echo", "none"};
  std::array<char*, 7> arg{};
  for (std::size_t i = 0; i < words.size(); ++i) arg[i] = words[i].data();
  auto lmp = std::make_unique<LAMMPS_NS::LAMMPS>(static_cast<int>(arg.size()), arg.data(), comm);
  engine::register_styles(*lmp);
  return lmp;
}

void run_lines(LAMMPS_NS::LAMMPS& lmp, std::initializer_list<std::string> lines) {
  for (const std::string& line : lines) lmp.input->one(line.c_str());
}

std::vector<double> gather(const std::vector<double>& mine, MPI_Comm comm) {
  int ranks = 0, size = static_cast<int>(mine.size()), total = 0;
  MPI_Comm_size(comm, &ranks);
  std::vector<int> sizes(static_cast<std::size_t>(ranks)), starts(sizes.size());
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm);
  for (std::size_t r = 0; r < sizes.size(); ++r) {
    starts[r] = total;
    total += sizes[r];
  }
  std::vector<double> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, all.data(), sizes.data(), starts.data(), MPI_DOUBLE,
                 comm);
  return all;
}

}  // namespace muckpile::test
