// SPDX-License-Identifier: GPL-2.0-or-later
// A blast pattern as a table: where holes and their decks are, what is in them, when they fire.
// Scope: data and its checks; create_blocks cuts the crushed zones, fix muckpile/blast loads them,
// muckpile-post plan draws them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "args/csv_table.h"
#include "args/range.h"
#include "explosive/decoupling.h"
#include "geometry/block_model.h"

namespace muckpile {

/// Allowed delays [s]; a number beyond is probably in milliseconds.
[[nodiscard]] Range delay_range();
/// Allowed coordinates [m], those of map grids included.
[[nodiscard]] Range place_range();

/// One charged chamber of a hole.
struct Deck {
  std::string hole{};                           ///< name of its hole
  Vec3 hole_toe = Vec3::Zero();                 ///< lower end of the drilled hole [m]
  Vec3 hole_collar = Vec3::Zero();              ///< its mouth [m]
  Vec3 toe = Vec3::Zero();                      ///< lower end of this chamber [m]
  Vec3 collar = Vec3::Zero();                   ///< its upper end [m]
  double from = 0.0, to = 0.0;                  ///< depths of the two ends below the mouth [m]
  double diameter = 0.0;                        ///< of the hole [m]
  std::optional<std::string> explosive{};       ///< name; nothing: the style's
  std::optional<double> explosive_density{};    ///< [kg/m3]; nothing: the explosive's
  std::optional<double> detonation_velocity{};  ///< [m/s]; nothing: the explosive's
  std::optional<Coupling> coupling{};           ///< around a thinner charge; nothing: the style's
  std::optional<double> charge_diameter{};      ///< [m]
  std::optional<double> charge_length{};        ///< [m]; what is left of the chamber is an air deck
  std::optional<double> primer{};               ///< 0 toe to 1 collar
  std::optional<double> crushed_radius{};       ///< [m]
  std::string after{};                          ///< hole that the signal comes from; "": it starts
  double surface_delay = 0.0;                   ///< from there [s]
  double in_hole_delay = 0.0;                   ///< from the signal at the hole [s]
  double firing_time = 0.0;                     ///< all delays and their scatter, at least 0 [s]
};

/// Columns, lengths in m and times in s; those in brackets may be left out, or empty:
///   hole, collar_x_m, collar_y_m, collar_z_m, toe_x_m, toe_y_m, toe_z_m, diameter_m,
///   [from_m], [to_m]: the charged chamber, depths below the collar along the hole; else all of it
///   [explosive], [charge_diameter_m], [charge_length_m], [primer], [crushed_radius_m]
///   [explosive_density_kg_m3], [vod_m_s]: in place of the explosive's
///   [coupling]: air, water or stemming, around a charge thinner than its hole
///   [after], [surface_delay_s]: the signal reaches the hole that long after the hole `after`, or
///       after time 0
///   [in_hole_delay_s]: the deck fires that long after the signal
///   [scatter_s]: and so much later than that, or earlier; not before time 0
/// Several rows of one hole are its decks: same ends, diameter and signal, chambers apart.
class HoleTable {
 public:
  /// InputError with file and line.
  explicit HoleTable(const CsvTable& csv);
  [[nodiscard]] static HoleTable read(const std::string& path) {
    return HoleTable(CsvTable::read(path));
  }

  [[nodiscard]] const std::vector<Deck>& decks() const { return decks_; }  ///< in the file's order
  [[nodiscard]] std::size_t holes() const;                                 ///< drilled ones

  [[nodiscard]] double last_firing_time() const;  ///< [s]
  /// Box around all chambers [m].
  [[nodiscard]] Eigen::AlignedBox3d chambers() const;

  /// The crushed zone of each deck, its radius `ratio` hole radii unless the table has its own.
  [[nodiscard]] std::vector<Hole> crushed_zones(double ratio) const;

 private:
  std::vector<Deck> decks_;
};

}  // namespace muckpile
