// SPDX-License-Identifier: GPL-2.0-or-later
// The restart file that a name with `*` means.
// Scope: see the header.
#include "fixes/engine/restart_name.h"

#include <comm.h>
#include <lammps.h>

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "fixes/engine/exchange.h"
#include "fixes/engine/style_args.h"

namespace muckpile::engine {
namespace {

namespace fs = std::filesystem;

/// What stands in place of the `*`, if that is a number; else nothing.
std::string_view digits_of(std::string_view file, std::string_view before, std::string_view after) {
  if (file.size() <= before.size() + after.size() || !file.starts_with(before) ||
      !file.ends_with(after))
    return {};
  file.remove_prefix(before.size());
  file.remove_suffix(after.size());
  return file.find_first_not_of("0123456789") == std::string_view::npos ? file : "";
}

/// The name in place of `pattern`, or nothing.
std::string search(const std::string& pattern) {
  const std::size_t name = pattern.find_last_of('/') + 1;  // npos + 1 is 0
  std::string wanted = pattern.substr(name);
  if (const std::size_t part = wanted.find('%'); part != std::string::npos)
    wanted.replace(part, 1, "base");
  const std::size_t star = wanted.find('*');
  if (star == std::string::npos) return "";
  const std::string before = wanted.substr(0, star), after = wanted.substr(star + 1);
  std::string latest;
  std::uint64_t greatest = 0;
  std::error_code failed;
  for (const auto& entry :
       fs::directory_iterator(name == 0 ? "." : pattern.substr(0, name), failed)) {
    const std::string file = entry.path().filename().string();
    const std::string_view digits = digits_of(file, before, after);
    std::uint64_t step = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), step);
    if (digits.empty() || read.ec != std::errc{} || (!latest.empty() && step <= greatest)) continue;
    greatest = step;
    latest = digits;
  }
  if (latest.empty()) return "";
  return std::string(pattern).replace(pattern.find('*', name), 1, latest);
}

}  // namespace

std::string latest_restart(LAMMPS_NS::LAMMPS& lmp, const std::string& name) {
  if (name.find('*') == std::string::npos) return name;
  const std::string found = of_first_rank(lmp.comm->me == 0 ? search(name) : "", lmp.world);
  if (found.empty())
    stop(lmp, "read_restart: there is no file '" + name + "' with a step in place of the *");
  return found;
}

}  // namespace muckpile::engine
