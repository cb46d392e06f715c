// SPDX-License-Identifier: GPL-2.0-or-later
// What is wrong with a file of blocks, or with the blocks in it.
// Scope: the files that import_blocks() reads.
#pragma once

#include <sstream>

#include "args/input_error.h"

namespace muckpile {

template <class... Words>
[[noreturn]] void fail_import(const Words&... words) {
  std::ostringstream text;
  text << "block import: ";
  (text << ... << words);
  throw InputError(text.str());
}

}  // namespace muckpile
