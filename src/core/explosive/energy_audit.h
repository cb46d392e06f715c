// SPDX-License-Identifier: GPL-2.0-or-later
// Where the energy of the charges has gone: books of a hole, and the audit of all.
// Scope: sums in J since the start; who moves energy books it, nothing is computed from the rest
// but the energy spent in the crushed zone.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "explosive/blast_load.h"
#include "state/encoding.h"

namespace muckpile {

/// What one hole has given so far, beside GasState.
struct HoleBooks {
  double wall_work = 0.0;    ///< of its pressures, beyond the atmosphere, on the blocks [J]
  double expansion = 0.0;    ///< p dV of its gas at the wall of the crushed zone [J]
  double air_volume = 0.0;   ///< that this has swept against the atmosphere [m3]
  double into_joints = 0.0;  ///< energy of the gas that flowed into joints, less what came back [J]
  double let_go = 0.0;       ///< energy that its gas had as the hole was over [J]
};
template <>
struct Stored<HoleBooks> {
  static constexpr std::string_view kName = "hole_books";
  static constexpr int kVersion = 1;
  static auto fields(auto& books) {
    return std::tie(books.wall_work, books.expansion, books.air_volume, books.into_joints,
                    books.let_go);
  }
};

/// explosive = the sum of all others + error() [J].
///
/// crushing is what is left of the products' expansion from Vp to Vg, the dense stage, after the
/// pulse: the work on the walls, and on the atmosphere, beyond the p dV of the gas stage. A pulse
/// that does more work than the dense stage has leaves none, and an error.
struct EnergyAudit {
  double explosive = 0.0;     ///< of the charges that have fired
  double not_released = 0.0;  ///< what the law of expansion does not deliver of it
  double filling = 0.0;       ///< expansion into the room around a decoupled charge, without work
  double crushing = 0.0;      ///< of rock within the crushed zone
  double wall_work = 0.0;     ///< on the walls of the crushed zones, wave and gas
  double joint_work = 0.0;    ///< of the gas in joints on the blocks
  double air_work = 0.0;      ///< on the atmosphere
  double rock_heat = 0.0;     ///< into the walls of joints, net
  double in_holes = 0.0;      ///< internal energy of the gas there
  double in_joints = 0.0;     ///< internal energy of the gas there
  double vented = 0.0;        ///< with the gas that is in the open
  double stemming = 0.0;      ///< work on the stemming of the holes, and on what lies above it

  [[nodiscard]] double error() const {
    return explosive - (not_released + filling + crushing + wall_work + joint_work + air_work +
                        rock_heat + in_holes + in_joints + vented + stemming);
  }
  EnergyAudit& operator+=(const EnergyAudit& more);

  struct Term {
    std::string_view name;
    double EnergyAudit::*value;
  };
  /// All of them, in the order above.
  static const std::array<Term, 12> kTerms;
};

/// Share of an energy that its books may miss unremarked.
inline constexpr double kEnergyCloses = 0.01;

/// What to warn of at the end of a run, "" if the audit closes.
[[nodiscard]] std::string warning_of_missing(const EnergyAudit& audit);

/// What is known of one hole.
struct HoleAudit {
  EnergyAudit energy;        ///< without what its gas does in joints
  double into_joints = 0.0;  ///< with the gas that flowed into joints, less what came back [J]
  double stemming_out = GasState::kHolds;  ///< since the primer fired [s]; kHolds: it is in
  double stemming_speed = 0.0;             ///< now, or as it left [m/s]

  [[nodiscard]] double error() const { return energy.error() - into_joints; }
};

/// Of a hole that has fired, without what its gas does in joints. `explosive` is the energy of its
/// charge [J], 0 if not known: then that of its products. Zeros if the load is a pulse alone.
/// `in_hole` is the energy of the gas there,
/// `ambient` the pressure of the atmosphere [Pa].
[[nodiscard]] EnergyAudit audit_of_hole(const BlastLoad& load, double explosive, double in_hole,
                                        const GasState& gas, const HoleBooks& books,
                                        double ambient);

}  // namespace muckpile
