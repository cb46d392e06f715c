// SPDX-License-Identifier: GPL-2.0-or-later
// Whoever holds the record of which run this is.
// Scope: an interface only; fix muckpile/blocks implements it, as the record goes with the blocks
// into restart files.
#pragma once

#include "fixes/output/run_record.h"

namespace muckpile {

class RecordedRunHolder {
 public:
  virtual ~RecordedRunHolder() = default;
  [[nodiscard]] virtual RunRecord& record() = 0;
};

}  // namespace muckpile
