// SPDX-License-Identifier: GPL-2.0-or-later
// What a script asks of a folder of results of another run.
// Scope: see the header.
#include "provenance/results_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace muckpile {
namespace {

namespace fs = std::filesystem;

fs::path whole_path(const std::string& name) {
  std::error_code unheeded;
  fs::path path = fs::weakly_canonical(fs::absolute(name, unheeded), unheeded);
  return path.has_filename() ? path : path.parent_path();
}

/// None where there is no such file.
std::optional<std::string> scene_text(const std::string& folder) {
  for (const fs::path& each : {fs::path(folder) / "dump", fs::path(folder)}) {
    std::ifstream in(each / "scene.json");
    if (!in) continue;
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  }
  return std::nullopt;
}

}  // namespace

bool lies_in(const std::string& path, const std::string& folder) {
  const fs::path inner = whole_path(path), outer = whole_path(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

bool has_scene(const std::string& folder) { return scene_text(folder).has_value(); }

std::optional<double> scene_number(const std::string& folder, const std::string& key) {
  const std::string text = scene_text(folder).value_or(""), name = '"' + key + '"';
  const std::size_t at = text.find(name);
  const std::size_t colon = at == std::string::npos ? at : text.find(':', at + name.size());
  if (colon == std::string::npos) return std::nullopt;
  std::istringstream rest(text.substr(colon + 1));
  double number = 0.0;
  return rest >> number ? std::optional(number) : std::nullopt;
}

}  // namespace muckpile
