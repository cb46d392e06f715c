// SPDX-License-Identifier: GPL-2.0-or-later
// The one file that reaches LIGGGHTS' private style maps, and the one table of our styles.
// Scope: written for LIGGGHTS 3.8; the static_asserts stop the build if a map's type changes.
#include "fixes/engine/registry.h"

#include <error.h>
#include <fix.h>
#include <force.h>
#include <input.h>
#include <lammps.h>
#include <modify.h>
#include <pair.h>

#include <map>
#include <type_traits>

#include "fixes/blocks/block_motion.h"
#include "fixes/blocks/create_blocks.h"
#include "fixes/blocks/fix_muckpile_balance.h"
#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/blocks/fix_muckpile_shapes.h"
#include "fixes/blocks/fix_muckpile_sleep.h"
#include "fixes/blocks/fix_multisphere_muckpile.h"
#include "fixes/blocks/rank_grid.h"
#include "fixes/contact/fix_muckpile_contact_history.h"
#include "fixes/contact/fix_muckpile_ground.h"
#include "fixes/contact/fix_muckpile_wall.h"
#include "fixes/contact/pair_muckpile_block.h"
#include "fixes/contact/sphere_commands.h"
#include "fixes/explosive/charge_design.h"
#include "fixes/explosive/fix_muckpile_blast.h"
#include "fixes/explosive/fix_muckpile_gas.h"
#include "fixes/explosive/hole_pattern.h"
#include "fixes/joints/fix_muckpile_joint.h"
#include "fixes/joints/fix_muckpile_quiet.h"
#include "fixes/output/fix_muckpile_dump.h"
#include "fixes/output/fix_muckpile_gauges.h"
#include "fixes/output/fix_muckpile_impulse.h"
#include "fixes/output/fix_muckpile_ledger.h"
#include "fixes/output/write_panels.h"
#include "fixes/output/write_scene.h"
#include "fixes/run/fix_muckpile_progress.h"
#include "fixes/run/fix_muckpile_timestep.h"
#include "fixes/run/read_sealed_restart.h"
#include "fixes/run/require.h"
#include "fixes/run/run_blast.h"
#include "fixes/run/run_blocks.h"

namespace muckpile::engine {
namespace {

using LAMMPS_NS::Fix;
using LAMMPS_NS::Force;
using LAMMPS_NS::Input;
using LAMMPS_NS::LAMMPS;
using LAMMPS_NS::Modify;
using LAMMPS_NS::Pair;

using CommandCreator = void (*)(LAMMPS*, int, char**);
using FixCreator = Fix* (*)(LAMMPS*, int, char**);
using PairCreator = Pair* (*)(LAMMPS*);

// Explicit instantiation may name a private member ([temp.spec]/6); the friend hands it out.
template <typename Tag, typename Tag::Type member>
struct Expose {
  friend typename Tag::Type private_member(Tag) { return member; }
};
struct FixMap {
  using Type = std::map<std::string, FixCreator>* Modify::*;
  friend Type private_member(FixMap);
};
struct CommandMap {
  using Type = std::map<std::string, CommandCreator>* Input::*;
  friend Type private_member(CommandMap);
};
template struct Expose<FixMap, &Modify::fix_map>;
template struct Expose<CommandMap, &Input::command_map>;
static_assert(std::is_same_v<decltype(Force::pair_map), std::map<std::string, PairCreator>*>);

template <typename Style>
Fix* create_fix(LAMMPS* lmp, int narg, char** arg) {
  return new Style(lmp, narg, arg);  // the engine owns and deletes it
}
template <typename Style>
Pair* create_pair(LAMMPS* lmp) {
  return new Style(lmp);  // the engine owns and deletes it
}
template <typename Style>
void run_command(LAMMPS* lmp, int narg, char** arg) {
  Style(lmp).command(narg, arg);
}
template <void (SphereCommands::*command)(int, char**)>
void run_sphere_command(LAMMPS* lmp, int narg, char** arg) {
  (SphereCommands(lmp).*command)(narg, arg);
}

void register_again(LAMMPS* lmp, int, char**) { register_styles(*lmp); }

const std::map<std::string, CommandCreator>& commands() {
  static const std::map<std::string, CommandCreator> table = {
      {"block_motion", &run_command<BlockMotionCommand>},
      {"charge_design", &run_command<ChargeDesignCommand>},
      {"create_blocks", &run_command<CreateBlocks>},
      {"hole_pattern", &run_command<HolePatternCommand>},
      {"muckpile_styles", &register_again},
      {"rank_grid", &run_command<RankGridCommand>},
      {"require", &run_command<Require>},
      {"run_blast", &run_command<RunBlastCommand>},
      {"run_blocks", &run_command<RunBlocksCommand>},
      {"write_panels", &run_command<WritePanelsCommand>},
      {"write_scene", &run_command<WriteScene>},
  };
  return table;
}
/// In place of commands of the engine.
const std::map<std::string, CommandCreator>& replaced_commands() {
  static const std::map<std::string, CommandCreator> table = {
      {"displace_atoms", &run_sphere_command<&SphereCommands::displace_atoms>},
      {"read_restart", &run_command<ReadSealedRestart>},
      {"set", &run_sphere_command<&SphereCommands::set>},
      {"velocity", &run_sphere_command<&SphereCommands::velocity>},
  };
  return table;
}
const std::map<std::string, FixCreator>& fixes() {
  static const std::map<std::string, FixCreator> table = {
      {"multisphere/muckpile", &create_fix<FixMultisphereMuckpile>},
      {"muckpile/balance", &create_fix<FixMuckpileBalance>},
      {"muckpile/blast", &create_fix<FixMuckpileBlast>},
      {"muckpile/blocks", &create_fix<FixMuckpileBlocks>},
      {"muckpile/contact/history", &create_fix<FixMuckpileContactHistory>},
      {"muckpile/dump", &create_fix<FixMuckpileDump>},
      {"muckpile/gas", &create_fix<FixMuckpileGas>},
      {"muckpile/gauges", &create_fix<FixMuckpileGauges>},
      {"muckpile/ground", &create_fix<FixMuckpileGround>},
      {"muckpile/impulse", &create_fix<FixMuckpileImpulse>},
      {"muckpile/joint", &create_fix<FixMuckpileJoint>},
      {"muckpile/ledger", &create_fix<FixMuckpileLedger>},
      {"muckpile/progress", &create_fix<FixMuckpileProgress>},
      {"muckpile/quiet", &create_fix<FixMuckpileQuiet>},
      {"muckpile/shapes", &create_fix<FixMuckpileShapes>},
      {"muckpile/sleep", &create_fix<FixMuckpileSleep>},
      {"muckpile/timestep", &create_fix<FixMuckpileTimestep>},
      {"muckpile/wall", &create_fix<FixMuckpileWall>},
  };
  return table;
}
const std::map<std::string, PairCreator>& pairs() {
  static const std::map<std::string, PairCreator> table = {
      {"muckpile/block", &create_pair<PairMuckpileBlock>},
  };
  return table;
}

template <typename Map>
void add_all(LAMMPS& lmp, Map* engine_map, const Map& ours, const char* kind) {
  if (engine_map == nullptr) {
    lmp.error->all(FLERR,
                   (std::string("this LIGGGHTS has no table of ") + kind + " styles").c_str());
  }
  for (const auto& [name, creator] : ours) {
    const auto [place, added] = engine_map->emplace(name, creator);
    if (!added && place->second != creator) {
      lmp.error->all(
          FLERR, ("LIGGGHTS already has a " + std::string(kind) + " style '" + name + "'").c_str());
    }
  }
}

}  // namespace

std::vector<StyleName> style_names() {
  std::vector<StyleName> names;
  for (const auto& entry : commands()) names.push_back({"command", entry.first});
  for (const auto& entry : fixes()) names.push_back({"fix", entry.first});
  for (const auto& entry : pairs()) names.push_back({"pair", entry.first});
  return names;
}

std::unique_ptr<Fix> make_fix(LAMMPS& lmp, const std::string& style, std::vector<char*> arg) {
  std::string name = style;
  arg.at(2) = name.data();
  const auto& known = *(lmp.modify->*private_member(FixMap{}));
  return std::unique_ptr<Fix>(known.at(style)(&lmp, static_cast<int>(arg.size()), arg.data()));
}

void register_styles(LAMMPS& lmp) {
  auto* engine_commands = lmp.input->*private_member(CommandMap{});
  add_all(lmp, engine_commands, commands(), "command");
  for (const auto& [name, creator] : replaced_commands())
    engine_commands->insert_or_assign(name, creator);
  add_all(lmp, lmp.modify->*private_member(FixMap{}), fixes(), "fix");
  add_all(lmp, lmp.force->pair_map, pairs(), "pair");
}

}  // namespace muckpile::engine
