// SPDX-License-Identifier: GPL-2.0-or-later
// The state of a fix as bytes of LIGGGHTS' restart file.
// Scope: the engine does not tell the length when it reads, so the length is part of the bytes.
#include "fixes/engine/restart_file.h"

#include <comm.h>
#include <lammps.h>
#include <mpi.h>

#include <cstring>
#include <limits>
#include <vector>

#include "fixes/engine/style_args.h"

namespace muckpile::engine {
namespace {

/// LIGGGHTS counts the bytes of a fix in an int.
void require_size(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::size_t bytes) {
  constexpr double kMost = std::numeric_limits<int>::max() - 1e6;
  const double all = total(lmp, static_cast<double>(bytes));
  if (all <= kMost) return;
  stop(lmp, "write_restart: fix " + style + " has " + std::to_string(all / 1e9) +
                " GB, but LIGGGHTS reads 2 GiB of a fix at most");
}

}  // namespace

void write_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file,
                 ByteWriter& common, ByteWriter& mine) {
  require_size(lmp, style, mine.bytes().size());
  std::vector<std::vector<char>> outgoing(static_cast<std::size_t>(lmp.comm->nprocs));
  outgoing.front() = std::move(mine.bytes());
  const auto parts = exchange_bytes(outgoing, lmp.world);
  if (lmp.comm->me != 0) return;
  std::size_t count = common.bytes().size();
  for (const auto& part : parts) count += part.size();
  const int all = static_cast<int>(count + sizeof(count));
  std::fwrite(&all, sizeof(all), 1, file);
  std::fwrite(&count, sizeof(count), 1, file);
  std::fwrite(common.bytes().data(), 1, common.bytes().size(), file);
  for (const auto& part : parts) std::fwrite(part.data(), 1, part.size(), file);
}

void write_state(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file,
                 ByteWriter& common) {
  ByteWriter none;
  write_state(lmp, style, file, common, none);
}

ByteReader read_state(const char* state) {
  std::size_t count = 0;
  std::memcpy(&count, state, sizeof(count));
  return {state + sizeof(count), count};
}

double total(LAMMPS_NS::LAMMPS& lmp, double mine) {
  double all = 0.0;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, lmp.world);
  return all;
}

double share_of_total(LAMMPS_NS::LAMMPS& lmp, double all) { return lmp.comm->me == 0 ? all : 0.0; }

}  // namespace muckpile::engine
