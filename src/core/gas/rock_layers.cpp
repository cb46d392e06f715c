// SPDX-License-Identifier: GPL-2.0-or-later
// Conduction of heat into layered rock; equations in the header.
#include "gas/rock_layers.h"

namespace muckpile {
namespace {

constexpr double kGrowth = 1.8;  // of the layers, from each to the next

/// Thicknesses that add up to 1.
RockLayers::Excess shares() {
  RockLayers::Excess shares;
  double sum = 0.0, layer = 1.0;
  for (double& share : shares) {
    share = layer;
    sum += layer;
    layer *= kGrowth;
  }
  for (double& share : shares) share /= sum;
  return shares;
}

}  // namespace

/// Lengths in sqrt(time), x/sqrt(diffusivity): then conductivity and heat capacity are both e.
RockLayers RockLayers::half_space(double effusivity) {
  constexpr double kDepth = 0.74;  // [s^(1/2)]; the first layer is 0.003
  RockLayers rock;
  const Excess share = shares();
  for (std::size_t k = 0; k < kLayers; ++k) {
    rock.capacity_[k] = effusivity * kDepth * share[k];
    if (k + 1 < kLayers) rock.between_[k] = effusivity / (0.5 * kDepth * (share[k] + share[k + 1]));
  }
  rock.to_face_ = 0.5 * kDepth * share[0] / effusivity;
  return rock;
}

RockLayers RockLayers::sphere(double diameter, double conductivity, double heat_capacity) {
  RockLayers rock;
  const Excess share = shares();
  const double radius = 0.5 * diameter, face = radius * radius;
  const auto resistance = [&](double inner, double outer) {
    return face * (1.0 / inner - 1.0 / outer) / conductivity;
  };
  double outer = radius, middle_before = radius;
  for (std::size_t k = 0; k < kLayers; ++k) {
    const bool last = k + 1 == kLayers;
    const double inner = last ? 0.0 : outer - radius * share[k];
    const double cubes = outer * outer * outer - inner * inner * inner;
    const double middle = last ? 0.75 * outer : 0.5 * (inner + outer);
    rock.capacity_[k] = heat_capacity * cubes / (3.0 * face);
    if (k == 0)
      rock.to_face_ = resistance(middle, radius);
    else
      rock.between_[k - 1] = 1.0 / resistance(middle, middle_before);
    middle_before = middle;
    outer = inner;
  }
  return rock;
}

double RockLayers::heat(const Excess& excess) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < kLayers; ++k) sum += capacity_[k] * excess[k];
  return sum;
}

RockLayers::Step::Step(const RockLayers& rock, double length) : length_(length) {
  double inner = 0.0, passes = 0.0;  // conductance to the layer within, and what it lets through
  for (std::size_t k = kLayers; k-- > 0;) {
    const double rate = rock.capacity_[k] / length;
    const double outer = k > 0 ? rock.between_[k - 1] : 0.0;
    const double all = rate + outer + inner * (1.0 - passes);
    of_outer_[k] = outer / all;
    of_before_[k] = rate / all;
    of_inner_[k] = inner / all;
    if (k == 0) first_ = 1.0 / all;
    passes = of_outer_[k];
    inner = outer;
  }
  face_ = first_ + rock.to_face_;
}

}  // namespace muckpile
