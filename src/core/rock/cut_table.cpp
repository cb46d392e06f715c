// SPDX-License-Identifier: GPL-2.0-or-later
// The keywords of create_blocks; see the header.
#include "rock/cut_table.h"

#include <cmath>

#include "args/numbers.h"
#include "geometry/cut/hole_rings.h"
#include "geometry/cut/tessellation.h"
#include "geometry/surface/mine_words.h"

namespace muckpile {
namespace {

constexpr int kMostBands = 20;

}  // namespace

const ArgTable& cut_table() {
  static const ArgTable args =
      add_mine_words(
          ArgTable(kCreateBlocks)
              .real("density", "kg/m3", Range::closed(100.0, 30000.0), std::nullopt,
                    "density of the rock beside the zones")
              .group(
                  "size", 2, 2 * kMostBands + 1, false,
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
              .word("surface", {}, "none",
                    "file of a closed surface (.stl, or faces of .dxf) that holds the rock")
              .word(
                  "terrain", {}, "none",
                  "file of a ground surface, one height everywhere (.xyz, .csv, .txt, .las, .stl, "
                  ".dxf), above which there is no rock"),
          "the files of `surface`, `terrain`, `block_model`, `fault` and zones")
          .real("burden", "m", Range::closed(0.0, 1e3), 0.0,
                "of the plan: the report has the burden of each hole along its charge, and warns "
                "below 0.6 and above 1.5 of this; 0: only with `surface` or `terrain`, no "
                "warning")
          .word("burden_file", {}, "none",
                "CSV file for the burdens, which `muckpile-post burden` draws, or none")
          .flag("superpose", false,
                "with `size harries`: the cracks of all charges add up, not those of the nearest "
                "alone")
          .real("block_min", "m", Range::closed(1e-5, 1e3), std::nullopt, "smallest block size")
          .real("block_max", "m", Range::closed(1e-5, 1e3), std::nullopt, "largest block size")
          .group("hole", 7, 7, true,
                 "crushed zone of one charge: toe x y z, collar x y z, radius [m]; its rock is "
                 "removed")
          .group("hole_row", 11, 11, true,
                 "N dx dy dz, then the words of `hole`: N equal holes, each shifted by (dx, dy, "
                 "dz) [m] from the one before")
          .group(
              "hole_table", 2, 2, false,
              "FILE RATIO: the pattern of a CSV file, one crushed zone per charged deck, of RATIO "
              "hole radii (>= 1) unless the file says")
          .group("support", 2, 2, true,
                 "`fixed REGION` or `mirror REGION`: how boundary faces with their centroid in "
                 "that region are supported; all others are free")
          .group(
              "joint_plane", 6, 7, true,
              "natural joint: x y z of a point [m], dip and dip direction [degrees; y is north, x "
              "is east], number of the `joint_class` of fix muckpile/joint (0: none), and "
              "optionally a radius about the point [m] beyond which its facets are like all others")
          .group("natural_joints", 4, 11, true,
                 "a set of natural joints at random places: dip and dip direction [degrees], mean "
                 "spacing [m; >= block_min, or 0: no such set], number of the `joint_class`, and "
                 "optionally "
                 "`persistence SHARE RADIUS` (joint is that share of each plane, in discs of that "
                 "radius [m; >= block_min]), `fisher K` (scatter of the normals, 5 to 1e6), "
                 "`spacings exponential` (default) or `spacings even`")
          .group("fault", 2, 2, true,
                 "FILE N: surface of triangles (.stl, faces of .dxf), open or closed, whose facets "
                 "have the `joint_class` N of fix muckpile/joint (0: none)")
          .word("joint_words", {}, "none",
                "name of the variable of style `index` that holds words of fix muckpile/joint: "
                "a joint_class or a zone that the rock asks for and they lack is told before the "
                "cut, of a script with one create_blocks; none: the fix tells it, after the cut")
          .group(
              "block_model", 1, 2, false,
              "FILE: CSV file of cells of rock, for zones with `model`; with `partial` behind it, "
              "rock without a cell has `density`, else it is refused")
          .group("zone", 3, 13, true,
                 "zone of other rock: NAME, its density [kg/m3], where it is, and optionally "
                 "`class N` "
                 "(number of the `joint_class` of its plane borders; 0: none) and `size_factor F` "
                 "(block size over that of `size`; 0.1 to 10). Where: `above` or "
                 "`below` x y z dip direction (a point of its border [m], dip and dip direction "
                 "[degrees]), `layer` x y z dip direction thickness (above that plane, [m]), "
                 "`region ID`, `inside FILE` (of a closed surface, .stl or faces of "
                 ".dxf), or `model` (cells of `block_model` with that name). A block is of the "
                 "first zone that holds its centroid; the cut "
                 "follows plane borders")
          .group("muck", 5, 7, false,
                 "FOLDER dx dy dz, `all` or `moved`, and optionally SHARE (0) and FLOOR (none): "
                 "the blocks of the last snapshot of the run in FOLDER, shifted by (dx, dy, dz) "
                 "[m], lie loose in front of the rock; `all`, or those that have `moved` by more "
                 "than V^(1/3). At most SHARE (0 to 1) of their mass may lie in the rock, below "
                 "the height FLOOR [m] or beyond the box, and is left out. FOLDER `none`: no muck")
          .word("cut", {"voronoi", "joint_sets"}, "voronoi",
                "how the rock is cut: graded Voronoi blocks, or joint sets in concentric bands")
          .group("joint_set", 2, 3, true,
                 "for `cut joint_sets`, two or three times: dip and dip direction [degrees], and "
                 "optionally the spacing relative to the other sets' (1; 0.1 to 10)")
          .real("sliver", "", Range::closed(0.0, 0.3), kThinnestPart,
                "for `cut joint_sets`: no block gets 3 volume / surface below this share of the "
                "size asked for")
          .real("rings_from", "", Range::closed(kImagesTooLarge, kImagesFail), kImagesTooLarge,
                "for `cut voronoi`: block size over radius of a crushed zone from which on blocks "
                "stand in rings")
          .word("wall", {"round", "blocks"}, "round",
                "of a crushed zone: `round`, it gives way to a pressure as that of a round hole "
                "does; `blocks`, the joints there are as stiff as all others")
          .integer("spheres_per_block", "", Range::closed(1, 64), 8,
                   "contact spheres in each block, at least")
          .real("sphere_growth", "", Range::closed(1.0, 1.5), 1.0,
                "radius of the contact spheres over that of spheres inside the block; overlaps at "
                "the start carry no force")
          .real("sphere_gap", "", Range::closed(0.0, 100.0), 0.0,
                "share of `block_min` (>= 0.2) that no place of a block's surface lies farther "
                "from its contact spheres: blocks where `spheres_per_block` leave larger gaps have "
                "more, 64 at most; 0: all have the same number")
          .integer("type", "", Range::closed(1, 1000), 1, "atom type of the spheres")
          .integer("seed", "", Range::closed(1, 2147483647), 1, "seed of the cut")
          .integer("sweeps", "", Range::closed(0, 200), 20, "size-weighted Lloyd sweeps")
          .integer("max_blocks", "", Range::closed(0, 100000000), 0,
                   "refuse to make more blocks; 0: as many as half of this machine's memory holds, "
                   "at most 5 million")
          .word("file", {}, "none", "VTK file for the blocks in the start configuration, or none");
  return args;
}

double cut_real(const std::string& keyword, const std::string& word, const char* unit,
                const Range& range) {
  return parse_real(kCreateBlocks, keyword, word, unit, range);
}

long cut_whole(const std::string& keyword, const std::string& word, const Range& range) {
  return parse_integer(kCreateBlocks, keyword, word, "", range);
}

double cut_radians(const std::string& keyword, const std::string& word, double most_degrees) {
  return cut_real(keyword, word, "deg", Range::closed(0.0, most_degrees)) * M_PI / 180.0;
}

std::string in_create_blocks(const std::string& message) {
  const std::string name(kCreateBlocks);
  return message.rfind(name, 0) == 0 ? message : name + ": " + message;
}

}  // namespace muckpile
