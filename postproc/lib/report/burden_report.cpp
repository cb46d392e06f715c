// SPDX-License-Identifier: GPL-2.0-or-later
// The burden of each hole along its charge, as table and picture.
// Scope: see the header.
#include "report/burden_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "draw/png_file.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/mine_frame.h"
#include "report/burden_plot.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "rock/burden_file.h"

namespace muckpile {
namespace {

// Of the hole table where it has as many decks as there are charges; else their numbers.
std::vector<std::string> names_of(const ResultFolder& folder, size_t charges) {
  std::vector<std::string> names;
  if (std::filesystem::exists(folder.dump("holes.csv"))) {
    const HoleTable table = hole_table_of(folder);
    if (table.decks().size() == charges) {
      for (const Deck& deck : table.decks()) names.push_back(deck.hole);
      return names;
    }
  }
  for (size_t h = 0; h < charges; ++h) names.push_back(std::to_string(h + 1));
  return names;
}

std::string word_for(BurdenIs verdict) {
  switch (verdict) {
    case BurdenIs::too_little:
      return "too_little";
    case BurdenIs::as_planned:
      return "as_planned";
    case BurdenIs::too_much:
      return "too_much";
    case BurdenIs::not_judged:
      break;
  }
  return "";
}

void write_table(const ResultFolder& folder, const BurdenFile& burdens,
                 const std::vector<std::string>& names) {
  const std::optional<MineFrame> frame = mine_frame(folder);
  CsvWriter csv(folder.file("burden.csv"),
                with_mine_points("hole,in_front,verdict,along_m,x_m,y_m,z_m,burden_m,to_face_m,"
                                 "face_x_m,face_y_m,face_z_m",
                                 frame, {"", "face_"}));
  for (size_t h = 0; h < burdens.holes.size(); ++h) {
    const HoleBurden& hole = burdens.holes[h];
    for (const BurdenPiece& piece : hole.pieces) {
      const std::optional<double> counts = burden_that_counts(hole, piece);
      const Vec3 face = piece.burden ? piece.face : Vec3::Constant(std::nan(""));
      const std::string front = hole.in_front ? names[*hole.in_front] : "";
      csv.row_at(
          joined({names[h], front, word_for(judged(counts, burdens.plan))}, ","),
          {piece.along, piece.at.x(), piece.at.y(), piece.at.z(), counts.value_or(std::nan("")),
           piece.burden.value_or(std::nan("")), face.x(), face.y(), face.z()},
          mine_points(frame, {piece.at, face}));
    }
  }
}

std::vector<HoleBurdens> drilled_holes(const BurdenFile& burdens,
                                       const std::vector<std::string>& names) {
  std::vector<HoleBurdens> holes;
  std::map<std::string, size_t> known;
  for (size_t h = 0; h < burdens.holes.size(); ++h) {
    const auto [place, fresh] = known.emplace(names[h], holes.size());
    if (fresh) holes.push_back({names[h], {}});
    for (const BurdenPiece& piece : burdens.holes[h].pieces) {
      const std::optional<double> counts = burden_that_counts(burdens.holes[h], piece);
      if (counts)
        holes[place->second].points.push_back(
            {piece.at.z(), *counts, judged(counts, burdens.plan)});
    }
  }
  return holes;
}

nlohmann::ordered_json keys_of(const std::vector<HoleBurdens>& holes, double plan) {
  double least = std::nan(""), greatest = std::nan("");
  int too_little = 0, too_much = 0;
  for (const HoleBurdens& hole : holes) {
    const auto any = [&](BurdenIs verdict) {
      return std::ranges::count(hole.points, verdict, &BurdenPoint::verdict) > 0 ? 1 : 0;
    };
    too_little += any(BurdenIs::too_little);
    too_much += any(BurdenIs::too_much);
    for (const BurdenPoint& point : hole.points) {
      least = std::fmin(least, point.burden);
      greatest = std::fmax(greatest, point.burden);
    }
  }
  const bool told = plan > 0.0;
  nlohmann::ordered_json keys;
  keys["burden_plan_m"] = told ? plan : std::nan("");
  keys["burden_least_m"] = least;
  keys["burden_greatest_m"] = greatest;
  keys["holes_burden_too_little"] = nullptr;
  keys["holes_burden_too_much"] = nullptr;
  if (told) keys["holes_burden_too_little"] = too_little, keys["holes_burden_too_much"] = too_much;
  return keys;
}

}  // namespace

void report_burden(const ResultFolder& folder) {
  const std::filesystem::path file = folder.dump("burden.csv");
  BurdenFile burdens;
  if (std::filesystem::exists(file)) burdens = read_burdens(file);
  if (burdens.holes.empty()) {
    for (const char* name : {"burden.csv", "burden.png"})
      std::filesystem::remove(folder.file(name));
    const NotMeasurable why(
        "burden: needs a hole in dump/burden.csv, which create_blocks writes with 'burden_file'");
    if (std::filesystem::exists(folder.dump("run.json")))
      take_back(folder, "burden", keys_of({}, 0.0), why);
    throw why;
  }
  const std::vector<std::string> names = names_of(folder, burdens.holes.size());
  write_table(folder, burdens, names);
  const std::vector<HoleBurdens> holes = drilled_holes(burdens, names);
  write_png(draw_burdens(holes, burdens.plan), folder.file("burden.png"));
  nlohmann::ordered_json keys;
  if (std::filesystem::exists(folder.dump("run.json"))) keys = common_keys(folder);
  keys.update(keys_of(holes, burdens.plan));
  folder.merge_into_summary(keys, {refusal_key("burden")});
}

}  // namespace muckpile
