// SPDX-License-Identifier: GPL-2.0-or-later
// A folder that all ranks of a test share.
// Scope: see the header.
#include "scratch_folder.h"

#include <mpi.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace muckpile::test {

ScratchFolder::ScratchFolder(const std::string& name) {
  int id = static_cast<int>(getpid());  // of rank 0, so that runs at the same time do not meet
  MPI_Bcast(&id, 1, MPI_INT, 0, MPI_COMM_WORLD);
  path_ = std::filesystem::temp_directory_path() / ("muckpile_" + name + '_' + std::to_string(id));
  std::filesystem::create_directories(path_);
  MPI_Barrier(MPI_COMM_WORLD);
}

ScratchFolder::~ScratchFolder() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Barrier(MPI_COMM_WORLD);
  std::error_code ignored;
  if (rank == 0) std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::own(const std::string& name) const {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return path_ / ("rank" + std::to_string(rank) + '_' + name);
}

std::string content(const std::filesystem::path& path) {
  std::ostringstream all;
  all << std::ifstream(path).rdbuf();
  return all.str();
}

}  // namespace muckpile::test
