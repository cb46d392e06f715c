// SPDX-License-Identifier: GPL-2.0-or-later
// Text files of results.
// Scope: see the header.
#include "fixes/engine/output_file.h"

#include <comm.h>
#include <lammps.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "fixes/engine/exchange.h"
#include "fixes/engine/style_args.h"

namespace muckpile::engine {
namespace {

/// What went wrong, or nothing.
std::string put(const std::string& file, const char* mode, const std::string& text) {
  std::FILE* out = std::fopen(file.c_str(), mode);
  if (out == nullptr) return std::strerror(errno);
  const bool whole = std::fwrite(text.data(), 1, text.size(), out) == text.size();
  const int fault = whole && std::fflush(out) == 0 ? 0 : errno;
  // A network's file system may tell only now.
  if (std::fclose(out) != 0 && fault == 0) return std::strerror(errno);
  return fault == 0 ? "" : std::strerror(fault);
}

std::string add(const std::string& file, const std::string& text) { return put(file, "a", text); }

/// As put(); a file that is there stays as it is until the new one is whole.
std::string replace(const std::string& file, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code fault, unheeded;
  fs::path there = fs::canonical(file, fault);  // a link stays a link
  if (fault) there = file;
  if (fs::exists(there, unheeded) && !fs::is_regular_file(there, unheeded))
    return put(file, "w", text);  // a device, a pipe
  const std::string part = there.string() + ".part";
  std::string wrong = put(part, "w", text);
  if (wrong.empty()) {
    fs::rename(part, there, fault);
    if (fault) wrong = fault.message();
  }
  if (!wrong.empty()) fs::remove(part, unheeded);
  return wrong;
}

void put_or_stop(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& file,
                 std::string (*way)(const std::string&, const std::string&),
                 const std::string& text) {
  const std::string fault = of_first_rank(lmp.comm->me == 0 ? way(file, text) : "", lmp.world);
  if (fault.empty()) return;
  stop(lmp,
       where + ": '" + file + "' cannot be written: " + fault +
           "; make room or choose another folder, and go on from a restart file or start anew");
}

}  // namespace

void write_file(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& file,
                const std::string& text) {
  put_or_stop(lmp, where, file, replace, text);
}

void append_to_file(LAMMPS_NS::LAMMPS& lmp, const std::string& where, const std::string& file,
                    const std::string& text) {
  put_or_stop(lmp, where, file, add, text);
}

}  // namespace muckpile::engine
