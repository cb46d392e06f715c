// SPDX-License-Identifier: GPL-2.0-or-later
// write_scene: words to a JSON object.
// Scope: see the header.
#include "fixes/output/write_scene.h"

#include <comm.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "args/input_error.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/first_rank.h"
#include "fixes/engine/json_text.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/script_variables.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/recorded_run_holder.h"
#include "fixes/run/build_info.h"

namespace muckpile {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStyle = "write_scene";
constexpr std::string_view kMayChange = "may_change";

struct Words {
  std::string file;
  Json scene = Json::object();
  std::vector<std::string> may_change;
};

/// A number as a number, however the script spells it; anything else as text.
Json json_value(const std::string& text) {
  return std::visit([](const auto& value) { return Json(value); }, read_spelling(text));
}

void refuse_key(const Json& scene, const std::string& key) {
  constexpr std::array<std::string_view, 8> kOurs{"knobs", "command_line", "version",   "commit",
                                                  "ranks", "compiler",     "libraries", "run_id"};
  const std::string where = std::string(kStyle) + ": key '" + key + "' ";
  if (std::find(kOurs.begin(), kOurs.end(), key) != kOurs.end())
    throw InputError(where + "is written by the command itself; choose another");
  if (scene.contains(key)) throw InputError(where + "is given twice");
}

Words read_words(const std::vector<std::string>& words) {
  if (words.size() < 3 || words[1] != "case")
    throw InputError(std::string(kStyle) +
                     ": needs a file, the word 'case' and the name of the case, got '" +
                     (words.size() < 2 ? "" : words[1]) + "'");
  Words read;
  read.file = words[0];
  for (std::size_t k = 1; k < words.size(); k += 2) {
    if (words[k] == kMayChange) {
      read.may_change.assign(words.begin() + static_cast<std::ptrdiff_t>(k) + 1, words.end());
      return read;
    }
    refuse_key(read.scene, words[k]);
    // An empty variable leaves no word.
    if (k + 1 == words.size() || words[k + 1] == kMayChange)
      throw InputError(std::string(kStyle) + ": key '" + words[k] + "' has no value");
    read.scene[words[k]] = json_value(words[k + 1]);
  }
  return read;
}

/// In quotes where a shell would split or change it.
std::string as_shell_word(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,/:@%^";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// As the system has it; "unknown" where it does not tell.
std::string command_line() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::string line;
  for (std::string word; std::getline(in, word, '\0');)
    line += std::string(line.empty() ? "" : " ") + as_shell_word(word);
  return line.empty() ? "unknown" : line;
}

Json knobs(LAMMPS_NS::LAMMPS& lmp) {
  Json object = Json::object();
  for (const Knob& knob : engine::script_knobs(lmp)) {
    if (knob.value) object[knob.name] = json_value(*knob.value);
  }
  return object;
}

void add_record(LAMMPS_NS::LAMMPS& lmp, const std::string& run_id, Json& scene) {
  const BuildInfo build = build_info();
  scene["run_id"] = run_id;
  scene["version"] = MUCKPILE_VERSION;
  scene["commit"] = build.commit;
  scene["compiler"] = build.compiler;
  for (const auto& [name, version] : build.libraries) scene["libraries"][name] = version;
  scene["ranks"] = lmp.comm->nprocs;
  scene["command_line"] = command_line();
  scene["knobs"] = knobs(lmp);
}

/// Of a scene that stands there; "" if none can be read.
std::optional<std::string> id_of_scene(const std::string& file) {
  std::ifstream in(file);
  if (!in) return std::nullopt;
  const Json scene = Json::parse(in, nullptr, false);
  const auto id = scene.is_object() ? scene.find("run_id") : scene.end();
  return scene.is_object() && id != scene.end() && id->is_string() ? id->get<std::string>() : "";
}

/// A run that goes on writes on what it has left, not over the results of another.
void refuse_other_run(LAMMPS_NS::LAMMPS& lmp, const std::string& file, const std::string& run_id) {
  engine::on_first_rank(lmp, [&] {
    const std::optional<std::string> there = id_of_scene(file);
    if (!there || *there == run_id) return;
    throw InputError(std::string(kStyle) + ": '" + file + "' must be of the run that goes on, " +
                     run_id + ", or not be there, got " +
                     (there->empty() ? "one without a run_id that can be read"
                                     : "the scene of another run, " + *there) +
                     "; go on in the folder of the restart file's run, or in a new one (-var out)");
  });
}

}  // namespace

void WriteScene::command(int narg, char** arg) {
  Words words =
      engine::or_engine_error(*lmp, [&] { return read_words(engine::words_of(narg, arg, 0)); });
  auto* run = engine::find_view<RecordedRunHolder>(*lmp);
  if (run == nullptr)
    engine::stop(*lmp, std::string(kStyle) +
                           ": needs create_blocks before it, or read_restart and fix "
                           "multisphere/muckpile");
  run->record().allow_changes(words.may_change);
  run->record().check_values(*lmp, kStyle);
  if (run->record().goes_on()) refuse_other_run(*lmp, words.file, run->record().id());
  add_record(*lmp, run->record().id(), words.scene);
  if (comm->me == 0) {
    std::error_code unheeded;  // writing tells
    std::filesystem::create_directories(std::filesystem::path(words.file).parent_path(), unheeded);
  }
  engine::write_file(*lmp, kStyle, words.file, engine::json_text(words.scene));
  // The script may have more knobs behind this command.
  run->record().complete_with([&engine = *lmp, words]() mutable {
    words.scene["knobs"] = knobs(engine);
    engine::write_file(engine, kStyle, words.file, engine::json_text(words.scene));
  });
}

}  // namespace muckpile
