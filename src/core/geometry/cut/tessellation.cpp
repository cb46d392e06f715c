// SPDX-License-Identifier: GPL-2.0-or-later
// Graded centroidal Voronoi blocks: seeds, Lloyd sweeps with mirrored seeds, final cells.
// Scope: deterministic; the sweeps may be shared with other processes.
#include "geometry/cut/tessellation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <utility>

#include "args/input_error.h"
#include "geometry/cut/conformity.h"
#include "geometry/cut/ground.h"
#include "geometry/cut/hole_rings.h"
#include "geometry/cut/joined_parts.h"
#include "geometry/cut/relaxation.h"
#include "geometry/cut/seeding.h"
#include "geometry/holes/hole_surface.h"
#include "geometry/shape/plane_parts.h"

namespace muckpile {
namespace {

template <class... Words>
[[noreturn]] void fail(const Words&... words) {
  std::ostringstream text;
  text << "block tessellation: ";
  (text << ... << words);
  throw InputError(text.str());
}

void check_hole(const TessellationOptions& options, std::size_t h) {
  const Hole& hole = options.holes[h];
  if (!(std::isfinite(hole.radius) && hole.radius > 0.0)) {
    fail("radius of hole ", h + 1, " must be > 0 m, got '", hole.radius, "'");
  }
  if (!(hole_length(hole) > 0.0)) fail("hole ", h + 1, " must have a length > 0 m, got '0'");
  for (const Vec3& end : {hole.toe, hole.collar}) {
    const bool in_box =
        (end.array() >= options.lo.array()).all() && (end.array() <= options.hi.array()).all();
    if (!in_box) {
      fail("the axis of hole ", h + 1, " must lie in the box, got an end at '", end.x(), ' ',
           end.y(), ' ', end.z(), "'");
    }
    if (options.region.inside && !options.region.inside(end)) {
      fail("the axis of hole ", h + 1, " must lie in the rock, got an end at '", end.x(), ' ',
           end.y(), ' ', end.z(), "'");
    }
  }
  const double size = options.size.at(hole.radius);
  if (!options.rings && size > 2.0 * hole.radius) {
    fail("with joint sets, blocks at the wall of hole ", h + 1,
         " must be <= its crushed-zone diameter ", 2.0 * hole.radius, " m, got '", size,
         "'; take a block_min below that (inputs: -var block_min), a wider charge or 'cut "
         "voronoi', whose blocks may be three times as wide");
  }
}

void check(const TessellationOptions& options) {
  const Vec3 edge = options.hi - options.lo;
  if (!(edge.allFinite() && edge.minCoeff() > 0.0)) {
    fail("the box edges must be > 0 m, got '", edge.x(), ' ', edge.y(), ' ', edge.z(), "'");
  }
  if (options.sweeps < 0) fail("sweeps must be >= 0, got '", options.sweeps, "'");
  if (static_cast<bool>(options.region.inside) !=
      static_cast<bool>(options.region.surface_points)) {
    fail("a region needs both inside and surface_points");
  }
  for (const CutPlane& plane : options.planes) {
    if (!(plane.normal.allFinite() && plane.normal.norm() > 0.0 && plane.point.allFinite()))
      fail("a plane of the cut needs a point and a normal");
  }
  for (std::size_t h = 0; h < options.holes.size(); ++h) check_hole(options, h);
}

/// Those of the rings too.
double seeds_expected(const TessellationOptions& options, double give_up) {
  const HoleRings rings(options);
  return static_cast<double>(rings.seeds().size()) +
         integrate_density(options, Ground(options, rings), give_up);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void add_face_statistics(const TessellationOptions& options, const std::vector<Block>& blocks,
                         TessellationStatistics& statistics) {
  statistics.hole_volume.assign(options.holes.size(), 0.0);
  statistics.hole_area.assign(options.holes.size(), 0.0);
  statistics.smallest_face_area_ratio = std::numeric_limits<double>::infinity();
  for (const Block& block : blocks) {
    const double block_area = std::pow(block.mass.volume, 2.0 / 3.0);
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      statistics.smallest_face_area_ratio =
          std::min(statistics.smallest_face_area_ratio, face.area / block_area);
      if (!is_hole_face(block.neighbour[f])) continue;
      const auto h = static_cast<std::size_t>(hole_of_face(block.neighbour[f]));
      statistics.hole_area[h] += face.area;
      statistics.hole_volume[h] += enclosed_by_face(options.holes[h], face);
    }
  }
}

void add_volume_statistics(const TessellationOptions& options, const std::vector<Block>& blocks,
                           TessellationStatistics& statistics) {
  std::vector<double> ratios;
  ratios.reserve(blocks.size());
  for (const Block& block : blocks) {
    statistics.block_volume += block.mass.volume;
    ratios.push_back(std::cbrt(block.mass.volume) / block.target_size);
  }
  statistics.box_volume = (options.hi - options.lo).prod();
  statistics.void_volume = statistics.box_volume - statistics.block_volume;
  statistics.median_size_ratio = median(std::move(ratios));
}

void add_blocks(const Relaxation& relaxation, Tessellation& result) {
  if (relaxation.seeds() == 0) return;
  std::vector<Block> blocks = relaxation.make_blocks();
  result.statistics.faces_collapsed += collapse_one_sided_faces(blocks);
  std::vector<double>& volumes = result.statistics.cylinder_volume;
  volumes.resize(relaxation.cylinder_volumes().size(), 0.0);
  for (std::size_t h = 0; h < volumes.size(); ++h) volumes[h] += relaxation.cylinder_volumes()[h];
  const int first = static_cast<int>(result.blocks.size());
  for (Block& block : blocks) {
    for (int& other : block.neighbour) other += other >= 0 ? first : 0;
    result.blocks.push_back(std::move(block));
  }
}

Relaxation relaxed_whole(const TessellationOptions& options) {
  Relaxation relaxation(options);
  if (relaxation.seeds() == 0) return relaxation;
  for (int k = 0; k < options.sweeps; ++k) relaxation.sweep();
  return relaxation;
}

/// The parts of the rock between the planes, each relaxed for itself.
class RelaxedParts {
 public:
  explicit RelaxedParts(const TessellationOptions& options) : rock_(parts_of(options)) {
    const std::vector<RockPart>& parts = rock_.parts;
    const Ground ground = voronoi_ground(options);
    const std::vector<SeedPair> pairs = pairs_across(options, parts);
    const HoleRings rings(options);
    for (const RockPart& part : parts) alone_.push_back(options_of(options, part));
    for (std::size_t p = 0; p < parts.size(); ++p)
      relaxations_.emplace_back(alone_[p], parts[p].seeds, parts[p].bounds,
                                rings_in(rings, parts[p]));
    for (int k = 0; k < options.sweeps; ++k) {
      for (Relaxation& relaxation : relaxations_) relaxation.sweep();
      for (const SeedPair& pair : pairs) {
        make_symmetric(ground, options.planes[pair.plane], parts[pair.part],
                       relaxations_[pair.part].seed(pair.seed), parts[pair.other_part],
                       relaxations_[pair.other_part].seed(pair.other_seed));
      }
    }
    for (Relaxation& relaxation : relaxations_) relaxation.drop_slivers_of_rings();
  }
  [[nodiscard]] const std::vector<Relaxation>& all() const { return relaxations_; }
  [[nodiscard]] const RockParts& rock() const { return rock_; }

 private:
  RockParts rock_;
  std::vector<TessellationOptions> alone_;
  std::vector<Relaxation> relaxations_;
};

void cut_whole(const TessellationOptions& options, Tessellation& result) {
  add_blocks(relaxed_whole(options), result);
}

void cut_parts(const TessellationOptions& options, Tessellation& result) {
  const RelaxedParts parts(options);
  result.statistics.merged_parts = parts.rock().merged;
  result.statistics.lost_parts = parts.rock().lost;
  result.statistics.lost_volume = parts.rock().lost_volume;
  for (const Relaxation& relaxation : parts.all()) add_blocks(relaxation, result);
  join_in_planes(options.planes, result.blocks);
  open_planes_to_voids(options, result.blocks);
}

}  // namespace

double checked_block_count(const TessellationOptions& options) {
  check(options);
  const double allowed = static_cast<double>(options.max_blocks);
  const double count = seeds_expected(options, allowed);
  if (count > allowed) {
    fail("more than ", options.max_blocks,
         " blocks are expected, which is the limit; enlarge the blocks, shrink the rock or raise "
         "the limit");
  }
  if (!(count >= 1.0)) fail("the rock holds less than one block (expected ", count, ")");
  return count;
}

void add_statistics(const TessellationOptions& options, Tessellation& result) {
  add_volume_statistics(options, result.blocks, result.statistics);
  add_face_statistics(options, result.blocks, result.statistics);
}

double expected_block_count(const TessellationOptions& options, double give_up) {
  check(options);
  return seeds_expected(options, give_up);
}

void share_sweeps(const TessellationOptions& options) {
  (void)checked_block_count(options);
  if (options.planes.empty())
    (void)relaxed_whole(options);
  else
    (void)RelaxedParts(options);
}

Tessellation tessellate(const TessellationOptions& options) {
  Tessellation result;
  result.statistics.expected_blocks = checked_block_count(options);
  (options.planes.empty() ? cut_whole : cut_parts)(options, result);
  if (result.blocks.empty()) fail("no seed fell into the rock");
  add_statistics(options, result);
  return result;
}

}  // namespace muckpile
