// SPDX-License-Identifier: GPL-2.0-or-later
// The sections of a run's page that show what was measured.
// Scope: pictures and figures that the other commands have left.
#pragma once

#include "page/html.h"
#include "page/page_parts.h"

namespace muckpile {

void add_measures(Html& page, const PageContent& run);

}  // namespace muckpile
