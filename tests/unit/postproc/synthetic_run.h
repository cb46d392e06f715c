// SPDX-License-Identifier: GPL-2.0-or-later
// Made-up runs: rock of equal cubes, and a pile or crater built from them cube by cube, so every
// measure is known. Scope: tests only. The dumps are written as the engine writes them; blocks.vtk
// by the same function.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geometry/block_model.h"
#include "io/blocks_file.h"
#include "io/snapshot.h"
#include "temporary_folder.h"

namespace muckpile::testing {

inline constexpr double kCube = 0.5;        // edge [m]
inline constexpr double kDensity = 2700.0;  // [kg/m3]

// Cube of edge kCube with its lower corner here [m].
Block cube_at(const Vec3& low);
// Cubes that fill a box; its sides are whole numbers of cubes.
std::vector<Block> cubes_in(const Vec3& low, const Vec3& high);
// The same blocks as the post-processor reads them, ids from 1.
std::vector<StartBlock> as_start_blocks(const std::vector<Block>& blocks);

// A bench 10.5 m high, 5 m burden, 2 m wide, cubes from x = -8 to 0 and z = -1 to 10.5, whose
// burden prism has been moved to a pile in front of the face: steps of two cubes, 28 columns of 14,
// 14, 13, 13 ... 1, 1 cubes, one layer every 0.65 m. So: 210 cubes in each of 4 rows, swell
// 0.65/0.5, height 9.1 m, toe 14 m, slope 0.65 m per m.
struct BenchRun {
  std::vector<Block> shapes;
  std::vector<StartBlock> blocks;
  Snapshot last;
};
inline constexpr double kBurden = 5.0, kBenchHeight = 10.5, kLayer = 0.65;
inline constexpr int kSteps = 14;
BenchRun bench_run();

// Cubes in |x|, |y| < 10 m, z from -5 to 0. Those within 4 m of the axis and above -2 m (by centre)
// have been thrown 20 m along x.
BenchRun crater_run();

// Leans the rock: rows shift towards -x with height, so that a face x = 0 stands at this angle.
void shear(std::vector<Block>& blocks, double degrees);

// Puts the id of a run where the engine puts it: the title of blocks.vtk, the first line of a
// snapshot, the last column of history.csv, a key of run.json and scene.json.
void mark_with_run(const std::filesystem::path& path, const std::string& id);
void write_snapshot(const std::filesystem::path& path, const std::vector<StartBlock>& blocks,
                    const Snapshot& snapshot);
// The dump/ folder of a bench: blocks, scene, history, run and three snapshots; in the middle one
// the prism moves at 6 m/s along x and its two outer layers of cubes at 14 m/s.
void write_bench(const std::filesystem::path& folder);
// Puts the floor of that bench on a surveyed slope, which falls by `fall` per metre from the toe
// on, and its pile with it. dump/floor.stl has the slope, and behind it what the rock stands on.
void put_on_slope(const std::filesystem::path& folder, double fall);
void write_crater(const std::filesystem::path& folder);
// The pile of the bench alone, as a heap on the floor in front of the symmetry plane x = 0.
void write_heap(const std::filesystem::path& folder);

}  // namespace muckpile::testing
