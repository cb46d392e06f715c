// SPDX-License-Identifier: GPL-2.0-or-later
// How deep the charge of a crater lies.
// Scope: the key burial_depth_m of scene.json.
#pragma once

#include "io/result_folder.h"

namespace muckpile {

// [m]. Throws InputError where the scene does not have it, or it is not 1e-3 to 1e4 m: a damaged
// file may hold any number.
double burial_depth(const ResultFolder& folder);

}  // namespace muckpile
