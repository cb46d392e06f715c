// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of one run: where its dumps are, what its scene was, and its summary.json.
// Scope: the summary is written to a second file and renamed, so a reader never sees half of it.
#include "io/result_folder.h"

#include <fstream>
#include <utility>

#include "args/input_error.h"
#include "io/images.h"
#include "io/muck.h"
#include "io/run_id.h"
#include "provenance/run_files.h"

namespace muckpile {
namespace {

/// Lengths of a plan that no report can use at 0 or below; those that are no numbers are refused
/// where they are asked for.
void require_lengths(const nlohmann::ordered_json& scene, const std::filesystem::path& file) {
  for (const char* key : {"burden_m", "hole_diameter_m"}) {
    const auto found = scene.find(key);
    if (found == scene.end() || !found->is_number() || found->get<double>() > 0.0) continue;
    throw InputError(file.string() + ": " + key + " must be > 0 m, got '" + found->dump() + "'");
  }
}

// A run, and each part of it, leaves a snapshot of its last step.
void require_end(const std::filesystem::path& last, const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  const nlohmann::ordered_json run = read_json_object(file);
  const auto still = run.find("still"), steps = run.find("steps");
  if (steps == run.end() || !steps->is_number()) return;
  if (snapshot_step(last.filename().string()) >= steps->get<long long>()) return;
  const bool rests = still != run.end() && *still == true;
  throw InputError(last.string() + ": is the last snapshot, but the run " +
                   (rests ? "came to rest" : "ended") + " at step " + steps->dump() +
                   ": that one's is missing");
}

}  // namespace

ResultFolder::ResultFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (!std::filesystem::is_directory(folder_ / "dump")) {
    throw InputError(folder_.string() + ": has no folder dump/; give the folder that a run wrote");
  }
  scene_ = read_json_object(dump("scene.json"));
  require_lengths(scene_, dump("scene.json"));
  run_id_ = run_id_of(folder_ / "dump");
}

const std::vector<StartBlock>& ResultFolder::blocks() const {
  if (blocks_ == nullptr) {
    std::vector<StartBlock> blocks = read_blocks(dump("blocks.vtk"));
    const size_t rock = rock_blocks(blocks);
    if (symmetry() != 1 && rock != blocks.size()) {
      throw InputError(dump("blocks.vtk").string() +
                       ": muck in a model with images is not measured");
    }
    add_images(blocks, symmetry());
    if (rock < blocks.size() && symmetry() == 1) {
      rock_ = std::make_shared<const std::vector<StartBlock>>(
          blocks.begin(), blocks.begin() + static_cast<std::ptrdiff_t>(rock));
    }
    blocks_ = std::make_shared<const std::vector<StartBlock>>(std::move(blocks));
  }
  return *blocks_;
}

const std::vector<StartBlock>& ResultFolder::rock() const {
  const std::vector<StartBlock>& all = blocks();
  return rock_ == nullptr ? all : *rock_;
}

int ResultFolder::symmetry() const {
  if (!scene_has("symmetry")) return 1;
  const double number = scene_number("symmetry");
  for (const int each : {1, 2, 4}) {
    if (number == each) return each;
  }
  throw InputError(dump("scene.json").string() + ": symmetry must be 1, 2 or 4, got '" +
                   scene_["symmetry"].dump() + "'");
}

bool ResultFolder::is_still() const {
  const nlohmann::ordered_json run = read_json_object(dump("run.json"));
  const auto still = run.find("still");
  return still != run.end() && *still == true;
}

std::vector<std::filesystem::path> ResultFolder::snapshots() const {
  std::vector<std::filesystem::path> files = snapshot_files(folder_ / "dump");
  if (files.empty()) throw InputError(dump("").string() + ": holds no blocks_<step>.csv or .bin");
  require_end(files.back(), dump("run.json"));
  return files;
}

std::string ResultFolder::scene_word(const std::string& key) const {
  const auto found = scene_.find(key);
  return found != scene_.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string ResultFolder::knob(const std::string& name) const {
  const auto knobs = scene_.find("knobs");
  if (knobs == scene_.end() || !knobs->is_object()) return {};
  const auto found = knobs->find(name);
  return found != knobs->end() && found->is_string() ? found->get<std::string>() : std::string();
}

double ResultFolder::scene_number(const std::string& key) const {
  const auto found = scene_.find(key);
  if (found == scene_.end() || !found->is_number()) {
    throw InputError(dump("scene.json").string() + ": " + key + " must be a number");
  }
  return found->get<double>();
}

void ResultFolder::merge_into_summary(const nlohmann::ordered_json& keys,
                                      const std::vector<std::string>& dropped) const {
  const std::filesystem::path path = file("summary.json");
  nlohmann::ordered_json summary =
      std::filesystem::exists(path) ? read_json_object(path) : nlohmann::ordered_json::object();
  const auto before = summary.find("run_id");
  if (before != summary.end() ? *before != run_id_ : !run_id_.empty())
    summary = nlohmann::ordered_json::object();
  if (!run_id_.empty()) summary["run_id"] = run_id_;
  for (const std::string& key : dropped) summary.erase(key);
  for (const auto& [key, value] : keys.items()) summary[key] = value;
  const std::filesystem::path draft = file("summary.json.part");
  {
    std::ofstream out(draft);
    out << summary.dump(2) << '\n';
    if (!out.flush()) throw InputError(draft.string() + ": cannot be written");
  }
  std::filesystem::rename(draft, path);
}

}  // namespace muckpile
