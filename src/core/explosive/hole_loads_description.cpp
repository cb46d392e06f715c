// SPDX-License-Identifier: GPL-2.0-or-later
// What fix muckpile/blast prints about its loads; see hole_loads.h.
#include <ostream>
#include <sstream>

#include "args/first_lines.h"
#include "explosive/attenuation.h"
#include "explosive/hole_loads.h"

namespace muckpile {
namespace {

constexpr double kMPa = 1e6;

void describe_pressures(std::ostream& text, const BlastOptions& options, const LoadedHole& hole) {
  text << "  explosive " << hole.explosive.name << ": " << hole.explosive.density << " kg/m3, "
       << hole.explosive.detonation_velocity << " m/s";
  if (hole.energy_known) text << ", " << hole.explosive.energy / 1e6 << " MJ/kg";
  if (options.charge.energy_share < 1.0) {
    text << " released, " << options.charge.energy_share << " of its energy";
  }
  if (!hole.explosive.source.empty()) text << " (" << hole.explosive.source << ")";
  text << '\n';
  if (!options.needs_borehole_pressure()) return;
  text << "  borehole pressure P0 = " << hole.initial_pressure / kMPa
       << " MPa; by formula: " << alternative_pressures(options.charge, hole.explosive) << '\n';
  if (hole.wall_pressure != hole.initial_pressure) {
    text << "  decoupled: " << hole.wall_pressure / kMPa << " MPa on the wall, products free in "
         << free_volume_ratio(hole.shape, hole.decoupling) << " V0\n";
  }
}

/// What the products hold beside what the explosive has.
void describe_products(std::ostream& text, const BlastOptions& options, const LoadedHole& hole) {
  const ProductExpansion products = product_expansion(options.charge, hole.explosive);
  const double density = hole.explosive.density, energy = products.energy() / density;
  constexpr double kUseful = 100e6;  // where makers stop to count "effective energy" [Pa]
  text << "  products: exponent " << products.gamma() << ", they hold " << energy / 1e6 << " MJ/kg";
  if (hole.energy_known) text << ", " << energy / hole.explosive.energy << " of the explosive's";
  text << ", and do " << products.work_down_to(kUseful) / density / 1e6 << " MJ/kg down to "
       << kUseful / kMPa << " MPa\n";
}

/// P1 by every exponent that is known, so that the choice can be judged.
void describe_wave(std::ostream& text, const BlastOptions& options, const LoadedHole& hole,
                   const Hole& zone) {
  text << "  wave peak P1 = " << wall_peak(options, hole, zone) / kMPa
       << " MPa on r1 = " << zone.radius << " m (" << zone.radius / hole.shape.hole_radius
       << " hole radii, exponent " << hole.exponent << "), rise " << options.pulse_shape.rise_time
       << " s";
  if (hole.wall_pressure > 0.0) {
    const auto other = [&](const char* name, double exponent) {
      if (exponent <= 0.0) return;
      text << ", " << name << " (" << exponent << ") "
           << attenuated_pressure(hole.wall_pressure, hole.shape.hole_radius, zone.radius,
                                  exponent) /
                  kMPa;
    };
    text << "; by exponent";
    other("shock", exponent_of(options, Attenuation::shock, hole.explosive));
    other("Liu-Katsabanis", exponent_of(options, Attenuation::liu_katsabanis, hole.explosive));
    other("Hino", kHinoExponent);
    text << " MPa";
  }
  text << '\n';
}

/// Decks of a table whose charge differs from that of the first one.
void describe_others(std::ostream& text, const BlastOptions& options,
                     const std::vector<Hole>& zones) {
  if (!options.pattern || !options.needs_borehole_pressure()) return;
  const LoadedHole first = loaded_hole(options, zones.front(), 0);
  std::vector<std::string> others;
  for (std::size_t k = 1; k < zones.size(); ++k) {
    const LoadedHole hole = loaded_hole(options, zones[k], k);
    if (hole.explosive.name == first.explosive.name &&
        hole.explosive.density == first.explosive.density &&
        hole.explosive.detonation_velocity == first.explosive.detonation_velocity &&
        hole.wall_pressure == first.wall_pressure)
      continue;
    std::ostringstream line;
    line.precision(4);
    line << "  hole " << k + 1 << " ('" << options.pattern->decks()[k].hole
         << "'): " << hole.explosive.name << ", " << hole.explosive.density << " kg/m3, "
         << hole.explosive.detonation_velocity << " m/s, P0 = " << hole.initial_pressure / kMPa
         << " MPa, " << hole.wall_pressure / kMPa << " MPa on the wall\n";
    others.push_back(line.str());
  }
  text << first_lines(others, "  ", "charges that differ from that of hole 1");
}

}  // namespace

std::string describe(const BlastOptions& options, const std::vector<Hole>& crushed_zones,
                     const std::vector<HoleBlast>& blasts) {
  const Hole& zone = crushed_zones.front();
  const BlastLoad& load = blasts.front().load();
  const LoadedHole hole = loaded_hole(options, zone, 0);
  std::ostringstream text;
  text.precision(4);
  text << options.where << ": " << blasts.size() << " hole(s), hole 1:\n";
  describe_pressures(text, options, hole);
  describe_wave(text, options, hole, zone);
  if (options.gas) {
    describe_products(text, options, hole);
    const double limit = load.pulse_limit(0.0, 0.0);
    if (load.wave_peak() > limit) {
      text << "  the pulse is limited to what the products can press, " << limit / kMPa
           << " MPa on a wall at rest\n";
    }
    const BlastLoad::StartEnergies at = load.start_energies();
    text << "  gas from " << load.gas_pressure(0.0, 0.0) / kMPa
         << " MPa at Vg = " << load.start_volume()
         << " m3, charge volume V0 = " << load.charge_volume() << " m3, ";
    if (zone.share < 1.0)
      text << "both " << zone.share << " of the whole, whose axis is in mirror planes, ";
    text << "once wave and crushing have taken " << at.dense / at.products << " of the energy, ";
    if (options.vent_by_flow) {
      text << "leaves through the collar once " << options.flow.stemming_length
           << " m of stemming are out, and through cracks from " << options.flow.crack_delay
           << " s on\n";
    } else {
      text << "vents after " << *options.vent_time << " s, decay " << *options.vent_decay << " s\n";
    }
  }
  describe_others(text, options, crushed_zones);
  text << "  firing times [s]:";
  for (const HoleBlast& blast : blasts) text << ' ' << blast.firing_time();
  text << '\n';
  return text.str();
}

}  // namespace muckpile
