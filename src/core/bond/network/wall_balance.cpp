// SPDX-License-Identifier: GPL-2.0-or-later
// Gas that flows round a block on a crushed zone.
// Scope: see the header.
#include "bond/network/wall_balance.h"

#include <algorithm>
#include <map>
#include <utility>

namespace muckpile {
namespace {

// Normals of facets are kept in single precision: of a block's surface, what their sum is off at
// most.
constexpr double kRounding = 1e-6;

}  // namespace

/// A block without a wall that shares a facet with one has a place of its own at the end, where
/// nothing is looked up.
WallBalance::WallBalance(const FacetTables& tables, std::span<const BoundaryFace> faces) {
  std::map<std::pair<int, int>, Vec3> of;  // by block and hole
  std::map<int, std::uint32_t> places;     // of blocks that have a wall
  for (const BoundaryFace& face : faces) {
    if (face.hole < 0) continue;
    of.try_emplace({face.block, face.hole}, Vec3::Zero()).first->second += face.area * face.normal;
    places.try_emplace(face.block, static_cast<std::uint32_t>(places.size()));
  }
  const auto nowhere = static_cast<std::uint32_t>(places.size());
  const auto place_of = [&](int block) {
    const auto found = places.find(block);
    return found != places.end() ? found->second : nowhere;
  };
  std::vector<double> surface(places.size() + 1, 0.0);  // [m2]
  for (std::size_t f = 0; f < tables.size(); ++f) {
    const std::uint32_t i = place_of(tables.i_of(f)), j = place_of(tables.j_of(f));
    surface[i] += tables.area(f);
    surface[j] += tables.area(f);
    if (i == nowhere && j == nowhere) continue;
    beside_.push_back({static_cast<std::uint32_t>(f), i, j, tables.area(f), tables.normal(f)});
  }
  if (empty()) return;
  faces_.assign(places.size() + 1, Vec3::Zero());
  for (const BoundaryFace& face : faces) {
    const std::uint32_t place = place_of(face.block);
    surface[place] += face.area;
    faces_[place] += face.area * face.normal;
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k].hole < 0) continue;
    const Vec3& wall = of.at({faces[k].block, faces[k].hole});
    const std::uint32_t place = place_of(faces[k].block);
    walls_.push_back(
        {static_cast<std::uint32_t>(k), place, wall, kRounding * surface[place] * wall.norm()});
  }
}

void WallBalance::share_load(const FacetHistory& history, std::span<BoundaryFace> faces) {
  backs_ = faces_;
  for (const Beside& beside : beside_) {
    // Gas in a joint is followed and presses by itself: there the load is not reduced.
    const bool followed = history.traces(beside.facet).gas;
    if (history.state(beside.facet) == FacetState::retired && !followed) continue;
    const double share = followed ? 1.0 : history.contacts().fade(beside.facet);
    const Vec3 part = share * beside.area * beside.normal;
    backs_[beside.i] += part;
    backs_[beside.j] -= part;
  }
  for (const Wall& wall : walls_) {
    const double lost = backs_[wall.block].dot(wall.sum);
    faces[wall.face].load_share =
        lost <= wall.rounding ? 1.0 : std::max(0.0, 1.0 - lost / wall.sum.squaredNorm());
  }
}

double WallBalance::bytes() const {
  return static_cast<double>(beside_.capacity() * sizeof(Beside) +
                             walls_.capacity() * sizeof(Wall) +
                             (faces_.capacity() + backs_.capacity()) * sizeof(Vec3));
}

}  // namespace muckpile
