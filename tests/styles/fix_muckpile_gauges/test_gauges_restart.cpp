// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gauges over a restart: the file is that of the run that went on without one.
// Scope: one lump that spins and swings; on as many ranks as wrote the file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "gauge_rows.h"
#include "rock_scene.h"
#include "scratch_folder.h"

namespace muckpile::test {
namespace {

constexpr double kStep = 2e-5;  // [s]
const std::string kBox = "-3 3 -3 3 -3 3", kBodies = "multisphere/muckpile";

void add_styles(RockScene& scene, const std::filesystem::path& folder, const std::string& pace) {
  scene.command(
      "fix joint all muckpile/joint youngs_modulus 50e9 poisson_ratio 0.25 density 2600 cohesion "
      "1e12 friction_angle 50 tension 1e12 contact_check no");
  scene.command("fix gauges all muckpile/gauges directory " + folder.string() + " " + pace +
                " line -0.9 0 0 0.9 0.1 0.1 3");
}

/// One rank waits for the file of another.
void make_lump(RockScene& scene, const std::filesystem::path& folder, const std::string& pace) {
  scene.cut("-1 1 -0.5 0.5 -0.5 0.5",
            "density 2600 size uniform 0.5 block_min 0.5 block_max 0.5 spheres_per_block 1 seed 3");
  add_styles(scene, folder, pace);
  scene.set_motion([](int, const Vec3& at) {
    return Motion{Vec3(0.2 * at.x(), 0, 0) + Vec3(0, 0, 4).cross(at), Vec3(0, 0, 4)};
  });
}

void expect_to_go_on(const std::string& pace) {
  const ScratchFolder folder("gauges_restart");
  {
    RockScene whole(MPI_COMM_WORLD, kBox, "* 1 1", kBodies);
    make_lump(whole, folder / "", pace);
    whole.run(130, kStep);
    whole.command("write_restart " + (folder / "middle.restart").string());
    whole.run(120, kStep);
  }
  const auto before = gauge_rows(folder / "gauges.csv");
  ASSERT_EQ(before.size(), 3U * 26U);
  // It writes into the file that the whole run has left, which ends later.
  RockScene half = RockScene::restarted(MPI_COMM_WORLD, (folder / "middle.restart").string());
  add_styles(half, folder / "", pace);
  half.run(40, kStep);
  const auto middle = gauge_rows(folder / "gauges.csv");
  EXPECT_EQ(middle.size(), 3U * 18U);  // steps 0 to 170
  half.run(80, kStep);
  EXPECT_LT(difference(before, gauge_rows(folder / "gauges.csv")), 1e-6);
}

TEST(GaugesRestart, BySteps) { expect_to_go_on("every 10"); }

TEST(GaugesRestart, ByInterval) { expect_to_go_on("interval 2e-4"); }

}  // namespace
}  // namespace muckpile::test
