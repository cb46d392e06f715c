// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of a run's surface against a surveyed one: the difference from above, and both mean
// profiles below it.
// Scope: draws what it is given.
#pragma once

#include "draw/canvas.h"
#include "measure/surface_comparison.h"

namespace muckpile {

Canvas draw_survey(const SurfacePair& pair, const ProfilePair& profiles,
                   const SurfaceDifference& difference);

}  // namespace muckpile
