// SPDX-License-Identifier: GPL-2.0-or-later
// The chosen expansion law; see the header.
#include "explosive/product_expansion.h"

#include <sstream>

#include "args/require.h"

namespace muckpile {

ProductExpansion::ProductExpansion(const TwoStageIsentrope::Parameters& two_stage,
                                   const std::optional<JwlParameters>& jwl)
    : two_stage_(two_stage), switch_ratio_(two_stage_.switch_ratio()) {
  if (!jwl) return;
  jwl_.emplace(*jwl);
  switch_ratio_ = jwl_->volume_ratio_at(two_stage.switch_pressure);
  if (switch_ratio_ <= JwlIsentrope::kFittedTo) return;
  std::ostringstream rule;
  rule << "at least " << jwl_->pressure(JwlIsentrope::kFittedTo) << " Pa, the pressure at "
       << JwlIsentrope::kFittedTo << " V0 to which JWL is fitted,";
  refuse_value("gas_switch_pressure", rule.str().c_str(), "", two_stage.switch_pressure);
}

}  // namespace muckpile
