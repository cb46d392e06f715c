// SPDX-License-Identifier: GPL-2.0-or-later
// Figures of the perf programs as the rows of a CSV file.
// Scope: perf_table RESULTS NAME...; RESULTS/NAME.json is what perf_NAME has printed. Only the
// figures per point, sphere, joint, pair and rebuild, and their targets, are shown.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>

namespace {

using Json = nlohmann::ordered_json;

bool is_shown(const std::string& key) {
  static const std::set<std::string> shown{
      "ns_per_point",         "target_ns_per_point", "ns_per_sphere",
      "target_ns_per_sphere", "ns_per_joint",        "target_ns_per_joint",
      "rebuild_wall_s",       "rebuild_target_s",    "contact_step_ns_per_candidate_pair",
      "ns_per_pair"};
  return shown.contains(key);
}

class Table {
 public:
  explicit Table(std::string program) : program_(std::move(program)) {}

  // The outermost object that a figure lies in is its scene; `size` is that of one run of several.
  void add(const Json& object, const std::string& scene, const std::string& size) const {
    for (const auto& [key, value] : object.items()) {
      if (value.is_object()) {
        add(value, scene.empty() ? key + size : scene, size);
      } else if (value.is_array()) {
        for (const Json& run : value) add(run, scene, size_of(run));
      } else if (value.is_number() && is_shown(key)) {
        const bool target = key.find("target") != std::string::npos;
        std::printf("%s,\"%s\",%s,%.3g\n", program_.c_str(), target ? "target" : scene.c_str(),
                    key.c_str(), value.get<double>());
      }
    }
  }

 private:
  static std::string size_of(const Json& run) {
    return ", " + run.at("blocks").dump() + " blocks of " + run.at("spheres_per_block").dump() +
           " spheres";
  }

  std::string program_;
};

void write(int argc, char** argv) {
  std::puts("program,scene,figure,value");
  for (int k = 2; k < argc; ++k) {
    const std::string name = argv[k];
    const auto path = std::filesystem::path(argv[1]) / (name + ".json");
    std::ifstream in(path);
    if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
    Table("perf_" + name).add(Json::parse(in), "", "");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s RESULTS NAME...\n", argv[0]);
    return 2;
  }
  try {
    write(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "perf_table: %s\n", error.what());
    return 1;
  }
  return 0;
}
