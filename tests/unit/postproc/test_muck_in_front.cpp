// SPDX-License-Identifier: GPL-2.0-or-later
// Muck that lay in front of the rock is in pictures and in no measure of the blasted rock.
// Scope: the made-up bench with and without a row of cubes in front of it.
#include <gtest/gtest.h>

#include "args/input_error.h"
#include "geometry/files/block_file.h"
#include "input_error_of.h"
#include "report/block_colours.h"
#include "report/reports.h"
#include "report/run_data.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kMuckMoves = 3.0;  // along x [m]

/// Twenty cubes far in front of the bench, which the blast pushes on.
std::vector<Block> muck_cubes() { return cubes_in({20.0, -1.0, 0.0}, {22.5, 1.0, 0.5}); }

void add_muck(const std::filesystem::path& dump) {
  BenchRun run = bench_run();
  const std::vector<Block> muck = muck_cubes();
  std::vector<Block> all = run.shapes;
  all.insert(all.end(), muck.begin(), muck.end());
  const double density[] = {kDensity};
  const std::vector<double> masses(muck.size(), 2000.0 * kCube * kCube * kCube);
  write_blocks((dump / "blocks.vtk").string(), all, 1, density, {}, "", masses);
  for (const auto& path : snapshot_files(dump)) {
    Snapshot snapshot = read_snapshot(path, run.blocks);
    for (const StartBlock& block : as_start_blocks(muck)) {
      BlockState state = start_snapshot({block}).states.front();
      if (snapshot.time > 0.0) state.centre.x() += kMuckMoves;
      state.velocity.x() = 40.0;  // faster than any of the rock
      if (snapshot.time > 4.0) state.velocity.x() = 0.0;
      snapshot.states.push_back(state);
    }
    write_snapshot(path, as_start_blocks(all), snapshot);
  }
}

class MuckInFront : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const auto& path : {without_.path(), with_.path()}) write_bench(path);
    add_muck(with_.path() / "dump");
  }
  static nlohmann::ordered_json summary(const TemporaryFolder& of) {
    return read_json_object(of.path() / "summary.json");
  }
  TemporaryFolder without_, with_;
};

TEST_F(MuckInFront, IsInNoMeasureOfTheProfile) {
  for (const auto& path : {without_.path(), with_.path()})
    report_profile(ResultFolder(path), {kCube, 0.125}, {});
  const auto without = summary(without_), with = summary(with_);
  for (const auto& [key, value] : without.items()) {
    const bool of_all = key == "swell_factor" || key == "pile_bulk_volume_m3" ||
                        key == "pile_solid_volume_m3" || key == "beyond_toe_fraction_collapse";
    if (of_all)
      EXPECT_TRUE(with[key].is_null()) << key;
    else
      EXPECT_EQ(with[key], value) << key;
  }
  EXPECT_NEAR(with["muck_mass_kg"], 20 * 2000.0 * 0.125, 1e-6);
  EXPECT_NEAR(with["muck_moved_m"], kMuckMoves, 1e-6);
  EXPECT_FALSE(without.contains("muck_mass_kg"));
}

TEST_F(MuckInFront, IsInNoFragment) {
  for (const auto& path : {without_.path(), with_.path()}) report_fragments(ResultFolder(path), {});
  const auto without = summary(without_), with = summary(with_);
  for (const auto& [key, value] : without.items()) EXPECT_EQ(with[key], value) << key;
}

TEST_F(MuckInFront, HasItsOwnColour) {
  const ResultFolder folder(with_.path());
  const std::vector<StartBlock>& blocks = folder.blocks();
  const Snapshot last = read_snapshot(folder.snapshots().back(), blocks);
  const BlockColours colours = block_colours(BlockFields(folder, blocks).of("start_height", last));
  const size_t rock = rock_blocks(blocks);
  ASSERT_EQ(blocks.size(), rock + muck_cubes().size());
  for (size_t b = 0; b < blocks.size(); ++b) {
    const bool of_muck = colours.of_block[b].red == kMuck.red &&
                         colours.of_block[b].green == kMuck.green &&
                         colours.of_block[b].blue == kMuck.blue;
    EXPECT_EQ(of_muck, b >= rock) << b;
  }
}

TEST_F(MuckInFront, FollowsTheRockInTheFile) {
  std::string text = text_of(with_.path() / "dump" / "blocks.vtk");
  const size_t at = text.find("SCALARS muck");
  ASSERT_NE(at, std::string::npos);
  const size_t first = text.find("\n0\n", at);
  text[first + 1] = '1';
  write_text(with_.path() / "dump" / "blocks.vtk", text);
  EXPECT_NE(input_error_of([&] {
              (void)ResultFolder(with_.path()).blocks();
            }).find("the ids of muck must be greater than those of rock"),
            std::string::npos);
}

}  // namespace
}  // namespace muckpile
