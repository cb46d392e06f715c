// SPDX-License-Identifier: GPL-2.0-or-later
// What is wrong with a file of blocks, or with the blocks in it.
// Scope: the files that import_blocks() reads.
#pragma once

#include <sstream>

#include "args/input_error.h"

namespace muckpile {

/// With a file's name.
template <class... Words>
[[noreturn]] void fail_file(const Words&... words) {
  std::ostringstream text;
  (text << ... << words);
  throw InputError(text.str());
}

/// Of its cells.
template <class... Words>
[[noreturn]] void fail_import(const Words&... words) {
  fail_file("block import: ", words...);
}

}  // namespace muckpile
