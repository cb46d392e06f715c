// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks from a VTK file: what was written comes back, shared faces are found, and cells that
// cannot be blocks are named. Scope: scenes of a few hundred blocks and files of two or three
// cells; lengths in metres.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "bond/build/facet_builder.h"
#include "cut_checks.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/files/block_file.h"
#include "geometry/files/block_import.h"
#include "geometry/files/cell_file.h"
#include "input_error_of.h"
#include "shapes.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

TessellationOptions blast_options() {
  TessellationOptions options;
  options.hi = Vec3(3.0, 2.0, 2.0);
  options.holes = {{Vec3(1.4, 1.0, 0.6), Vec3(1.5, 1.1, 1.4), 0.25}};
  options.size = SizeLaw::power({0.8, 1.0}, {0.25, 0.6});
  options.sweeps = 5;
  return options;
}

FacetSet facets_of(const std::vector<Block>& blocks) {
  return build_facets(blocks, 1, [](const Vec3&) { return Support::free; });
}

void expect_same_facets(const FacetSet& a, const FacetSet& b) {
  ASSERT_EQ(a.facets.size(), b.facets.size());
  for (std::size_t k = 0; k < a.facets.size(); ++k) {
    EXPECT_EQ(a.facets[k].tag_i, b.facets[k].tag_i);
    EXPECT_EQ(a.facets[k].tag_j, b.facets[k].tag_j);
    EXPECT_NEAR(a.facets[k].area, b.facets[k].area, 1e-10);
    EXPECT_LT((a.facets[k].arm_i - b.facets[k].arm_i).norm(), 1e-9);
    EXPECT_LT((a.facets[k].opening_i - b.facets[k].opening_i).norm(), 1e-9);
  }
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (std::size_t k = 0; k < a.faces.size(); ++k) {
    EXPECT_EQ(a.faces[k].hole, b.faces[k].hole);
    EXPECT_NEAR(a.faces[k].area, b.faces[k].area, 1e-10);
  }
}

void expect_round_trip(const Tessellation& cut, TessellationOptions rock) {
  rock.size = SizeLaw::power({1.0, 1.0}, {0.05, 2.0});  // the limits count
  const testing::TemporaryFolder folder;
  const std::string path = (folder.path() / "blocks.vtk").string();
  write_blocks(path, cut.blocks, 1, 2700.0);
  const Tessellation back = import_blocks(path, rock);
  ASSERT_EQ(back.blocks.size(), cut.blocks.size());
  for (std::size_t b = 0; b < cut.blocks.size(); ++b) {
    const Block &was = cut.blocks[b], &is = back.blocks[b];
    EXPECT_NEAR(is.mass.volume, was.mass.volume, 1e-10 * was.mass.volume);
    EXPECT_LT((is.mass.centroid - was.mass.centroid).norm(), 1e-10);
    EXPECT_EQ(is.shape.faces.size(), was.shape.faces.size());
  }
  expect_same_facets(facets_of(cut.blocks), facets_of(back.blocks));
  EXPECT_NEAR(back.statistics.hole_volume[0], cut.statistics.hole_volume[0], 1e-9);
}

TEST(BlockImport, BringsBackAVoronoiCut) {
  expect_round_trip(tessellate(blast_options()), blast_options());
}

TEST(BlockImport, BringsBackACutByJointSets) {
  const JointSetCut how{{{Vec3(1.0, 0.1, 0.2)}, {Vec3(-0.1, 1.0, 0.1)}, {Vec3(0.2, 0.0, 1.0)}}};
  expect_round_trip(cut_by_joint_sets(blast_options(), how), blast_options());
}

std::string file_of(const std::string& cells) {
  return "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET UNSTRUCTURED_GRID\n" + cells;
}

std::vector<Block> blocks_of(const std::string& cells) {
  TextWords text(file_of(cells));
  return joined_blocks(read_cells(text, "test.vtk"));
}

/// A cube of 1 m and one of 0.5 m on the middle of its top, moved by `dx`, `dz`, as hexahedra.
std::string two_cubes(double dx, double dz) {
  std::ostringstream out;
  out << "POINTS 16 double\n0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\n";
  for (const double z : {1.0 + dz, 1.5 + dz}) {
    for (const auto& [x, y] : {std::pair(0.25, 0.25), {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}})
      out << x + dx << ' ' << y << ' ' << z << ' ';
  }
  out << "\nCELLS 2 18\n8 0 1 2 3 4 5 6 7\n8 8 9 10 11 12 13 14 15\nCELL_TYPES 2\n12\n12\n";
  return out.str();
}

TEST(BlockImport, FacetIsWhatTwoFacesShare) {
  const std::vector<Block> blocks = blocks_of(two_cubes(0.5, 0.0));  // half of it over the edge
  ASSERT_EQ(blocks.size(), 2u);
  for (const Block& block : blocks) test::expect_convex_and_closed(block);
  EXPECT_NEAR(test::expect_shared_faces(blocks), 2.0 * 0.25 * 0.5, 1e-12);
}

TEST(BlockImport, BlocksApartShareNothing) {
  EXPECT_EQ(test::expect_shared_faces(blocks_of(two_cubes(0.0, 0.01))), 0.0);
}

std::string refusal(const std::string& cells) {
  return input_error_of([&] { (void)blocks_of(cells); });
}

TEST(BlockImport, NamesWhatIsWrong) {
  EXPECT_EQ(refusal(two_cubes(0.0, -0.1)), "block import: cells 1 and 2 overlap by 0.025 m3");
  const std::string tetra = "POINTS 5 double\n0 0 0 1 0 0 0 1 0 0 0 1 0.2 0.2 0.2\n";
  EXPECT_EQ(refusal(tetra + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"), "");
  EXPECT_EQ(refusal(tetra + "CELLS 1 5\n4 0 1 2 9\nCELL_TYPES 1\n10\n"),
            "block import: cell 1 has a point that is not in the file");
  EXPECT_EQ(refusal(tetra + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n5\n"),
            "block import: cell 1 must be a polyhedron, tetrahedron, hexahedron, wedge or pyramid, "
            "got type '5'");
  EXPECT_EQ(refusal(tetra + "CELLS 1 5\n4 65536 3 0 1\nCELL_TYPES 1\n42\n"),
            "block import: cell 1 must have at most 65535 faces, got '65536'");
  EXPECT_EQ(refusal(tetra + "CELLS 1 14\n13 3 3 0 2 1 3 0 1 3 3 0 3 2\nCELL_TYPES 1\n42\n"),
            "block import: cell 1 is not closed");
  // the slanted face pushed in to the point 4
  EXPECT_EQ(refusal(tetra + "CELLS 1 27\n25 6 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 4 3 2 3 4 3 3 1 4\n"
                            "CELL_TYPES 1\n42\n"),
            "block import: cell 1 is not convex at its face 4");
  EXPECT_EQ(refusal("POINTS 1 double\n0 0"),
            "'test.vtk', line 6: a coordinate expected; the file ends there, as if it had been cut "
            "short");
  EXPECT_EQ(refusal("POINTS -3 double\n"),
            "'test.vtk', line 5: number of points must be >= 0 and <= 1000000000, got '-3'");
  TextWords no_vtk("hello\n");
  EXPECT_THROW((void)read_cells(no_vtk, "x"), InputError);
  TextWords new_vtk("# vtk DataFile Version 5.1\nt\nASCII\n");
  EXPECT_THROW((void)read_cells(new_vtk, "x"), InputError);
  TessellationOptions rock;
  EXPECT_THROW((void)import_blocks("/no/such/file.vtk", rock), InputError);
}

}  // namespace
}  // namespace muckpile
