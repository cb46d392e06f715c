// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of one run: where its dumps are, what its scene was, and its summary.json.
// Scope: dump/ is only read; summary.json is merged key by key, so that the sub-commands do not
// undo each other.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "figures/figures.h"
#include "io/blocks_file.h"
#include "io/snapshot.h"

namespace muckpile {

class ResultFolder {
 public:
  // Reads dump/scene.json. Throws InputError if the folder or the scene is absent or malformed, or
  // if the files of dump/ are not all of one run (io/run_id.h).
  explicit ResultFolder(std::filesystem::path folder);

  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::filesystem::path dump(const std::string& name) const {
    return folder_ / "dump" / name;
  }

  // dump/blocks_<step>.csv in order of step. Throws InputError if there is none.
  [[nodiscard]] std::vector<std::filesystem::path> snapshots() const;
  // Of the whole blast: those of the model, then their images behind its symmetry planes. Read at
  // the first call; the folder and its copies keep them.
  [[nodiscard]] const std::vector<StartBlock>& blocks() const;
  // Those of them that are no muck (io/muck.h), which are the first.
  [[nodiscard]] const std::vector<StartBlock>& rock() const;
  // How many times the model makes the blast: 1, or 2 or 4 by the scene's key symmetry. Throws
  // InputError on another number.
  [[nodiscard]] int symmetry() const;

  [[nodiscard]] std::string scene_word(const std::string& key) const;  // "" if absent
  [[nodiscard]] bool scene_has(const std::string& key) const { return scene_.contains(key); }
  // The text of a knob that the scene holds; "" if it has none of that name.
  [[nodiscard]] std::string knob(const std::string& name) const;
  // Throws InputError if the scene lacks the key or it is no number.
  [[nodiscard]] double scene_number(const std::string& key) const;

  // Whether the run ended because the rock had come to rest. False where run.json does not say.
  [[nodiscard]] bool is_still() const;

  // Of all files of dump/; "" where no file has one.
  [[nodiscard]] const std::string& run_id() const { return run_id_; }

  // Takes the `dropped` keys out of summary.json, adds or replaces `keys` and keeps its other ones,
  // unless they are another run's. A number that is not finite becomes null.
  void merge_into_summary(const nlohmann::ordered_json& keys,
                          const std::vector<std::string>& dropped = {}) const;

 private:
  std::filesystem::path folder_;
  nlohmann::ordered_json scene_;
  std::string run_id_;
  mutable std::shared_ptr<const std::vector<StartBlock>> blocks_;
  mutable std::shared_ptr<const std::vector<StartBlock>> rock_;  // null: all blocks
};

using check::read_json_object;

}  // namespace muckpile
