// SPDX-License-Identifier: GPL-2.0-or-later
// The state of a fix as a part of LIGGGHTS' restart file.
// Scope: the engine does not tell the length when it reads, so the length is part of the bytes.
#include "fixes/engine/restart_file.h"

#include <comm.h>
#include <lammps.h>
#include <mpi.h>

#include <cstring>
#include <limits>
#include <vector>

#include "fixes/engine/exchange.h"
#include "fixes/engine/over_ranks.h"

namespace muckpile::engine {
namespace {

/// LIGGGHTS counts the bytes of a fix in an int.
void require_size(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::size_t bytes) {
  constexpr double kMost = std::numeric_limits<int>::max() - 1e6;
  const double all = sum_over_ranks(static_cast<double>(bytes), lmp.world);
  if (all <= kMost) return;
  stop(lmp, "write_restart: fix " + style + " has " + std::to_string(all / 1e9) +
                " GB, but LIGGGHTS reads 2 GiB of a fix at most");
}

}  // namespace

void write_part(LAMMPS_NS::LAMMPS& lmp, const std::string& style, std::FILE* file, ByteWriter part,
                ByteWriter mine) {
  require_size(lmp, style, mine.bytes().size());
  std::vector<std::vector<char>> outgoing(static_cast<std::size_t>(lmp.comm->nprocs));
  outgoing.front() = std::move(mine.bytes());
  const auto shares = exchange_bytes(outgoing, lmp.world);
  if (lmp.comm->me != 0) return;
  std::size_t count = part.bytes().size();
  for (const auto& share : shares) count += share.size();
  const int all = static_cast<int>(count + sizeof(count));
  std::fwrite(&all, sizeof(all), 1, file);
  std::fwrite(&count, sizeof(count), 1, file);
  std::fwrite(part.bytes().data(), 1, part.bytes().size(), file);
  for (const auto& share : shares) std::fwrite(share.data(), 1, share.size(), file);
}

ByteReader reader_of_part(const char* state) {
  std::size_t count = 0;
  std::memcpy(&count, state, sizeof(count));
  return {state + sizeof(count), count};
}

double share_of_total(LAMMPS_NS::LAMMPS& lmp, double all) { return lmp.comm->me == 0 ? all : 0.0; }

}  // namespace muckpile::engine
