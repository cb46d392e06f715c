// SPDX-License-Identifier: GPL-2.0-or-later
// Benches that the measures of `profile` are not made for are refused, and leave no figures.
// Scope: report/bench_scene, and what report_profile takes back.
#include <gtest/gtest.h>

#include <cmath>

#include "args/input_error.h"
#include "geometry/files/block_file.h"
#include "input_error_of.h"
#include "report/bench_scene.h"
#include "report/not_measurable.h"
#include "report/plan_report.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

class Refusals : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(temporary_.path()); }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] BenchScene bench() const { return bench_scene(folder(), folder().blocks()); }
  void lean_face() {
    std::vector<Block> blocks = bench_run().shapes;
    shear(blocks, 140.0);  // far over the floor
    write_blocks(folder().dump("blocks.vtk").string(), blocks, 1, kDensity);
  }
  void set_holes(const std::string& holes) {
    const auto path = folder().dump("run.json");
    std::string text = text_of(path);
    write_text(path, text.insert(1, "\"holes\": " + holes + ", "));
  }
  void expect_refused(const std::string& part) {
    try {
      report_profile(folder(), {kCube, 0.125}, {});
      FAIL() << "measured";
    } catch (const NotMeasurable& refusal) {
      EXPECT_NE(std::string(refusal.what()).find(part), std::string::npos) << refusal.what();
    }
  }
  TemporaryFolder temporary_;
};

TEST_F(Refusals, FaceFarInFrontOfTheHolesIsNotMeasured) {
  lean_face();
  expect_refused(
      "profile: the free face must lie in front of the front row of holes by less than twice "
      "burden_m of scene.json, 5 m, got 11.");
  expect_refused("no plane: rock begins between x = 0");
  expect_refused("stands at 140° to the horizontal");
}

// A hollow, 1 m deep, at y > 0.
TEST_F(Refusals, FaceOfAnyShapeIsMeasuredAsItWasCut) {
  const BenchRun whole = bench_run();
  BenchRun run;
  Snapshot middle;
  double throw_cg = 0.0, cubes = 0.0;
  for (size_t b = 0; b < whole.blocks.size(); ++b) {
    const Vec3& start = whole.blocks[b].centroid;
    if (start.x() > -1.0 && start.y() > 0.0 && start.z() > 0.0) continue;
    run.shapes.push_back(whole.shapes[b]);
    run.last.states.push_back(whole.last.states[b]);
    BlockState moving{start, Quat::Identity(), Vec3::Zero(), Vec3::Zero(), 1, 0.0};
    const double behind = (start.y() > 0.0 ? -1.0 : 0.0) - start.x();   // of the face
    moving.velocity.x() = start.z() > 0.0 && behind < 1.3 ? 9.0 : 0.0;  // the layer and more
    middle.states.push_back(moving);
    if (start.x() < -kBurden || start.z() < 0.0) continue;
    throw_cg += whole.last.states[b].centre.x() - start.x();
    cubes += 1.0;
  }
  run.blocks = as_start_blocks(run.shapes);
  run.last.step = 2000;
  middle.step = 1000;
  write_blocks(folder().dump("blocks.vtk").string(), run.shapes, 1, kDensity);
  write_snapshot(folder().dump("blocks_000000000.csv"), run.blocks, start_snapshot(run.blocks));
  write_snapshot(folder().dump("blocks_000001000.csv"), run.blocks, middle);
  write_snapshot(folder().dump("blocks_000002000.csv"), run.blocks, run.last);
  const BenchScene scene = bench();
  const FaceMap& face = *scene.planes.face;
  EXPECT_NEAR(face.x(0.6, 4.0), -1.0, 1e-9);
  EXPECT_NEAR(face.x(-0.6, 4.0), 0.0, 1e-9);
  EXPECT_NEAR(face.toe(0.6), -1.0, 1e-9);
  EXPECT_NEAR(face_line(scene, 0.6).front().x(), -1.0, 1e-9);
  report_profile(folder(), {kCube, 0.125}, {});
  const auto keys = read_json_object(folder().file("summary.json"));
  EXPECT_NEAR(keys["throw_cg_m"], throw_cg / cubes, 1e-6);
  EXPECT_NEAR(keys["face_velocity_m_s"], 9.0, 1e-9);
  EXPECT_NEAR(keys["beyond_toe_fraction"], 1.0, 1e-12);
  EXPECT_TRUE(keys["beyond_toe_fraction_collapse"].is_null());
  EXPECT_NE(keys["face_note"].get<std::string>().find("no plane: rock begins between x = -1 and 0"),
            std::string::npos);
}

TEST_F(Refusals, NothingThatLooksCurrentStays) {
  report_profile(folder(), {kCube, 0.125}, {});
  EXPECT_TRUE(read_json_object(folder().file("summary.json"))["face_note"].is_null());
  report_fragments(folder(), {kCube, {}});
  lean_face();
  expect_refused("free face");
  EXPECT_FALSE(std::filesystem::exists(folder().file("profile.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder().file("profile.png")));
  const auto keys = read_json_object(folder().file("summary.json"));
  for (const char* key :
       {"face_velocity_m_s", "face_velocity_mean_m_s", "burden_velocity_m_s", "throw_cg_m",
        "throw_max_m", "throw_max_note", "beyond_toe_fraction", "beyond_toe_fraction_collapse",
        "pile_height_m", "pile_toe_m", "swell_factor", "repose_angle_deg", "blocks_on_the_move"}) {
    EXPECT_FALSE(keys.contains(key)) << key;
  }
  EXPECT_TRUE(keys["fragment_p50_m"].is_number());
  EXPECT_NE(keys["profile_refused"].get<std::string>().find("free face"), std::string::npos);
}

TEST_F(Refusals, OtherReportsGoOn) {
  lean_face();
  EXPECT_NO_THROW(report_fragments(folder(), {kCube, {}}));
  EXPECT_NO_THROW(report_energy(folder()));
  PictureOptions small;
  small.width = 320;
  small.height = 180;
  EXPECT_NO_THROW(report_picture(folder(), small));
}

TEST_F(Refusals, AreForgottenOnceTheBenchIsMeasured) {
  folder().merge_into_summary({{"profile_refused", "why"}});
  report_profile(folder(), {kCube, 0.125}, {});
  EXPECT_FALSE(read_json_object(folder().file("summary.json")).contains("profile_refused"));
}

TEST_F(Refusals, HolesThatLeanAsideOrForwardOrUnlikeAreNotMeasured) {
  const std::string message = "profile: holes must be parallel and upright, or lean straight back";
  const std::string upright =
      "{\"toe_m\": [-5, 0, -1], \"collar_m\": [-5, 0, 8], \"radius_m\": 0.15}";
  set_holes("[{\"toe_m\": [-5, 0, -1], \"collar_m\": [-5, 0.3, 8], \"radius_m\": 0.15}]");
  expect_refused(message + ", got one from x = -5, y = 0 m at its toe to x = -5, y = 0.3 m");
  set_holes("[{\"toe_m\": [-5, 0, -1], \"collar_m\": [-4.7, 0, 8], \"radius_m\": 0.15}]");
  expect_refused(message);
  set_holes("[" + upright +
            ", {\"toe_m\": [-8, 0, -1], \"collar_m\": [-10, 0, 8], \"radius_m\": 0.15}]");
  expect_refused(message);
}

TEST_F(Refusals, HolesThatLeanBackAreMeasuredFromTheFloor) {
  // 0.25 m back per metre of height; 5 m behind the toe at the floor.
  set_holes("[{\"toe_m\": [-4.75, 0, -1], \"collar_m\": [-7, 0, 8], \"radius_m\": 0.15}]");
  const BenchScene leaning = bench();
  EXPECT_DOUBLE_EQ(leaning.planes.hole_back, 0.25);
  EXPECT_DOUBLE_EQ(leaning.depth, 5.0);
  const auto bars = hole_bars(leaning, 0.0);
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_DOUBLE_EQ(bars[0].low.x(), -4.75);
  EXPECT_DOUBLE_EQ(bars[0].high.x(), -7.0);
  EXPECT_DOUBLE_EQ(bars[1].high.x(), -7.625);  // 2.5 m higher
  EXPECT_DOUBLE_EQ(bars[1].high.y(), kBenchHeight);
}

TEST_F(Refusals, FaceThatLeansBackIsMeasuredBehindItsPlane) {
  std::vector<Block> blocks = bench_run().shapes;
  shear(blocks, 76.0);
  write_blocks(folder().dump("blocks.vtk").string(), blocks, 1, kDensity);
  set_holes("[{\"toe_m\": [-4.75, 0, -1], \"collar_m\": [-7, 0, 8], \"radius_m\": 0.15}]");
  const double back = 1.0 / std::tan(76.0 * M_PI / 180.0);
  EXPECT_NEAR(bench().planes.face_back, back, 1e-5);
  report_profile(folder(), {kCube, 0.125}, {});
  const auto keys = read_json_object(folder().file("summary.json"));
  // The cubes that were the prism of the upright bench still are: hole and face lean alike, to
  // 0.25 and 0.249328, and the middle of the rearmost cube is 0.25 m in front of the holes.
  EXPECT_NEAR(keys["beyond_toe_fraction"], 1.0, 1e-12);
  EXPECT_NEAR(keys["face_velocity_m_s"], 14.0, 1e-6);
  // As upright, 507.5/105 + 2.5, and by as much more as the prism leans back at its mean height.
  EXPECT_NEAR(keys["throw_cg_m"], 507.5 / 105.0 + 2.5 + 5.25 * back, 1e-5);
  EXPECT_TRUE(keys["beyond_toe_fraction_collapse"].is_null());
}

TEST_F(Refusals, FrontRowMustStandAtTheBurden) {
  set_holes("[{\"toe_m\": [-4, 0, -1], \"collar_m\": [-4, 0, 8], \"radius_m\": 0.15}]");
  expect_refused(
      "profile: the front row of holes must stand at x = -5 m, the burden_m of "
      "scene.json, got x = -4 m");
}

TEST_F(Refusals, MalformedHolesAreAFaultOfTheFile) {
  set_holes("[{\"toe_m\": [-4, 0], \"collar_m\": [-4, 0, 8], \"radius_m\": 0.15}]");
  try {
    static_cast<void>(bench());
    FAIL() << "read";
  } catch (const NotMeasurable&) {
    FAIL() << "taken for a refusal";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("run.json: holes must be a list of toe_m"),
              std::string::npos);
  }
}

constexpr const char* kTwoRows =
    "[{\"toe_m\": [-5, 0.5, -1], \"collar_m\": [-5, 0.5, 8], \"radius_m\": 0.15},"
    " {\"toe_m\": [-7.75, -0.5, -1], \"collar_m\": [-7.75, -0.5, 3], \"radius_m\": 0.15},"
    " {\"toe_m\": [-7.75, -0.5, 4], \"collar_m\": [-7.75, -0.5, 8], \"radius_m\": 0.15}]";

TEST_F(Refusals, LeaveBenchesOfSeveralRowsWithoutACollapse) {
  set_holes(kTwoRows);
  EXPECT_FALSE(bench().one_row);
  EXPECT_DOUBLE_EQ(bench().depth, 7.75);
  report_profile(folder(), {kCube, 0.125}, {});
  const auto keys = read_json_object(folder().file("summary.json"));
  EXPECT_NEAR(keys["throw_cg_m"], 507.5 / 105.0 + 2.5, 1e-7);
  EXPECT_TRUE(keys["beyond_toe_fraction_collapse"].is_null());
}

TEST_F(Refusals, SectionShowsTheHolesThatItCutsAndNoOther) {
  EXPECT_EQ(hole_bars(bench(), 0.0).size(), 2U);  // charge and stemming of the scene's only hole
  EXPECT_TRUE(hole_bars(bench(), 0.5).empty());
  set_holes(kTwoRows);
  EXPECT_DOUBLE_EQ(y_of_middle_hole(bench(), folder().blocks()), 0.5);
  const auto front = hole_bars(bench(), 0.5);
  ASSERT_EQ(front.size(), 2U);
  EXPECT_DOUBLE_EQ(front[0].low.x(), -5.0);
  EXPECT_DOUBLE_EQ(front[0].half, 0.05);  // a hole of 0.1 m
  EXPECT_DOUBLE_EQ(front[0].high.y(), 8.0);
  EXPECT_DOUBLE_EQ(front[1].high.y(), kBenchHeight);
  const auto back = hole_bars(bench(), -0.5);
  ASSERT_EQ(back.size(), 3U);  // two decks, one stemming
  EXPECT_EQ(back[0].name, "charge before");
  EXPECT_EQ(back[1].name, "");
  EXPECT_DOUBLE_EQ(back[2].low.y(), 8.0);
}

TEST(CraterRefusal, OfAChargeBesideTheAxisTakesTheFiguresBack) {
  TemporaryFolder temporary;
  write_crater(temporary.path());
  const ResultFolder folder(temporary.path());
  report_crater(folder, {}, {});
  const std::string text = text_of(folder.dump("run.json"));
  const auto set_charge = [&](const std::string& x) {
    const std::string end = "[" + x + ", 0, -2]";
    write_text(folder.dump("run.json"), "{\"holes\": [{\"toe_m\": " + end + ", \"collar_m\": " +
                                            end + ", \"radius_m\": 0.1}], " + text.substr(1));
  };
  set_charge("0.5");
  EXPECT_THROW(report_crater(folder, {}, {}), NotMeasurable);
  EXPECT_FALSE(std::filesystem::exists(folder.file("crater.csv")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("launch.csv")));
  const auto refused = read_json_object(folder.file("summary.json"));
  EXPECT_FALSE(refused.contains("crater_radius_m"));
  EXPECT_TRUE(refused.contains("crater_refused"));
  set_charge("0.05");  // of 2 m burial depth: a fortieth
  report_crater(folder, {}, {});
  EXPECT_FALSE(read_json_object(folder.file("summary.json")).contains("crater_refused"));
}

TEST(CraterRefusal, OfABurialDepthThatIsNone) {
  TemporaryFolder temporary;
  write_crater(temporary.path());
  const std::string file = (temporary.path() / "dump/scene.json").string(), text = text_of(file);
  for (const std::string depth : {"0", "-2", "1e-300", "1e300"}) {
    std::string damaged = text;
    const std::string key = "\"burial_depth_m\": ";
    damaged.replace(damaged.find(key), key.size() + 3, key + depth);
    write_text(file, damaged);
    EXPECT_NE(input_error_of([&] { report_crater(ResultFolder(temporary.path()), {}, {}); })
                  .find("burial_depth_m must be 1e-3 to 1e4 m"),
              std::string::npos)
        << depth;
  }
}

TEST_F(Refusals, PlanNeedsAHoleTable) {
  EXPECT_THROW(report_plan(temporary_.path()), NotMeasurable);
}

TEST_F(Refusals, PlanOfATableOfAnotherRunIsNotDrawn) {
  set_holes("[{\"toe_m\": [-5, 0, -1], \"collar_m\": [-5, 0, 8], \"radius_m\": 0.15}]");
  const std::string head =
      "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m\n";
  write_text(folder().dump("holes.csv"), head + "a,-5,0,10.5,-5,0,-1,0.1,2.5,11.5\n");
  EXPECT_NO_THROW(report_plan(temporary_.path()));
  write_text(folder().dump("holes.csv"), head + "a,-6,0,10.5,-6,0,-1,0.1,2.5,11.5\n");
  EXPECT_THROW(report_plan(temporary_.path()), InputError);
}

}  // namespace
}  // namespace muckpile
