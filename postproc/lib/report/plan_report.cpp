// SPDX-License-Identifier: GPL-2.0-or-later
// Plan of a blast pattern: table, keys and picture.
// Scope: what the picture shows is in blast_plan.h.
#include "report/plan_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "args/input_error.h"
#include "draw/png_file.h"
#include "explosive/hole_table.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "io/pattern_charges.h"
#include "report/blast_plan.h"
#include "report/hole_outlines.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "rock/burden_file.h"

namespace muckpile {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Of each deck [m], by the table that create_blocks has left; empty without it.
std::vector<double> ways_to_face(const ResultFolder& folder, const HoleTable& table) {
  const std::filesystem::path path = folder.dump("burden.csv");
  if (!std::filesystem::exists(path)) return {};
  const BurdenFile burdens = read_burdens(path);
  if (burdens.holes.size() != table.decks().size()) return {};
  std::vector<double> ways;
  for (const HoleBurden& hole : burdens.holes) {
    double least = kNaN;
    for (const BurdenPiece& piece : hole.pieces) {
      if (piece.burden) least = std::fmin(least, *piece.burden);
    }
    ways.push_back(least);
  }
  return ways;
}

void write_table(const ResultFolder& folder, const std::vector<PlannedHole>& plan) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("plan.csv"),
                with_mine_columns("hole,in_front,x_m,y_m,fires_s,charge_kg,burden_m,"
                                  "relief_ms_per_m,within_8_ms_kg",
                                  frame));
  for (const PlannedHole& hole : plan) {
    const Relief& relief = hole.relief;
    const std::string front = relief.in_front ? plan[*relief.in_front].name : "";
    csv.row_at(
        joined({hole.name, front}, ","),
        {hole.collar.x(), hole.collar.y(), hole.fires, hole.mass, relief.burden.value_or(kNaN),
         1e3 * relief.per_metre.value_or(kNaN), hole.within_window},
        mine_place(frame, hole.collar.x(), hole.collar.y()));
  }
}

void add_least_relief(const std::vector<PlannedHole>& plan, nlohmann::ordered_json& keys) {
  double least = kNaN;
  for (const PlannedHole& hole : plan)
    least = std::fmin(least, 1e3 * hole.relief.per_metre.value_or(kNaN));
  if (!std::isnan(least)) keys["burden_relief_least_ms_per_m"] = least;
}

std::vector<TimedCharge> charges_without_run(const HoleTable& table) {
  std::vector<TimedCharge> charges;
  for (const Deck& deck : table.decks())
    charges.push_back({deck.firing_time,
                       charge_mass(deck, deck.explosive_density.value_or(
                                             deck.explosive ? density_of(*deck.explosive,
                                                                         ExplosiveTable::shipped())
                                                            : kNaN))});
  return charges;
}

size_t most_decks_together(const HoleTable& table) {
  std::vector<TimedCharge> decks;
  for (const Deck& deck : table.decks()) decks.push_back({deck.firing_time, 1.0});
  return static_cast<size_t>(std::lround(largest_within(decks, kVibrationWindow)));
}

// The rock of each hole, where the run has cut it and it is a bench that can be measured.
std::vector<HolePolygon> outlines_if_told(const ResultFolder& folder) {
  if (folder.scene_word("case") != "bench" || !std::filesystem::exists(folder.dump("blocks.vtk")))
    return {};
  try {
    return hole_outlines(folder, bench_scene(folder, folder.rock()), folder.rock());
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

void report_plan(const std::filesystem::path& what) {
  if (!std::filesystem::is_directory(what)) {
    const auto picture = std::filesystem::path(what).replace_extension(".png");
    if (picture == what)
      throw InputError(
          "plan: " + what.string() +
          ": the picture would replace the table; rename the table, to .csv for example");
    const HoleTable table = HoleTable::read(what.string());
    write_png(draw_plan(table, planned_holes(table, charges_without_run(table), {})), picture);
    return;
  }
  const ResultFolder folder(what);
  if (!std::filesystem::exists(folder.dump("holes.csv")))
    refuse_to_measure(folder, "plan", "needs the run's hole table, dump/holes.csv");
  const HoleTable table = hole_table_of(folder);
  const std::vector<TimedCharge> charges = charges_of_decks(folder, table);
  const std::vector<PlannedHole> plan = planned_holes(table, charges, ways_to_face(folder, table));
  write_png(draw_plan(table, plan, outlines_if_told(folder)), folder.file("plan.png"));
  write_table(folder, plan);
  const auto firing = [](const Deck& deck) { return deck.firing_time; };
  nlohmann::ordered_json keys;
  if (std::filesystem::exists(folder.dump("run.json"))) keys = common_keys(folder);
  keys["pattern_holes"] = table.holes();
  keys["pattern_decks"] = table.decks().size();
  keys["first_firing_s"] = std::ranges::min(table.decks(), {}, firing).firing_time;
  keys["last_firing_s"] = std::ranges::max(table.decks(), {}, firing).firing_time;
  keys["most_decks_within_8_ms"] = most_decks_together(table);
  keys["largest_charge_within_8_ms_kg"] = largest_within(charges, kVibrationWindow);
  add_least_relief(plan, keys);
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
