// SPDX-License-Identifier: GPL-2.0-or-later
// create_blocks: from a region to multisphere bodies and facets.
// Scope: see the header.
#include "create_blocks.h"

#include <atom.h>
#include <atom_vec.h>
#include <comm.h>
#include <domain.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <multisphere.h>
#include <region.h>
#include <unistd.h>
#include <update.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <sstream>

#include "args/numbers.h"
#include "engine/bodies.h"
#include "engine/exchange.h"
#include "explosive/hole_table.h"
#include "fix_muckpile_balance.h"
#include "fix_muckpile_blocks.h"
#include "geometry/block_file.h"
#include "geometry/block_import.h"
#include "geometry/filling_quality.h"
#include "geometry/hole_overlap.h"

namespace muckpile {
namespace {

constexpr const char* kStyle = "create_blocks";

constexpr int kMostBands = 20;

const ArgTable& table() {
  static const ArgTable args =
      ArgTable(kStyle)
          .real("density", "kg/m3", Range::closed(100.0, 30000.0), std::nullopt,
                "density of the rock")
          .group("size", 2, 2 * kMostBands + 1, false,
                 "block size V^(1/3) against distance from the nearest charge: `harries b K T "
                 "alpha` (hole "
                 "radius [m], wall strain, breaking strain, absorption per hole radius), `power c "
                 "p` (size = "
                 "c r^p), `table FILE` (two columns, m), `uniform s` [m], `bands R1 s1 R2 s2 ...` "
                 "(s1 out to R1, s2 from there to R2, ..., the "
                 "last s beyond, m; 20 bands at most), `target kuz_ram x50 n` "
                 "or `target "
                 "swebrec x50 xmax b` (fitted to that size curve, m), `import FILE` (blocks as a "
                 "VTK file has them); required")
          .flag("superpose", false,
                "with `size harries`: the cracks of all charges add up, not those of the nearest "
                "alone")
          .real("block_min", "m", Range::positive(), std::nullopt, "smallest block size")
          .real("block_max", "m", Range::positive(), std::nullopt, "largest block size")
          .group("hole", 7, 7, true,
                 "crushed zone of one charge: toe x y z, collar x y z, radius [m]; its rock is "
                 "removed")
          .group("hole_row", 11, 11, true,
                 "N dx dy dz, then the words of `hole`: N equal holes, each shifted by (dx, dy, "
                 "dz) [m] from the "
                 "one before; numbered after all single holes")
          .group(
              "hole_table", 2, 2, false,
              "FILE RATIO: the pattern of a CSV file, one crushed zone per charged deck, of RATIO "
              "hole radii (>= 1) unless the file says; numbered after all rows")
          .group("support", 2, 2, true,
                 "`fixed REGION` or `mirror REGION`: how boundary faces with their centroid in "
                 "that region "
                 "are held; all others are free faces")
          .group(
              "joint_plane", 6, 7, true,
              "natural joint: x y z of a point [m], dip and dip direction [degrees; y is north, x "
              "is east], number of the `joint_class` of fix muckpile/joint (0: none), and "
              "optionally a radius about the point [m] beyond which its facets are like all others")
          .word("cut", {"voronoi", "joint_sets"}, "voronoi",
                "how the rock is cut: graded Voronoi blocks, or joint sets in concentric bands")
          .group("joint_set", 2, 3, true,
                 "for `cut joint_sets`, two or three times: dip and dip direction [degrees], and "
                 "optionally the spacing relative to the other sets' (1; 0.1 to 10)")
          .real("sliver", "", Range::closed(0.0, 0.3), kThinnestPart,
                "for `cut joint_sets`: no block gets 3 volume / surface below this share of the "
                "size asked for")
          .integer("spheres_per_block", "", Range::closed(1, 64), 8,
                   "contact spheres in each block")
          .real("sphere_growth", "", Range::closed(1.0, 1.5), 1.0,
                "radius of the contact spheres over that of spheres inside the block; above 1 they "
                "stand for the "
                "volume of the corners; overlaps at the start carry no force")
          .integer("type", "", Range::closed(1, 1000), 1, "atom type of the spheres")
          .integer("seed", "", Range::closed(1, 2147483647), 1, "seed of the cut")
          .integer("sweeps", "", Range::closed(0, 200), 20, "size-weighted Lloyd sweeps")
          .integer("max_blocks", "", Range::closed(0, 100000000), 0,
                   "refuse to make more blocks; 0: as many as half of this machine's memory holds, "
                   "at most 5 million")
          .word("file", {}, "none", "VTK file for the blocks in the start configuration, or none");
  return args;
}

/// Fails unless `size LAW` has so many values behind it.
void need_values(const std::vector<std::string>& words, std::size_t count) {
  if (words.size() == count + 1) return;
  throw InputError(std::string(kStyle) + ": size " + words[0] + " takes " + std::to_string(count) +
                   " value(s), got " + std::to_string(words.size() - 1));
}

double value_of_size(const std::vector<std::string>& words, std::size_t k, const char* unit) {
  return parse_real(kStyle, "size " + words[0], words[k], unit, Range::non_negative());
}

SizeLimits size_limits(const ArgValues& args) {
  const SizeLimits limits{args.real("block_min"), args.real("block_max")};
  if (limits.largest < limits.smallest) {
    throw InputError(std::string(kStyle) + ": block_max must be >= block_min (" +
                     number_text(limits.smallest) + " m), got '" + number_text(limits.largest) +
                     "'");
  }
  return limits;
}

SizeLaw size_bands(const std::vector<std::string>& words, const SizeLimits& limits) {
  if (words.size() % 2 == 0)
    throw InputError(std::string(kStyle) + ": size bands takes pairs of a radius and a size");
  SizeBands bands;
  for (std::size_t k = 1; k + 1 < words.size(); k += 2)
    bands.bands.emplace_back(value_of_size(words, k, "m"), value_of_size(words, k + 1, "m"));
  return SizeLaw::bands(bands, limits);
}

/// What the core says, after the name of the style.
std::string in_style(const std::string& message) {
  return message.rfind(kStyle, 0) == 0 ? message : std::string(kStyle) + ": " + message;
}

/// Runs `body` on rank 0; a fault there stops all ranks with its message.
void on_rank_0(LAMMPS_NS::LAMMPS& lmp, const std::function<void()>& body) {
  std::string fault;
  if (lmp.comm->me == 0) {
    try {
      body();
    } catch (const std::exception& error) {
      fault = error.what();
    }
  }
  int length = static_cast<int>(fault.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, lmp.world);
  if (length == 0) return;
  fault.resize(static_cast<std::size_t>(length));
  MPI_Bcast(fault.data(), length, MPI_CHAR, 0, lmp.world);
  engine::stop(lmp, in_style(fault));
}

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Size below which `share` of the rock's volume lies [m].
double size_by_volume(std::vector<double> sizes, double share) {
  std::sort(sizes.begin(), sizes.end());
  double all = 0.0, below = 0.0;
  for (double size : sizes) all += size * size * size;
  for (double size : sizes) {
    below += size * size * size;
    if (below >= share * all) return size;
  }
  return sizes.back();
}

}  // namespace

void CreateBlocks::command(int narg, char** arg) {
  if (narg < 1) engine::stop(*lmp, "create_blocks: needs the ID of a region as its first word");
  check_engine();
  const ArgValues args = engine::read_args(*lmp, table(), kStyle, narg, arg, 1);
  if (args.integer("type") > atom->ntypes) {
    engine::stop(*lmp, "create_blocks: type must be <= " + std::to_string(atom->ntypes) +
                           ", the number of atom types of the box, got '" +
                           std::to_string(args.integer("type")) + "'");
  }
  LAMMPS_NS::Region& rock = region(arg[0]);
  check_overlap(rock);
  const double start = MPI_Wtime();
  number_from_what_exists();
  settle_new_fixes();
  TessellationOptions what;
  SupportRule held;
  engine::or_engine_error(*lmp, [&] {
    try {
      what = options(rock, args);
      held = support(args);
    } catch (const InputError& refused) {
      throw InputError(in_style(refused.what()));
    }
    return 0;
  });
  if (sweeps_are_shared(args)) share_sweeps_of_rank_0(what);
  Model model;
  on_rank_0(*lmp, [&] {
    model = cut(what, args);
    model.facets = build_facets(model.rock.blocks, first_tag_, held);
    assign_joint_classes(joint_planes(args), model.rock.blocks, first_tag_, model.facets.facets);
    if (args.word("file") != "none")
      write_blocks(args.word("file"), model.rock.blocks, first_tag_, args.real("density"));
  });
  int blocks = static_cast<int>(model.rock.blocks.size());
  MPI_Bcast(&blocks, 1, MPI_INT, 0, world);
  if (FixMuckpileBalance* balance = FixMuckpileBalance::find(*lmp)) {
    std::vector<Vec3> centres;
    for (const RigidBody& body : model.bodies) centres.push_back(body.centre);
    balance->cut_for(centres);
  }
  create(hand_out(model), what.holes, args, blocks);
  if (comm->me == 0) report(model, MPI_Wtime() - start);
}

void CreateBlocks::number_from_what_exists() {
  multisphere_ = engine::find_multisphere(*lmp);
  first_tag_ = multisphere_->tag_max_body() + 1;
  int mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) mine = std::max(mine, static_cast<int>(atom->tag[i]));
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  first_atom_tag_ = all + 1;
}

/// The engine sets the per-atom arrays of a new fix at the start of the first run, and would wipe
/// what create_body writes: do it now instead.
void CreateBlocks::settle_new_fixes() {
  for (int f = 0; f < modify->nfix; ++f) {
    LAMMPS_NS::Fix& fix = *modify->fix[f];
    if (fix.just_created == 0 || fix.create_attribute == 0) continue;
    fix.just_created = 0;
    fix.pre_set_arrays();
    for (int i = 0; i < atom->nlocal; ++i) fix.set_arrays(i);
  }
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
}

LAMMPS_NS::Region& CreateBlocks::region(const std::string& id) const {
  const int index = domain->find_region(id.c_str());
  if (index < 0) engine::stop(*lmp, "create_blocks: region must exist, got '" + id + "'");
  return *domain->regions[index];
}

void CreateBlocks::check_overlap(LAMMPS_NS::Region& rock) const {
  const engine::Bodies bodies(*engine::find_multisphere(*lmp));
  int inside = 0, all = 0;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto c = bodies.centre(b);
    inside += rock.match(c.x(), c.y(), c.z()) != 0 ? 1 : 0;
  }
  MPI_Allreduce(&inside, &all, 1, MPI_INT, MPI_SUM, world);
  if (all > 0) {
    engine::stop(*lmp, std::string("create_blocks: region '") + rock.id +
                           "' must not overlap rock that exists, got " + std::to_string(all) +
                           " bodies with their centre in it");
  }
}

std::vector<Hole> CreateBlocks::holes(const ArgValues& args) const {
  const auto read = [](const char* keyword, const std::vector<std::string>& words,
                       std::size_t first) {
    std::array<double, 7> v{};
    for (std::size_t k = 0; k < v.size(); ++k) {
      v[k] = parse_real(kStyle, keyword, words[first + k], "m",
                        k < 6 ? Range::any() : Range::positive());
    }
    return Hole{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6]};
  };
  std::vector<Hole> found;
  for (const auto& words : args.groups("hole")) found.push_back(read("hole", words, 0));
  for (const auto& words : args.groups("hole_row")) {
    const long count = parse_integer(kStyle, "hole_row", words[0], "", Range::closed(1, 100000));
    Vec3 shift;
    for (int c = 0; c < 3; ++c) {
      shift[c] =
          parse_real(kStyle, "hole_row", words[static_cast<std::size_t>(c) + 1], "m", Range::any());
    }
    const Hole first = read("hole_row", words, 4);
    for (long k = 0; k < count; ++k) {
      const Vec3 by = static_cast<double>(k) * shift;
      found.push_back({first.toe + by, first.collar + by, first.radius});
    }
  }
  for (const auto& words : args.groups("hole_table")) {
    const double ratio = parse_real(kStyle, "hole_table", words[1], "", Range::closed(1.0, 20.0));
    const std::vector<Hole> pattern = HoleTable::read(words[0]).crushed_zones(ratio);
    found.insert(found.end(), pattern.begin(), pattern.end());
  }
  return found;
}

std::vector<JointPlane> CreateBlocks::joint_planes(const ArgValues& args) const {
  std::vector<JointPlane> planes;
  for (const auto& words : args.groups("joint_plane")) {
    const auto number = [&](std::size_t k, const char* unit, const Range& range) {
      return parse_real(kStyle, "joint_plane", words[k], unit, range);
    };
    const auto metres = [&](std::size_t k) { return number(k, "m", Range::any()); };
    JointPlane plane;
    plane.point = {metres(0), metres(1), metres(2)};
    plane.normal = normal_of_dip(number(3, "deg", Range::closed(0.0, 90.0)) * M_PI / 180.0,
                                 number(4, "deg", Range::closed(0.0, 360.0)) * M_PI / 180.0);
    plane.joint_class = static_cast<std::uint8_t>(
        parse_integer(kStyle, "joint_plane", words[5], "", Range::closed(0, 255)));
    if (words.size() > 6) plane.radius = number(6, "m", Range::positive());
    planes.push_back(plane);
  }
  return planes;
}

JointSetCut CreateBlocks::joint_sets(const ArgValues& args) const {
  JointSetCut how{{}, args.real("sliver")};
  for (const auto& words : args.groups("joint_set")) {
    const auto radians = [&](std::size_t k, double most) {
      return parse_real(kStyle, "joint_set", words[k], "deg", Range::closed(0.0, most)) * M_PI /
             180.0;
    };
    JointSet set{normal_of_dip(radians(0, 90.0), radians(1, 360.0))};
    if (words.size() > 2)
      set.spacing = parse_real(kStyle, "joint_set", words[2], "", Range::closed(0.1, 10.0));
    how.sets.push_back(set);
  }
  return how;
}

SizeLaw CreateBlocks::size_law(const ArgValues& args) const {
  if (!args.given("size")) throw InputError("create_blocks: keyword 'size' is required");
  const std::vector<std::string>& words = args.groups("size").front();
  const SizeLimits limits = size_limits(args);
  const auto number = [&](std::size_t k, const char* unit) {
    return value_of_size(words, k, unit);
  };
  const auto need = [&](std::size_t count) { need_values(words, count); };
  if (words[0] == "harries") {
    need(4);
    return SizeLaw::harries(
        HarriesParameters{number(1, "m"), number(2, ""), number(3, ""), number(4, "")}, limits);
  }
  if (words[0] == "power") {
    need(2);
    return SizeLaw::power(PowerParameters{number(1, ""), number(2, "")}, limits);
  }
  if (words[0] == "table") {
    need(1);
    return SizeLaw::table(read_size_table_file(words[1]), limits);
  }
  if (words[0] == "bands") return size_bands(words, limits);
  if (words[0] == "uniform") {
    need(1);
    return SizeLaw::uniform(number(1, "m"));
  }
  if (words[0] == "import") {
    need(1);
    return SizeLaw::table({{0.0, limits.smallest}}, limits);  // the limits alone count
  }
  if (words[0] == "target") {
    (void)size_target(args);
    return SizeLaw::table({{0.0, limits.smallest}}, limits);  // until the rock is cut
  }
  throw InputError(std::string(kStyle) +
                   ": size must be harries, power, table, bands, uniform, target or import, got '" +
                   words[0] + "'");
}

std::optional<SizeTarget> CreateBlocks::size_target(const ArgValues& args) const {
  const std::vector<std::string>& words = args.groups("size").front();
  if (words[0] != "target") return std::nullopt;
  const auto number = [&](std::size_t k, const char* unit) {
    return parse_real(kStyle, "size target " + words[1], words[k], unit, Range::positive());
  };
  if (words[1] == "kuz_ram" && words.size() == 4) {
    return SizeTarget::kuz_ram(number(2, "m"), number(3, ""));
  }
  if (words[1] == "swebrec" && words.size() == 5) {
    return SizeTarget::swebrec(number(2, "m"), number(3, "m"), number(4, ""));
  }
  throw InputError(std::string(kStyle) +
                   ": size target must be followed by 'kuz_ram x50 n' or 'swebrec x50 xmax b'");
}

std::size_t CreateBlocks::most_blocks(const ArgValues& args) const {
  if (args.integer("max_blocks") > 0) return static_cast<std::size_t>(args.integer("max_blocks"));
  // Measured peaks: 12 kB a block while cutting, 0.7 kB a sphere in LIGGGHTS and contact lists.
  const double bytes_per_block =
      12e3 + 0.7e3 * static_cast<double>(args.integer("spheres_per_block"));
  const double installed =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  return static_cast<std::size_t>(std::min(0.5 * installed / bytes_per_block, 5e6));
}

TessellationOptions CreateBlocks::options(LAMMPS_NS::Region& rock, const ArgValues& args) const {
  if (rock.bboxflag == 0) {
    throw InputError(std::string(kStyle) + ": region '" + rock.id + "' must be bounded");
  }
  TessellationOptions what;
  what.lo = {rock.extent_xlo, rock.extent_ylo, rock.extent_zlo};
  what.hi = {rock.extent_xhi, rock.extent_yhi, rock.extent_zhi};
  const Vec3 box_lo(domain->boxlo), box_hi(domain->boxhi);
  if ((what.lo.array() < box_lo.array()).any() || (what.hi.array() > box_hi.array()).any()) {
    throw InputError(std::string(kStyle) + ": region '" + rock.id +
                     "' must lie inside the simulation box");
  }
  what.holes = holes(args);
  refuse_overlapping_holes(what.holes);
  what.size = size_law(args);
  what.superpose = args.flag("superpose");
  if (what.superpose && args.groups("size").front()[0] != "harries") {
    throw InputError(std::string(kStyle) + ": superpose yes needs size harries");
  }
  for (const JointPlane& plane : joint_planes(args))
    what.planes.push_back({plane.point, plane.normal});
  what.seed = static_cast<unsigned long>(args.integer("seed"));
  what.sweeps = static_cast<int>(args.integer("sweeps"));
  what.max_blocks = most_blocks(args);
  if (std::strcmp(rock.style, "block") == 0 && rock.interior != 0) return what;
  what.region.inside = [&rock](const Vec3& p) { return rock.match(p.x(), p.y(), p.z()) != 0; };
  what.region.surface_points = [&rock](const Vec3& p, double cutoff) {
    const int count = rock.surface(p.x(), p.y(), p.z(), cutoff);
    std::vector<Vec3> points;
    for (int c = 0; c < count; ++c) {
      const auto& hit = rock.contact[c];
      points.push_back(p - Vec3(hit.delx, hit.dely, hit.delz));
    }
    return points;
  };
  return what;
}

SupportRule CreateBlocks::support(const ArgValues& args) const {
  std::vector<std::pair<Support, LAMMPS_NS::Region*>> rules;
  for (const auto& words : args.groups("support")) {
    if (words[0] != "fixed" && words[0] != "mirror") {
      throw InputError(std::string(kStyle) + ": support must be fixed or mirror, got '" + words[0] +
                       "'");
    }
    rules.emplace_back(words[0] == "fixed" ? Support::fixed : Support::mirror, &region(words[1]));
  }
  return [rules](const Vec3& at) {
    for (const auto& [kind, where] : rules) {
      if (where->match(at.x(), at.y(), at.z()) != 0) return kind;
    }
    return Support::free;
  };
}

/// Of the other cuts rank 0 alone knows when and over which seeds they sweep.
bool CreateBlocks::sweeps_are_shared(const ArgValues& args) const {
  const std::string& size = args.groups("size").front().front();
  const bool plain = args.word("cut") == "voronoi" && size != "import" && size != "target";
  return comm->nprocs > 1 && plain && !args.given("joint_set") && !args.given("sliver");
}

/// Rank 0 sweeps later, as it cuts; what goes wrong it reports.
void CreateBlocks::share_sweeps_of_rank_0(TessellationOptions& what) const {
  what.team.rank = comm->me;
  what.team.ranks = comm->nprocs;
  what.team.gather = [this](const std::vector<double>& mine) {
    return engine::gather_all(mine, world);
  };
  auto most = static_cast<std::uint64_t>(what.max_blocks);  // other nodes may have less memory
  MPI_Bcast(&most, 1, MPI_UINT64_T, 0, world);
  what.max_blocks = static_cast<std::size_t>(most);
  if (comm->me == 0) return;
  try {
    share_sweeps(what);
  } catch (const std::exception&) {
  }
}

CreateBlocks::Model CreateBlocks::cut(const TessellationOptions& what,
                                      const ArgValues& args) const {
  Model model;
  const bool by_sets = args.word("cut") == "joint_sets";
  if (!by_sets && (args.given("joint_set") || args.given("sliver")))
    throw InputError("joint_set and sliver need 'cut joint_sets'");
  if (by_sets && size_target(args))
    throw InputError("size target needs 'cut voronoi': joint sets halve block sizes in steps");
  const std::vector<std::string>& size = args.groups("size").front();
  if (size[0] == "import") {
    if (args.given("cut")) throw InputError("size import leaves nothing to cut: no 'cut'");
    model.rock = import_blocks(size[1], what);
  } else if (by_sets) {
    model.rock = cut_by_joint_sets(what, joint_sets(args));
  } else if (const auto target = size_target(args)) {
    FittedCut fitted =
        tessellate_to_target(what, *target, {args.real("block_min"), args.real("block_max")});
    model.rock = std::move(fitted.cut);
    model.sizes = std::move(fitted.comparison);
    model.why_missed = std::move(fitted.why_missed);
  } else {
    model.rock = tessellate(what);
  }
  if (model.rock.blocks.empty())
    throw InputError("the region holds no block; block sizes are too large for it");
  const auto spheres = static_cast<int>(args.integer("spheres_per_block"));
  for (const Block& block : model.rock.blocks) {
    model.bodies.push_back(
        rigid_body(block, args.real("density"), spheres, args.real("sphere_growth")));
  }
  model.largest_overlap = largest_overlap(model.rock.blocks, model.bodies);
  return model;
}

std::vector<char> CreateBlocks::hand_out(const Model& model) const {
  std::array<double, 6> box{};
  std::copy_n(domain->sublo, 3, box.begin());
  std::copy_n(domain->subhi, 3, box.begin() + 3);
  std::vector<std::array<double, 6>> boxes(static_cast<std::size_t>(comm->nprocs));
  MPI_Gather(box.data(), 6, MPI_DOUBLE, boxes.data(), 6, MPI_DOUBLE, 0, world);

  std::vector<engine::ByteWriter> outgoing(boxes.size());
  const auto owner = [&](const Vec3& at) {
    for (std::size_t rank = 0; rank < boxes.size(); ++rank) {
      const Vec3 lo(boxes[rank].data()), hi(boxes[rank].data() + 3);
      if ((at.array() >= lo.array()).all() && (at.array() < hi.array()).all()) return rank;
    }
    return std::size_t{0};
  };
  std::vector<std::vector<const Facet*>> facets_of(model.bodies.size());
  const auto place = [&](int tag) { return static_cast<std::size_t>(tag - first_tag_); };
  for (const Facet& facet : model.facets.facets) {
    facets_of[place(facet.tag_i)].push_back(&facet);
    if (facet.tag_j != kGroundTag) facets_of[place(facet.tag_j)].push_back(&facet);
  }
  std::vector<std::vector<BoundaryFace>> faces_of(model.bodies.size());
  for (const BoundaryFace& face : model.facets.faces) faces_of[place(face.tag)].push_back(face);

  int atom_tag = first_atom_tag_;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const RigidBody& body = model.bodies[b];
    engine::ByteWriter& out = outgoing[owner(body.centre)];
    out.put(first_tag_ + static_cast<int>(b));
    out.put(atom_tag);
    out.put(body.mass);
    out.put(body.volume);
    out.put(body.centre);
    out.put(body.inertia);
    out.put(body.axes);
    out.put_all(body.spheres);
    out.put_all(faces_of[b]);
    out.put(facets_of[b].size());
    for (const Facet* facet : facets_of[b]) out.put(*facet);
    atom_tag += static_cast<int>(body.spheres.size());
  }
  const auto buffers = engine::bytes_of(outgoing);
  return engine::exchange_bytes(buffers, world).front();
}

void CreateBlocks::create(const std::vector<char>& mine, const std::vector<Hole>& holes,
                          const ArgValues& args, int blocks) {
  std::vector<BlockRecord> records;
  std::vector<Facet> facets;
  std::vector<BoundaryFace> faces;
  for (engine::ByteReader in(mine); !in.empty();) {
    RigidBody body;
    const int tag = in.get<int>(), atom_tag = in.get<int>();
    body.mass = in.get<double>();
    body.volume = in.get<double>();
    body.centre = in.get<Vec3>();
    body.inertia = in.get<Vec3>();
    body.axes = in.get<Mat3>();
    body.spheres = in.get_all<Sphere>();
    create_body(body, tag, atom_tag, args);
    records.push_back({tag, body.volume, body.mass, body.centre, body.axes, {}});
    for (const BoundaryFace& face : in.get_all<BoundaryFace>()) faces.push_back(face);
    for (const Facet& facet : in.get_all<Facet>()) facets.push_back(facet);
  }
  int natoms = atom->nlocal;
  double local = natoms, all = 0.0;
  MPI_Allreduce(&local, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  atom->natoms = static_cast<LAMMPS_NS::bigint>(all);
  if (atom->map_style != 0) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
  engine::find_multisphere(*lmp)->add_body_finalize();
  FixMuckpileBlocks::find_or_make(*lmp).add(records, facets, faces, holes, blocks);
}

void CreateBlocks::create_body(const RigidBody& body, int tag, int first_atom_tag,
                               const ArgValues& args) {
  const auto count = static_cast<int>(body.spheres.size());
  const int type = static_cast<int>(args.integer("type"));
  double reach = 0.0;
  std::vector<Vec3> displace(body.spheres.size());
  std::vector<double*> rows(body.spheres.size());
  for (std::size_t k = 0; k < body.spheres.size(); ++k) {
    const Sphere& sphere = body.spheres[k];
    displace[k] = body.axes.transpose() * (sphere.centre - body.centre);
    rows[k] = displace[k].data();
    reach = std::max(reach, displace[k].norm() + sphere.radius);
    Vec3 at = sphere.centre;
    atom->avec->create_atom(type, at.data());
    const int m = atom->nlocal - 1;
    atom->tag[m] = first_atom_tag + static_cast<int>(k);
    atom->mask[m] = 1;
    atom->radius[m] = sphere.radius;
    atom->density[m] = args.real("density");
    atom->rmass[m] = body.mass;
    for (int f = 0; f < modify->nfix; ++f) {
      if (modify->fix[f]->create_attribute != 0) modify->fix[f]->set_arrays(m);
    }
    multisphere_->set_body_displace(m, rows[k], tag, 1.0 / count);
  }
  Vec3 centre = body.centre, zero = Vec3::Zero(), inertia = body.inertia;
  Mat3 axes = body.axes;
  std::array<bool, 3> free{true, true, true};
  multisphere_->data().add_body(count, centre.data(), zero.data(), reach, zero.data(), zero.data(),
                                body.mass, args.real("density"), type, 1, inertia.data(),
                                axes.col(0).data(), axes.col(1).data(), axes.col(2).data(),
                                rows.data(), free.data(), free.data());
  auto* ids = multisphere_->data().prop().getElementProperty<LAMMPS_NS::ScalarContainer<int>>(
      "id_multisphere");
  ids->set(multisphere_->n_body() - 1, tag);
}

void CreateBlocks::report(const Model& model, double seconds) const {
  std::vector<double> sizes, ratios;
  double volume = 0.0;
  for (const Block& block : model.rock.blocks) {
    sizes.push_back(std::cbrt(block.mass.volume));
    ratios.push_back(sizes.back() / block.target_size);
    volume += block.mass.volume;
  }
  std::size_t spheres = 0, joints = 0;
  for (const RigidBody& body : model.bodies) spheres += body.spheres.size();
  for (const Facet& facet : model.facets.facets) joints += facet.kind == FacetKind::joint ? 1 : 0;
  std::array<char, 1024> text{};
  std::snprintf(text.data(), text.size(),
                "create_blocks: %zu blocks, %zu spheres, %zu joints, %zu supported and %zu free or "
                "loaded faces\n"
                "  block size by number: smallest %.4g, 10 %% %.4g, 50 %% %.4g, 90 %% %.4g, "
                "largest %.4g m; by mass: 20 %% "
                "%.4g, 50 %% %.4g, 80 %% %.4g m; over target %.3f .. %.3f (10 and 90 %%)\n"
                "  volume %.9g m3 in blocks, %.4g m3 removed; largest initial sphere overlap %.3g "
                "of a radius; %.2f s\n",
                sizes.size(), spheres, joints, model.facets.facets.size() - joints,
                model.facets.faces.size(), quantile(sizes, 0.0), quantile(sizes, 0.1),
                quantile(sizes, 0.5), quantile(sizes, 0.9), quantile(sizes, 1.0),
                size_by_volume(sizes, 0.2), size_by_volume(sizes, 0.5), size_by_volume(sizes, 0.8),
                quantile(ratios, 0.1), quantile(ratios, 0.9), volume,
                model.rock.statistics.void_volume, model.largest_overlap, seconds);
  engine::print_once(*lmp, text.data());
  if (model.rock.statistics.merged_parts > 0) {
    engine::print_once(*lmp, "  " + std::to_string(model.rock.statistics.merged_parts) +
                                 " parts between joint planes are too thin for a block: they stay "
                                 "with the rock beside them, where the joint ends\n");
  }
  if (model.rock.statistics.lost_parts > 0) {
    engine::print_once(*lmp, "  " + std::to_string(model.rock.statistics.lost_parts) +
                                 " parts between joint planes are left out, since no seed fell "
                                 "into their " +
                                 number_text(model.rock.statistics.lost_volume) +
                                 " m3 of rock: take smaller blocks\n");
  }
  report_filling(model);
  if (model.sizes) report_target(*model.sizes, model.why_missed);
}

/// Means over some blocks, evenly chosen.
void CreateBlocks::report_filling(const Model& model) const {
  constexpr std::size_t kBlocks = 200;
  const std::size_t step = std::max<std::size_t>(1, model.bodies.size() / kBlocks);
  FillingQuality mean;
  double count = 0.0;
  for (std::size_t b = 0; b < model.bodies.size(); b += step, count += 1.0) {
    const FillingQuality one = filling_quality(model.rock.blocks[b].shape, model.bodies[b].spheres);
    mean.coverage += one.coverage;
    mean.surface_deviation += one.surface_deviation;
  }
  std::ostringstream text;
  text.precision(3);
  text << "  spheres cover " << 100.0 * mean.coverage / count
       << " % of their block; its surface lies " << 100.0 * mean.surface_deviation / count
       << " % of V^(1/3) off theirs (means of " << count << " blocks)\n";
  engine::print_once(*lmp, text.str());
}

void CreateBlocks::report_target(const SizeComparison& sizes, const std::string& why) const {
  std::ostringstream text;
  text.precision(4);
  text << "  size curve by mass, target and achieved [m]:";
  for (const SizeComparison::Point& point : sizes.points) {
    text << "\n    P" << std::lround(100.0 * point.share) << ' ' << point.target << ' '
         << point.achieved;
  }
  text << "\n  greatest difference between block_min and block_max: "
       << 100.0 * sizes.greatest_difference << " % of the mass";
  text << (sizes.good()
               ? "\n"
               : "; the target is missed (allowed: 3 %, and 5 % for P20, P50, P80): " + why + "\n");
  engine::print_once(*lmp, text.str());
}

}  // namespace muckpile
