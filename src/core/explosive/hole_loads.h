// SPDX-License-Identifier: GPL-2.0-or-later
// The loads of all holes, from the words of fix muckpile/blast and the crushed zones of the rock.
// Scope: no engine; every fault throws InputError that starts with the options' `where`.
#pragma once

#include <string>
#include <vector>

#include "explosive/blast_options.h"
#include "explosive/hole_blast.h"
#include "geometry/block_model.h"

namespace muckpile {

/// A charge in its hole, with all that its load needs.
struct LoadedHole {
  NamedExplosive explosive;
  ChargeShape shape;
  DecouplingRule decoupling;
  double initial_pressure = 0.0;  ///< P0, 0 if nothing needs it [Pa]
  double wall_pressure = 0.0;     ///< on the hole's wall [Pa]
  double exponent = 0.0;          ///< of the attenuation
  bool energy_known = false;      ///< explosive.energy counts
  double primer = 0.0;            ///< 0 toe to 1 collar of the charge
  double firing_time = 0.0;       ///< [s]
};

/// Hole `index` counts from 0.
[[nodiscard]] LoadedHole loaded_hole(const BlastOptions& options, const Hole& zone,
                                     std::size_t index);
/// Exponent of the attenuation; 0 where it is not known because nothing needs it.
[[nodiscard]] double exponent_of(const BlastOptions& options, Attenuation by,
                                 const NamedExplosive& explosive);
/// P1 on the wall of the crushed zone [Pa].
[[nodiscard]] double wall_peak(const BlastOptions& options, const LoadedHole& hole,
                               const Hole& zone);

/// The loads of all holes. InputError: no hole, a delay for a hole that is not there, a crushed
/// zone narrower than the hole.
[[nodiscard]] std::vector<HoleBlast> hole_blasts(const BlastOptions& options,
                                                 const std::vector<Hole>& crushed_zones);

/// Exponent of the expanded gas of all holes, by the law of expansion. InputError: holes whose
/// gases differ.
[[nodiscard]] double gas_gamma(const BlastOptions& options);

/// Specific gas constant of the products of all charges, the mean by their mass; of the style's own
/// explosive where there is no hole [J/(kg K)].
[[nodiscard]] double gas_constant(const BlastOptions& options,
                                  const std::vector<Hole>& crushed_zones);

/// One hole's explosive, and the rock that it crushes; the share of both that is modelled.
struct HoleCharge {
  double mass = 0.0;          ///< [kg]
  double gas = 0.0;           ///< of it, what reacts in time [kg]
  double energy = 0.0;        ///< 0 if the explosive's is not known [J]
  double crushed_rock = 0.0;  ///< between the hole and the wall of its crushed zone [m3]
};
[[nodiscard]] std::vector<HoleCharge> hole_charges(const BlastOptions& options,
                                                   const std::vector<Hole>& crushed_zones);

/// For the log: the pressures of the first hole with the alternatives beside them, and the firing
/// time of each hole.
[[nodiscard]] std::string describe(const BlastOptions& options,
                                   const std::vector<Hole>& crushed_zones,
                                   const std::vector<HoleBlast>& blasts);

}  // namespace muckpile
