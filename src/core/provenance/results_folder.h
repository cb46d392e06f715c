// SPDX-License-Identifier: GPL-2.0-or-later
// What a script asks of a folder of results of another run.
// Scope: paths, and numbers and the id of dump/scene.json as write_scene writes it.
#pragma once

#include <optional>
#include <string>

namespace muckpile {

/// Whether a path is a folder, or lies in it, whatever links lead there. Neither need exist.
[[nodiscard]] bool lies_in(const std::string& path, const std::string& folder);

/// Whether a folder of results has a dump/scene.json, or is that folder dump.
[[nodiscard]] bool has_scene(const std::string& folder);

/// The number of a key in dump/scene.json of a folder of results, or in scene.json if it is that
/// folder dump; none where there is no such file or no such number.
[[nodiscard]] std::optional<double> scene_number(const std::string& folder, const std::string& key);

/// The run_id of that file, "" where it has none; nothing where there is no such file.
[[nodiscard]] std::optional<std::string> scene_run_id(const std::string& folder);

/// Whether these bytes stand anywhere in a file; false where it cannot be read.
[[nodiscard]] bool file_holds(const std::string& file, const std::string& bytes);

}  // namespace muckpile
