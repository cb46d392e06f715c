// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of each hole.
// Scope: see the header.
#include "measure/hole_rock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "measure/face_velocity.h"

namespace muckpile {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PatternHole hole_of(const Deck& deck) {
  const Vec3 along = deck.hole_collar - deck.hole_toe;
  const Vec2 lean = along.head<2>() / along.z();
  return {deck.hole,        0,  deck.hole_toe.head<2>() - deck.hole_toe.z() * lean, lean,
          deck.firing_time, 0.0};
}

void number_rows(std::vector<PatternHole>& holes, double burden) {
  std::ranges::sort(holes, std::ranges::greater{}, [](const PatternHole& h) { return h.foot.x(); });
  int row = 0;
  double front = holes.empty() ? 0.0 : holes.front().foot.x();
  for (PatternHole& hole : holes) {
    if (front - hole.foot.x() > 0.5 * burden) {
      ++row;
      front = hole.foot.x();
    }
    hole.row = row;
  }
  std::ranges::stable_sort(holes, {},
                           [](const PatternHole& h) { return std::pair(h.row, h.foot.y()); });
}

}  // namespace

std::vector<PatternHole> pattern_holes(const HoleTable& table, const std::vector<double>& masses,
                                       double burden) {
  std::map<std::string, size_t> known;
  std::vector<PatternHole> holes;
  for (size_t k = 0; k < table.decks().size(); ++k) {
    const Deck& deck = table.decks()[k];
    const auto [place, fresh] = known.emplace(deck.hole, holes.size());
    if (fresh) holes.push_back(hole_of(deck));
    PatternHole& hole = holes[place->second];
    hole.firing_time = std::min(hole.firing_time, deck.firing_time);
    hole.charge += masses[k];
  }
  number_rows(holes, burden);
  return holes;
}

void number_rows(std::vector<PatternHole>& holes, const HoleFrames& frames) {
  for (PatternHole& hole : holes) {
    const auto own = std::ranges::find(frames.holes(), hole.name, &HoleFrame::name);
    if (own != frames.holes().end()) hole.row = own->row;
  }
  std::ranges::stable_sort(holes, {},
                           [](const PatternHole& h) { return std::pair(h.row, h.foot.y()); });
}

std::vector<int> hole_of_blocks(const std::vector<StartBlock>& blocks,
                                const std::vector<PatternHole>& holes, const BenchPlanes& planes,
                                double burden) {
  const auto across = [](const PatternHole& hole) { return hole.foot.x(); };
  const double last = planes.frames != nullptr ? planes.frames->depth()
                                               : -std::ranges::min(holes, {}, across).foot.x();
  const double behind = last + 0.5 * burden;
  std::vector<int> nearest(blocks.size(), -1);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& start = blocks[b].centroid;
    if (!planes.in_front_of(behind, start)) continue;
    double least = std::numeric_limits<double>::infinity();
    for (size_t h = 0; h < holes.size(); ++h) {
      const Vec2 axis = holes[h].foot + start.z() * holes[h].lean;
      const double distance = (start.head<2>() - axis).norm();
      if (distance >= least) continue;
      least = distance;
      nearest[b] = static_cast<int>(h);
    }
  }
  return nearest;
}

CastRock cast_rock(const std::vector<size_t>& chosen, const std::vector<StartBlock>& blocks,
                   const Snapshot& last, const std::vector<char>& moved,
                   const BenchPlanes& planes) {
  CastRock rock;
  for (const size_t b : chosen) {
    ++rock.blocks;
    rock.mass += blocks[b].mass;
    rock.volume += blocks[b].volume;
    rock.moved_volume += moved[b] != 0 ? blocks[b].volume : 0.0;
    const Vec3& start = blocks[b].centroid;
    rock.throw_mean += blocks[b].mass * planes.outward(start).dot(last.states[b].centre - start);
  }
  rock.throw_mean = rock.blocks > 0 ? rock.throw_mean / rock.mass : kNan;
  rock.velocity = rock.velocity_time = kNan;
  return rock;
}

void add_velocity(CastRock& rock, const std::vector<size_t>& chosen,
                  const std::vector<StartBlock>& blocks, const Snapshot& now,
                  const BenchPlanes& planes) {
  if (chosen.empty()) return;
  const double velocity = mean_outward_velocity(blocks, now, chosen, planes);
  if (velocity <= rock.velocity) return;
  rock.velocity = velocity;
  rock.velocity_time = now.time;
}

}  // namespace muckpile
