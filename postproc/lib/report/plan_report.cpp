// SPDX-License-Identifier: GPL-2.0-or-later
// Plan of a blast pattern: holes, firing times, contours of equal time.
// Scope: x to the right, y up, equal scales; the first deck of a hole stands for it.
#include "report/plan_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "args/input_error.h"
#include "draw/axes.h"
#include "draw/png_file.h"
#include "explosive/hole_table.h"
#include "io/charges.h"
#include "io/csv_writer.h"
#include "io/pattern_charges.h"
#include "measure/contours.h"
#include "report/block_colours.h"
#include "report/reports.h"

namespace muckpile {
namespace {

constexpr double kLeft = 105.0, kRight = 30.0, kAbove = 150.0, kBelow = 85.0;  // margins [px]
constexpr double kMostSide = 1400.0;  // of the plot area [px]
constexpr double kTextSize = 18.0;

struct Plan {
  std::vector<std::string> names;
  std::vector<Vec2> places;   // of the collars [m]
  std::vector<double> times;  // of each hole's first deck [ms]
};

Plan plan_of(const HoleTable& table) {
  std::map<std::string, size_t> known;
  Plan plan;
  for (const Deck& deck : table.decks()) {
    const double time = 1e3 * deck.firing_time;
    const auto [place, fresh] = known.emplace(deck.hole, plan.places.size());
    if (fresh) {
      plan.names.push_back(deck.hole);
      plan.places.emplace_back(deck.hole_collar.x(), deck.hole_collar.y());
      plan.times.push_back(time);
    } else {
      double& first = plan.times[place->second];
      first = std::min(first, time);
    }
  }
  return plan;
}

// The holes with a margin of the mean distance between neighbours.
std::pair<AxisRange, AxisRange> frame(const Plan& plan) {
  const auto range = [&](Eigen::Index k) {
    const auto [low, high] =
        std::ranges::minmax_element(plan.places, {}, [k](const Vec2& p) { return p[k]; });
    return AxisRange{(*low)[k], (*high)[k]};
  };
  AxisRange x = range(0), y = range(1);
  const double area = std::max(1.0, (x.high - x.low) * (y.high - y.low));
  const double margin = std::sqrt(area / static_cast<double>(plan.places.size()));
  return {{x.low - margin, x.high + margin}, {y.low - margin, y.high + margin}};
}

void draw_contours(const Plan& plan, const Axes& axes, const ColourMap& map, Canvas& canvas) {
  constexpr int kWanted = 15;
  const std::vector<Triangle> triangles = triangulate(plan.places);
  for (const double level : straight_ticks({map.low(), map.high()}, kWanted)) {
    for (const auto& [from, to] : contour(plan.places, plan.times, triangles, level)) {
      canvas.line(axes.place(from.x(), from.y()), axes.place(to.x(), to.y()), 2.5, map.at(level));
    }
  }
}

void draw_holes(const Plan& plan, const Axes& axes, const ColourMap& map, Canvas& canvas) {
  constexpr double kRadius = 7.0;
  constexpr int kCorners = 16;
  for (size_t h = 0; h < plan.places.size(); ++h) {
    const Vec2 at = axes.place(plan.places[h].x(), plan.places[h].y());
    std::vector<Vec2> disc;
    for (int k = 0; k < kCorners; ++k) {
      const double angle = 2.0 * M_PI * k / kCorners;
      disc.push_back(at + kRadius * Vec2(std::cos(angle), std::sin(angle)));
    }
    canvas.fill(disc, map.at(plan.times[h]));
    disc.push_back(disc.front());
    canvas.polyline(disc, 1.5, kInk);
    canvas.text(at + Vec2(0.0, -11.0), spelled(plan.times[h], 4), kTextSize, kInk, Anchor::kCentre);
  }
}

void write_table(const Plan& plan, const std::filesystem::path& path) {
  CsvWriter csv(path, "hole,x_m,y_m,fires_s");
  for (size_t h = 0; h < plan.places.size(); ++h)
    csv.row(plan.names[h], {plan.places[h].x(), plan.places[h].y(), 1e-3 * plan.times[h]});
}

Canvas draw(const HoleTable& table, const Plan& plan) {
  const auto [x, y] = frame(plan);
  const double scale = kMostSide / std::max(x.high - x.low, y.high - y.low);
  const double width = std::max(600.0, scale * (x.high - x.low));
  const double height = scale * (y.high - y.low);
  const double more = 0.5 * (width / scale - (x.high - x.low));
  Canvas canvas(static_cast<int>(kLeft + width + kRight),
                static_cast<int>(kAbove + height + kBelow), kWhite);
  const Axes axes({kLeft, kAbove}, {kLeft + width, kAbove + height}, {x.low - more, x.high + more},
                  y);
  const auto [first, last] = std::ranges::minmax(plan.times);
  BlockColours colours;
  colours.map = amount_map(first, std::max(last, first + 1e-3));
  colours.label = "first deck fires [ms]";
  axes.draw_grid(canvas);
  draw_contours(plan, axes, *colours.map, canvas);
  draw_holes(plan, axes, *colours.map, canvas);
  axes.draw_frame(canvas, "x [m]", "y [m]");
  canvas.text({kLeft, 48.0}, "Plan of the blast", 30.0, kInk);
  canvas.text(
      {kLeft, 88.0},
      std::to_string(table.holes()) + " holes, " + std::to_string(table.decks().size()) + " decks",
      kTextSize + 4.0, kInk);
  draw_legend(colours, {kLeft + width - 310.0, 22.0}, canvas);
  return canvas;
}

size_t most_decks_together(const HoleTable& table) {
  std::vector<TimedCharge> decks;
  for (const Deck& deck : table.decks()) decks.push_back({deck.firing_time, 1.0});
  return static_cast<size_t>(std::lround(largest_within(decks, kVibrationWindow)));
}

// The table may be one that another run has left, or have been changed since.
void require_same_charges(const ResultFolder& folder, const HoleTable& table) {
  const std::vector<Charge> charges = charges_of_run(folder);
  if (charges.empty()) return;
  for (const Deck& deck : table.decks()) {
    const double near = 0.01 * (deck.collar - deck.toe).norm();
    const bool found = std::ranges::any_of(charges, [&](const Charge& charge) {
      return (charge.toe - deck.toe).norm() <= near && (charge.collar - deck.collar).norm() <= near;
    });
    if (found) continue;
    throw InputError(folder.dump("holes.csv").string() + ": hole '" + deck.hole +
                     "' is not where " + folder.dump("run.json").string() +
                     " has a charge; give the folder the table that the run has read");
  }
}

}  // namespace

void report_plan(const std::filesystem::path& what) {
  if (!std::filesystem::is_directory(what)) {
    const HoleTable table = HoleTable::read(what.string());
    write_png(draw(table, plan_of(table)), std::filesystem::path(what).replace_extension(".png"));
    return;
  }
  const ResultFolder folder(what);
  const HoleTable table = HoleTable::read(folder.dump("holes.csv").string());
  require_same_charges(folder, table);
  const Plan plan = plan_of(table);
  write_png(draw(table, plan), folder.file("plan.png"));
  write_table(plan, folder.file("plan.csv"));
  const auto firing = [](const Deck& deck) { return deck.firing_time; };
  nlohmann::ordered_json keys;
  if (std::filesystem::exists(folder.dump("run.json"))) keys = common_keys(folder);
  keys["pattern_holes"] = table.holes();
  keys["pattern_decks"] = table.decks().size();
  keys["first_firing_s"] = std::ranges::min(table.decks(), {}, firing).firing_time;
  keys["last_firing_s"] = std::ranges::max(table.decks(), {}, firing).firing_time;
  keys["most_decks_within_8_ms"] = most_decks_together(table);
  keys["largest_charge_within_8_ms_kg"] =
      largest_within(charges_of_decks(folder, table), kVibrationWindow);
  folder.merge_into_summary(keys);
}

}  // namespace muckpile
