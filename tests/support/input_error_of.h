// SPDX-License-Identifier: GPL-2.0-or-later
// Runs code that must throw InputError and gives back its message.
// Scope: tests; "" means that nothing was thrown.
#pragma once

#include <string>

#include "args/input_error.h"

namespace muckpile {

template <class Code>
std::string input_error_of(Code&& code) {
  try {
    code();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace muckpile
