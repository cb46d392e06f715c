// SPDX-License-Identifier: GPL-2.0-or-later
// The list of all keyword tables.
// Scope: see the header.
#include "fixes/interfaces/keyword_tables.h"

#include "bond/law/joint_law_table.h"
#include "explosive/blast_options.h"
#include "explosive/charge_design.h"
#include "explosive/hole_pattern.h"
#include "geometry/files/panel_mesh.h"
#include "rock/cut_table.h"
#include "run/blast_plan.h"
#include "run/blocks_run.h"
#include "wall/wall_options.h"

namespace muckpile {

std::vector<ArgTable> keyword_tables() {
  std::vector<ArgTable> tables = {block_contact_keywords(),
                                  block_motion_keywords(),
                                  blast_table(),
                                  charge_design_table(),
                                  cut_table(),
                                  dump_keywords(),
                                  gas_keywords(),
                                  gauges_keywords(),
                                  hole_pattern_table(),
                                  joint_keywords(),
                                  progress_keywords(),
                                  quiet_keywords(),
                                  rank_grid_keywords(),
                                  run_blast_table(),
                                  run_blocks_table(),
                                  sleep_keywords(),
                                  timestep_keywords(),
                                  wall_table(),
                                  write_panels_table()};
  for (const JointLawEntry& law : joint_law_entries()) tables.push_back(law.table);
  return tables;
}

}  // namespace muckpile
