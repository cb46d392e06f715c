// SPDX-License-Identifier: GPL-2.0-or-later
// What the words of create_blocks ask for; see the header.
#include "rock/cut_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "args/input_error.h"
#include "args/numbers.h"
#include "explosive/hole_table.h"
#include "geometry/holes/hole_overlap.h"
#include "rock/cut_table.h"
#include "rock/faults.h"
#include "rock/rock_surfaces.h"
#include "rock/zone_bodies.h"
#include "rock/zone_model.h"
#include "rock/zone_sizes.h"

namespace muckpile {
namespace {

using Words = std::vector<std::string>;

[[noreturn]] void refuse_cut(const std::string& text) { refuse(kCreateBlocks, text); }

SizeLimits size_limits(const ArgValues& args) {
  const SizeLimits limits{args.real("block_min"), args.real("block_max")};
  if (limits.largest < limits.smallest) {
    refuse_cut("block_max must be >= block_min (" + number_text(limits.smallest) + " m), got '" +
               number_text(limits.largest) + "'");
  }
  return limits;
}

/// Value k of `size LAW ...`.
double size_value(const Words& words, std::size_t k, const char* unit) {
  return cut_real("size " + words[0], words[k], unit, Range::closed(0.0, 1e9));
}

/// Fails unless `size LAW` has so many values behind it.
void need_values(const Words& words, std::size_t count) {
  if (words.size() == count + 1) return;
  refuse_cut("size " + words[0] + " takes " + std::to_string(count) + " value(s), got " +
             std::to_string(words.size() - 1));
}

SizeLaw size_bands(const Words& words, const SizeLimits& limits) {
  if (words.size() % 2 == 0) refuse_cut("size bands takes pairs of a radius and a size");
  SizeBands bands;
  for (std::size_t k = 1; k + 1 < words.size(); k += 2)
    bands.bands.emplace_back(size_value(words, k, "m"), size_value(words, k + 1, "m"));
  return SizeLaw::bands(bands, limits);
}

SizeLaw size_law(const Words& words, const SizeLimits& limits) {
  const auto number = [&](std::size_t k, const char* unit) { return size_value(words, k, unit); };
  if (words[0] == "harries") {
    need_values(words, 4);
    return SizeLaw::harries(
        HarriesParameters{number(1, "m"), number(2, ""), number(3, ""), number(4, "")}, limits);
  }
  if (words[0] == "power") {
    need_values(words, 2);
    return SizeLaw::power(PowerParameters{number(1, ""), number(2, "")}, limits);
  }
  if (words[0] == "table") {
    need_values(words, 1);
    return SizeLaw::table(read_size_table_file(words[1]), limits);
  }
  if (words[0] == "bands") return size_bands(words, limits);
  if (words[0] == "uniform") {
    need_values(words, 1);
    return SizeLaw::uniform(number(1, "m"));
  }
  refuse_cut("size must be harries, power, table, bands, uniform, target or import, got '" +
             words[0] + "'");
}

SizeTarget size_target(const Words& words) {
  const auto number = [&](std::size_t k, const char* unit) {
    return cut_real("size target " + words[1], words[k], unit, Range::left_open(0.0, 1e3));
  };
  if (words.size() == 4 && words[1] == "kuz_ram")
    return SizeTarget::kuz_ram(number(2, "m"), number(3, ""));
  if (words.size() == 5 && words[1] == "swebrec")
    return SizeTarget::swebrec(number(2, "m"), number(3, "m"), number(4, ""));
  refuse_cut("size target must be followed by 'kuz_ram x50 n' or 'swebrec x50 xmax b'");
}

void read_size(CutOptions& options, const ArgValues& args) {
  if (!args.given("size")) refuse_cut("keyword 'size' is required");
  const Words& words = args.groups("size").front();
  options.limits = size_limits(args);
  options.rock.superpose = args.flag("superpose");
  if (options.rock.superpose && words[0] != "harries")
    refuse_cut("superpose yes needs size harries");
  if (words[0] != "import" && words[0] != "target") {
    options.rock.size = size_law(words, options.limits);
    return;
  }
  // Of the law only the limits count then.
  options.rock.size = SizeLaw::table({{0.0, options.limits.smallest}}, options.limits);
  if (words[0] == "target") {
    options.target = size_target(words);
    return;
  }
  need_values(words, 1);
  options.import_file = words[1];
}

/// Seven words from `first` on.
Hole hole_of(const std::string& keyword, const Words& words, std::size_t first) {
  std::array<double, 7> v{};
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] = cut_real(keyword, words[first + k], "m",
                    k < 6 ? place_range() : Range::left_open(0.0, 1e3));
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, v[6]};
}

void add_row(std::vector<Hole>& holes, const Words& words) {
  const long count = cut_whole("hole_row", words[0], Range::closed(1, 100000));
  Vec3 shift;
  for (int c = 0; c < 3; ++c)
    shift[c] = cut_real("hole_row", words[static_cast<std::size_t>(c) + 1], "m", place_range());
  const Hole first = hole_of("hole_row", words, 4);
  for (long k = 0; k < count; ++k) {
    const Vec3 by = static_cast<double>(k) * shift;
    holes.push_back({first.toe + by, first.collar + by, first.radius});
  }
}

void add_collars(std::vector<Collar>& collars, const HoleTable& table, const std::string& file) {
  std::set<std::string> known;
  for (const Deck& deck : table.decks())
    if (known.insert(deck.hole).second) collars.push_back({deck.hole, file, deck.hole_collar});
}

std::vector<Hole> crushed_zones(const ArgValues& args, std::vector<Collar>& collars) {
  std::vector<Hole> holes;
  for (const Words& words : args.groups("hole")) holes.push_back(hole_of("hole", words, 0));
  for (const Words& words : args.groups("hole_row")) add_row(holes, words);
  for (const Words& words : args.groups("hole_table")) {
    const double ratio = cut_real("hole_table", words[1], "", Range::closed(1.0, 20.0));
    const HoleTable table = HoleTable::read(words[0]);
    const std::vector<Hole> pattern = table.crushed_zones(ratio);
    holes.insert(holes.end(), pattern.begin(), pattern.end());
    add_collars(collars, table, words[0]);
  }
  refuse_overlapping_holes(holes);
  return holes;
}

JointSetCut joint_sets(const ArgValues& args) {
  JointSetCut how{{}, args.real("sliver")};
  for (const Words& words : args.groups("joint_set")) {
    JointSet set{normal_of_dip(cut_radians("joint_set", words[0], 90.0),
                               cut_radians("joint_set", words[1], 360.0))};
    if (words.size() > 2)
      set.spacing = cut_real("joint_set", words[2], "", Range::closed(0.1, 10.0));
    how.sets.push_back(set);
  }
  return how;
}

void read_cut(CutOptions& options, const ArgValues& args) {
  if (args.word("cut") == "joint_sets") {
    options.joint_sets = joint_sets(args);
  } else if (args.given("joint_set") || args.given("sliver")) {
    refuse_cut("joint_set and sliver need 'cut joint_sets'");
  }
  if (args.given("rings_from") && (options.joint_sets || options.import_file))
    refuse_cut("rings_from needs 'cut voronoi'");
  options.rock.rings_from = args.real("rings_from");
  if (options.joint_sets && options.target)
    refuse_cut("size target needs 'cut voronoi': joint sets halve block sizes in steps");
  if (options.import_file && args.given("cut"))
    refuse_cut("size import leaves nothing to cut: no 'cut'");
}

/// As many as half of the memory [bytes] holds, at most 5 million. Measured peaks, as a run is
/// set up: 12.5 kB a block with five spheres, of that 0.7 kB a sphere in LIGGGHTS and contact
/// lists. What sphere_gap adds is not known before the cut.
std::size_t blocks_in_memory(std::size_t memory, int spheres_per_block) {
  const double bytes_per_block = 9e3 + 0.7e3 * spheres_per_block;
  return static_cast<std::size_t>(
      std::min(0.5 * static_cast<double>(memory) / bytes_per_block, 5e6));
}

void read_spheres(CutOptions& options, const ArgValues& args) {
  constexpr double kSmallest = 0.2;  // below, kMostSpheres would do no more than this
  options.spheres.count = static_cast<int>(args.integer("spheres_per_block"));
  options.spheres.growth = args.real("sphere_growth");
  const double gap = args.real("sphere_gap");
  if (gap == 0.0) return;
  if (gap < kSmallest)
    refuse_cut("sphere_gap must be 0 or >= " + number_text(kSmallest) + ", got '" +
               number_text(gap) + "'");
  options.spheres.surface_gap = gap * options.limits.smallest;
}

void read_muck(CutOptions& options, const ArgValues& args) {
  if (!args.given("muck")) return;
  const Words& words = args.groups("muck").front();
  if (words[0] == "none") return;
  MuckSource muck;
  muck.folder = words[0];
  for (int c = 0; c < 3; ++c)
    muck.shift[c] = cut_real("muck", words[static_cast<std::size_t>(c) + 1], "m", place_range());
  muck.moved_only = words[4] == "moved";
  if (!muck.moved_only && words[4] != "all")
    refuse_cut("muck must have 'all' or 'moved' behind its shift, got '" + words[4] + "'");
  if (words.size() > 5) muck.overlap = cut_real("muck", words[5], "", Range::closed(0.0, 1.0));
  if (words.size() > 6) muck.floor = cut_real("muck", words[6], "m", place_range());
  muck.least_size = 0.5 * options.limits.smallest;
  options.muck = muck;
}

CutOptions read(const ArgValues& args, std::size_t memory) {
  CutOptions options;
  options.density = args.real("density");
  read_size(options, args);
  read_spheres(options, args);
  read_cut(options, args);
  read_mine_frame(options, args);
  read_surfaces(options, args);
  options.burden = args.real("burden");
  options.burdens_wanted =
      options.burden > 0.0 || !options.surfaces.empty() || args.word("burden_file") != "none";
  TessellationOptions& rock = options.rock;
  rock.holes = crushed_zones(args, options.collars);
  for (const Words& words : args.groups("joint_plane"))
    options.natural_joints.push_back(joint_plane_of(words));
  for (const JointPlane& plane : options.natural_joints)
    rock.planes.push_back({plane.point, plane.normal});
  for (const Words& words : args.groups("natural_joints")) {
    if (const auto set = natural_joint_set_of(words, options.limits))
      options.natural_joint_sets.push_back(*set);
  }
  for (const Words& words : args.groups("zone")) options.zones.push_back(rock_zone_of(words));
  read_zone_bodies(options);
  read_zone_model(options, args);
  check_zone_sizes(options);
  read_faults(options, args);
  read_muck(options, args);
  rock.seed = static_cast<unsigned long>(args.integer("seed"));
  rock.sweeps = static_cast<int>(args.integer("sweeps"));
  rock.max_blocks = args.integer("max_blocks") > 0
                        ? static_cast<std::size_t>(args.integer("max_blocks"))
                        : blocks_in_memory(memory, options.spheres.count);
  options.round_walls = args.word("wall") == "round";
  return options;
}

}  // namespace

std::vector<double> CutOptions::densities() const {
  std::vector<double> all{density};
  for (const RockZone& zone : zones) all.push_back(zone.density);
  return all;
}

CutOptions cut_options(const ArgValues& args, std::size_t memory) {
  try {
    return read(args, memory);
  } catch (const InputError& error) {
    throw InputError(in_create_blocks(error.what()));
  }
}

}  // namespace muckpile
