// SPDX-License-Identifier: GPL-2.0-or-later
// Size-weighted Lloyd sweeps over seeds that are mirrored at holes and region, and their cells.
// Scope: deterministic; a team of processes may share the sweeps. Valid options only, as
// tessellate() checks them.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/cut/cell_cutter.h"
#include "geometry/cut/ground.h"
#include "geometry/cut/hole_rings.h"
#include "geometry/cut/tessellation.h"
#include "geometry/shape/mirror.h"

namespace muckpile {

class Relaxation {
 public:
  // Scatters the seeds. The options must be valid and outlive this object.
  explicit Relaxation(const TessellationOptions& options);
  // With these seeds, and cells that end at these planes, whose unit normals look out. The seeds of
  // rings around holes come behind them.
  Relaxation(const TessellationOptions& options, std::vector<Vec3> seeds,
             std::vector<CutPlane> bounds, HoleRings rings);

  void sweep();  // moves each seed to its cell's centroid
  // Once all seeds stand: takes away the seeds of rings that have no block of their own beside the
  // others, the least first. The cells beside them grow.
  void drop_slivers_of_rings();
  [[nodiscard]] std::vector<Block> make_blocks() const;  // the cells of the present seeds
  [[nodiscard]] std::size_t seeds() const { return seeds_.size(); }
  [[nodiscard]] Vec3& seed(std::size_t k) { return seeds_[k]; }
  // Per hole: volume of the cylinder within the region [m3].
  [[nodiscard]] const std::vector<double>& cylinder_volumes() const { return cylinder_volumes_; }

 private:
  struct Swept {
    std::vector<double> seeds;   // where they go, three numbers each [m]
    std::vector<double> carved;  // pairs: hole, volume between its axis and one cell's face [m3]
  };
  [[nodiscard]] Swept sweep_part(std::size_t first, std::size_t last) const;
  [[nodiscard]] Swept shared_sweep() const;
  [[nodiscard]] std::vector<Vec3> points_with(const Images& images) const;
  // Of a ring; none of another seed.
  [[nodiscard]] const RingSeed* ring_seed(std::size_t seed) const {
    return seed < first_ring_ ? nullptr : &rings_.seeds()[seed - first_ring_];
  }
  // Guess of how far the neighbours of a seed are [m].
  [[nodiscard]] double first_reach(std::size_t seed) const;
  // False if nothing is left of the cell, which may be so of a seed of a ring, and at a void.
  [[nodiscard]] bool cut(CellCutter& cutter, std::size_t seed, const VoidWall& wall) const;
  // Those of the rings themselves; per seed.
  [[nodiscard]] std::vector<VoidWall> own_walls() const;
  // Where all cells end at voids: between planes they reach over several sides of one.
  [[nodiscard]] std::vector<VoidWall> fitted_walls(
      CellCutter& cutter, const std::vector<std::vector<CutPlane>>& prisms) const;
  // Of the holes that have rings, and of those that planes cross; none for others.
  [[nodiscard]] std::vector<std::vector<CutPlane>> prisms_between_planes() const;
  [[nodiscard]] Vec3 relaxed(const Vec3& seed, const Vec3& centroid, double volume) const;
  void add_hole_volumes(const Polyhedron& shape, const std::vector<int>& codes,
                        std::vector<double>& carved) const;
  [[nodiscard]] std::vector<int> face_codes(const std::vector<int>& points,
                                            const Images& images) const;
  // Seeds of rings whose blocks are too small, in falling order of number: of such near each other
  // the one with the least block.
  [[nodiscard]] std::vector<std::size_t> slivers_of_rings() const;
  void adjust_radii(const std::vector<double>& hole_volumes);
  // Of relaxation_fitted.cpp: what fitted surfaces ask of the last cells.
  void bound_by_fitted(Images& images) const;
  void stop_leaks(Images& images) const;
  void fit_images(Images& images) const;

  const TessellationOptions& options_;
  HoleRings rings_;
  Ground ground_;
  std::vector<Vec3> seeds_;  // [m]
  std::size_t first_ring_;   // number of the first seed of a ring, up to the last of all
  std::vector<CutPlane> bounds_;
  // Radii shrunk so that the carved volume is the cylinder's; 0 where rings make the void.
  std::vector<Hole> mirrored_holes_;
  std::vector<double> cylinder_volumes_;  // [m3]
};

}  // namespace muckpile
