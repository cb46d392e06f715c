// SPDX-License-Identifier: GPL-2.0-or-later
// The rock as the engine takes it; see the header.
#include "rock/rock_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "args/input_error.h"
#include "bond/build/wall_facets.h"
#include "geometry/files/block_import.h"
#include "rock/burden_faces.h"
#include "rock/faults.h"
#include "rock/mirrored_holes.h"
#include "rock/zone_model.h"

namespace muckpile {
namespace {

void cut_blocks(RockModel& model, const CutOptions& options) {
  if (options.import_file) {
    model.rock = import_blocks(*options.import_file, options.rock);
  } else if (options.joint_sets) {
    model.rock = cut_by_joint_sets(options.rock, *options.joint_sets);
  } else if (options.target) {
    FittedCut fitted = tessellate_to_target(options.rock, *options.target, options.limits);
    model.rock = std::move(fitted.cut);
    model.sizes = std::move(fitted.comparison);
    model.why_missed = std::move(fitted.why_missed);
  } else {
    model.rock = tessellate(options.rock);
  }
}

void choose_zones(RockModel& model, const CutOptions& options) {
  for (const RockZone& zone : options.zones) model.zones.push_back(zone.name);
  if (model.zones.empty()) return;
  for (const Block& block : model.rock.blocks)
    model.zone_of.push_back(zone_at(options.zones, block.mass.centroid));
  require_cells(options, model);
}

/// With the radii of cylinders as wide as the voids that the cut left.
std::vector<Hole> holes_as_cut(const CutOptions& options, const Tessellation& rock) {
  std::vector<Hole> holes = options.rock.holes;
  const TessellationStatistics& cut = rock.statistics;
  for (std::size_t h = 0; h < std::min(holes.size(), cut.hole_volume.size()); ++h) {
    if (cut.hole_volume[h] > 0.0 && cut.cylinder_volume[h] > 0.0)
      holes[h].radius *= std::sqrt(cut.hole_volume[h] / cut.cylinder_volume[h]);
  }
  return holes;
}

}  // namespace

RockModel cut_rock(const CutOptions& options, int first_tag, const SupportRule& support) {
  RockModel model;
  cut_blocks(model, options);
  const std::vector<Block>& blocks = model.rock.blocks;
  if (blocks.empty())
    throw InputError("the region holds no block; block sizes are too large for it");
  choose_zones(model, options);
  const std::vector<double> densities = options.densities();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double density = model.zones.empty() ? options.density : densities[model.zone_of[b]];
    model.bodies.push_back(rigid_body(blocks[b], density, options.spheres));
  }
  model.largest_overlap = largest_overlap(blocks, model.bodies);
  // Blocks on both sides of a zone's border are mirror images, and face each other squarely.
  const bool leans =
      options.joint_sets.has_value() || !options.natural_joints.empty() || !options.faults.empty();
  model.facets = build_facets(blocks, first_tag, support, leans ? Leaning::much : Leaning::little,
                              model.zone_of);
  model.holes = holes_between_mirrors(options.rock.holes, blocks, first_tag, model.facets);
  model.plan_burden = options.burden;
  if (options.burdens_wanted)
    model.burdens = hole_burdens(
        blocks, options.rock.holes, support,
        SurveyedRock{options.surfaces, options.region_alone, options.rock.lo, options.rock.hi});
  if (options.round_walls)
    fit_walls(blocks, first_tag, holes_as_cut(options, model.rock), model.facets);
  std::vector<JointPlane> joints = options.natural_joints;
  joints.insert(joints.end(), options.zone_joints.begin(), options.zone_joints.end());
  model.natural_planes = joints.size();
  assign_joint_classes(joints, blocks, first_tag, model.facets.facets);
  assign_fault_classes(options, first_tag, model);
  if (options.muck)
    model.muck = lay_muck(*options.muck, blocks, options.spheres,
                          first_tag + static_cast<int>(blocks.size()));
  return model;
}

}  // namespace muckpile
