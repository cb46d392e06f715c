// SPDX-License-Identifier: GPL-2.0-or-later
// The one exception that core code throws for a fault in the user's input.
// Scope: text only; fixes/engine turns it into a collective engine error.
#pragma once

#include <stdexcept>
#include <string>

namespace muckpile {

class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
};

/// `where` names style and id, as in every message.
[[noreturn]] inline void refuse(const std::string& where, const std::string& text) {
  throw InputError(where + ": " + text);
}

}  // namespace muckpile
