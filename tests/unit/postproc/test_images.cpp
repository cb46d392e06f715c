// SPDX-License-Identifier: GPL-2.0-or-later
// Half and quarter models shown and measured as the whole blast.
// Scope: io/images and what stands on it in a result folder.
#include <gtest/gtest.h>

#include <algorithm>

#include "args/input_error.h"
#include "geometry/files/block_file.h"
#include "io/images.h"
#include "measure/columns.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

Vec3 reflected(const Vec3& p, const Vec3& signs) { return p.cwiseProduct(signs); }

TEST(Images, MoveAsReflectionsOfTheModel) {
  std::vector<StartBlock> blocks = as_start_blocks(cubes_in({0, 0, -1}, {1, 1, 0}));
  const size_t count = blocks.size();
  add_images(blocks, 4);
  ASSERT_EQ(blocks.size(), 4 * count);
  EXPECT_EQ(modelled(blocks), count);
  EXPECT_TRUE(std::ranges::is_sorted(blocks, std::ranges::less{}, &StartBlock::id));
  std::vector<BlockState> states(blocks.size());
  const Vec3 axis = Vec3(1, 2, 3).normalized(), spin(0.1, -0.2, 0.3);
  for (size_t b = 0; b < count; ++b) {
    const Quat turn(Eigen::AngleAxisd(0.7 + static_cast<double>(b), axis));
    states[b] = {blocks[b].centroid + Vec3(1, 2, 3), turn, {4, 5, 6}, spin, blocks[b].id, 0.5};
  }
  add_image_states(blocks, states);
  constexpr double kStep = 1e-6;  // [s]
  for (size_t b = count; b < blocks.size(); ++b) {
    const size_t model = b % count;
    const Vec3 signs(b / count == 1 ? 1 : -1, b / count == 2 ? 1 : -1, 1);
    EXPECT_NEAR(mass_properties(polyhedron_of(blocks[b].shape)).volume, blocks[b].volume, 1e-12);
    const auto original = moved_vertices(blocks[model], states[model]);
    const auto image = moved_vertices(blocks[b], states[b]);
    for (size_t v = 0; v < original.size(); ++v) {
      EXPECT_LT((image[v] - reflected(original[v], signs)).norm(), 1e-12);
      // so do the points' velocities
      const auto after = [&](const BlockState& s, const Vec3& p) -> Vec3 {
        return kStep * (s.velocity + s.spin.cross(p - s.centre));
      };
      EXPECT_LT(
          (after(states[b], image[v]) - reflected(after(states[model], original[v]), signs)).norm(),
          1e-12 * kStep * 10.0);
    }
  }
}

TEST(Images, AHalfIsReflectedInYAlone) {
  std::vector<StartBlock> blocks = as_start_blocks(cubes_in({-1, 0, -1}, {1, 1, 0}));
  const size_t count = blocks.size();
  add_images(blocks, 2);
  ASSERT_EQ(blocks.size(), 2 * count);
  EXPECT_EQ(blocks[count].centroid, reflected(blocks[0].centroid, {1, -1, 1}));
  add_images(blocks, 1);
  EXPECT_EQ(blocks.size(), 2 * count);
}

/// With energies in its run.json.
void write_whole(const std::filesystem::path& folder) {
  write_crater(folder);
  write_text(folder / "dump" / "run.json",
             "{\"blocks\": 9, \"spheres\": 9, \"joints\": 9, \"steps\": 2000, "
             "\"physical_time_s\": 4.5, \"wall_time_s\": 60.0, \"energy_balance_error\": 0.002, "
             "\"still\": true, \"gas_work_J\": 8e6, \"joint_crushing_J\": 3e5, "
             "\"mass_left_scene_kg\": 5.0, "
             "\"energy_audit_J\": {\"explosive\": 2e7}, \"energy_audit_error\": 0.001}\n");
}

/// The same files for the rock of the quarter x, y > 0.
void write_quarter(const std::filesystem::path& folder, const std::string& symmetry) {
  write_whole(folder);
  const BenchRun all = crater_run();
  BenchRun part;
  for (size_t b = 0; b < all.blocks.size(); ++b) {
    if (all.blocks[b].centroid.head<2>().minCoeff() < 0.0) continue;
    part.shapes.push_back(all.shapes[b]);
    part.last.states.push_back(all.last.states[b]);
    part.last.states.back().fragment = static_cast<int>(part.shapes.size());
  }
  part.blocks = as_start_blocks(part.shapes);
  part.last.step = all.last.step;
  part.last.time = all.last.time;
  const std::filesystem::path dump = folder / "dump";
  write_blocks((dump / "blocks.vtk").string(), part.shapes, 1, kDensity);
  write_snapshot(dump / "blocks_000000000.csv", part.blocks, start_snapshot(part.blocks));
  write_snapshot(dump / "blocks_000002000.csv", part.blocks, part.last);
  write_text(dump / "scene.json", "{\"case\": \"crater\", \"symmetry\": " + symmetry +
                                      ", \"burial_depth_m\": 2.0, \"charge_mass_kg\": 10.0, "
                                      "\"hole_diameter_m\": 0.2}\n");
}

TEST(Images, AQuarterOfTheCraterIsMeasuredAsTheWhole) {
  const TemporaryFolder whole, quarter;
  write_whole(whole.path());
  write_quarter(quarter.path(), "4");
  report_crater(ResultFolder(whole.path()), {}, {});
  report_crater(ResultFolder(quarter.path()), {}, {});
  const auto expected = check::read_json_object(whole.path() / "summary.json");
  const auto found = check::read_json_object(quarter.path() / "summary.json");
  EXPECT_EQ(found["symmetry"], 4);
  for (const char* key :
       {"crater_radius_m", "crater_depth_m", "crater_volume_m3", "apparent_crater_radius_m",
        "apparent_crater_volume_m3", "ejecta_mass_kg"}) {
    EXPECT_NEAR(found[key].get<double>() / expected[key].get<double>(), 1.0, 1e-9) << key;
  }
  EXPECT_EQ(found["gas_work_J"].get<double>(), 32e6);
  EXPECT_EQ(found["joint_crushing_J"].get<double>(), 12e5);
  EXPECT_EQ(found["mass_left_scene_kg"].get<double>(), 20.0);
  EXPECT_EQ(found["energy_audit_J"]["explosive"].get<double>(), 8e7);
  EXPECT_EQ(found["energy_audit_error"].get<double>(), 0.001);
}

TEST(Images, OtherSymmetriesAreRefused) {
  const TemporaryFolder folder;
  write_quarter(folder.path(), "3");
  try {
    report_crater(ResultFolder(folder.path()), {}, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("symmetry must be 1, 2 or 4, got '3'"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace muckpile
