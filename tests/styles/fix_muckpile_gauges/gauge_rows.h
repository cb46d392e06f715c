// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of fix muckpile/gauges, as a test reads them.
// Scope: numbers by column; the id of the run is left out.
#pragma once

#include <filesystem>
#include <vector>

#include "math/types.h"

namespace muckpile::test {

struct GaugeRow {
  long step = 0;
  double time = 0.0;  // [s]
  int gauge = 0, block = 0;
  Vec3 start, moved, velocity;  // [m], [m], [m/s]
  Mat3 stress;                  // [Pa]
  double pressure = 0.0;        // [Pa]
};

std::vector<GaugeRow> gauge_rows(const std::filesystem::path& file);
/// Those of one gauge.
std::vector<GaugeRow> rows_of(const std::vector<GaugeRow>& rows, int gauge);

/// Largest differences of displacements, velocities and stresses, each over the largest of its
/// kind. Fails the test where the rows are not of the same steps and gauges.
double difference(const std::vector<GaugeRow>& one, const std::vector<GaugeRow>& other);

}  // namespace muckpile::test
