// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of a pile's size curves: simulated, fitted, by formula, and where blocks end.
// Scope: draws what it is given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "measure/fragments.h"
#include "measure/kuz_ram.h"
#include "measure/size_fit.h"

namespace muckpile {

struct FragmentCurves {
  std::vector<SizePoint> sieve;                   // of the pile by sieve size
  std::vector<SizePoint> by_volume;               // by V^(1/3)
  std::vector<SizePoint> block_sieve;             // by sieve size, if every joint had broken
  std::vector<SizePoint> block_volume;            // by V^(1/3), likewise
  std::optional<SizeFit> rosin_rammler, swebrec;  // of `sieve`
  std::optional<KuzRamCurve> kuz_ram;
};

Canvas draw_fragments(const FragmentCurves& curves, const std::string& title,
                      const std::string& warning);

}  // namespace muckpile
