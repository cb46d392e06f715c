// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint: what a script reads from it, and what it changes by fix_modify.
// Scope: sums over ranks; nothing here runs in a step of its own accord.
#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

#include "args/numbers.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/joints/fix_muckpile_joint.h"

namespace muckpile {

double FixMuckpileJoint::sum(double mine) const { return engine::sum_over_ranks(mine, world); }

double FixMuckpileJoint::compute_vector(int n) {
  using enum Output;
  switch (static_cast<Output>(n)) {
    case joints:
      return store_ == nullptr ? 0.0 : store_->facets_created();
    case broken:
      return sum(network_.broken_count());
    case broken_share:
      return sum(network_.broken_area(false)) / std::max(sum(network_.broken_area(true)), 1e-300);
    case elastic:
      return sum(network_.elastic_energy());
    case fracture:
      return sum(network_.losses().fracture);
    case friction:
      return sum(network_.losses().friction);
    case damping:
      return sum(network_.losses().damping);
    case pressure_work_done:
      return sum(network_.pressure_work());
    case longest_step:
      return follows_blocks() ? stable_step(Breaking::possible, 0.0).seconds
                              : std::numeric_limits<double>::infinity();
    case softened:
      return network_.softened();
    case crushing:
      return sum(network_.losses().crushing);
    default:
      return 0.0;
  }
}

int FixMuckpileJoint::modify_param(int narg, char** arg) {
  if (std::strcmp(arg[0], "soften") != 0) return 0;
  const std::string where = engine::name_of_modify(*this);
  if (narg < 2) engine::stop(*lmp, where + ": soften needs a factor in (0, 1]");
  const bool damps = narg > 2 && std::strcmp(arg[2], "damping") == 0;
  if (damps && narg < 4) engine::stop(*lmp, where + ": soften ... damping needs a share >= 0");
  if (version_ == 0 || store_ == nullptr)
    engine::stop(*lmp, where + ": soften needs a run (run 0 will do) before it");
  engine::or_engine_error(*lmp, [&] {
    const double factor = parse_real(where, "soften", arg[1], "", Range::left_open(0.0, 1.0));
    std::optional<double> damping;
    if (damps) damping = parse_real(where, "damping", arg[3], "", Range::closed(0.0, 10.0));
    if (!follows_blocks()) {  // create_blocks has cut more since the last run
      check_classes();
      follow_blocks();
    }
    gather_state();
    network_.soften(factor, damping, team());
    ++softenings_;
    return 0;
  });
  return damps ? 4 : 2;
}

double FixMuckpileJoint::memory_usage() {
  const auto bytes = [](const auto&... table) {
    return (static_cast<double>(table.capacity() * sizeof(table[0])) + ...);
  };
  return network_.memory_usage() +
         bytes(lower_tags_, upper_tags_, first_of_, enclosed_tags_, loaded_, poses_);
}

}  // namespace muckpile
