// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of what the gauges of a run felt: speed and stress over time, and peaks against scaled
// distance.
// Scope: draws what it is given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "draw/canvas.h"
#include "io/gauges_file.h"
#include "measure/power_fit.h"

namespace muckpile {

struct GaugePeak {
  const GaugeHistory* gauge;
  double distance;              // from the nearest charge's axis [m]
  double scaled;                // over the square root of the charge per delay [m/kg^0.5]
  double speed;                 // largest magnitude of the velocity [m/s]
  double time;                  // of it [s]
  double arrival;               // when the speed first reaches a tenth of the largest [s]
  double pressure;              // largest mean pressure [Pa]
  double compression, tension;  // largest -s3 and largest s1 [Pa]
};

// Speed, mean pressure, largest and least principal stress of at most eight gauges of as many
// blocks, spread over the distances, from time 0 to three times that of the last peak.
Canvas draw_waves(const std::vector<GaugePeak>& peaks);

// `charge`: per delay [kg].
Canvas draw_peaks(const std::vector<GaugePeak>& peaks, const std::optional<PowerFit>& fit,
                  double charge);

}  // namespace muckpile
