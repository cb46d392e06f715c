// SPDX-License-Identifier: GPL-2.0-or-later
// Charge per window of time; see the header.
#include "explosive/charge_window.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace muckpile {

double charge_mass(const Deck& deck, double density) {
  const double radius = 0.5 * deck.charge_diameter.value_or(deck.diameter);
  const double length = deck.charge_length.value_or(deck.to - deck.from);
  return std::numbers::pi * radius * radius * length * density;
}

double largest_within(std::span<const TimedCharge> charges, double window) {
  // Sums of delays are exact to far less; charges the whole window apart are apart.
  constexpr double kRounding = 1e-7;  // [s]
  std::vector<TimedCharge> by_time(charges.begin(), charges.end());
  std::ranges::sort(by_time, {}, &TimedCharge::time);
  double largest = 0.0;
  for (auto first = by_time.begin(); first != by_time.end(); ++first) {
    double sum = 0.0;
    for (auto each = first; each != by_time.end() && each->time < first->time + window - kRounding;
         ++each)
      sum += each->mass;
    if (std::isnan(sum)) return sum;
    largest = std::max(largest, sum);
  }
  return largest;
}

}  // namespace muckpile
