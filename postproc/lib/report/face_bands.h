// SPDX-License-Identifier: GPL-2.0-or-later
// Velocity of the free face over height, as table and picture.
// Scope: peaks over the snapshots; which blocks make a band is measure/face_velocity.h.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "io/result_folder.h"
#include "io/snapshot.h"
#include "measure/face_velocity.h"

namespace muckpile {

inline constexpr int kFaceBands = 10;  // of height, as a velocity profile of a filmed face has

// A band of height of the face in front of a hole, or of all.
struct FaceBand {
  std::string name;
  double low, high;  // [m]
  std::vector<size_t> layer;
  double peak = std::nan(""), time = std::nan("");  // [m/s], [s]
};

// Of the rock of a layer, where it is the fastest so far.
void add_velocity(FaceBand& band, const std::vector<StartBlock>& blocks, const Snapshot& now,
                  const BenchPlanes& planes);

// face_velocity.csv and face_velocity.png.
void write_face_bands(const ResultFolder& folder, const std::vector<FaceBand>& bands, bool still);
void remove_face_bands(const ResultFolder& folder);

}  // namespace muckpile
