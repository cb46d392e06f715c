// SPDX-License-Identifier: GPL-2.0-or-later
// A JSON object as the text of a file.
// Scope: numbers that are not finite become null; bytes that are no UTF-8, as names of files may
// have, become replacement characters.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace muckpile::engine {

[[nodiscard]] inline std::string json_text(const nlohmann::ordered_json& object) {
  return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace muckpile::engine
