// SPDX-License-Identifier: GPL-2.0-or-later
// The chosen expansion law; see the header.
#include "explosive/product_expansion.h"

namespace muckpile {

ProductExpansion::ProductExpansion(const Law& law)
    : law_(law), switch_ratio_(std::visit([](const auto& l) { return l.switch_ratio(); }, law)) {}

double ProductExpansion::gamma() const {
  return std::visit([](const auto& law) { return law.gamma(); }, law_);
}

double ProductExpansion::stored_energy(double volume_ratio) const {
  return std::visit([volume_ratio](const auto& law) { return law.stored_energy(volume_ratio); },
                    law_);
}

}  // namespace muckpile
