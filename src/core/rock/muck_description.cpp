// SPDX-License-Identifier: GPL-2.0-or-later
// What create_blocks prints about muck; see muck.h.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "geometry/shape/shared_volume.h"
#include "rock/muck.h"

namespace muckpile {
namespace {

struct Span {
  double low, high;  // [m]; low > high: none
};

/// Where a vertical line is inside of a convex block.
Span inside(const std::vector<FaceGeometry>& faces, double x, double y) {
  constexpr double kUpright = 1e-9;
  Span span{-1e300, 1e300};
  for (const FaceGeometry& face : faces) {
    const Vec3& n = face.normal;
    const double left = n.dot(face.centroid) - n.x() * x - n.y() * y;
    if (std::abs(n.z()) < kUpright) {
      if (left < 0.0) return {1.0, 0.0};
    } else if (n.z() > 0.0) {
      span.high = std::min(span.high, left / n.z());
    } else {
      span.low = std::max(span.low, left / n.z());
    }
  }
  return span;
}

/// Level bounds of a block, in cells.
struct Cells {
  Cells(const Block& block, double cell) {
    for (const Vec3& v : block.shape.vertices) {
      x0 = std::min(x0, static_cast<long>(std::floor(v.x() / cell)));
      x1 = std::max(x1, static_cast<long>(std::floor(v.x() / cell)));
      y0 = std::min(y0, static_cast<long>(std::floor(v.y() / cell)));
      y1 = std::max(y1, static_cast<long>(std::floor(v.y() / cell)));
    }
  }
  long x0 = 1L << 40, x1 = -x0, y0 = x0, y1 = -x0;
};

struct Sizes {
  double volume = 0.0, mass = 0.0, floor = 1e300, top = -1e300, front = 1e300, toe = -1e300;
};

Sizes sizes_of(const Muck& muck) {
  Sizes all;
  for (const RigidBody& body : muck.bodies) {
    all.volume += body.volume;
    all.mass += body.mass;
    for (const Sphere& s : body.spheres) all.floor = std::min(all.floor, s.centre.z() - s.radius);
  }
  for (const Block& block : muck.blocks) {
    for (const Vec3& v : block.shape.vertices) {
      all.top = std::max(all.top, v.z());
      all.front = std::min(all.front, v.x());
      all.toe = std::max(all.toe, v.x());
    }
  }
  return all;
}

}  // namespace

double bulk_volume(const std::vector<Block>& blocks, double floor, double cell) {
  std::map<std::pair<long, long>, Span> columns;
  for (const Block& block : blocks) {
    const std::vector<FaceGeometry> faces = face_geometries(block.shape);
    const Cells cells(block, cell);
    for (long i = cells.x0; i <= cells.x1; ++i) {
      for (long j = cells.y0; j <= cells.y1; ++j) {
        const Span span = inside(faces, (static_cast<double>(i) + 0.5) * cell,
                                 (static_cast<double>(j) + 0.5) * cell);
        if (span.low > span.high) continue;
        Span& column = columns.try_emplace({i, j}, span).first->second;
        column = {std::min(column.low, span.low), std::max(column.high, span.high)};
      }
    }
  }
  const double block_size = 4.0 * cell;
  double volume = 0.0;
  for (const auto& [place, column] : columns) {
    const double from = column.low > floor + block_size ? column.low : floor;
    volume += cell * cell * (column.high - from);
  }
  return volume;
}

std::string describe_muck(const Muck& muck, const MuckSource& source) {
  if (muck.blocks.empty()) return "";
  const Sizes sizes = sizes_of(muck);
  const double size = std::cbrt(sizes.volume / static_cast<double>(muck.blocks.size()));
  const double bulk = bulk_volume(muck.blocks, sizes.floor, 0.25 * size);
  std::ostringstream text;
  text.precision(4);
  text << "  muck: " << muck.blocks.size() << " blocks of " << size << " m in the mean, "
       << sizes.mass << " kg, as '" << source.folder << "' has them at t = " << muck.time
       << " s; from x = " << sizes.front << " to " << sizes.toe << " m, up to z = " << sizes.top
       << " m; " << bulk << " m3 loose, swell " << bulk / sizes.volume << '\n';
  if (muck.standing.blocks > 0)
    text << "  muck: left out are " << muck.standing.blocks << " blocks, " << muck.standing.mass
         << " kg, that have not left their place\n";
  if (muck.in_rock.blocks > 0)
    text << "  muck: left out are " << muck.in_rock.blocks << " blocks, " << muck.in_rock.mass
         << " kg, in what is rock or floor now, or beyond the box\n";
  constexpr double kMoving = 0.02;
  if (muck.moving_share > kMoving)
    text << "WARNING: create_blocks: " << 100.0 * muck.moving_share
         << " % of the muck's mass was faster than 0.1 m/s in its snapshot; it is taken at rest, "
            "and may lie steeper than it would have\n";
  return text.str();
}

}  // namespace muckpile
