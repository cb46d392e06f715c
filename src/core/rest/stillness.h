// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a block has hardly moved for a while.
// Scope: one block by itself; what its neighbours do is the caller's.
#pragma once

#include "math/types.h"
#include "state/encoding.h"

namespace muckpile {

/// A block is still once it has stayed within `distance` of one place for `time`, and is slower
/// than `speed`. So a block that starts from rest with an acceleration above 2 distance / time^2 is
/// never still, nor is one that turns back with more than (2 + sqrt 2)^2 distance / time^2.
struct StillnessLimits {
  double distance;  ///< [m]
  double time;      ///< [s]
  double speed;     ///< [m/s]
};

/// Where a block is; its surface lies within `radius` of its centre.
struct BlockPlace {
  Vec3 centre;    ///< [m]
  Mat3 axes;      ///< of the block in space, columns
  double radius;  ///< [m]
  double speed;   ///< of its fastest point [m/s]
};

class Stillness {
 public:
  /// Takes over where the block is at `now` [s]; true if it is still.
  bool follow(const StillnessLimits& limits, const BlockPlace& place, double now);

 private:
  friend struct Stored<Stillness>;
  Vec3 centre_ = Vec3::Zero();
  Mat3 axes_ = Mat3::Zero();  // no place: the first look begins the stay
  double since_ = 0.0;
};
template <>
struct Stored<Stillness> {
  static constexpr std::string_view kName = "stillness";
  static constexpr int kVersion = 1;
  static auto fields(auto& stay) { return std::tie(stay.centre_, stay.axes_, stay.since_); }
};

}  // namespace muckpile
