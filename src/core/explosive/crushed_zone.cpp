// SPDX-License-Identifier: GPL-2.0-or-later
// Crushed-zone formulas; sources in the header.
#include "explosive/crushed_zone.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "args/input_error.h"
#include "args/require.h"

namespace muckpile {
namespace {

constexpr double kWidestZone = 20.0;  // over the hole [-]

double esen_ratio(const CrushedZoneInput& in) {
  require_positive("youngs_modulus", "Pa", in.youngs_modulus);
  require_positive("ucs", "Pa", in.ucs);
  const double stiffness = in.youngs_modulus / (1.0 + in.poisson_ratio);
  const double index = std::pow(wall_peak(in), 3.0) / (stiffness * in.ucs * in.ucs);
  constexpr double kNoCrushing = 2.6;
  return index < kNoCrushing ? 1.0 : 0.812 * std::pow(index, 0.219);
}

double dai_ratio(const CrushedZoneInput& in) {
  require_positive("ucs", "Pa", in.ucs);
  if (!(in.strain_rate >= 1e2 && in.strain_rate <= 1e4)) {
    refuse_value("strain_rate", "from 100 to 10000", "1/s", in.strain_rate);
  }
  const double mu = 0.8 * in.poisson_ratio;  // dynamic
  const double b = mu / (1.0 - mu);
  const double mises = std::sqrt(std::pow(1.0 + b, 2.0) + 1.0 + b * b -
                                 2.0 * mu * (1.0 - mu) * std::pow(1.0 - b, 2.0));
  const double strength = in.ucs * std::cbrt(in.strain_rate);
  return std::pow(in.pressure_share * in.wall_shock * mises / (std::sqrt(2.0) * strength),
                  1.0 / (2.0 + b));
}

double strength_ratio(const CrushedZoneInput& in) {
  require_positive("ucs", "Pa", in.ucs);
  require_positive("crushing_factor", "", in.crushing_factor);
  require_positive("attenuation_exponent", "", in.attenuation_exponent);
  const double ratio =
      std::pow(wall_peak(in) / (in.crushing_factor * in.ucs), 1.0 / in.attenuation_exponent);
  if (ratio <= kWidestZone) return ratio;
  std::ostringstream text;
  text << "crushed_zone strength makes a zone of " << ratio << " hole radii, at most "
       << kWidestZone
       << " are allowed: ucs, crushing_factor or attenuation_exponent is too small, or give "
          "crushed_zone multiple";
  throw InputError(text.str());
}

double multiple_ratio(const CrushedZoneInput& in) {
  if (!(in.multiple >= 1.0 && in.multiple <= kWidestZone)) {
    refuse_value("crushed_ratio", "from 1 to 20", "", in.multiple);
  }
  require_positive("attenuation_exponent", "", in.attenuation_exponent);
  return in.multiple * std::pow(in.pressure_share, 1.0 / in.attenuation_exponent);
}

double ratio(CrushedZone model, const CrushedZoneInput& in) {
  switch (model) {
    case CrushedZone::strength:
      return strength_ratio(in);
    case CrushedZone::esen:
      return esen_ratio(in);
    case CrushedZone::djordjevic:
      require_positive("tensile_strength", "Pa", in.tensile_strength);
      return std::sqrt(wall_peak(in) / (24.0 * in.tensile_strength));
    case CrushedZone::kanchibotla:
      require_positive("ucs", "Pa", in.ucs);
      return std::sqrt(in.pressure_share * in.cj_pressure / in.ucs);
    case CrushedZone::dai:
      return dai_ratio(in);
    case CrushedZone::multiple:
      break;
  }
  return multiple_ratio(in);
}

}  // namespace

double wall_peak(const CrushedZoneInput& input) {
  return input.pressure_share * input.borehole_pressure;
}

double crushed_zone_radius(CrushedZone model, const CrushedZoneInput& input) {
  require_positive("hole_diameter", "m", 2.0 * input.hole_radius);
  if (!(input.poisson_ratio >= 0.0 && input.poisson_ratio < 0.5)) {
    refuse_value("poisson_ratio", "0 or more and below 0.5", "", input.poisson_ratio);
  }
  require_positive("pressure on the wall", "of that of a full hole", input.pressure_share);
  return input.hole_radius * std::max(1.0, ratio(model, input));
}

}  // namespace muckpile
