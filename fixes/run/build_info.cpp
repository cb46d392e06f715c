// SPDX-License-Identifier: GPL-2.0-or-later
// Of what this program was built.
// Scope: see the header. muckpile_commit.h is made anew by each build (cmake/WriteCommit.cmake).
#include "fixes/run/build_info.h"

#include <mpi.h>

#include <Eigen/Core>
#include <array>
#include <nlohmann/json.hpp>

#include "muckpile_commit.h"

#define MUCKPILE_TEXT_OF(x) #x
#define MUCKPILE_TEXT(x) MUCKPILE_TEXT_OF(x)
#define MUCKPILE_DOTTED(a, b, c) MUCKPILE_TEXT(a) "." MUCKPILE_TEXT(b) "." MUCKPILE_TEXT(c)

namespace muckpile {
namespace {

/// "Open MPI v4.1.4": up to the first comma or line's end.
std::string mpi_version() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  const std::string all(text.data(), static_cast<std::size_t>(length));
  return all.substr(0, all.find_first_of(",\n"));
}

}  // namespace

BuildInfo build_info() {
  return {
      MUCKPILE_COMMIT,
      MUCKPILE_COMPILER,
      {{"LIGGGHTS", MUCKPILE_LIGGGHTS_VERSION},
       {"MPI", mpi_version()},
       {"Eigen", MUCKPILE_DOTTED(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
       {"voro++", MUCKPILE_VOROPP_VERSION},
       {"nlohmann_json", MUCKPILE_DOTTED(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                         NLOHMANN_JSON_VERSION_PATCH)}}};
}

}  // namespace muckpile
