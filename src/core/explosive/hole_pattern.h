// SPDX-License-Identifier: GPL-2.0-or-later
// A blast plan of equal holes in rows behind a bench's face, and the hole table that it makes.
// Scope: plane face through the line x = 0, z = 0, rock at x < 0, rows along y about y = 0; no
// engine, no files; the command hole_pattern writes the text.
#pragma once

#include <string>

#include "args/parse_args.h"

namespace muckpile {

struct HolePattern {
  long rows = 1, holes_per_row = 1;
  double burden = 0.0;              ///< between rows, and of the first one, at the floor [m]
  double spacing = 0.0;             ///< between holes of a row [m]
  double stagger = 0.0;             ///< by which every second row is moved along y, of spacing [-]
  double bench_height = 0.0;        ///< of the collars above the floor z = 0 [m]
  double subdrill = 0.0;            ///< depth of the holes' lower ends below the floor [m]
  double stemming = 0.0;            ///< along the hole [m]
  double hole_diameter = 0.0;       ///< [m]
  double face_angle = 0.0;          ///< of the face, from the horizontal [rad]
  double hole_angle = 0.0;          ///< of the holes, from the horizontal [rad]
  double delay_in_row = 0.0;        ///< from hole to hole [s]
  double delay_between_rows = 0.0;  ///< from the first hole of a row to that of the next [s]
  double in_hole_delay = 0.0;       ///< of the lowest deck [s]
  long decks = 1;                   ///< charges in a hole, of equal lengths
  double deck_stemming = 0.0;       ///< between two of them, along the hole [m]
  double deck_delay = 0.0;          ///< from a deck to the one above [s]

  [[nodiscard]] double hole_length() const;     ///< [m]
  [[nodiscard]] double charged_length() const;  ///< of all decks of a hole [m]
  /// Shortest way from the axes of the first row to the plane of the face, at a height [m].
  [[nodiscard]] double front_burden(double height) const;
};

[[nodiscard]] ArgTable hole_pattern_table();

/// InputError that starts with `where`: holes that run out of the face, stemming that leaves no
/// charge, decks that touch.
[[nodiscard]] HolePattern hole_pattern(const ArgValues& values, const std::string& where);

/// The CSV file that HoleTable reads: holes `r1h1`, `r1h2`, ... from the row at the face and from
/// the least y, decks from below; the signal runs along each row from its first hole.
[[nodiscard]] std::string hole_table_text(const HolePattern& pattern);

/// For the log: counts, lengths, burden of the first row at the floor and at the collars, last
/// firing.
[[nodiscard]] std::string describe(const HolePattern& pattern);

}  // namespace muckpile
