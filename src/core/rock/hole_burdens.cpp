// SPDX-License-Identifier: GPL-2.0-or-later
// Burdens along charges.
// Scope: see the header.
#include "rock/hole_burdens.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "args/first_lines.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/shape/polygon.h"
#include "rock/burden_faces.h"

namespace muckpile {
namespace {

constexpr int kPoints = 20;  // along a charge

/// Of the way from the axis to a face: its length and its end there [m].
struct Nearest {
  double way = std::numeric_limits<double>::infinity();
  Vec3 at = Vec3::Zero();
};

Nearest on_edge(const PlaneFrame& across, const Vec3& from, const Vec3& to) {
  const Vec2 a = across.flat(from), along = across.flat(to) - a;
  const double share =
      along.squaredNorm() > 0.0 ? std::clamp(-a.dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
  return {(a + share * along).norm(), from + share * (to - from)};
}

/// The nearest place of what of a face lies between two heights along the axis; infinitely far if
/// nothing does.
Nearest nearest_between(const Corners& face, const PlaneFrame& across, double from, double to) {
  const Corners part = cut_at(cut_at(face, across.origin, across.normal, from, -1.0), across.origin,
                              across.normal, to, 1.0);
  Nearest nearest;
  for (std::size_t k = 0; k < part.size(); ++k) {
    const Nearest here = on_edge(across, part[k], part[(k + 1) % part.size()]);
    if (here.way < nearest.way) nearest = here;
  }
  return nearest;
}

/// Whether the way from the axis meets the face squarely enough for it to be beside the charge: a
/// piece that meets none so only sees where a face ends, such as a subdrill at the floor.
bool is_square(const FreeFace& face, const PlaneFrame& across, const Vec3& place) {
  constexpr double kLeast = 0.8;     // cosine
  constexpr double kFlattest = 0.5;  // of the normal at right angles to the axis
  const Vec2 normal(across.first.dot(face.normal), across.second.dot(face.normal)),
      way = across.flat(place);
  return normal.norm() >= kFlattest && way.dot(normal) >= kLeast * way.norm() * normal.norm();
}

/// In each of the pieces of a charge.
std::vector<Nearest> nearest_along(const Hole& hole, const std::vector<FreeFace>& faces) {
  const Vec3 along = hole.collar - hole.toe;
  const PlaneFrame across(hole.toe, along);
  const double step = along.norm() / kPoints;
  std::vector<Nearest> nearest(kPoints);
  std::vector<char> beside(kPoints, 0);  // some face, which the nearest place need not be of
  for (const FreeFace& face : faces) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (const Vec3& p : face.corners) {
      const double height = across.normal.dot(p - hole.toe);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    const int first = std::max(0, static_cast<int>(std::floor(std::max(0.0, lowest) / step)));
    for (int k = first; k < kPoints && k * step <= highest; ++k) {
      const auto piece = static_cast<std::size_t>(k);
      const Nearest here = nearest_between(face.corners, across, k * step, (k + 1) * step);
      if (!std::isfinite(here.way)) continue;
      if (is_square(face, across, here.at)) beside[piece] = 1;
      if (here.way < nearest[piece].way) nearest[piece] = here;
    }
  }
  for (std::size_t piece = 0; piece < nearest.size(); ++piece)
    if (beside[piece] == 0) nearest[piece] = {};
  return nearest;
}

HoleBurden burden_of(const Hole& hole, const std::vector<FreeFace>& faces) {
  HoleBurden burden;
  double sum = 0.0;
  int beside = 0;
  for (const Nearest& nearest : nearest_along(hole, faces)) {
    const double share = (static_cast<double>(burden.pieces.size()) + 0.5) / kPoints;
    BurdenPiece piece{share * (hole.collar - hole.toe).norm(),
                      hole.toe + share * (hole.collar - hole.toe), std::nullopt, Vec3::Zero()};
    if (std::isfinite(nearest.way)) {
      piece.burden = nearest.way;
      piece.face = nearest.at;
      burden.least = std::min(burden.least.value_or(nearest.way), nearest.way);
      burden.greatest = std::max(burden.greatest.value_or(nearest.way), nearest.way);
      sum += nearest.way;
      ++beside;
    }
    burden.pieces.push_back(piece);
  }
  burden.bare = 1.0 - static_cast<double>(beside) / kPoints;
  if (beside > 0) burden.mean = sum / beside;
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
  std::optional<double> least, greatest;
  for (const BurdenPiece& piece : burden.pieces) {
    const std::optional<double> here = burden_that_counts(burden, piece);
    if (!here) continue;
    least = std::min(least.value_or(*here), *here);
    greatest = std::max(greatest.value_or(*here), *here);
  }
  std::string text;
  if (judged(least, plan) == BurdenIs::too_little)
    text += start + rounded_text(*least, 3) + " m at least, below " + number_text(kLeastBurden) +
            than + ": rock may fly far; move or charge it less\n";
  if (judged(greatest, plan) == BurdenIs::too_much)
    text += start + rounded_text(*greatest, 3) + " m at most, above " +
            number_text(kGreatestBurden) + than + ": toe may stay\n";
  return text;
}

}  // namespace

std::optional<double> burden_that_counts(const HoleBurden& hole, const BurdenPiece& piece) {
  if (!hole.in_front) return piece.burden;
  return std::min(piece.burden.value_or(hole.to_front), hole.to_front);
}

BurdenIs judged(const std::optional<double>& burden, double plan) {
  if (!burden || !(plan > 0.0)) return BurdenIs::not_judged;
  if (*burden < kLeastBurden * plan) return BurdenIs::too_little;
  return *burden > kGreatestBurden * plan ? BurdenIs::too_much : BurdenIs::as_planned;
}

std::vector<HoleBurden> hole_burdens(const std::vector<Block>& blocks,
                                     const std::vector<Hole>& holes, const SupportRule& support,
                                     const SurveyedRock& surveyed) {
  const std::vector<FreeFace> faces = free_faces(blocks, support, surveyed);
  std::vector<HoleBurden> burdens;
  for (const Hole& hole : holes) burdens.push_back(burden_of(hole, faces));
  for (std::size_t h = 0; h < holes.size(); ++h) find_hole_in_front(holes, h, burdens);
  return burdens;
}

std::vector<HoleBurden> hole_burdens(const std::vector<Block>& blocks,
                                     const std::vector<Hole>& holes, const SupportRule& support) {
  return hole_burdens(blocks, holes, support, SurveyedRock{});
}

std::string describe_burdens(const std::vector<HoleBurden>& burdens, double plan) {
  std::ostringstream text;
  text << "  burden of each hole along its charge, to the free face beside it [m]\n"
          "    hole    least     mean greatest  to the hole in front\n";
  std::vector<std::string> warnings;
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
    const std::string warning = plan > 0.0 ? warning_of(burden, h, plan) : "";
    if (!warning.empty()) warnings.push_back(warning);
  }
  return text.str() +
         first_lines(warnings,
                     "WARNING: create_blocks: ", "holes with burdens that far from the plan's");
}

}  // namespace muckpile
