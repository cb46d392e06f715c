// SPDX-License-Identifier: GPL-2.0-or-later
// What a script asks of a folder of results of another run.
// Scope: see the header.
#include "provenance/results_folder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "provenance/run_files.h"

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

/// What stands behind a key and its colon.
std::optional<std::string> value_of(const std::string& scene, const std::string& key) {
  const std::string name = '"' + key + '"';
  const std::size_t at = scene.find(name);
  const std::size_t colon = at == std::string::npos ? at : scene.find(':', at + name.size());
  if (colon == std::string::npos) return std::nullopt;
  return scene.substr(colon + 1);
}

}  // namespace

bool lies_in(const std::string& path, const std::string& folder) {
  const fs::path inner = whole_path(path), outer = whole_path(folder);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

bool has_scene(const std::string& folder) { return scene_text(folder).has_value(); }

std::optional<double> scene_number(const std::string& folder, const std::string& key) {
  const auto value = value_of(scene_text(folder).value_or(""), key);
  if (!value) return std::nullopt;
  std::istringstream rest(*value);
  double number = 0.0;
  return rest >> number ? std::optional(number) : std::nullopt;
}

std::optional<std::string> scene_run_id(const std::string& folder) {
  const auto scene = scene_text(folder);
  if (!scene) return std::nullopt;
  const std::string value = value_of(*scene, "run_id").value_or("");
  const std::size_t open = value.find('"');
  if (open == std::string::npos) return "";
  const std::string id = value.substr(open + 1, value.find('"', open + 1) - open - 1);
  return is_run_id(id) ? id : "";
}

bool file_holds(const std::string& file, const std::string& bytes) {
  constexpr std::size_t kPiece = 1 << 20;
  std::ifstream in(file, std::ios::binary);
  std::string piece;  // with the end of the one before
  std::vector<char> read(kPiece);
  while (in) {
    in.read(read.data(), static_cast<std::streamsize>(read.size()));
    piece.append(read.data(), static_cast<std::size_t>(in.gcount()));
    if (piece.find(bytes) != std::string::npos) return true;
    if (piece.size() > bytes.size()) piece.erase(0, piece.size() - bytes.size());
  }
  return false;
}

}  // namespace muckpile
