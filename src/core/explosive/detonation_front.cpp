// SPDX-License-Identifier: GPL-2.0-or-later
// Arrival of the detonation along a column; equations in the header.
#include "explosive/detonation_front.h"

#include <algorithm>
#include <cmath>

#include "args/require.h"

namespace muckpile {

DetonationFront::DetonationFront(const Parameters& parameters)
    : toe_(parameters.toe),
      axis_(parameters.collar - parameters.toe),
      length_(axis_.norm()),
      velocity_(parameters.detonation_velocity),
      firing_time_(parameters.firing_time) {
  require_positive("charge length", "m", length_);
  require_positive("vod", "m/s", velocity_);
  require_not_negative("delay", "s", firing_time_);
  if (!(parameters.primer >= 0.0 && parameters.primer <= 1.0)) {
    refuse_value("primer", "bottom, top or between 0 and 1", "", parameters.primer);
  }
  axis_ /= length_;
  primer_ = parameters.primer * length_;
}

double DetonationFront::arrival_time(const Vec3& point) const {
  const double height = std::clamp(axis_.dot(point - toe_), 0.0, length_);
  return firing_time_ + std::abs(height - primer_) / velocity_;
}

double DetonationFront::last_arrival_time() const {
  return firing_time_ + std::max(primer_, length_ - primer_) / velocity_;
}

}  // namespace muckpile
