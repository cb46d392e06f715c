// SPDX-License-Identifier: GPL-2.0-or-later
// Adds Muckpile's styles to a running LIGGGHTS, and lists them.
// Scope: registration only. The engine's `clear` command builds fresh style maps: the command
// `muckpile_styles` puts ours back.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace muckpile::engine {

struct StyleName {
  std::string kind;  ///< "command", "fix", "compute" or "pair"
  std::string name;
};

/// Every style that Muckpile adds, in the order of the table.
[[nodiscard]] std::vector<StyleName> style_names();

/// Makes the styles known to `lmp`; stops the run if the engine already has one of that name.
void register_styles(LAMMPS_NS::LAMMPS& lmp);

/// A fix of LIGGGHTS made from the words of a fix command, with `style` in place of theirs. It is
/// no part of the run: the caller owns it and passes on what the engine asks for.
[[nodiscard]] std::unique_ptr<LAMMPS_NS::Fix> make_fix(LAMMPS_NS::LAMMPS& lmp,
                                                       const std::string& style,
                                                       std::vector<char*> arg);

}  // namespace muckpile::engine
