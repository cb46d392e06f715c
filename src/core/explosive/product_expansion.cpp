// SPDX-License-Identifier: GPL-2.0-or-later
// The chosen expansion law; see the header.
#include "explosive/product_expansion.h"

#include <algorithm>

#include "explosive/volume_ratio.h"

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
  if (wanted <= 0.0) return energy();
  return energy() - stored_energy(volume_ratio_where(
                        filled_, [&](double ratio) { return pressure(ratio) > wanted; }));
}

ProductExpansion ProductExpansion::switched_at(double volume_ratio) const {
  ProductExpansion switched = *this;
  switched.switch_ratio_ = volume_ratio;
  return switched;
}

ProductExpansion ProductExpansion::switched_after(double share) const {
  const double left = (1.0 - share) * energy();
  return switched_at(
      volume_ratio_where(filled_, [&](double ratio) { return stored_energy(ratio) > left; }));
}

ProductExpansion ProductExpansion::after_filling(double volume_ratio) const {
  ProductExpansion filled = *this;
  if (volume_ratio <= filled_) return filled;
  filled.hotter_ = hotter_ * energy() / stored_energy(volume_ratio);
  filled.filled_ = volume_ratio;
  return filled;
}

}  // namespace muckpile
