// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of holes behind a face; see the header.
#include "explosive/hole_pattern.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include "args/input_error.h"
#include "args/numbers.h"
#include "explosive/hole_table.h"
#include "explosive/table_text.h"

namespace muckpile {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// How far a line of this angle runs back per height.
double run_back(double angle) { return 1.0 / std::tan(angle); }

std::string short_text(double value) { return stepped_text(value); }

std::string name_of(long row, long hole) {
  return std::string("r").append(std::to_string(row + 1)) + "h" + std::to_string(hole + 1);
}

double first_y(const HolePattern& p, long row) {
  const double row_half = 0.5 * static_cast<double>(p.holes_per_row - 1) * p.spacing;
  if (p.rows == 1) return -row_half;
  return -row_half + (row % 2 == 0 ? -0.5 : 0.5) * p.stagger * p.spacing;
}

void check_lengths(const HolePattern& p, const std::string& where) {
  if (p.decks > 1 && p.deck_stemming <= 0.0) {
    refuse(where, "deck_stemming must be > 0 m between " + std::to_string(p.decks) +
                      " decks, got '" + number_text(p.deck_stemming) + "'");
  }
  if (p.charged_length() > 0.0) return;
  refuse(where, "stemming and deck_stemming must leave a charge in holes of " +
                    short_text(p.hole_length()) + " m, got '" + number_text(p.stemming) +
                    "' m and " + std::to_string(p.decks - 1) + " times '" +
                    number_text(p.deck_stemming) + "' m");
}

// The table of the holes has a limit of its own for what the decks add up to.
void check_delays(const HolePattern& p, const std::string& where) {
  const double last = p.in_hole_delay + static_cast<double>(p.decks - 1) * p.deck_delay;
  if (delay_range().contains(last)) return;
  refuse(where, "in_hole_delay and deck_delay must add up to " + delay_range().text() +
                    " s in the highest of " + std::to_string(p.decks) + " decks, got '" +
                    number_text(last) + "' s");
}

// The face leans back faster than the holes, so the collar is nearest to it, or the toe.
void check_front(const HolePattern& p, const std::string& where) {
  for (const double height : {0.0, p.bench_height}) {
    const double burden = p.front_burden(height);
    if (burden > p.hole_diameter) continue;
    refuse(where,
           "burden, face_angle and hole_angle must keep the first row behind the face, got "
           "a burden of " +
               short_text(burden) + " m at the height of " + short_text(height) +
               " m; take a larger burden or a hole_angle nearer to the face_angle");
  }
}

void add_tables(ArgTable& table) {
  table.word("file", {}, std::nullopt, "CSV file to write")
      .word(
          "take", {}, "none",
          "a hole table of one's own, which is checked and copied to `file` instead; of the other "
          "keywords `charges`, `origin`, `throw_bearing` and those that say so count")
      .word(
          "kirra", {}, "none",
          "a CSV file of holes that Kirra has exported, which is converted to `file` instead, with "
          "`stemming`, `in_hole_delay` and those below that say so")
      .word("charges", {}, "none",
            "a CSV file of what is in single holes, by their names; the others have what the plan "
            "says")
      .real("throw_bearing", "deg", Range::closed(0.0, 360.0), 90.0,
            "with `kirra` or `origin`: that the face looks to, from north over east; it becomes "
            "the x axis")
      .group("origin", 3, 3, false,
             "with `kirra` or `take`: x y z of the face's toe in the coordinates of the file [m]; "
             "without it, and with `auto auto auto`, the holes of `kirra` set it, and a table that "
             "is taken stays where it is");
}

void add_lengths(ArgTable& table) {
  const Range length = Range::left_open(0.0, 100.0);
  table.integer("rows", "", Range::closed(1, 1000), std::nullopt, "rows of holes behind the face")
      .integer("holes_per_row", "", Range::closed(1, 1000), std::nullopt, "holes in each row")
      .real(
          "burden", "m", length, std::nullopt,
          "from the face's toe to the first row, and from row to row, at the height of the floor; "
          "with `kirra` and no `origin`: of the foremost hole")
      .real("spacing", "m", length, std::nullopt, "between the holes of a row")
      .real("stagger", "", Range::closed(0.0, 1.0), 0.5,
            "by which every second row is moved along the row, of spacing; 0: a rectangle")
      .real("bench_height", "m", Range::closed(0.1, 100.0), std::nullopt,
            "of the collars above the floor")
      .real("subdrill", "m", Range::closed(0.0, 50.0), 0.0,
            "depth of the holes' lower ends below the floor; with `kirra`: where its file has none")
      .real("stemming", "m", Range::closed(0.0, 150.0), std::nullopt,
            "from the collar to the highest charge, along the hole")
      .real("hole_diameter", "m", Range::closed(5e-3, 1.0), std::nullopt, "of all holes")
      .real("face_angle", "deg", Range::closed(30.0, 90.0), 90.0,
            "of the free face, from the horizontal; 90: upright")
      .real("hole_angle", "deg", Range::closed(45.0, 90.0), 90.0,
            "of the holes, from the horizontal; below 90 the collar lies behind the toe");
}

void add_delays(ArgTable& table) {
  const Range delays = Range::closed(0.0, 10.0);  // 17 is one in milliseconds
  table.real("delay_in_row", "s", delays, 0.0, "from hole to hole of a row")
      .real("delay_between_rows", "s", delays, 0.0,
            "from the first hole of a row to that of the next")
      .real("in_hole_delay", "s", delays, 0.0, "of the detonators")
      .integer("decks", "", Range::closed(1, 20), 1, "charges in each hole, of equal lengths")
      .real("deck_stemming", "m", Range::closed(0.0, 50.0), 0.0, "between two of them")
      .real("deck_delay", "s", delays, 0.0, "from a deck to the one above it")
      .real("scatter", "", Range::closed(0.0, 0.2), 0.0,
            "standard deviation of each delay element over its delay, of surface delays and of "
            "in-hole delays; for tables of `take` and `kirra`, too")
      .integer("scatter_seed", "", Range::closed(1, 2147483647), 1, "of its draws");
}

}  // namespace

double HolePattern::hole_length() const { return (bench_height + subdrill) / std::sin(hole_angle); }

double HolePattern::charged_length() const {
  return hole_length() - stemming - static_cast<double>(decks - 1) * deck_stemming;
}

double HolePattern::front_burden(double height) const {
  return std::sin(face_angle) * (burden + height * (run_back(hole_angle) - run_back(face_angle)));
}

ArgTable hole_pattern_table() {
  ArgTable table("hole_pattern");
  add_tables(table);
  add_lengths(table);
  add_delays(table);
  return table;
}

HolePattern hole_pattern(const ArgValues& values, const std::string& where) {
  const HolePattern p{.rows = values.integer("rows"),
                      .holes_per_row = values.integer("holes_per_row"),
                      .burden = values.real("burden"),
                      .spacing = values.real("spacing"),
                      .stagger = values.real("stagger"),
                      .bench_height = values.real("bench_height"),
                      .subdrill = values.real("subdrill"),
                      .stemming = values.real("stemming"),
                      .hole_diameter = values.real("hole_diameter"),
                      .face_angle = kDegree * values.real("face_angle"),
                      .hole_angle = kDegree * values.real("hole_angle"),
                      .delay_in_row = values.real("delay_in_row"),
                      .delay_between_rows = values.real("delay_between_rows"),
                      .in_hole_delay = values.real("in_hole_delay"),
                      .decks = values.integer("decks"),
                      .deck_stemming = values.real("deck_stemming"),
                      .deck_delay = values.real("deck_delay")};
  constexpr long kMost = 10000;
  if (p.rows * p.holes_per_row * p.decks > kMost)
    throw InputError(where + ": rows, holes_per_row and decks must make at most " +
                     std::to_string(kMost) + " charges, got '" +
                     std::to_string(p.rows * p.holes_per_row * p.decks) + "'");
  check_lengths(p, where);
  check_delays(p, where);
  check_front(p, where);
  return p;
}

std::string hole_table_text(const HolePattern& p) {
  std::ostringstream text;
  text << "# " << p.rows << " rows of " << p.holes_per_row << " holes by hole_pattern\n"
       << "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
          "after,surface_delay_s,in_hole_delay_s\n";
  const double back = run_back(p.hole_angle);
  const double deck = p.charged_length() / static_cast<double>(p.decks);
  for (long row = 0; row < p.rows; ++row) {
    const double x = -static_cast<double>(row + 1) * p.burden;
    for (long hole = 0; hole < p.holes_per_row; ++hole) {
      const std::string y = short_text(first_y(p, row) + static_cast<double>(hole) * p.spacing);
      const std::string before = hole > 0  ? name_of(row, hole - 1)
                                 : row > 0 ? name_of(row - 1, 0)
                                           : "";
      const double delay = hole > 0 ? p.delay_in_row : row > 0 ? p.delay_between_rows : 0.0;
      for (long k = 0; k < p.decks; ++k) {
        const double to = p.hole_length() - static_cast<double>(k) * (deck + p.deck_stemming);
        text << name_of(row, hole) << ',' << short_text(x - back * p.bench_height) << ',' << y
             << ',' << short_text(p.bench_height) << ',' << short_text(x + back * p.subdrill) << ','
             << y << ',' << short_text(-p.subdrill) << ',' << short_text(p.hole_diameter) << ','
             << short_text(to - deck) << ',' << short_text(to) << ',' << before << ','
             << short_text(delay) << ','
             << short_text(p.in_hole_delay + static_cast<double>(k) * p.deck_delay) << '\n';
      }
    }
  }
  return text.str();
}

std::string describe(const HolePattern& p) {
  const double last = static_cast<double>(p.rows - 1) * p.delay_between_rows +
                      static_cast<double>(p.holes_per_row - 1) * p.delay_in_row + p.in_hole_delay +
                      static_cast<double>(p.decks - 1) * p.deck_delay;
  std::ostringstream text;
  text.precision(4);
  text << "hole_pattern: " << p.rows << " rows of " << p.holes_per_row << " holes of "
       << p.hole_length() << " m, " << p.charged_length() << " m of it charged in " << p.decks
       << (p.decks == 1 ? " deck" : " decks")
       << "\n  shortest way from the first row to the face: " << p.front_burden(0.0)
       << " m at the floor, " << p.front_burden(p.bench_height)
       << " m at the collars\n  rock of a hole: " << p.burden * p.spacing * p.bench_height
       << " m3; the last deck fires at " << last << " s\n";
  return text.str();
}

}  // namespace muckpile
