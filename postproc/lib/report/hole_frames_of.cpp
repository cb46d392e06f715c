// SPDX-License-Identifier: GPL-2.0-or-later
// Directions of holes from their burdens.
// Scope: see the header.
#include "report/hole_frames_of.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "io/charges.h"
#include "rock/burden_file.h"

namespace muckpile {
namespace {

struct DrilledHole {
  HoleFrame frame;
  Vec2 way = Vec2::Zero();                      // sum of the ways to the face [m]
  std::vector<std::pair<Vec3, Vec3>> pieces{};  // each with its nearest place of the face
  std::optional<size_t> in_front{};             // the deck
};

HoleFrame frame_of(const Deck& deck) {
  const Vec3 along = deck.hole_collar - deck.hole_toe;
  const Vec2 lean = along.head<2>() / along.z();
  return {deck.hole, deck.hole_toe.head<2>() - deck.hole_toe.z() * lean, lean, Vec2::UnitX(), {}};
}

// Faces below the floor are no way for the rock.
void add_burden(DrilledHole& hole, const HoleBurden& burden) {
  for (const BurdenPiece& piece : burden.pieces) {
    if (!piece.burden || piece.face.z() < 0.0) continue;
    hole.way += (piece.face - piece.at).head<2>();
    hole.pieces.emplace_back(piece.at, piece.face);
  }
  if (burden.in_front && !hole.in_front) hole.in_front = burden.in_front;
}

// The face along the direction is where the plane through its nearest place, across the way there,
// is met: of a corner hole that is the corner, though no nearest place lies there.
void set_direction(DrilledHole& hole) {
  constexpr double kGrazing = 0.3;  // cosine: a face so far aside is none of this direction
  if (hole.way.norm() > 0.0) hole.frame.direction = hole.way.normalized();
  const Vec2& direction = hole.frame.direction;
  for (const auto& [at, face] : hole.pieces) {
    const Vec2 way = (face - at).head<2>();
    const double along = direction.dot(way);
    if (along <= kGrazing * way.norm()) continue;
    hole.frame.face.emplace_back(face.z(), direction.dot(at.head<2>()) + way.squaredNorm() / along);
  }
  std::ranges::stable_sort(hole.frame.face, {}, [](const Vec2& p) { return p.x(); });
}

// Holes in front of holes; a ring of them, which no plan has, ends at its length.
int row_of(const std::vector<DrilledHole>& holes, const std::vector<size_t>& hole_of_deck,
           size_t hole) {
  int row = 0;
  while (holes[hole].in_front && row < static_cast<int>(holes.size())) {
    const size_t front = hole_of_deck[*holes[hole].in_front];
    if (front == hole) break;  // another deck of its own
    hole = front;
    ++row;
  }
  return row;
}

}  // namespace

std::shared_ptr<const HoleFrames> hole_frames_of(const ResultFolder& folder, HolePlan plan,
                                                 std::string& missing) {
  for (const char* file : {"holes.csv", "burden.csv"}) {
    if (std::filesystem::exists(folder.dump(file))) continue;
    missing = std::string("dump/") + file + " is missing";
    return nullptr;
  }
  const HoleTable table = hole_table_of(folder);
  const BurdenFile burdens = read_burdens(folder.dump("burden.csv"));
  if (burdens.holes.size() != table.decks().size()) {
    missing = "dump/burden.csv has other charges than dump/holes.csv";
    return nullptr;
  }
  std::vector<DrilledHole> holes;
  std::map<std::string, size_t> known;
  std::vector<size_t> hole_of_deck;
  for (size_t k = 0; k < table.decks().size(); ++k) {
    const auto [place, fresh] = known.emplace(table.decks()[k].hole, holes.size());
    if (fresh) holes.push_back({frame_of(table.decks()[k])});
    hole_of_deck.push_back(place->second);
    add_burden(holes[place->second], burdens.holes[k]);
  }
  for (const Deck& deck : table.decks()) {
    const Vec3 along = deck.hole_collar - deck.hole_toe;
    if (along.z() > 0.5 * along.norm()) continue;
    missing = "hole " + deck.hole + " is flatter than 30°";
    return nullptr;
  }
  std::vector<HoleFrame> frames;
  for (size_t h = 0; h < holes.size(); ++h) {
    set_direction(holes[h]);
    if (holes[h].frame.face.empty()) {
      missing = "hole " + holes[h].frame.name + " has no free face beside it above the floor";
      return nullptr;
    }
    holes[h].frame.row = row_of(holes, hole_of_deck, h);
    frames.push_back(holes[h].frame);
  }
  return std::make_shared<const HoleFrames>(std::move(frames), plan);
}

}  // namespace muckpile
