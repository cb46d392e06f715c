// SPDX-License-Identifier: GPL-2.0-or-later
// Burdens along charges.
// Scope: see the header.
#include "rock/hole_burdens.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/shape/polygon.h"

namespace muckpile {
namespace {

constexpr int kPoints = 20;  // along a charge

using Corners = std::vector<Vec3>;

std::vector<Corners> free_faces(const std::vector<Block>& blocks, const SupportRule& support) {
  std::vector<Corners> faces;
  for (const Block& block : blocks) {
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != kFreeFace) continue;
      if (support(face_geometry(block.shape, static_cast<int>(f)).centroid) != Support::free)
        continue;
      Corners corners;
      for (const int v : block.shape.faces[f])
        corners.push_back(block.shape.vertices[static_cast<std::size_t>(v)]);
      faces.push_back(std::move(corners));
    }
  }
  return faces;
}

/// The part of a polygon on the side of a plane at right angles to `along` where sign t <= sign
/// end.
Corners cut_at(const Corners& polygon, const Vec3& from, const Vec3& along, double end,
               double sign) {
  Corners kept;
  const auto over = [&](const Vec3& p) { return sign * (along.dot(p - from) - end); };
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3 &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
    const double here = over(p), there = over(q);
    if (here <= 0.0) kept.push_back(p);
    if ((here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0))
      kept.push_back(p + here / (here - there) * (q - p));
  }
  return kept;
}

double distance_to_edge(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double share =
      along.squaredNorm() > 0.0 ? std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
  return (a + share * along).norm();
}

/// Of the axis from what of a face lies between two heights along it; infinity if nothing does [m].
double distance_between(const Corners& face, const PlaneFrame& across, double from, double to) {
  const Corners part = cut_at(cut_at(face, across.origin, across.normal, from, -1.0), across.origin,
                              across.normal, to, 1.0);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < part.size(); ++k)
    nearest = std::min(
        nearest, distance_to_edge(across.flat(part[k]), across.flat(part[(k + 1) % part.size()])));
  return nearest;
}

HoleBurden burden_of(const Hole& hole, const std::vector<Corners>& faces) {
  const Vec3 along = hole.collar - hole.toe;
  const PlaneFrame across(hole.toe, along);
  const double step = along.norm() / kPoints;
  std::vector<double> nearest(kPoints, std::numeric_limits<double>::infinity());
  for (const Corners& face : faces) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Vec3& p : face) {
      const double height = across.normal.dot(p - hole.toe);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    const int first = std::max(0, static_cast<int>(std::floor(std::max(0.0, lowest) / step)));
    for (int k = first; k < kPoints && k * step <= highest; ++k) {
      double& here = nearest[static_cast<std::size_t>(k)];
      here = std::min(here, distance_between(face, across, k * step, (k + 1) * step));
    }
  }
  std::erase_if(nearest, [](double d) { return !std::isfinite(d); });
  HoleBurden burden;
  burden.bare = 1.0 - static_cast<double>(nearest.size()) / kPoints;
  if (nearest.empty()) return burden;
  burden.least = *std::ranges::min_element(nearest);
  burden.greatest = *std::ranges::max_element(nearest);
  double sum = 0.0;
  for (const double d : nearest) sum += d;
  burden.mean = sum / static_cast<double>(nearest.size());
  return burden;
}

/// Of the middles of two charges, at right angles to the first [m].
double way_to(const Hole& hole, const Hole& other) {
  const Vec3 along = (hole.collar - hole.toe).normalized();
  const Vec3 between = 0.5 * (other.toe + other.collar - hole.toe - hole.collar);
  return (between - along.dot(between) * along).norm();
}

/// The nearest of the holes that are nearer to a face by a good part of the way between them.
void find_hole_in_front(const std::vector<Hole>& holes, std::size_t which,
                        std::vector<HoleBurden>& burdens) {
  constexpr double kNearer = 0.4;  // of the way to it
  HoleBurden& mine = burdens[which];
  if (!mine.mean) return;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    if (h == which || !burdens[h].mean) continue;
    const double way = way_to(holes[which], holes[h]);
    if (way > *mine.mean || *mine.mean - *burdens[h].mean < kNearer * way) continue;
    const bool is_deck = way < 2.0 * (holes[which].radius + holes[h].radius);
    if (is_deck || (mine.in_front && way >= mine.to_front)) continue;
    mine.in_front = h;
    mine.to_front = way;
  }
}

std::string warning_of(const HoleBurden& burden, std::size_t number, double plan) {
  const std::string start =
      "WARNING: create_blocks: hole " + std::to_string(number + 1) + " has a burden of ";
  const std::string than = " of the plan's " + number_text(plan) + " m along its charge";
  if (!burden.least) return "";
  std::string text;
  if (*burden.least < kLeastBurden * plan)
    text += start + rounded_text(*burden.least, 3) + " m at least, below " +
            number_text(kLeastBurden) + than + ": rock may fly far; move or charge it less\n";
  const double greatest = burden.in_front ? burden.to_front : *burden.greatest;
  if (greatest > kGreatestBurden * plan)
    text += start + rounded_text(greatest, 3) + " m at most, above " +
            number_text(kGreatestBurden) + than + ": toe may stay\n";
  return text;
}

}  // namespace

std::vector<HoleBurden> hole_burdens(const std::vector<Block>& blocks,
                                     const std::vector<Hole>& holes, const SupportRule& support) {
  const std::vector<Corners> faces = free_faces(blocks, support);
  std::vector<HoleBurden> burdens;
  for (const Hole& hole : holes) burdens.push_back(burden_of(hole, faces));
  for (std::size_t h = 0; h < holes.size(); ++h) find_hole_in_front(holes, h, burdens);
  return burdens;
}

std::string describe_burdens(const std::vector<HoleBurden>& burdens, double plan) {
  std::ostringstream text;
  text << "  burden of each hole along its charge, to the free face beside it [m]\n"
          "    hole    least     mean greatest  to the hole in front\n";
  std::string warnings;
  text << std::fixed << std::setprecision(2);
  for (std::size_t h = 0; h < burdens.size(); ++h) {
    const HoleBurden& burden = burdens[h];
    text << "    " << std::setw(4) << h + 1;
    if (burden.mean)
      text << std::setw(9) << *burden.least << std::setw(9) << *burden.mean << std::setw(9)
           << *burden.greatest;
    else
      text << "  no free face beside it";
    if (burden.in_front) text << "  " << burden.to_front << " to " << *burden.in_front + 1;
    if (burden.mean && burden.bare > 0.0)
      text << "  (none beside " << std::lround(100.0 * burden.bare) << " % of the charge)";
    text << '\n';
    if (plan > 0.0) warnings += warning_of(burden, h, plan);
  }
  return text.str() + warnings;
}

}  // namespace muckpile
