// SPDX-License-Identifier: GPL-2.0-or-later
// Holes of a blast plan.
// Scope: see the header.
#include "report/blast_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace muckpile {
namespace {

double fired_from(const std::vector<TimedCharge>& charges, double start) {
  constexpr double kRounding = 1e-7;  // [s], as in largest_within()
  double sum = 0.0;
  for (const TimedCharge& charge : charges) {
    if (charge.time > start - kRounding && charge.time < start + kVibrationWindow - kRounding)
      sum += charge.mass;
  }
  return sum;
}

struct Sums {
  Vec2 middles = Vec2::Zero();
  int decks = 0;
  double face = std::numeric_limits<double>::infinity();
};

}  // namespace

std::vector<PlannedHole> planned_holes(const HoleTable& table,
                                       const std::vector<TimedCharge>& charges,
                                       const std::vector<double>& to_face) {
  std::map<std::string, size_t> known;
  std::vector<PlannedHole> plan;
  std::vector<Sums> sums;
  for (size_t k = 0; k < table.decks().size(); ++k) {
    const Deck& deck = table.decks()[k];
    const auto [place, fresh] = known.emplace(deck.hole, plan.size());
    if (fresh) {
      plan.push_back({deck.hole, deck.hole_collar.head<2>(), Vec2::Zero(), deck.firing_time});
      sums.emplace_back();
    }
    PlannedHole& hole = plan[place->second];
    Sums& sum = sums[place->second];
    hole.fires = std::min(hole.fires, deck.firing_time);
    hole.mass += charges[k].mass;
    sum.middles += 0.5 * (deck.toe + deck.collar).head<2>();
    ++sum.decks;
    if (k < to_face.size() && !std::isnan(to_face[k])) sum.face = std::min(sum.face, to_face[k]);
  }
  std::vector<ReliefHole> holes;
  for (size_t h = 0; h < plan.size(); ++h) {
    plan[h].charge = sums[h].middles / sums[h].decks;
    plan[h].within_window = fired_from(charges, plan[h].fires);
    holes.push_back({plan[h].charge, plan[h].fires});
    if (std::isfinite(sums[h].face)) holes.back().face = sums[h].face;
  }
  const std::vector<Relief> reliefs = burden_relief(holes);
  for (size_t h = 0; h < plan.size(); ++h) plan[h].relief = reliefs[h];
  return plan;
}

}  // namespace muckpile
