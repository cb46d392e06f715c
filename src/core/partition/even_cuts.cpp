// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts of one axis by weight.
// Scope: see the header.
#include "partition/even_cuts.h"

#include <algorithm>
#include <numeric>

namespace muckpile {

std::vector<double> even_cuts(std::span<const double> weights, int parts) {
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double width = 1.0 / static_cast<double>(weights.size());
  std::vector<double> cuts{0.0};
  double below = 0.0;  // weight of the bins left of `bin`
  std::size_t bin = 0;
  for (int part = 1; part < parts; ++part) {
    const double share = static_cast<double>(part) / parts;
    if (total <= 0.0) {
      cuts.push_back(share);
      continue;
    }
    while (bin + 1 < weights.size() && below + weights[bin] < share * total)
      below += weights[bin++];
    const double within = weights[bin] > 0.0 ? (share * total - below) / weights[bin] : 0.0;
    cuts.push_back((static_cast<double>(bin) + std::clamp(within, 0.0, 1.0)) * width);
  }
  cuts.push_back(1.0);
  return cuts;
}

std::vector<double> widened_cuts(std::vector<double> cuts, double narrowest) {
  const auto parts = static_cast<double>(cuts.size() - 1);
  const double least = std::min(narrowest, 1.0 / parts);
  for (std::size_t k = 1; k + 1 < cuts.size(); ++k)
    cuts[k] = std::max(cuts[k], cuts[k - 1] + least);
  for (std::size_t k = cuts.size() - 2; k > 0; --k)
    cuts[k] = std::min(cuts[k], cuts[k + 1] - least);
  return cuts;
}

std::vector<double> neighbourly_cuts(std::span<const double> now, std::span<const double> wanted,
                                     double margin) {
  std::vector<double> cuts(wanted.begin(), wanted.end());
  for (std::size_t k = 1; k + 1 < cuts.size(); ++k) {
    const double least = now[k - 1] + margin, most = now[k + 1] - margin;
    cuts[k] = least < most ? std::clamp(cuts[k], least, most) : now[k];
  }
  return cuts;
}

}  // namespace muckpile
