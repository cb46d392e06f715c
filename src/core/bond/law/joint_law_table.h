// SPDX-License-Identifier: GPL-2.0-or-later
// The laws that a class of natural joints can have, by name, and their keywords.
// Scope: words to numbers. A new law adds its entry to joint_law_entries(); see CONTRIBUTING.md.
#pragma once

#include <string>
#include <vector>

#include "args/arg_table.h"
#include "args/parse_args.h"
#include "bond/law/joint_material.h"

namespace muckpile {

struct JointLawEntry {
  std::string name;
  ArgTable table;  ///< in the units that a user types
  JointClass (*make)(const ArgValues& args, const std::string& where);
};

/// Each law's own entry is declared in its header.
[[nodiscard]] const std::vector<JointLawEntry>& joint_law_entries();

/// An empty table for the keywords of a law.
[[nodiscard]] ArgTable joint_class_table(const std::string& law);
/// What a user types as 0 for a joint as stiff as the rock on either side.
[[nodiscard]] double rigid_if_0(double stiffness);

struct JointClassWords {
  std::vector<JointClass> classes;  ///< from 1 on
  std::vector<std::string> others;  ///< words that are no class's
  std::string echo;                 ///< the classes as understood, one line for each value
};
/// Takes every `joint_class N law NAME keyword value ...` out of `words`. A class ends before the
/// first word that is no keyword of its law. `style`: the table of all other words.
/// Throws InputError.
[[nodiscard]] JointClassWords read_joint_classes(const ArgTable& style, const std::string& where,
                                                 const std::vector<std::string>& words);

}  // namespace muckpile
