// SPDX-License-Identifier: GPL-2.0-or-later
// hole_pattern: words to the core, its text to a file.
// Scope: see the header.
#include "fixes/explosive/hole_pattern.h"

#include <comm.h>
#include <error.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <system_error>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "explosive/charge_plan.h"
#include "explosive/delay_scatter.h"
#include "explosive/hole_pattern.h"
#include "explosive/hole_table.h"
#include "explosive/kirra_table.h"
#include "fixes/engine/output_file.h"
#include "fixes/engine/script_variables.h"
#include "fixes/engine/style_args.h"

namespace muckpile {
namespace {

double radians(double degrees) { return degrees * M_PI / 180.0; }

struct TableText {
  std::string text, report;
  std::optional<Vec3> place{};  // in the mine that is 0 0 0 of the table [m]
  std::string warning{};
};

constexpr double kMostCollarOffset = 0.5;  // [m], of the collars' mean height from bench_height

/// The words of `origin`; nothing where it is left out, or says so.
std::optional<Vec3> origin_of(const ArgValues& values, const std::string& where) {
  for (const auto& words : values.groups("origin")) {
    if (std::count(words.begin(), words.end(), "auto") == 3) continue;
    Vec3 origin;
    for (int c = 0; c < 3; ++c)
      origin[c] =
          parse_real(where, "origin", words[static_cast<std::size_t>(c)], "m", place_range());
    return origin;
  }
  return std::nullopt;
}

std::string place_text(const Vec3& origin, const ArgValues& values) {
  return "  place 0 0 0 is " + number_text(origin.x()) + ' ' + number_text(origin.y()) + ' ' +
         number_text(origin.z()) + " m there; x looks to the bearing " +
         number_text(values.real("throw_bearing")) + " degrees\n";
}

/// The bench is cut at bench_height, and stemming is counted from there. Holes drilled from the face
/// have their collars lower, so this is no fault.
std::string collars_beside(double bench_height, const HoleTable& table, const std::string& where,
                           const std::string& file) {
  std::map<std::string, double> heights;
  for (const Deck& deck : table.decks()) heights[deck.hole] = deck.hole_collar.z();
  double mean = 0.0;
  for (const auto& [hole, height] : heights) mean += height / static_cast<double>(heights.size());
  if (std::abs(mean - bench_height) <= kMostCollarOffset) return {};
  return where + ": the collars of " + file + " stand at z = " + rounded_text(mean) +
         " m in the mean, but bench_height, from which the stemming is counted, is " +
         number_text(bench_height) + " m";
}

/// A bench has no hole that is drilled upwards.
std::string upside_down(const HoleTable& table, const std::string& where, const std::string& file) {
  const auto up = std::ranges::find_if(
      table.decks(), [](const Deck& deck) { return deck.hole_toe.z() > deck.hole_collar.z(); });
  if (up == table.decks().end()) return {};
  return where + ": hole " + up->hole + " of " + file + " has its toe above its collar";
}

TableText taken(const std::string& own, const ArgValues& values, const std::string& where) {
  const CsvTable csv = CsvTable::read(own);
  const HoleTable table(csv);  // finds what is wrong with it
  TableText made{csv.text(),
                 where + ": " + std::to_string(table.holes()) + " holes, " +
                     std::to_string(table.decks().size()) + " decks of " + own + "\n",
                 origin_of(values, where)};
  if (made.place) {
    made.text = placed_table(csv, own, {*made.place, radians(values.real("throw_bearing"))});
    made.report += place_text(*made.place, values);
  }
  const HoleTable placed(CsvTable::parse(made.text, own));
  made.warning = upside_down(placed, where, own);
  if (made.warning.empty())
    made.warning = collars_beside(values.real("bench_height"), placed, where, own);
  return made;
}

KirraFrame frame_of(const ArgValues& values, const std::string& where) {
  KirraFrame frame;
  frame.throw_bearing = radians(values.real("throw_bearing"));
  frame.burden = values.real("burden");
  frame.subdrill = values.real("subdrill");
  frame.origin = origin_of(values, where);
  return frame;
}

/// The bench is cut at bench_height, so the holes of the plan must be those of such a bench.
void check_bench_height(const ConvertedHoles& holes, double bench_height,
                        const std::string& where) {
  if (std::abs(holes.collar_height - bench_height) <= kMostCollarOffset) return;
  refuse(where, "bench_height must be within " + number_text(kMostCollarOffset) +
                    " m of the collars' mean height above the floor, " +
                    rounded_text(holes.collar_height) + " m by the file of kirra, got '" +
                    number_text(bench_height) + "'; the floor is that of origin or subdrill");
}

TableText converted(const std::string& file, const ArgValues& values, const std::string& where) {
  if (values.integer("decks") != 1)
    refuse(where,
           "decks must be 1 with kirra, got '" + std::to_string(values.integer("decks")) + "'");
  const ConvertedHoles holes =
      convert_kirra(whole_file(file), file, frame_of(values, where),
                    {values.real("stemming"), values.real("in_hole_delay")});
  check_bench_height(holes, values.real("bench_height"), where);
  (void)HoleTable(CsvTable::parse(holes.table, file + ", converted"));
  return {holes.table,
          where + ": " + std::to_string(holes.holes) + " holes of " + file + " by Kirra\n" +
              place_text(holes.origin, values),
          holes.origin};
}

/// Faults of the user's file start with the command and its keyword.
template <class Read>
TableText of_file(const std::string& where, const std::string& keyword, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    const std::string text = error.what();
    throw InputError(text.rfind(where, 0) == 0 ? text : where + ": " + keyword + " " + text);
  }
}

TableText holes_of_plan(const ArgValues& values, const std::string& where) {
  const std::string &own = values.word("take"), &kirra = values.word("kirra");
  if (own != "none" && kirra != "none")
    refuse(where, "takes either take or kirra, got both '" + own + "' and '" + kirra + "'");
  if (kirra != "none")
    return of_file(where, "kirra", [&] { return converted(kirra, values, where); });
  if (own != "none") return of_file(where, "take", [&] { return taken(own, values, where); });
  if (origin_of(values, where)) refuse(where, "origin needs kirra or take");
  const HolePattern pattern = hole_pattern(values, where);
  return {hole_table_text(pattern), describe(pattern)};
}

TableText table_and_report(const ArgValues& values, const std::string& where) {
  TableText made = holes_of_plan(values, where);
  if (const std::string& file = values.word("charges"); file != "none") {
    made = of_file(where, "charges", [&] {
      const CsvTable charges = CsvTable::read(file);
      made.text = with_charges(made.text, "the plan", charges);
      made.report += "  " + std::to_string(charges.rows()) + " charges of " + file + "\n";
      return made;
    });
  }
  const DelayScatter scatter{values.real("scatter"),
                             static_cast<std::uint64_t>(values.integer("scatter_seed"))};
  if (scatter.share == 0.0) return made;
  const ScatteredTable late = scattered(made.text, where + ": the plan", scatter);
  return {late.text, made.report + late.report, made.place, made.warning};
}

}  // namespace

void HolePatternCommand::command(int narg, char** arg) {
  const std::string where = "hole_pattern";
  const ArgValues values = engine::or_engine_error(*lmp, [&] {
    return parse_args(hole_pattern_table(), where, engine::words_of(narg, arg, 0));
  });
  const TableText made =
      engine::or_engine_error(*lmp, [&] { return table_and_report(values, where); });
  const std::filesystem::path file = values.word("file");
  std::error_code unheeded;  // write_file tells what is wrong with the folder
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), unheeded);
  engine::write_file(*lmp, where, file.string(), made.text);
  engine::print_once(*lmp, made.report + "  table: " + file.string() + "\n");
  if (!made.warning.empty() && comm->me == 0) error->warning(FLERR, made.warning.c_str());
  if (!made.place) return;
  engine::set_script_variable(*lmp, "pattern_east", made.place->x());
  engine::set_script_variable(*lmp, "pattern_north", made.place->y());
  engine::set_script_variable(*lmp, "pattern_height", made.place->z());
}

}  // namespace muckpile
