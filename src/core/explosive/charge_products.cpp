// SPDX-License-Identifier: GPL-2.0-or-later
// Borehole pressure and expansion of a charge from its words; declared in charge_options.h.
#include <cmath>
#include <sstream>

#include "args/input_error.h"
#include "args/require.h"
#include "explosive/charge_options.h"

namespace muckpile {
namespace {

constexpr double kMPa = 1e6;

bool jwl_holds(const NamedExplosive& explosive) {
  constexpr double kAlike = 0.1;  // relative difference in density up to which the fit is used
  return explosive.jwl &&
         std::abs(explosive.density - explosive.jwl->density) <= kAlike * explosive.jwl->density;
}

void require_jwl(const ChargeOptions& options, const NamedExplosive& explosive) {
  if (options.energy_share < 1.0) {
    throw InputError("energy_share does not go with JWL, which is a fit to the whole reaction");
  }
  if (!explosive.jwl) {
    const bool by_expansion = options.expansion == Expansion::jwl;
    throw InputError(
        std::string(by_expansion ? "expansion" : "borehole_model") +
        " jwl needs JWL parameters, explosive '" + explosive.name +
        "' has none; take an explosive_table that has them (columns jwl_a_Pa ...), the "
        "keyword jwl, or " +
        (by_expansion ? "expansion covolume" : "another borehole_model"));
  }
  if (jwl_holds(explosive)) return;
  const double of_fit = explosive.jwl->density;
  std::ostringstream rule;
  rule << "within 10 % of the density " << of_fit << " that JWL was fitted at";
  refuse_value("explosive_density", rule.str().c_str(), "kg/m3", explosive.density);
}

/// Between light ANFO mixes and cast high explosives; outside, none of the formulas has been tried.
/// `share` of the energy slows an explosive that has its own vod.
void check_formula_range(const NamedExplosive& explosive, double share) {
  const auto check = [&](const std::string& name, const char* unit, double value, double lo,
                         double hi) {
    std::ostringstream rule;
    rule << "from " << lo << " to " << hi << ", the range of the formulas for P0,";
    if (share < 1.0 && name == "vod" && value < lo)
      rule << " also once energy_share " << share << " has slowed an explosive of the table,";
    if (!(value >= lo && value <= hi)) {
      refuse_value(name, rule.str().c_str(), unit, value);
    }
  };
  check("explosive_density", "kg/m3", explosive.density, 200.0, 2000.0);
  check("vod", "m/s", explosive.detonation_velocity, 1000.0, 9500.0);
}

double pressure_by(BoreholeModel model, const ChargeOptions& options,
                   const NamedExplosive& explosive) {
  const Explosive plain{explosive.density, explosive.detonation_velocity};
  switch (model) {
    case BoreholeModel::explosion_state_fit:
      return explosion_state_pressure_fit(plain);
    case BoreholeModel::explosion_state_gamma:
      if (!explosive.gamma) {
        throw InputError("borehole_model explosion_state_gamma needs explosive_gamma");
      }
      return explosion_state_pressure_by_gamma(plain, *explosive.gamma);
    case BoreholeModel::chapman_jouguet:
      return chapman_jouguet_pressure(plain);
    case BoreholeModel::impedance_matched:
      if (!options.rock_impedance) {
        throw InputError("borehole_model impedance_matched needs rock_impedance [Pa s/m]");
      }
      return impedance_matched_pressure(plain, *options.rock_impedance);
    case BoreholeModel::jwl:
      require_jwl(options, explosive);
      return JwlIsentrope(*explosive.jwl).pressure(1.0);
    case BoreholeModel::explosion_state:
      break;
  }
  return explosion_state_pressure(plain);
}

TwoStageIsentrope two_stage_of(const ChargeOptions& options, const NamedExplosive& explosive) {
  TwoStageIsentrope::Parameters two_stage = options.isentrope;
  two_stage.initial_pressure = initial_pressure(options, explosive);
  const bool known = explosive.energy > 0.0;
  if (!options.switch_by_energy || (!known && !options.switch_typed)) {
    return TwoStageIsentrope(two_stage);
  }
  if (!known) throw InputError("gas_switch_pressure energy needs explosive_energy [J/kg]");
  two_stage.switch_pressure =
      energy_switch_pressure(two_stage, explosive.energy * explosive.density);
  return TwoStageIsentrope(two_stage);
}

CovolumeIsentrope covolume_of(const ChargeOptions& options, const NamedExplosive& explosive) {
  if (explosive.energy <= 0.0) {
    throw InputError("expansion covolume needs explosive_energy [J/kg]");
  }
  return CovolumeIsentrope({.initial_pressure = initial_pressure(options, explosive),
                            .energy = explosive.energy * explosive.density,
                            .gamma = options.isentrope.dilute_exponent,
                            .switch_pressure = options.isentrope.switch_pressure});
}

ProductExpansion jwl_of(const ChargeOptions& options, const NamedExplosive& explosive) {
  require_jwl(options, explosive);
  if (!options.switch_by_energy) {
    return ProductExpansion(JwlGas(*explosive.jwl, options.isentrope.switch_pressure));
  }
  const JwlIsentrope fit(*explosive.jwl);
  const ProductExpansion from_start(JwlGas(*explosive.jwl, fit.pressure(1.0)));
  if (!options.dense_share) return from_start;
  const double most = 1.0 - fit.stored_energy(JwlIsentrope::kFittedTo) / fit.stored_energy(1.0);
  if (*options.dense_share > most) {
    std::ostringstream rule;
    rule << "at most " << most << ", what is spent at " << JwlIsentrope::kFittedTo
         << " V0 to which JWL is fitted";
    refuse_value("dense_share", rule.str(), "", *options.dense_share);
  }
  return from_start.switched_after(*options.dense_share);
}

}  // namespace

NamedExplosive released(const ChargeOptions& options, NamedExplosive explosive, bool vod_typed) {
  explosive.energy *= options.energy_share;
  explosive.reacts = options.energy_share;
  if (!vod_typed) explosive.detonation_velocity *= std::sqrt(options.energy_share);
  return explosive;
}

NamedExplosive table_explosive(const ChargeOptions& options, const std::string& name,
                               const std::string& where) {
  return released(options, options.table.find(name, where), false);
}

double initial_pressure(const ChargeOptions& options, const NamedExplosive& explosive) {
  if (options.typed_pressure) return *options.typed_pressure;
  check_formula_range(explosive, options.energy_share);
  return pressure_by(options.model, options, explosive);
}

DecouplingRule decoupling_rule(const ChargeOptions& options, double attenuation_exponent) {
  DecouplingRule rule = options.decoupling;
  if (rule.coupling == Coupling::stemming && !options.coupling_exponent_typed) {
    rule.coupling_exponent = attenuation_exponent;
  }
  return rule;
}

std::string alternative_pressures(const ChargeOptions& options, const NamedExplosive& explosive) {
  std::ostringstream text;
  text.precision(4);
  const auto add = [&](const char* name, BoreholeModel model) {
    text << (text.str().empty() ? "" : ", ") << name << ' '
         << pressure_by(model, options, explosive) / kMPa;
  };
  add("explosion state", BoreholeModel::explosion_state);
  add("its fit", BoreholeModel::explosion_state_fit);
  if (explosive.gamma) add("its gamma form", BoreholeModel::explosion_state_gamma);
  add("Chapman-Jouguet", BoreholeModel::chapman_jouguet);
  if (options.rock_impedance) add("impedance-matched", BoreholeModel::impedance_matched);
  if (jwl_holds(explosive)) add("JWL", BoreholeModel::jwl);
  text << " MPa";
  return text.str();
}

bool stage_by_crushing(const ChargeOptions& options) {
  return options.expansion != Expansion::two_stage && options.switch_by_energy &&
         !options.dense_share;
}

ProductExpansion product_expansion(const ChargeOptions& options, const NamedExplosive& explosive) {
  switch (options.expansion) {
    case Expansion::jwl:
      return jwl_of(options, explosive);
    case Expansion::covolume: {
      const ProductExpansion gas(covolume_of(options, explosive));
      const bool by_share = options.switch_by_energy && options.dense_share;
      if (by_share) return gas.switched_after(*options.dense_share);
      return options.switch_by_energy ? gas.switched_at(1.0) : gas;
    }
    case Expansion::two_stage:
      break;
  }
  return ProductExpansion(two_stage_of(options, explosive));
}

}  // namespace muckpile
