// SPDX-License-Identifier: GPL-2.0-or-later
// Faces in planes of the cut without a neighbour.
// Scope: see the header.
#include "geometry/cut/open_planes.h"

#include <cmath>

#include "geometry/cut/ground.h"
#include "geometry/cut/unit_planes.h"

namespace muckpile {
namespace {

// Beside rounding of the block size.
constexpr double kRounding = 1e-6, kOut = 1e-3;

}  // namespace

OpenPlanes open_planes(const TessellationOptions& options, const std::vector<Block>& blocks) {
  OpenPlanes open;
  if (options.planes.empty()) return open;
  const Ground ground = voronoi_ground(options);
  const UnitPlanes planes(options.planes);
  for (const Block& block : blocks) {
    const double size = std::cbrt(block.mass.volume);
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      if (!planes.hold(face, kRounding * size)) continue;
      // Where the rock ends in the plane, nothing should be behind it.
      if (!ground.in_region(face.centroid + kOut * size * face.normal)) continue;
      open.all += face.area;
      if (block.neighbour[f] != kFreeFace) continue;
      ++open.faces;
      open.area += face.area;
    }
  }
  return open;
}

}  // namespace muckpile
