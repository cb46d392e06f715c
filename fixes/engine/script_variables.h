// SPDX-License-Identifier: GPL-2.0-or-later
// The variables that an input script has defined so far, and new ones.
// Scope: LIGGGHTS keeps their table private; here is the one file that reaches it.
#pragma once

#include <string>
#include <vector>

#include "provenance/knobs.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace muckpile::engine {

/// All variables, in the order of their definition: those of style `index`, which -var can set,
/// with their present value, all others without one.
[[nodiscard]] Knobs script_knobs(LAMMPS_NS::LAMMPS& lmp);

struct Definition {
  std::string name;
  std::string text;  ///< behind the style: a value, or a formula
};
/// Variables of the styles index, string, equal and atom. `text` does not depend on the engine's
/// state: a formula is not worked out.
[[nodiscard]] std::vector<Definition> script_definitions(LAMMPS_NS::LAMMPS& lmp);

/// The value of an index variable, "" if there is none of this name.
[[nodiscard]] std::string knob_value(LAMMPS_NS::LAMMPS& lmp, const std::string& name);

/// Makes a variable of style string, or gives it another value.
void set_script_variable(LAMMPS_NS::LAMMPS& lmp, const std::string& name, double value);

}  // namespace muckpile::engine
