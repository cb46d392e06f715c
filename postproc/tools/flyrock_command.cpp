// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command flyrock of muckpile-post.
// Scope: see the header.
#include "flyrock_command.h"

#include <cstdio>
#include <memory>
#include <string>

#include "args/rounded_text.h"
#include "command_words.h"
#include "draw/axes.h"
#include "report/reports.h"

namespace muckpile {
namespace {

struct FlyrockWords {
  std::string folder;
  FlyrockOptions options;
};

std::string in_metres(const nlohmann::ordered_json& value, double factor = 1.0) {
  if (!value.is_number()) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.0f", factor * value.get<double>());
  return text;
}

void print_row(const std::string& name, const nlohmann::ordered_json& low,
               const nlohmann::ordered_json& high, double factor) {
  const std::string range =
      low == high ? in_metres(high) : in_metres(low) + " to " + in_metres(high);
  std::printf("%-54s %16s %16s\n", name.c_str(), range.c_str(), in_metres(high, factor).c_str());
}

void print_table(const nlohmann::ordered_json& keys) {
  const double factor = keys["formula_flyrock_safety_factor"];
  const std::string low = rounded_text(keys["formula_flyrock_k_low"]),
                    high = rounded_text(keys["formula_flyrock_k_high"]);
  const std::string k = ", k = " + (low == high ? high : low + " to " + high);
  std::printf("%s\n%-54s %16s %16s\n", keys["formula_flyrock_note"].get<std::string>().c_str(), "",
              "range L [m]", ("clearance " + rounded_text(factor) + " L [m]").c_str());
  const auto row = [&](const std::string& name, const std::string& key) {
    print_row(name + k, keys["formula_" + key + "_low_m"], keys["formula_" + key + "_high_m"],
              factor);
  };
  row("Richards & Moore: face burst", "face_burst");
  row("Richards & Moore: cratering", "cratering");
  row("Richards & Moore: gun-barrelling", "gun_barrelling");
  print_row("McKenzie: scaled depth of burial " + spelled(keys["formula_depth_of_burial_m_kg033"]) +
                " m/kg^(1/3)",
            keys["formula_mckenzie_m"], keys["formula_mckenzie_m"], factor);
  if (const auto& note = keys["formula_clearance_note"]; note.is_string())
    std::printf("%s\n", note.get<std::string>().c_str());
  std::printf("%-54s %16s   %s\n", "farthest block of this run",
              in_metres(keys["farthest_block_m"]).c_str(),
              keys["farthest_block_note"].get<std::string>().c_str());
}

}  // namespace

void add_flyrock_command(CLI::App& app) {
  const auto words = std::make_shared<FlyrockWords>();
  FlyrockOptions& options = words->options;
  CLI::App* command = app.add_subcommand(
      "flyrock",
      "bench: flyrock.csv and a table: ranges of fly rock by formulas of practice, clearances, and "
      "the farthest block of the run");
  command->add_option("folder", words->folder, "result folder of the run; it holds dump/")
      ->required();
  command
      ->add_option("--k", options.site_constant,
                   "site constant of Richards & Moore (default: its usual range, 14 to 30)")
      ->check(between(0.1, 1000.0));
  command
      ->add_option("--launch-angle", options.launch_angle_deg,
                   "of stemming that is blown out, to the horizontal [deg]")
      ->check(between(45.0, 90.0));
  command->add_option("--factor", options.safety_factor, "factor of safety: clearance over range")
      ->check(between(1.0, 10.0));
  command->callback([words] {
    const ResultFolder folder(words->folder);
    report_flyrock(folder, words->options);
    print_table(read_json_object(folder.file("summary.json")));
  });
}

}  // namespace muckpile
