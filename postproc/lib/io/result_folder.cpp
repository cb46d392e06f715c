// SPDX-License-Identifier: GPL-2.0-or-later
// The folder of one run: where its dumps are, what its scene was, and its summary.json.
// Scope: the summary is written to a second file and renamed, so a reader never sees half of it.
#include "io/result_folder.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <utility>

#include "args/input_error.h"

namespace muckpile {
namespace {

// The step in "blocks_000001000.csv", or -1 for any other name.
long step_of(const std::string& name) {
  constexpr std::string_view kBefore = "blocks_", kAfter = ".csv";
  if (!name.starts_with(kBefore) || !name.ends_with(kAfter)) return -1;
  const char* begin = name.data() + kBefore.size();
  const char* end = name.data() + name.size() - kAfter.size();
  long step = -1;
  const auto [stop, error] = std::from_chars(begin, end, step);
  return error == std::errc() && stop == end ? step : -1;
}

}  // namespace

nlohmann::ordered_json read_json_object(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw InputError(path.string() + ": cannot be opened");
  nlohmann::ordered_json object;
  try {
    object = nlohmann::ordered_json::parse(in);
  } catch (const nlohmann::json::parse_error& error) {
    throw InputError(path.string() + ": " + error.what());
  }
  if (!object.is_object()) throw InputError(path.string() + ": must hold one JSON object");
  return object;
}

ResultFolder::ResultFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  if (!std::filesystem::is_directory(folder_ / "dump")) {
    throw InputError(folder_.string() + ": has no folder dump/; give the folder that a run wrote");
  }
  scene_ = read_json_object(dump("scene.json"));
}

std::vector<std::filesystem::path> ResultFolder::snapshots() const {
  std::vector<std::pair<long, std::filesystem::path>> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "dump")) {
    const long step = step_of(entry.path().filename().string());
    if (step >= 0) found.emplace_back(step, entry.path());
  }
  if (found.empty()) throw InputError(dump("").string() + ": holds no blocks_<step>.csv");
  std::ranges::sort(found);
  std::vector<std::filesystem::path> paths;
  for (auto& [step, path] : found) paths.push_back(std::move(path));
  return paths;
}

std::string ResultFolder::scene_word(const std::string& key) const {
  const auto found = scene_.find(key);
  return found != scene_.end() && found->is_string() ? found->get<std::string>() : std::string();
}

double ResultFolder::scene_number(const std::string& key) const {
  const auto found = scene_.find(key);
  if (found == scene_.end() || !found->is_number()) {
    throw InputError(dump("scene.json").string() + ": " + key + " must be a number");
  }
  return found->get<double>();
}

void ResultFolder::merge_into_summary(const nlohmann::ordered_json& keys) const {
  const std::filesystem::path path = file("summary.json");
  nlohmann::ordered_json summary =
      std::filesystem::exists(path) ? read_json_object(path) : nlohmann::ordered_json::object();
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
