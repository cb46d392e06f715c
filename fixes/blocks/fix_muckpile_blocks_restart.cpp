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
#include "fixes/engine/exchange.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/restart_seal.h"
#include "fixes/engine/style_args.h"

namespace muckpile {
namespace {

/// To be raised whenever what one of our fixes writes changes, or its order.
constexpr std::size_t kFormat = 8;

/// Sizes of what is written as bytes: another build may lay it out differently.
using Layout = std::array<std::size_t, 8>;
constexpr Layout kLayout{kFormat,
                         sizeof(BlockRecord),
                         sizeof(Facet),
                         sizeof(FacetTraces),
                         sizeof(ContactMemory),
                         sizeof(ExtraMemory),
                         sizeof(BoundaryFace),
                         sizeof(Hole)};

}  // namespace

/// Copies the keeper's facets: it goes on computing with them.
void FixMuckpileBlocks::write_restart(FILE* file) {
  const FacetLists lists = handed_over_ ? keeper_->copy() : FacetLists{facets_, memory_, faces_};
  engine::ByteWriter mine;
  mine.put_all(records_);
  mine.put_all(lists.faces);
  mine.put(lists.facets.size());
  for (std::size_t f = 0; f < lists.facets.size(); ++f) put(mine, lists.facets[f], lists.memory[f]);

  update->update_time();  // from here on both runs count from the same moment
  engine::ByteWriter all;
  all.put(kLayout);
  all.put(update->atime);
  int highest_class = highest_joint_class_;  // of the facets of this rank so far
  MPI_Allreduce(MPI_IN_PLACE, &highest_class, 1, MPI_INT, MPI_MAX, world);
  all.put(highest_class);
  all.put_all(holes_);
  all.put(blocks_created_);
  all.put(facets_created_);
  record_.write(*lmp, all);
  engine::write_state(*lmp, style, file, all, mine);
}

/// At an interruption the engine chooses the name: the log tells whose file it is, and that it is
/// whole.
void FixMuckpileBlocks::write_restart_file(char* file) {
  engine::seal_restart(*lmp, file);
  namespace signals = LAMMPS_NS::SignalHandler;
  if (signals::request_quit && signals::request_write_restart)
    engine::print_once(*lmp, std::string("interrupted: the state is in '") + file + "'\n");
}

void FixMuckpileBlocks::restart(char* state) {
  engine::ByteReader reader = engine::read_state(state);
  if (reader.get<Layout>() != kLayout)
    engine::stop(*lmp, "read_restart: the file is of another version of Muckpile");
  update->atime = reader.get<double>();
  update->atimestep = update->ntimestep;
  highest_joint_class_ = reader.get<int>();
  holes_ = reader.get_all<Hole>();
  blocks_created_ = reader.get<int>();
  facets_created_ = reader.get<int>();
  record_.read(reader);
  check_bodies();
  read_lists(reader);
  restored_ = true;
  synchronise();
}

/// Every rank reads all and keeps what its bodies, which are here already, need. A facet of two
/// ranks stands in the file twice.
void FixMuckpileBlocks::read_lists(engine::ByteReader& reader) {
  const std::vector<int> tags = body_tags();
  const std::unordered_set<int> here(tags.begin(), tags.end());
  std::vector<FacetEntry> facets;
  while (!reader.empty()) {
    for (const auto& record : reader.get_all<BlockRecord>()) {
      if (here.count(record.tag) > 0) records_.push_back(record);
    }
    for (const auto& face : reader.get_all<BoundaryFace>()) {
      if (here.count(face.tag) > 0) faces_.push_back(face);
    }
    for (auto left = reader.get<std::size_t>(); left > 0; --left) {
      FacetEntry entry = get_facet(reader);
      if (here.count(entry.first.tag_i) + here.count(entry.first.tag_j) > 0)
        facets.push_back(std::move(entry));
    }
  }
  add_facets(std::move(facets));
}

/// Refuses bodies whose numbers are not finite, as in a file that fix muckpile/progress left when a
/// run had gone wrong.
void FixMuckpileBlocks::check_bodies() {
  const engine::Bodies bodies(*multisphere_);
  std::array<int, 2> mine{bodies.count(), 0}, all{};
  for (int b = 0; b < bodies.count(); ++b) {
    if (!bodies.centre(b).allFinite() || !bodies.velocity(b).allFinite() ||
        !bodies.axes(b).allFinite() || !bodies.spin(b).allFinite())
      ++mine[1];
  }
  MPI_Allreduce(mine.data(), all.data(), 2, MPI_INT, MPI_SUM, world);
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
