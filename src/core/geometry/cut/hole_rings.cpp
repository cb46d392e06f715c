// SPDX-License-Identifier: GPL-2.0-or-later
// Seeds in rings around holes that are narrow against their blocks.
// Scope: see the header.
#include "geometry/cut/hole_rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "args/input_error.h"
#include "args/rounded_text.h"
#include "geometry/cut/ground.h"
#include "geometry/holes/hole_overlap.h"
#include "geometry/holes/hole_surface.h"

namespace muckpile {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSame = 1e-6;  // of a radius: two points, or two lines, are one

// Rock between the end of a hole and the next surface or hole that is thinner than that goes with
// the void [block sizes]; 3 V / A of such a plate is near kThinnestPart. Ours.
constexpr double kThinnestEnd = 0.25;

/// A hole and the rings beside it. Lengths in metres.
struct Ringed {
  std::size_t number;
  Hole hole;
  double size, length;
  int levels;
  double below = 0.0, above = 0.0;            // from its ends to its first and last level
  bool cap_below = false, cap_above = false;  // rings beyond the ends
  double over_below = 0.0, over_above = 0.0;  // how far the void goes on where there are none
  int columns = 6;
  double spread = 0.0;  // height that all rings on one line are spread for; 0: that of the levels

  [[nodiscard]] double height() const { return length / levels; }
  /// Beyond the cells of the rings.
  [[nodiscard]] double outer() const {
    constexpr double kLowest = 0.65;  // levels, in blocks: discs do not get wider
    const double h = std::max(spread > 0.0 ? spread : height(), kLowest * size);
    return std::sqrt(columns * size * size * size / (kPi * h) + hole.radius * hole.radius);
  }
  [[nodiscard]] double seeds_at() const { return outer() - 0.5 * size; }
  /// Of the sides of the prism.
  [[nodiscard]] double apothem() const {
    return hole.radius * std::sqrt(kPi / (columns * std::tan(kPi / columns)));
  }
  /// No point of the void is nearer to a seed farther than that from the axis than to one of the
  /// ring.
  [[nodiscard]] double reach() const {
    constexpr double kSlack = 1.02;
    const double edge = apothem() / std::cos(kPi / columns), rho = seeds_at();
    const double nearest =
        std::sqrt(rho * rho + edge * edge - 2.0 * rho * apothem() + 0.25 * height() * height());
    return std::max(outer(), kSlack * (edge + nearest));
  }
};

[[noreturn]] void fail(const std::string& text) { throw InputError("block tessellation: " + text); }

Vec3 direction(const Hole& hole) { return (hole.collar - hole.toe).normalized(); }

/// Whether two holes are decks of one.
bool on_one_line(const Hole& a, const Hole& b) {
  const Vec3 along = direction(a), between = b.toe - a.toe;
  return along.cross(direction(b)).norm() < kSame &&
         (between - between.dot(along) * along).norm() < kSame * a.radius;
}

/// How far the rock goes on beyond an end of a hole, up to `most` [m].
double rock_beyond(const Ground& ground, const Vec3& end, const Vec3& out, double most) {
  constexpr int kLooks = 16, kHalvings = 30;
  double in = 0.0, outside = most;
  for (int k = 1; k <= kLooks; ++k) {
    const double at = most * k / kLooks;
    if (!ground.in_region(end + at * out)) {
      outside = at;
      break;
    }
    in = at;
  }
  if (in == most) return most;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = 0.5 * (in + outside);
    (ground.in_region(end + middle * out) ? in : outside) = middle;
  }
  return in;
}

/// Whether a wall of the box holds the axis; `normal` is that wall's.
bool lies_in_wall(const TessellationOptions& options, const Hole& hole, Vec3& normal) {
  for (int c = 0; c < 3; ++c) {
    if (std::abs(direction(hole)[c]) > kSame) continue;
    const double from_wall = std::min(hole.toe[c] - options.lo[c], options.hi[c] - hole.toe[c]);
    if (from_wall > kSame * hole.radius) continue;
    normal = Vec3::Unit(c);
    return true;
  }
  return false;
}

/// Where two cells of a ring meet: in a wall of the box that holds the axis, else towards x or y.
Vec3 first_edge(const TessellationOptions& options, const Hole& hole) {
  const Vec3 along = direction(hole);
  Vec3 normal = Vec3::Zero();
  if (lies_in_wall(options, hole, normal)) return normal.cross(along).normalized();
  const Vec3 x = Vec3::UnitX() - along.x() * along, y = Vec3::UnitY() - along.y() * along;
  return (x.norm() > 0.5 ? x : y).normalized();
}

/// Blocks of a ring: six fill it, eight where quarters of it lie on both sides of two walls at
/// right angles. With four the rock around moves a tenth too little at three radii.
int column_count(const TessellationOptions& options, const Hole& hole) {
  Vec3 normal;
  return lies_in_wall(options, hole, normal) ? 8 : 6;
}

Ringed ringed(const TessellationOptions& options, const Ground& ground, std::size_t h) {
  const Hole& hole = options.holes[h];
  const double wall_size = options.size.at(hole.radius);
  const std::string name = "hole " + std::to_string(h + 1);
  if (wall_size > kCoarsest * hole.radius) {
    fail("blocks at the wall of " + name + " must be <= " + rounded_text(kCoarsest) +
         " times its crushed-zone radius " + rounded_text(hole.radius) + " m, got '" +
         rounded_text(wall_size) + "'; take a block_min below " +
         rounded_text(kCoarsest * hole.radius) + " m, or a wider charge");
  }
  Ringed ring{h, hole, wall_size, hole_length(hole), 1};
  ring.columns = column_count(options, hole);
  const Vec3 middle = 0.5 * (hole.toe + hole.collar), out = first_edge(options, hole);
  constexpr int kRounds = 4;  // sizes grow with distance
  for (int k = 0; k < kRounds; ++k) ring.size = ground.size(middle + ring.seeds_at() * out);
  constexpr double kShortest = 0.25;
  if (ring.length < kShortest * ring.size) {
    fail(name + " must be at least " + rounded_text(kShortest) + " of the blocks' " +
         rounded_text(ring.size) + " m long, got '" + rounded_text(ring.length) +
         "'; take a smaller block_min, or a longer charge");
  }
  constexpr double kHighest = 1.3;  // levels [block sizes]
  ring.levels = std::max(1, static_cast<int>(std::ceil(ring.length / ring.size - (kHighest - 1))));
  return ring;
}

/// What lies beyond an end of a hole: so much rock, behind which another hole may be, whose levels
/// are so high. Lengths in metres.
struct Beyond {
  double rock, half_level;
  bool hole = false;
};

Beyond beyond(const Ground& ground, const std::vector<Ringed>& line, const Ringed& ring,
              const Vec3& end, const Vec3& out) {
  const double half = 0.5 * ring.height();
  Beyond found{rock_beyond(ground, end, out, 2.0 * ring.size), half};
  for (const Ringed& other : line) {
    if (other.number == ring.number) continue;
    for (const Vec3& from : {other.hole.toe, other.hole.collar}) {
      const double way = (from - end).dot(out);
      if (way < -kSame * ring.length || way > found.rock) continue;
      found = {std::max(0.0, way), std::min(half, 0.5 * other.height()), true};
    }
  }
  return found;
}

/// Places the levels next to the ends of the holes on one line, and decides on rings beyond them.
void set_ends(const Ground& ground, std::vector<Ringed>& line) {
  constexpr int kRounds = 3;  // a hole of one level that is not in the middle gets two
  for (int round = 0; round < kRounds; ++round) {
    for (Ringed& ring : line) {
      const Vec3 along = direction(ring.hole);
      const auto place = [&](const Vec3& end, const Vec3& out, double& level, bool& cap,
                             double& over) {
        const Beyond there = beyond(ground, line, ring, end, out);
        cap = there.rock >= kThinnestEnd * ring.size;
        level = cap ? std::min(there.half_level, 0.5 * there.rock) : there.half_level;
        over = cap ? 0.0 : there.hole ? 0.5 * there.rock : ring.size;
      };
      place(ring.hole.toe, -along, ring.below, ring.cap_below, ring.over_below);
      place(ring.hole.collar, along, ring.above, ring.cap_above, ring.over_above);
      const double middle = (1.0 - kSame) * 0.5 * ring.length;
      if (ring.levels == 1 && std::min(ring.below, ring.above) < middle) ring.levels = 2;
    }
  }
}

/// Rings of decks stand at the same distance from the axis, so that planes between them are ends.
void spread_alike(std::vector<Ringed>& line) {
  double highest = 0.0;
  for (const Ringed& ring : line) highest = std::max(highest, ring.height());
  for (Ringed& ring : line) ring.spread = highest;
}

/// Of the levels of a hole from its toe [m].
std::vector<double> levels(const Ringed& ring) {
  if (ring.levels == 1) return {0.5 * ring.length};
  std::vector<double> at;
  const double step = (ring.length - ring.below - ring.above) / (ring.levels - 1);
  for (int k = 0; k < ring.levels; ++k) at.push_back(ring.below + k * step);
  return at;
}

/// Adds the seeds of one hole that lie in the rock. Two decks may share a ring between them.
void add_seeds(const TessellationOptions& options, const Ground& ground, const Ringed& ring,
               std::vector<RingSeed>& seeds) {
  constexpr double kShared = 0.3;  // [block sizes]
  const Hole& hole = ring.hole;
  const Vec3 along = direction(hole), first = first_edge(options, hole),
             second = along.cross(first);
  std::vector<std::pair<double, bool>> rings;  // from the toe [m], beside the void
  for (const double at : levels(ring)) rings.emplace_back(at, true);
  if (ring.cap_below) rings.emplace_back(-ring.below, false);
  if (ring.cap_above) rings.emplace_back(ring.length + ring.above, false);
  for (const auto& [at, beside] : rings) {
    for (int k = 0; k < ring.columns; ++k) {
      const double angle = 2.0 * kPi * (k + 0.5) / ring.columns;
      const Vec3 out = std::cos(angle) * first + std::sin(angle) * second;
      const Vec3 place = hole.toe + at * along + ring.seeds_at() * out;
      const auto is_there = [&](const RingSeed& seed) {
        return seed.hole < 0 && (seed.at - place).norm() < kShared * ring.size;
      };
      if (!ground.in_region(place)) continue;
      if (!beside && std::any_of(seeds.begin(), seeds.end(), is_there)) continue;
      const int number = beside ? static_cast<int>(ring.number) : -1;
      seeds.push_back({place, number, {hole.toe + ring.apothem() * out, out}, ring.size});
    }
  }
}

/// Around the void; unit normals look out.
std::vector<CutPlane> prism_of(const TessellationOptions& options, const Ringed& ring) {
  const Vec3 along = direction(ring.hole), first = first_edge(options, ring.hole),
             second = along.cross(first);
  std::vector<CutPlane> planes;
  for (int k = 0; k < ring.columns; ++k) {
    const double angle = 2.0 * kPi * (k + 0.5) / ring.columns;
    const Vec3 out = std::cos(angle) * first + std::sin(angle) * second;
    planes.push_back({ring.hole.toe + ring.apothem() * out, out});
  }
  planes.push_back({ring.hole.toe - ring.over_below * along, -along});
  planes.push_back({ring.hole.collar + ring.over_above * along, along});
  return planes;
}

/// Two holes that are not decks of one must leave room for the rings of both.
void refuse_meeting_rings(const std::vector<std::vector<Ringed>>& lines) {
  const auto with_rings = [](const Ringed& ring) {
    Hole wide = ring.hole;
    wide.radius = 0.5 * (ring.reach() + ring.seeds_at());
    return wide;
  };
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t k = i + 1; k < lines.size(); ++k)
      for (const Ringed& a : lines[i])
        for (const Ringed& b : lines[k]) {
          if (!overlap(with_rings(a), with_rings(b))) continue;
          fail("holes " + std::to_string(std::min(a.number, b.number) + 1) + " and " +
               std::to_string(std::max(a.number, b.number) + 1) +
               " are too near to each other for blocks of '" +
               rounded_text(std::max(a.size, b.size)) +
               "' m around both; make the blocks smaller or move the holes apart");
        }
}

/// The holes with rings, those on one line together, in the order of the options.
std::vector<std::vector<Ringed>> ringed_lines(const TessellationOptions& options,
                                              const Ground& ground) {
  std::vector<std::vector<Ringed>> lines;
  for (std::size_t h = 0; h < options.holes.size(); ++h) {
    const Hole& hole = options.holes[h];
    if (options.size.at(hole.radius) < options.rings_from * hole.radius) continue;
    Ringed ring = ringed(options, ground, h);
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& other) {
      return on_one_line(other.front().hole, hole);
    });
    if (line == lines.end()) {
      lines.push_back({ring});
    } else {
      ring.columns = line->front().columns;
      line->push_back(ring);
    }
  }
  return lines;
}

}  // namespace

HoleRings::HoleRings(const TessellationOptions& options) {
  if (!options.rings) return;
  lo_ = options.lo;
  hi_ = options.hi;
  const Ground ground(options);
  std::vector<std::vector<Ringed>> lines = ringed_lines(options, ground);
  if (lines.empty()) return;
  reach_.assign(options.holes.size(), 0.0);
  prisms_.resize(options.holes.size());
  for (std::vector<Ringed>& line : lines) {
    set_ends(ground, line);
    spread_alike(line);
    for (const Ringed& ring : line) {
      reach_[ring.number] = ring.reach();
      prisms_[ring.number] = prism_of(options, ring);
      add_seeds(options, ground, ring, seeds_);
    }
  }
  refuse_meeting_rings(lines);
}

double HoleRings::largest_reach() const {
  return reach_.empty() ? 0.0 : *std::max_element(reach_.begin(), reach_.end());
}

}  // namespace muckpile
