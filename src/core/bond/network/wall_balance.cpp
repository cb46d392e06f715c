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

WallBalance::WallBalance(const FacetTables& tables, std::span<const BoundaryFace> faces,
                         std::size_t blocks) {
  std::map<std::pair<int, int>, Vec3> of;  // by block and hole
  std::map<int, double> surface;           // of blocks that have a wall [m2]
  for (const BoundaryFace& face : faces) {
    if (face.hole < 0) continue;
    of.try_emplace({face.block, face.hole}, Vec3::Zero()).first->second += face.area * face.normal;
    surface.try_emplace(face.block, 0.0);
  }
  const auto add = [&surface](int block, double area) {
    const auto found = surface.find(block);
    if (found != surface.end()) found->second += area;
    return found != surface.end();
  };
  for (std::size_t f = 0; f < tables.size(); ++f) {
    const bool at_i = add(tables.i_of(f), tables.area(f)),
               at_j = add(tables.j_of(f), tables.area(f));
    if (at_i || at_j) beside_.push_back(static_cast<std::uint32_t>(f));
  }
  for (const BoundaryFace& face : faces) add(face.block, face.area);
  if (empty()) return;
  walls_.resize(faces.size());
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const BoundaryFace& face = faces[k];
    if (face.hole < 0) continue;
    const Vec3& wall = of.at({face.block, face.hole});
    walls_[k] = {wall, kRounding * surface.at(face.block) * wall.norm()};
  }
  backs_.assign(blocks, Vec3::Zero());
}

void WallBalance::share_load(const FacetTables& tables, const FacetHistory& history,
                             std::span<BoundaryFace> faces) {
  for (const std::uint32_t f : beside_) {
    const auto [i, j] = tables.blocks_of(f);
    backs_[i].setZero();
    backs_[j].setZero();
  }
  for (const BoundaryFace& face : faces) backs_[static_cast<std::size_t>(face.block)].setZero();
  for (const BoundaryFace& face : faces)
    backs_[static_cast<std::size_t>(face.block)] += face.area * face.normal;
  for (const std::uint32_t f : beside_) {
    // Gas in a joint is followed and presses by itself: there the load is not reduced.
    const bool followed = history.traces(f).gas;
    if (history.state(f) == FacetState::retired && !followed) continue;
    const double share = followed ? 1.0 : history.contacts().fade(f);
    const Vec3 part = share * tables.area(f) * tables.normal(f);
    const auto [i, j] = tables.blocks_of(f);
    backs_[i] += part;
    backs_[j] -= part;
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    BoundaryFace& face = faces[k];
    if (face.hole < 0) continue;
    const Vec3& wall = walls_[k].sum;
    const double lost = backs_[static_cast<std::size_t>(face.block)].dot(wall);
    face.load_share =
        lost <= walls_[k].rounding ? 1.0 : std::max(0.0, 1.0 - lost / wall.squaredNorm());
  }
}

double WallBalance::bytes() const {
  return static_cast<double>(beside_.capacity() * sizeof(beside_[0]) +
                             walls_.capacity() * sizeof(Wall) + backs_.capacity() * sizeof(Vec3));
}

}  // namespace muckpile
