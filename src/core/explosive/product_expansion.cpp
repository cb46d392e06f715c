// SPDX-License-Identifier: GPL-2.0-or-later
// The chosen expansion law; see the header.
#include "explosive/product_expansion.h"

#include <algorithm>

namespace muckpile {

ProductExpansion::ProductExpansion(const Law& law)
    : law_(law), switch_ratio_(std::visit([](const auto& l) { return l.switch_ratio(); }, law)) {}

double ProductExpansion::pressure(double volume_ratio) const {
  const double ratio = std::max(volume_ratio, filled_);
  return hotter_ * std::visit([ratio](const auto& law) { return law.pressure(ratio); }, law_);
}

double ProductExpansion::gamma() const {
  return std::visit([](const auto& law) { return law.gamma(); }, law_);
}

double ProductExpansion::stored_energy(double volume_ratio) const {
  const double ratio = std::max(volume_ratio, filled_);
  const double plateau = pressure(filled_) * std::max(0.0, filled_ - volume_ratio);
  return plateau +
         hotter_ * std::visit([ratio](const auto& law) { return law.stored_energy(ratio); }, law_);
}

double ProductExpansion::work_down_to(double wanted) const {
  if (pressure(filled_) <= wanted) return 0.0;
  if (wanted <= 0.0) return energy();
  double low = filled_, high = 2.0 * filled_;
  while (pressure(high) > wanted) high *= 2.0;
  for (int halving = 0; halving < 100; ++halving) {  // to rounding; the curve falls monotonically
    const double middle = 0.5 * (low + high);
    (pressure(middle) > wanted ? low : high) = middle;
  }
  return energy() - stored_energy(high);
}

ProductExpansion ProductExpansion::after_filling(double volume_ratio) const {
  ProductExpansion filled = *this;
  if (volume_ratio <= filled_) return filled;
  filled.hotter_ = hotter_ * energy() / stored_energy(volume_ratio);
  filled.filled_ = volume_ratio;
  return filled;
}

}  // namespace muckpile
