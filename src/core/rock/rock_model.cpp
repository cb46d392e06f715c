// SPDX-License-Identifier: GPL-2.0-or-later
// The rock as the engine takes it; see the header.
#include "rock/rock_model.h"

#include <utility>

#include "args/input_error.h"
#include "geometry/files/block_import.h"

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

}  // namespace

RockModel cut_rock(const CutOptions& options, int first_tag, const SupportRule& support) {
  RockModel model;
  cut_blocks(model, options);
  const std::vector<Block>& blocks = model.rock.blocks;
  if (blocks.empty())
    throw InputError("the region holds no block; block sizes are too large for it");
  for (const Block& block : blocks) {
    model.bodies.push_back(
        rigid_body(block, options.density, options.spheres_per_block, options.sphere_growth));
  }
  model.largest_overlap = largest_overlap(blocks, model.bodies);
  const bool leans = options.joint_sets.has_value() || !options.rock.planes.empty();
  model.facets = build_facets(blocks, first_tag, support, leans ? Leaning::much : Leaning::little);
  assign_joint_classes(options.natural_joints, blocks, first_tag, model.facets.facets);
  return model;
}

}  // namespace muckpile
