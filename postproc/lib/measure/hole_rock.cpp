// SPDX-License-Identifier: GPL-2.0-or-later
// The rock of each hole.
// Scope: see the header.
#include "measure/hole_rock.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

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

int owner_of(const Vec3& p, const std::vector<PatternHole>& holes, double spacing) {
  int aside = -1;
  for (size_t first = 0; first < holes.size(); first = end_of_row(holes, first)) {
    const size_t hole = hole_beside(holes, first, p);
    if (p.x() < axis_at(holes[hole], p.z()).x()) continue;
    if (reaches(holes, hole, p, spacing)) return static_cast<int>(hole);
    if (aside < 0) aside = static_cast<int>(hole);
  }
  return aside;
}

int owner_of(const Vec3& p, const HoleFrames& frames, const std::vector<int>& numbers) {
  const std::optional<size_t> hole = frames.hole_of(p);
  return hole ? numbers[*hole] : -1;
}

// Of each frame, its hole's; -1 where there is none.
std::vector<int> numbers_of(const HoleFrames& frames, const std::vector<PatternHole>& holes) {
  std::vector<int> numbers;
  for (const HoleFrame& frame : frames.holes()) {
    const auto own = std::ranges::find(holes, frame.name, &PatternHole::name);
    numbers.push_back(own != holes.end() ? static_cast<int>(own - holes.begin()) : -1);
  }
  return numbers;
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

Vec2 axis_at(const PatternHole& hole, double height) { return hole.foot + height * hole.lean; }

size_t end_of_row(const std::vector<PatternHole>& holes, size_t first) {
  size_t end = first;
  while (end < holes.size() && holes[end].row == holes[first].row) ++end;
  return end;
}

size_t hole_beside(const std::vector<PatternHole>& holes, size_t first, const Vec3& p) {
  const auto aside = [&](size_t h) { return std::abs(p.y() - axis_at(holes[h], p.z()).y()); };
  size_t beside = first;
  for (size_t h = first; h < holes.size() && holes[h].row == holes[first].row; ++h)
    if (aside(h) < aside(beside)) beside = h;
  return beside;
}

bool reaches(const std::vector<PatternHole>& holes, size_t hole, const Vec3& p, double spacing) {
  const double y = axis_at(holes[hole], p.z()).y(), aside = p.y() - y;
  if (std::abs(aside) <= 0.5 * spacing) return true;
  const size_t next = aside > 0.0 ? hole + 1 : hole - 1;  // past the last one below the first
  if (next >= holes.size() || holes[next].row != holes[hole].row) return false;
  return std::abs(axis_at(holes[next], p.z()).y() - y) <= kNeighbours * spacing;
}

std::vector<int> hole_of_blocks(const std::vector<StartBlock>& blocks,
                                const std::vector<PatternHole>& holes, const BenchPlanes& planes) {
  const std::vector<int> of_frames =
      planes.frames != nullptr ? numbers_of(*planes.frames, holes) : std::vector<int>{};
  std::vector<int> owner(blocks.size(), -1);
  for (size_t b = 0; b < blocks.size(); ++b) {
    const Vec3& start = blocks[b].centroid;
    if (!planes.in_front_of(std::numeric_limits<double>::infinity(), start)) continue;
    owner[b] = planes.frames != nullptr ? owner_of(start, *planes.frames, of_frames)
                                        : owner_of(start, holes, planes.spacing);
  }
  return owner;
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
