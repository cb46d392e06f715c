// SPDX-License-Identifier: GPL-2.0-or-later
// The seal at the end of a restart file.
// Scope: see the header.
#include "fixes/engine/restart_seal.h"

#include <comm.h>
#include <error.h>
#include <lammps.h>
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "fixes/engine/exchange.h"
#include "fixes/engine/style_args.h"
#include "provenance/fingerprint.h"

namespace muckpile::engine {
namespace {

struct Seal {
  std::array<char, 8> mark{'M', 'u', 'c', 'k', 'S', 'e', 'a', 'l'};
  std::uint64_t bytes = 0;  // before it
  std::uint64_t hash = 0;   // of those
};

constexpr std::string_view kOurs = "muckpile/block";  // styles that a file with blocks names
constexpr std::string_view kEngine = "LIGGGHTS";      // in the version that begins the file
constexpr std::size_t kShortest = 600;  // bytes; LIGGGHTS' file of an empty box has 602
constexpr std::size_t kHead = 256;      // bytes within which that stands

std::uint64_t hash_of(const char* first, std::size_t count) {
  return Fingerprint().add_bytes(first, count).value();
}

/// False if it cannot be read.
bool read_whole(const std::string& file, std::vector<char>& bytes) {
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  if (failed) return false;
  bytes.resize(size);
  std::ifstream in(file, std::ios::binary);
  return static_cast<bool>(in.read(bytes.data(), static_cast<std::streamsize>(size)));
}

bool holds(const std::vector<char>& bytes, std::size_t count, std::string_view word) {
  const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(count, bytes.size()));
  return std::search(bytes.begin(), end, word.begin(), word.end()) != end;
}

/// What is wrong with the file, or nothing.
std::string fault_of(const std::string& file) {
  std::vector<char> bytes;
  if (!read_whole(file, bytes)) return "cannot read '" + file + "'";
  if (!holds(bytes, kHead, kEngine)) return "'" + file + "' is no restart file of LIGGGHTS";
  if (bytes.size() < kShortest) return "'" + file + "' has lost its end; go on from another";
  Seal seal;
  const auto mark = seal.mark;
  if (bytes.size() >= sizeof(seal))
    std::memcpy(&seal, bytes.data() + bytes.size() - sizeof(seal), sizeof(seal));
  if (bytes.size() < sizeof(seal) || seal.mark != mark) {
    if (!holds(bytes, bytes.size(), kOurs)) return "";
    return "'" + file +
           "' has lost its end (or an earlier version of Muckpile wrote it); go on from another";
  }
  const std::size_t before = bytes.size() - sizeof(seal);
  if (seal.bytes == before && seal.hash == hash_of(bytes.data(), before)) return "";
  return "'" + file + "' is damaged: it is not as it was written; go on from another";
}

bool in_parts(const std::string& file) { return file.find('%') != std::string::npos; }

}  // namespace

void seal_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& file) {
  if (lmp.comm->me != 0 || in_parts(file)) return;
  std::vector<char> bytes;
  bool done = read_whole(file, bytes);
  if (done) {
    Seal seal;
    seal.bytes = bytes.size();
    seal.hash = hash_of(bytes.data(), bytes.size());
    std::ofstream out(file, std::ios::binary | std::ios::app);
    out.write(reinterpret_cast<const char*>(&seal), sizeof(seal));
    out.flush();
    done = static_cast<bool>(out);
  }
  if (!done)
    lmp.error->warning(FLERR, ("write_restart: '" + file + "' could not be written whole").c_str());
}

void require_whole_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& file) {
  if (in_parts(file)) return;
  const std::string fault = of_first_rank(lmp.comm->me == 0 ? fault_of(file) : "", lmp.world);
  if (!fault.empty()) stop(lmp, "read_restart: " + fault);
}

}  // namespace muckpile::engine
