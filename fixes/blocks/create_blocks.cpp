// SPDX-License-Identifier: GPL-2.0-or-later
// create_blocks: from a region to multisphere bodies and facets.
// Scope: see the header.
#include "fixes/blocks/create_blocks.h"

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <multisphere.h>
#include <region.h>
#include <unistd.h>
#include <update.h>

#include <cstdint>
#include <cstring>
#include <functional>
#include <sstream>

#include "args/input_error.h"
#include "fixes/blocks/block_placement.h"
#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/first_rank.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/script_variables.h"
#include "geometry/files/block_file.h"
#include "rock/burden_file.h"
#include "rock/cut_table.h"
#include "rock/faults.h"
#include "rock/ground_checks.h"
#include "rock/joint_words.h"
#include "rock/rock_surfaces.h"
#include "rock/zone_bodies.h"
#include "rock/zone_model.h"
#include "rock/zone_sizes.h"

namespace muckpile {
namespace {

void on_rank_0(LAMMPS_NS::LAMMPS& lmp, const std::function<void()>& body) {
  engine::on_first_rank(lmp, body, in_create_blocks);
}

/// Memory of this machine [bytes].
std::size_t installed_memory() {
  return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(sysconf(_SC_PAGE_SIZE));
}

/// All ranks know the holes, but rank 0 alone how much of each the rock holds.
std::vector<Hole> with_shares(std::vector<Hole> holes, const RockModel& model, MPI_Comm world) {
  std::vector<double> shares(holes.size(), 1.0);
  for (std::size_t h = 0; h < model.holes.size(); ++h) shares[h] = model.holes[h].share;
  engine::take_from_first_rank(shares, world);
  for (std::size_t h = 0; h < holes.size(); ++h) holes[h].share = shares[h];
  return holes;
}

void write_start(const std::string& file, const RockModel& model, int first_tag,
                 const std::vector<double>& densities, const std::string& run) {
  if (model.muck.blocks.empty())
    return write_blocks(file, model.rock.blocks, first_tag, densities, model.zone_of, run);
  std::vector<Block> blocks = model.rock.blocks;
  blocks.insert(blocks.end(), model.muck.blocks.begin(), model.muck.blocks.end());
  std::vector<double> muck;  // [kg]
  for (const RigidBody& body : model.muck.bodies) muck.push_back(body.mass);
  write_blocks(file, blocks, first_tag, densities, model.zone_of, run, muck);
}

/// Of a variable that the script has, or nothing is asked of them.
void look_at_joint_words(LAMMPS_NS::LAMMPS& lmp, const CutOptions& options,
                         const std::string& knob) {
  if (knob == "none") return;
  std::istringstream text(engine::knob_value(lmp, knob));
  std::vector<std::string> words;
  for (std::string word; text >> word;) words.push_back(word);
  if (words.empty())
    throw InputError(
        "create_blocks: joint_words must be the name of a variable of style index, "
        "which holds words of fix muckpile/joint, got '" +
        knob + "'");
  require_joint_words(options, knob, words);
}

RegionQuery query(LAMMPS_NS::Region& rock) {
  RegionQuery region;
  region.inside = [&rock](const Vec3& p) { return rock.match(p.x(), p.y(), p.z()) != 0; };
  region.surface_points = [&rock](const Vec3& p, double cutoff) {
    const int count = rock.surface(p.x(), p.y(), p.z(), cutoff);
    std::vector<Vec3> points;
    for (int c = 0; c < count; ++c) {
      const auto& hit = rock.contact[c];
      points.push_back(p - Vec3(hit.delx, hit.dely, hit.delz));
    }
    return points;
  };
  return region;
}

}  // namespace

void CreateBlocks::command(int narg, char** arg) {
  if (narg < 1) engine::stop(*lmp, "create_blocks: needs the ID of a region as its first word");
  check_engine();
  const ArgValues args = engine::read_args(*lmp, cut_table(), kCreateBlocks, narg, arg, 1);
  const int type = checked_type(args);
  LAMMPS_NS::Region& rock = region(arg[0]);
  check_overlap(rock);
  const double start = MPI_Wtime();
  CutOptions options;
  SupportRule supports;
  engine::or_engine_error(*lmp, [&] {
    options = cut_options(args, installed_memory());
    look_at_joint_words(*lmp, options, args.word("joint_words"));
    bound(options.rock, rock);
    lay_surfaces(options);
    lay_natural_joint_sets(options);
    lay_faults(options);
    find_zone_regions(options.zones);
    lay_zones(options);
    if (options.muck) {
      options.muck->lo = Vec3(domain->boxlo);
      options.muck->hi = Vec3(domain->boxhi);
    }
    supports = support(args);
    return 0;
  });
  engine::print_once(*lmp, engine::or_engine_error(*lmp, [&] { return ground_checks(options); }));
  const std::vector<double> densities = options.densities();
  BlockPlacement placement(lmp, type, options);
  if (comm->nprocs > 1 && options.is_plain_voronoi()) share_sweeps_of_rank_0(options.rock);
  RockModel model;
  on_rank_0(*lmp, [&] { model = cut_rock(options, placement.first_tag(), supports); });
  const std::string run = run_id(engine::words_of(narg, arg, 0), model);
  on_rank_0(*lmp, [&] {
    const std::string& file = args.word("file");
    if (file != "none") write_start(file, model, placement.first_tag(), densities, run);
    const std::string& burdens = args.word("burden_file");
    if (burdens != "none") write_burdens(burdens, {model.burdens, model.plan_burden}, run);
  });
  placement.place(model, with_shares(options.rock.holes, model, world));
  FixMuckpileBlocks::find(*lmp)->record().begin(run);
  if (comm->me == 0)
    engine::print_once(
        *lmp, describe(model, MPI_Wtime() - start) + describe_surfaces(options, model.rock) +
                  describe_open_planes(options, model.rock) +
                  describe_zone_sizes(options, model.rock, model.zone_of) +
                  describe_zone_bodies(options, model) + describe_zone_model(options) +
                  describe_faults(options, model) + describe_mine_frame(options) +
                  (options.muck ? describe_muck(model.muck, *options.muck) : ""));
}

/// All rock of a run has the id that comes with the first.
std::string CreateBlocks::run_id(const std::vector<std::string>& words,
                                 const RockModel& model) const {
  FixMuckpileBlocks* store = FixMuckpileBlocks::find(*lmp);
  const std::string known = store == nullptr ? "" : store->record().id();
  return known.empty() ? make_run_id(*lmp, words, model) : known;
}

void CreateBlocks::check_engine() const {
  if (domain->box_exist == 0)
    engine::stop(*lmp, "create_blocks: needs a simulation box (create_box) before it");
  if (std::strcmp(update->unit_style, "si") != 0) {
    engine::stop(*lmp, std::string("create_blocks: needs 'units si', got 'units ") +
                           update->unit_style + "'");
  }
  if (atom->sphere_flag == 0 || atom->rmass == nullptr) {
    engine::stop(*lmp, "create_blocks: needs 'atom_style granular' (or sphere)");
  }
  if (engine::find_multisphere(*lmp) == nullptr) {
    engine::stop(*lmp, "create_blocks: needs 'fix ID all multisphere' before it");
  }
  if (modify->nfix_restart_peratom > 0) {
    engine::stop(*lmp,
                 "create_blocks: must not stand between read_restart and the first run ('run 0' is "
                 "enough): until then LIGGGHTS keeps data of the file that new particles lack");
  }
}

int CreateBlocks::checked_type(const ArgValues& args) const {
  const long type = args.integer("type");
  if (type > atom->ntypes) {
    engine::stop(*lmp, "create_blocks: type must be <= " + std::to_string(atom->ntypes) +
                           ", the number of atom types of the box, got '" + std::to_string(type) +
                           "'");
  }
  return static_cast<int>(type);
}

LAMMPS_NS::Region& CreateBlocks::region(const std::string& id) const {
  const int index = domain->find_region(id.c_str());
  if (index < 0) engine::stop(*lmp, "create_blocks: region must exist, got '" + id + "'");
  return *domain->regions[index];
}

void CreateBlocks::check_overlap(LAMMPS_NS::Region& rock) const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  int inside = 0;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto c = bodies.centre(b);
    inside += rock.match(c.x(), c.y(), c.z()) != 0 ? 1 : 0;
  }
  const int all = engine::sum_over_ranks(inside, world);
  if (all > 0) {
    engine::stop(*lmp, std::string("create_blocks: region '") + rock.id +
                           "' must not overlap rock that exists, got " + std::to_string(all) +
                           " bodies with their centre in it");
  }
}

/// Box and surface of the rock.
void CreateBlocks::bound(TessellationOptions& what, LAMMPS_NS::Region& rock) const {
  const std::string name = std::string("create_blocks: region '") + rock.id + "'";
  if (rock.bboxflag == 0) throw InputError(name + " must be bounded");
  what.lo = {rock.extent_xlo, rock.extent_ylo, rock.extent_zlo};
  what.hi = {rock.extent_xhi, rock.extent_yhi, rock.extent_zhi};
  const Vec3 box_lo(domain->boxlo), box_hi(domain->boxhi);
  if ((what.lo.array() < box_lo.array()).any() || (what.hi.array() > box_hi.array()).any())
    throw InputError(name + " must lie inside the simulation box");
  const bool is_box = std::strcmp(rock.style, "block") == 0 && rock.interior != 0;
  if (!is_box) what.region = query(rock);
}

void CreateBlocks::find_zone_regions(std::vector<RockZone>& zones) const {
  for (RockZone& zone : zones) {
    if (zone.region.empty()) continue;
    zone.holds = [where = &region(zone.region)](const Vec3& at) {
      return where->match(at.x(), at.y(), at.z()) != 0;
    };
  }
}

SupportRule CreateBlocks::support(const ArgValues& args) const {
  std::vector<std::pair<Support, LAMMPS_NS::Region*>> rules;
  for (const auto& words : args.groups("support")) {
    if (words[0] != "fixed" && words[0] != "mirror")
      throw InputError("create_blocks: support must be fixed or mirror, got '" + words[0] + "'");
    rules.emplace_back(words[0] == "fixed" ? Support::fixed : Support::mirror, &region(words[1]));
  }
  return [rules](const Vec3& at) {
    for (const auto& [kind, where] : rules) {
      if (where->match(at.x(), at.y(), at.z()) != 0) return kind;
    }
    return Support::free;
  };
}

/// The other ranks take part in the sweeps that rank 0 makes later, as it cuts: nothing collective
/// may come in between. Rank 0 reports what goes wrong.
void CreateBlocks::share_sweeps_of_rank_0(TessellationOptions& what) const {
  what.team.rank = comm->me;
  what.team.ranks = comm->nprocs;
  what.team.gather = [this](const std::vector<double>& mine) {
    return engine::gather_all(mine, world);
  };
  const auto most = static_cast<std::int64_t>(what.max_blocks);  // other nodes may have less memory
  what.max_blocks = static_cast<std::size_t>(engine::of_first_rank(most, world));
  if (comm->me == 0) return;
  try {
    share_sweeps(what);
  } catch (const std::exception&) {
  }
}

}  // namespace muckpile
