// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blocks in restart files: all blocks, facets with their memory, faces, holes, what
// run it is, and the engine's time, which LIGGGHTS does not keep. Scope: read by the program that
// wrote it, on any number of ranks. LIGGGHTS gives the whole of a fix's data to every rank, at most
// 2 GiB of it.
#include <modify.h>
#include <signal_handling.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>
#include <utility>

#include "args/numbers.h"
#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/restart_seal.h"
#include "fixes/engine/style_args.h"

namespace muckpile {
namespace {

constexpr std::size_t kFacetsAtOnce = 4096;  // of a share; every rank holds one at a time

/// The lists of a rank in shares.
ByteWriter in_shares(const std::vector<BlockRecord>& records, FacetLists lists) {
  ByteWriter out;
  BlocksShare share{records, std::move(lists.faces), {}};
  for (std::size_t f = 0; f < lists.facets.size(); ++f) {
    share.facets.push_back({lists.facets[f], std::move(lists.memory[f])});
    if (share.facets.size() < kFacetsAtOnce) continue;
    out.put(share);
    share = {};
  }
  out.put(share);
  return out;
}

}  // namespace

/// Copies the keeper's facets: it goes on computing with them.
void FixMuckpileBlocks::write_restart(FILE* file) {
  FacetLists lists = handed_over_ ? keeper_->copy() : FacetLists{facets_, memory_, faces_};
  update->update_time();  // from here on both runs count from the same moment
  const BlocksState state{update->atime,
                          engine::greatest_over_ranks(highest_joint_class_, world),
                          holes_,
                          zones_,
                          blocks_created_,
                          facets_created_,
                          record_.recorded(*lmp),
                          softness()};
  engine::write_state<BlocksShare>(*lmp, style, file, state, in_shares(records_, std::move(lists)));
}

/// At an interruption the engine chooses the name: the log tells whose file it is, and that it is
/// whole.
void FixMuckpileBlocks::write_restart_file(char* file) {
  engine::seal_restart(*lmp, file);
  namespace signals = LAMMPS_NS::SignalHandler;
  if (signals::request_quit && signals::request_write_restart)
    engine::print_once(*lmp, std::string("interrupted: the state is in '") + file + "'\n");
}

/// Every rank reads all and keeps what its bodies, which are here already, need.
void FixMuckpileBlocks::restart(char* bytes) {
  const std::vector<int> tags = body_tags();
  const std::unordered_set<int> here(tags.begin(), tags.end());
  BlocksState state;
  std::vector<FacetEntry> facets;
  engine::read_state<BlocksShare>(*lmp, style, bytes, state, [&](BlocksShare&& share) {
    keep_needed(std::move(share), here, facets);
  });
  update->atime = state.time;
  update->atimestep = update->ntimestep;
  highest_joint_class_ = state.highest_joint_class;
  holes_ = std::move(state.holes);
  zones_ = std::move(state.zones);
  blocks_created_ = state.blocks_created;
  facets_created_ = state.facets_created;
  record_.go_on_from(std::move(state.run));
  softness_ = state.softness;
  check_bodies();
  add_facets(std::move(facets));
  restored_ = true;
  synchronise();
}

/// A facet of two ranks stands in the file twice; add_facets() takes one of them.
void FixMuckpileBlocks::keep_needed(BlocksShare&& share, const std::unordered_set<int>& here,
                                    std::vector<FacetEntry>& facets) {
  for (const BlockRecord& record : share.records) {
    if (here.count(record.tag) > 0) records_.push_back(record);
  }
  for (const BoundaryFace& face : share.faces) {
    if (here.count(face.tag) > 0) faces_.push_back(face);
  }
  for (FacetEntry& entry : share.facets) {
    if (here.count(entry.facet.tag_i) + here.count(entry.facet.tag_j) > 0)
      facets.push_back(std::move(entry));
  }
}

/// Refuses bodies whose numbers are not finite, as in a file that fix muckpile/progress left when a
/// run had gone wrong.
void FixMuckpileBlocks::check_bodies() {
  const engine::Bodies bodies(*multisphere_);
  std::array<int, 2> all{bodies.count(), 0};  // blocks, and those with such numbers
  for (int b = 0; b < bodies.count(); ++b) {
    if (!bodies.centre(b).allFinite() || !bodies.velocity(b).allFinite() ||
        !bodies.axes(b).allFinite() || !bodies.spin(b).allFinite())
      ++all[1];
  }
  engine::sum_over_ranks_in_place(all, world);
  if (all[1] > 0) {
    engine::stop(*lmp, "read_restart: " + std::to_string(all[1]) +
                           " blocks have a position or velocity that is not a number; go on from "
                           "a file written before that (command restart)");
  }
  if (all[0] == 0 && blocks_created_ > 0) {
    engine::stop(*lmp, "read_restart: all " + std::to_string(blocks_created_) +
                           " blocks had left the simulation box; go on from a file written before "
                           "that (command restart)");
  }
  lost_before_ = std::max(blocks_created_ - all[0], 0);
  engine::print_once(*lmp, "read_restart: " + std::to_string(all[0]) +
                               " blocks at t = " + number_text(update->atime) + " s" +
                               (lost_before_ > 0 ? "; " + std::to_string(lost_before_) +
                                                       " more had left the simulation box"
                                                 : std::string()) +
                               "\n");
}

FixMuckpileBlocks& FixMuckpileBlocks::find_or_make(LAMMPS_NS::LAMMPS& lmp) {
  if (FixMuckpileBlocks* found = find(lmp); found != nullptr) return *found;
  std::array<std::string, 3> words{"muckpile_blocks", "all", "muckpile/blocks"};
  std::array<char*, 3> arg{words[0].data(), words[1].data(), words[2].data()};
  lmp.modify->add_fix(3, arg.data());
  return *find(lmp);
}

}  // namespace muckpile
