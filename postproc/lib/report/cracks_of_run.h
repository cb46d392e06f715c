// SPDX-License-Identifier: GPL-2.0-or-later
// The cracks of a run that hang together with its holes.
// Scope: of the model without images, at the run's last step; docs/post/damage.md defines them.
#pragma once

#include <optional>
#include <vector>

#include "draw/canvas.h"
#include "io/result_folder.h"
#include "measure/cracks.h"

namespace muckpile {

struct CracksOfRun {
  std::vector<RockFace> faces;
  std::vector<char> broken;  // per face
  std::vector<Charge> charges;
  std::vector<std::optional<size_t>> holes;  // per face: the charge that its crack comes from
  std::vector<Reaches> reaches;              // per charge
  double hole_radius;                        // NaN: not known [m]

  [[nodiscard]] bool connected(size_t face) const { return holes[face].has_value(); }
  // Of the area of all broken joints; NaN where none is.
  [[nodiscard]] double connected_share() const;
  // Per block of the model, of its joint area.
  [[nodiscard]] std::vector<double> connected_of_blocks(size_t blocks) const;
};

// Nothing where the run did not write which joints hold at this step.
std::optional<CracksOfRun> cracks_of_run(const ResultFolder& folder,
                                         const std::vector<StartBlock>& rock, long step,
                                         double hole_radius);

// cracks.csv: per charge and direction, over its sections.
void write_crack_table(const CracksOfRun& cracks, const std::filesystem::path& path);

// The joints where a level plane through the middle of the first charge cuts them.
Canvas draw_cracks(const CracksOfRun& cracks);

}  // namespace muckpile
