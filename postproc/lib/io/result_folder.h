// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of one run: where its dumps are, what its scene was, and its summary.json.
// Scope: dump/ is only read; summary.json is merged key by key, so that the sub-commands do not
// undo each other.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

class ResultFolder {
 public:
  // Reads dump/scene.json. Throws InputError if the folder or the scene is absent or malformed.
  explicit ResultFolder(std::filesystem::path folder);

  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::filesystem::path dump(const std::string& name) const {
    return folder_ / "dump" / name;
  }

  // dump/blocks_<step>.csv in order of step. Throws InputError if there is none.
  [[nodiscard]] std::vector<std::filesystem::path> snapshots() const;
  [[nodiscard]] std::vector<StartBlock> blocks() const { return read_blocks(dump("blocks.vtk")); }

  [[nodiscard]] std::string scene_word(const std::string& key) const;  // "" if absent
  [[nodiscard]] bool scene_has(const std::string& key) const { return scene_.contains(key); }
  // Throws InputError if the scene lacks the key or it is no number.
  [[nodiscard]] double scene_number(const std::string& key) const;

  // Adds or replaces these keys of summary.json and keeps its other keys. A number that is not
  // finite becomes null.
  void merge_into_summary(const nlohmann::ordered_json& keys) const;

 private:
  std::filesystem::path folder_;
  nlohmann::ordered_json scene_;
};

// A JSON object from a file. Throws InputError, naming the file and the place, if it is absent or
// malformed.
nlohmann::ordered_json read_json_object(const std::filesystem::path& path);

}  // namespace muckpile
