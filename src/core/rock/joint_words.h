// SPDX-License-Identifier: GPL-2.0-or-later
// Whether the words of fix muckpile/joint have what create_blocks asks of them, before the cut.
// Scope: numbers of joint classes and names of zones; the fix reads the rest.
#pragma once

#include <string>
#include <vector>

#include "rock/cut_options.h"

namespace muckpile {

/// Throws InputError where natural joints, a fault or a zone have a joint_class that the words
/// lack, where a zone is not in them, or one of theirs is not in the rock. `knob`: the variable
/// that holds them, for the message.
void require_joint_words(const CutOptions& options, const std::string& knob,
                         const std::vector<std::string>& words);

}  // namespace muckpile
