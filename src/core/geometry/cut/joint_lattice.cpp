// SPDX-License-Identifier: GPL-2.0-or-later
// The planes of joint sets.
// Scope: see the header.
#include "geometry/cut/joint_lattice.h"

#include <algorithm>
#include <cmath>

#include "geometry/size/size_factor.h"

namespace muckpile {
namespace {

std::array<JointSet, 3> three_sets(const JointSetCut& how) {
  constexpr double kFlattest = 0.1;  // volume of the parallelepiped of the three unit normals
  if (how.sets.size() != 2 && how.sets.size() != 3)
    refuse_joint_sets("needs two or three sets, got '", how.sets.size(), "'");
  std::array<JointSet, 3> sets;
  std::copy(how.sets.begin(), how.sets.end(), sets.begin());
  for (std::size_t k = 0; k < how.sets.size(); ++k) {
    sets[k].normal.normalize();
    if (!sets[k].normal.allFinite() || !(sets[k].spacing > 0.0))
      refuse_joint_sets("set ", k + 1, " needs a direction and a spacing > 0");
  }
  if (how.sets.size() == 2) sets[2].normal = sets[0].normal.cross(sets[1].normal).normalized();
  const double solid = std::abs(sets[0].normal.dot(sets[1].normal.cross(sets[2].normal)));
  if (!(solid >= kFlattest)) {
    refuse_joint_sets(
        "the sets are nearly parallel to each other or to one line: their normals span '", solid,
        "', which must be >= ", kFlattest);
  }
  return sets;
}

}  // namespace

Lattice lattice_in(const TessellationOptions& rock, const JointSetCut& how) {
  const std::array<JointSet, 3> sets = three_sets(how);
  const ConvexCell box = box_cell(rock.lo, rock.hi);
  const double solid = std::abs(sets[0].normal.dot(sets[1].normal.cross(sets[2].normal)));
  const double product = sets[0].spacing * sets[1].spacing * sets[2].spacing;
  Lattice lattice;
  for (std::size_t k = 0; k < 3; ++k) {
    const double relative = sets[k].spacing * std::cbrt(solid / product);
    const auto [from, to] = extent(box.shape, sets[k].normal);
    const double wanted = relative * largest_block(rock);
    lattice[k] = {sets[k].normal, (to - from) / std::max(1.0, std::round((to - from) / wanted)),
                  from, relative};
  }
  return lattice;
}

LatticeCell in_lattice(const Lattice& lattice, ConvexCell cell) {
  constexpr double kRounding = 1e-9;
  LatticeCell placed{std::move(cell), {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [from, to] = extent(placed.cell.shape, lattice[k].normal);
    const LatticeSet& set = lattice[k];
    placed.between[k] = {std::floor((from - set.start) / set.spacing + kRounding),
                         std::ceil((to - set.start) / set.spacing - kRounding)};
  }
  return placed;
}

std::optional<std::size_t> widest_set(const Lattice& lattice, const LatticeCell& cell,
                                      double size) {
  constexpr double kFinest = 0.25;  // of the size; no plane nearer than that to another can help
  constexpr double kTie = 1.01;     // equal cells must not differ by rounding
  std::optional<std::size_t> best;
  double most = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const LatticeSet& set = lattice[k];
    const auto [a, b] = cell.between[k];
    if ((b - a) * set.spacing < kFinest * set.relative * size) continue;
    const auto [from, to] = extent(cell.cell.shape, set.normal);
    const double width = (to - from) / set.relative;
    if (width <= kTie * most) continue;
    most = width;
    best = k;
  }
  return best;
}

double plane_between(const std::pair<double, double>& planes) {
  const auto [a, b] = planes;
  return b - a > 1.5 ? a + std::floor(0.5 * (b - a)) : 0.5 * (a + b);
}

}  // namespace muckpile
