// SPDX-License-Identifier: GPL-2.0-or-later
// Size-weighted Lloyd sweeps over seeds that are mirrored at holes and region, and their cells.
// Scope: see the header.
#include "geometry/cut/relaxation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/cut/cell_cutter.h"
#include "geometry/cut/seeding.h"
#include "geometry/cut/void_walls.h"
#include "geometry/holes/hole_surface.h"

namespace muckpile {
namespace {

constexpr double kFirstReach =
    1.8;  // [block sizes] most neighbours of a relaxed cell are within it

/// Whether a hole lies behind one of the planes as a whole.
bool is_beyond(const std::vector<CutPlane>& bounds, const Hole& hole) {
  return std::any_of(bounds.begin(), bounds.end(), [&](const CutPlane& bound) {
    const auto height = [&](const Vec3& p) { return bound.normal.dot(p - bound.point); };
    return std::min(height(hole.toe), height(hole.collar)) > hole.radius;
  });
}

/// Whether all of a hole lies before all planes, and farther than so from them [m].
bool is_within(const std::vector<CutPlane>& bounds, const Hole& hole, double farther) {
  return std::all_of(bounds.begin(), bounds.end(), [&](const CutPlane& bound) {
    const auto height = [&](const Vec3& p) { return bound.normal.dot(p - bound.point); };
    return std::max(height(hole.toe), height(hole.collar)) < -(hole.radius + farther);
  });
}

[[noreturn]] void fail_without_cell(std::size_t seed) {
  throw std::runtime_error("Voronoi cell of seed " + std::to_string(seed) +
                           " vanished: it lies outside its part of the rock, or in another seed");
}

/// Takes away blocks without faces, which no block has for a neighbour.
void drop_empty(std::vector<Block>& blocks) {
  std::vector<int> number(blocks.size());
  int count = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    number[i] = blocks[i].shape.faces.empty() ? kFreeFace : count++;
  if (static_cast<std::size_t>(count) == blocks.size()) return;
  std::erase_if(blocks, [](const Block& block) { return block.shape.faces.empty(); });
  for (Block& block : blocks)
    for (int& other : block.neighbour)
      if (other >= 0) other = number[static_cast<std::size_t>(other)];
}

}  // namespace

Relaxation::Relaxation(const TessellationOptions& options)
    : Relaxation(options, scatter_seeds(options, voronoi_ground(options)), {}, HoleRings(options)) {
}

Relaxation::Relaxation(const TessellationOptions& options, std::vector<Vec3> seeds,
                       std::vector<CutPlane> bounds, HoleRings rings)
    : options_(options),
      rings_(std::move(rings)),
      ground_(options, rings_),
      seeds_(std::move(seeds)),
      first_ring_(seeds_.size()),
      bounds_(std::move(bounds)),
      mirrored_holes_(options.holes) {
  for (const RingSeed& ring : rings_.seeds()) seeds_.push_back(ring.at);
  for (std::size_t h = 0; h < mirrored_holes_.size(); ++h)
    if (rings_.around(h)) mirrored_holes_[h].radius = 0.0;
  for (const Hole& hole : options.holes) {
    const auto in_part = [&](const Vec3& p) { return ground_.in_region(p); };
    cylinder_volumes_.push_back(is_beyond(bounds_, hole) ? 0.0
                                                         : cylinder_volume_where(hole, in_part));
  }
}

std::vector<Vec3> Relaxation::points_with(const Images& images) const {
  std::vector<Vec3> points = seeds_;
  points.insert(points.end(), images.points.begin(), images.points.end());
  return points;
}

std::vector<int> Relaxation::face_codes(const std::vector<int>& points,
                                        const Images& images) const {
  const int seeds = static_cast<int>(seeds_.size());
  std::vector<int> codes;
  codes.reserve(points.size());
  for (const int p : points) {
    codes.push_back(p < 0       ? kFreeFace  // also a wall of its own: make_blocks()
                    : p < seeds ? p
                                : images.face_codes[static_cast<std::size_t>(p - seeds)]);
  }
  return codes;
}

// Centroid for the density size^-5, for which a centroidal diagram in three dimensions has cells
// of that size (Du, Wang 2005). First order: shift by (second moment / volume) * grad ln density,
// with the second moment of a ball, (3/4pi)^(2/3)/5 = 0.077 V^(2/3) per axis.
Vec3 Relaxation::relaxed(const Vec3& seed, const Vec3& centroid, double volume) const {
  constexpr double kMoment = 0.077, kLongestShift = 0.3;  // [-], [block sizes]
  const double size = std::cbrt(volume);
  Vec3 shift = -5.0 * kMoment * size * size * ground_.log_size_gradient(centroid);
  shift *= std::min(1.0, kLongestShift * size / std::max(shift.norm(), 1e-300));
  const Vec3 target = centroid + shift;
  return ground_.is_rock(target) ? target : seed;
}

void Relaxation::add_hole_volumes(const Polyhedron& shape, const std::vector<int>& codes,
                                  std::vector<double>& carved) const {
  for (std::size_t f = 0; f < codes.size(); ++f) {
    if (!is_hole_face(codes[f])) continue;
    const int h = hole_of_face(codes[f]);
    const FaceGeometry face = face_geometry(shape, static_cast<int>(f));
    carved.push_back(h);
    carved.push_back(enclosed_by_face(options_.holes[static_cast<std::size_t>(h)], face));
  }
}

// Tangent planes enclose more than the cylinder (by 3 % with ten blocks around); mirroring at a
// slightly smaller cylinder gives the crushed zone its volume. Where blocks are as wide as the
// zone, the least radius stops that: few planes enclose half as much again, or more.
void Relaxation::adjust_radii(const std::vector<double>& hole_volumes) {
  for (std::size_t h = 0; h < mirrored_holes_.size(); ++h) {
    if (!(hole_volumes[h] > 0.0) || rings_.around(h)) continue;
    const double radius = options_.holes[h].radius;
    const double scale = std::sqrt(cylinder_volumes_[h] / hole_volumes[h]);
    mirrored_holes_[h].radius = std::clamp(mirrored_holes_[h].radius * scale, 0.6 * radius, radius);
  }
}

double Relaxation::first_reach(std::size_t seed) const {
  return kFirstReach * ground_.size(seeds_[seed]);
}

bool Relaxation::cut(CellCutter& cutter, std::size_t seed, const VoidWall& wall) const {
  const bool left =
      cutter.cut(static_cast<int>(seed), first_reach(seed), wall.hole >= 0 ? &wall.plane : nullptr);
  if (!left && !ring_seed(seed) && wall.hole < 0) fail_without_cell(seed);
  return left;
}

Relaxation::Swept Relaxation::sweep_part(std::size_t first, std::size_t last) const {
  const Images images = mirror_seeds(seeds_, mirrored_holes_, options_.region, ground_);
  const std::vector<Vec3> points = points_with(images);
  CellCutter cutter(points, options_.lo, options_.hi, bounds_);
  const auto is_hole_image = [&, number = static_cast<int>(seeds())](int p) {
    return p >= number && is_hole_face(images.face_codes[static_cast<std::size_t>(p - number)]);
  };
  Swept swept;
  Polyhedron shape;
  std::vector<int> behind;
  for (std::size_t i = first; i < last; ++i) {
    if (ring_seed(i)) {
      swept.seeds.insert(swept.seeds.end(), seeds_[i].begin(), seeds_[i].end());
      continue;
    }
    if (!cutter.cut_fast(static_cast<int>(i), first_reach(i))) fail_without_cell(i);
    const auto [volume, centroid] = cutter.measure();
    const Vec3 next = relaxed(seeds_[i], centroid, volume);
    swept.seeds.insert(swept.seeds.end(), next.begin(), next.end());
    if (!cutter.any_face(is_hole_image)) continue;
    cutter.extract(shape, behind);
    add_hole_volumes(shape, face_codes(behind, images), swept.carved);
  }
  return swept;
}

// Each takes seeds that follow one another. If one fails, all do the whole sweep, to fail alike.
Relaxation::Swept Relaxation::shared_sweep() const {
  const SweepTeam& team = options_.team;
  const auto rank = static_cast<std::size_t>(team.rank),
             ranks = static_cast<std::size_t>(team.ranks);
  Swept mine;
  double failed = 0.0;
  try {
    mine = sweep_part(rank * seeds() / ranks, (rank + 1) * seeds() / ranks);
  } catch (const std::exception&) {
    failed = 1.0;
  }
  const std::vector<double> faults = team.gather({failed});
  if (std::find(faults.begin(), faults.end(), 1.0) == faults.end())
    return {team.gather(mine.seeds), team.gather(mine.carved)};
  (void)sweep_part(0, seeds());
  throw std::runtime_error("a process failed at its share of the Voronoi cells");
}

void Relaxation::sweep() {
  const Swept swept = options_.team.ranks > 1 ? shared_sweep() : sweep_part(0, seeds());
  for (std::size_t i = 0; i < seeds(); ++i) seeds_[i] = Vec3::Map(swept.seeds.data() + 3 * i);
  std::vector<double> hole_volumes(options_.holes.size(), 0.0);
  for (std::size_t k = 0; k < swept.carved.size(); k += 2)
    hole_volumes[static_cast<std::size_t>(swept.carved[k])] += swept.carved[k + 1];
  adjust_radii(hole_volumes);
}

std::vector<std::size_t> Relaxation::slivers_of_rings() const {
  constexpr double kApart = 4.0;  // [block sizes]
  const Images images = mirror_seeds(seeds_, mirrored_holes_, options_.region, ground_);
  const std::vector<Vec3> points = points_with(images);
  CellCutter cutter(points, options_.lo, options_.hi, bounds_);
  const std::vector<VoidWall> walls = own_walls();
  Polyhedron shape;
  std::vector<int> behind;
  std::vector<std::pair<double, std::size_t>> small;  // worth, seed
  for (std::size_t i = first_ring_; i < seeds_.size(); ++i) {
    double worth = 0.0;
    if (cut(cutter, i, walls[i])) {
      cutter.extract(shape, behind);
      worth = worth_as_block(*ring_seed(i), shape);
    }
    if (worth < 1.0) small.emplace_back(worth, i);
  }
  std::sort(small.begin(), small.end());
  std::vector<std::size_t> chosen;
  for (const auto& [worth, i] : small) {
    const bool alone = std::none_of(chosen.begin(), chosen.end(), [&](std::size_t other) {
      return (seeds_[other] - seeds_[i]).norm() < kApart * ring_seed(i)->size;
    });
    if (alone) chosen.push_back(i);
  }
  std::sort(chosen.rbegin(), chosen.rend());
  return chosen;
}

void Relaxation::drop_slivers_of_rings() {
  while (!bounds_.empty() && first_ring_ < seeds_.size()) {
    const std::vector<std::size_t> slivers = slivers_of_rings();
    if (slivers.empty() || slivers.size() == seeds_.size()) return;
    for (const std::size_t i : slivers) {
      seeds_.erase(seeds_.begin() + static_cast<std::ptrdiff_t>(i));
      rings_.drop(i - first_ring_);
    }
  }
}

std::vector<VoidWall> Relaxation::own_walls() const {
  std::vector<VoidWall> walls(seeds_.size());
  for (std::size_t k = 0; k < rings_.seeds().size(); ++k)
    walls[first_ring_ + k] = {rings_.seeds()[k].hole, rings_.seeds()[k].wall};
  return walls;
}

std::vector<std::vector<CutPlane>> Relaxation::prisms_between_planes() const {
  std::vector<std::vector<CutPlane>> prisms(options_.holes.size());
  if (bounds_.empty()) return prisms;
  for (std::size_t h = 0; h < prisms.size(); ++h) {
    const Hole& hole = options_.holes[h];
    if (rings_.around(h))
      prisms[h] = rings_.prism(h);
    else if (!is_beyond(bounds_, hole) && !is_within(bounds_, hole, options_.size.at(hole.radius)))
      prisms[h] = round_prism(hole);
  }
  return prisms;
}

std::vector<VoidWall> Relaxation::fitted_walls(
    CellCutter& cutter, const std::vector<std::vector<CutPlane>>& prisms) const {
  constexpr double kReach = 2.0;  // [block sizes] from a seed to the wall of a hole in its cell
  std::vector<VoidWall> walls = own_walls();
  const auto has_none = [&](int h) { return prisms[static_cast<std::size_t>(h)].empty(); };
  if (std::ranges::all_of(prisms, [](const auto& prism) { return prism.empty(); })) return walls;
  VoidWalls fitted(prisms);
  Polyhedron shape;
  std::vector<int> behind, holes;
  for (std::size_t i = 0; i < seeds_.size(); ++i) {
    const double size = ground_.size(seeds_[i]);
    ground_.holes_near(seeds_[i], kReach * size, holes);
    std::erase_if(holes, has_none);
    if (holes.empty() || !cut(cutter, i, {})) continue;
    cutter.extract(shape, behind);
    fitted.offer(i, shape, size, holes, ring_seed(i));
  }
  fitted.fit(walls);
  return walls;
}

std::vector<Block> Relaxation::make_blocks() const {
  const std::vector<std::vector<CutPlane>> prisms = prisms_between_planes();
  std::vector<Hole> mirrored = mirrored_holes_;
  for (std::size_t h = 0; h < mirrored.size(); ++h)
    if (!prisms[h].empty()) mirrored[h].radius = 0.0;
  Images images = mirror_seeds(seeds_, mirrored, options_.region, ground_);
  bound_by_fitted(images);
  const std::vector<Vec3> points = points_with(images);
  CellCutter cutter(points, options_.lo, options_.hi, bounds_);
  std::vector<Block> blocks(seeds_.size());
  const std::vector<VoidWall> walls = fitted_walls(cutter, prisms);
  std::vector<int> behind;
  for (std::size_t i = 0; i < seeds_.size(); ++i) {
    Block& block = blocks[i];
    if (!cut(cutter, i, walls[i])) continue;
    cutter.extract(block.shape, behind);
    block.neighbour = face_codes(behind, images);
    for (std::size_t f = 0; f < behind.size(); ++f)
      if (behind[f] == kOwnWall) block.neighbour[f] = hole_face(walls[i].hole);
    block.mass = mass_properties(block.shape);
    block.target_size = ground_.size(block.mass.centroid);
    open_to_voids(walls, static_cast<int>(i), block);
  }
  drop_empty(blocks);
  return blocks;
}

}  // namespace muckpile
