// SPDX-License-Identifier: GPL-2.0-or-later
// The sub-commands from dump/ to files: every promised file and key is there and has the known
// value. Scope: report/ and io/vtk_series on made-up runs.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "compare/comparison.h"
#include "compare/run_figures.h"
#include "compare/table_curves.h"
#include "io/vtk_series.h"
#include "measure/broken_out.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

// Width and height, and whether the picture holds more than a few colours.
struct PictureFacts {
  int width, height;
  bool has_drawing;
};

PictureFacts facts_of(const std::filesystem::path& path) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  int dark = 0;
  for (int y = 0; y < size[1]; ++y) {
    for (int x = 0; x < size[0]; ++x)
      dark += reader->GetOutput()->GetScalarComponentAsDouble(x, y, 0, 0) < 200.0;
  }
  return {size[0], size[1], dark > size[0] * size[1] / 100};
}

class BenchReports : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(temporary_.path()); }
  nlohmann::ordered_json summary() { return read_json_object(temporary_.path() / "summary.json"); }
  TemporaryFolder temporary_;
};

TEST_F(BenchReports, ProfileWritesItsKeysTableAndPicture) {
  const ResultFolder folder(temporary_.path());
  report_profile(folder, {kCube, 0.125}, {});
  const auto keys = summary();
  for (const char* key :
       {"blocks", "spheres", "joints", "joints_broken_fraction", "face_velocity_m_s",
        "fastest_block_m_s", "throw_cg_m", "throw_max_m", "pile_height_m", "pile_toe_m",
        "beyond_toe_fraction", "beyond_toe_fraction_collapse", "swell_factor", "repose_angle_deg",
        "energy_balance_error", "physical_time_s", "wall_time_s", "steps"}) {
    ASSERT_TRUE(keys.contains(key)) << key;
    EXPECT_TRUE(keys[key].is_number()) << key;
  }
  EXPECT_NEAR(keys["throw_cg_m"], 507.5 / 105.0 + 2.5, 1e-7);
  EXPECT_NEAR(keys["swell_factor"], 1.3, 1e-7);
  // The burden, 5 m x 10.5 m swollen by 1.3, slumped to a triangle of that slope on the wall behind
  // it: what lies beyond the toe is as its base is to the whole one, squared.
  const double slope = std::tan(keys["repose_angle_deg"].get<double>() * M_PI / 180.0);
  const double base = std::sqrt(2.0 * 5.0 * 10.5 * 1.3 / slope);
  EXPECT_NEAR(keys["beyond_toe_fraction_collapse"], std::pow(1.0 - 5.0 / base, 2), 1e-9);
  EXPECT_EQ(keys["beyond_toe_fraction"], 1.0);
  EXPECT_EQ(keys["throw_max_note"].get<std::string>().rfind("no clearance distance", 0), 0U);
  EXPECT_TRUE(keys["still_note"].is_null());
  // Charge from -1 to 8 m, above the floor 0 to 8, its middle half 2 to 6 m; the face layer moves
  // at 14 m/s.
  EXPECT_NEAR(keys["face_velocity_m_s"], 14.0, 1e-9);
  EXPECT_NEAR(keys["burden_velocity_m_s"], (2 * 14.0 + 8 * 6.0) / 10, 1e-9);  // layers of cubes
  EXPECT_DOUBLE_EQ(keys["fastest_block_m_s"], 31.5);
  const CsvTable table = CsvTable::read(folder.file("profile.csv"));
  EXPECT_EQ(table.number(0, table.column("x_m")), -7.9375);
  const PictureFacts picture = facts_of(folder.file("profile.png"));
  EXPECT_EQ(picture.width, 1600);
  EXPECT_TRUE(picture.has_drawing);
}

// A floor that was surveyed a metre lower from x = 1 m on, with the same pile on it.
class OnASurveyedFloor : public BenchReports {
 protected:
  void SetUp() override {
    BenchReports::SetUp();
    lower_the_floor(temporary_.path());
  }
  static void lower_the_floor(const std::filesystem::path& folder) {
    write_text(folder / "dump/floor.stl",
               "solid floor\n"
               "facet normal 0 0 1\nouter loop\nvertex 1 -50 -1\nvertex 60 -50 -1\n"
               "vertex 60 50 -1\nendloop\nendfacet\n"
               "facet normal 0 0 1\nouter loop\nvertex 1 -50 -1\nvertex 60 50 -1\n"
               "vertex 1 50 -1\nendloop\nendfacet\nendsolid floor\n");
    std::string scene = text_of(folder / "dump/scene.json");
    write_text(folder / "dump/scene.json",
               scene.insert(1, "\"floor_survey\": 1, \"floor_front_m\": 1.0, "));
  }
};

TEST_F(OnASurveyedFloor, ProfileHasItsHeightBesideTheSurfaces) {
  const ResultFolder folder(temporary_.path());
  report_profile(folder, {kCube, 0.125}, {});
  const CsvTable table = CsvTable::read(folder.file("profile.csv"));
  const size_t floor = table.column("floor_m"), x = table.column("x_m"),
               mean = table.column("pile_mean_m");
  for (size_t row = 0; row < table.rows(); ++row) {
    const double at = table.number(row, x);
    EXPECT_NEAR(table.number(row, floor), at < 0.0 ? 0.0 : std::max(-at, -1.0), 1e-5) << at;
    EXPECT_GE(table.number(row, mean), table.number(row, floor));
  }
}

TEST_F(OnASurveyedFloor, TablesWithItsHeightAreComparedAndOverlaid) {
  report_profile(ResultFolder(temporary_.path()), {kCube, 0.125}, {});
  TemporaryFolder other;
  write_bench(other.path());
  lower_the_floor(other.path());
  report_profile(ResultFolder(other.path()), {kCube, 0.125}, {});
  const auto compared =
      compare_runs(read_run_figures(temporary_.path()), read_run_figures(other.path()), {});
  const auto floor = std::ranges::find(compared, "profile.csv:floor_m", &ComparedQuantity::name);
  ASSERT_NE(floor, compared.end());
  EXPECT_TRUE(floor->same);
  const auto curves = read_curves(temporary_.path() / "profile.csv");
  EXPECT_TRUE(curves.of_column.contains("floor_m"));
}

TEST_F(BenchReports, ProfileOnALevelFloorHasNoHeightOfIt) {
  const ResultFolder folder(temporary_.path());
  report_profile(folder, {kCube, 0.125}, {});
  EXPECT_FALSE(CsvTable::read(folder.file("profile.csv")).find_column("floor_m"));
}

// The face layer, two cubes deep, moves the faster the higher: 4 m/s and 2 m/s more for each metre
// above the floor at 10 ms, half as much at 20 ms, but for its lowest 2 m, which are twice as fast
// then. A band of 1.05 m has the mean of its cubes.
TEST_F(BenchReports, FaceVelocityOverHeightIsThatOfTheFaceAtEachHeight) {
  const BenchRun run = bench_run();
  const auto speed = [](double height, double share) { return share * (4.0 + 2.0 * height); };
  const auto write = [&](long step, double time, double low, double high) {
    Snapshot now = start_snapshot(run.blocks);
    now.step = step;
    now.time = time;
    for (size_t b = 0; b < run.blocks.size(); ++b) {
      const Vec3& at = run.blocks[b].centroid;
      if (at.z() < 0.0) continue;
      const double along = at.x() > -1.0 ? speed(at.z(), at.z() < 2.0 ? low : high) : 0.5;
      now.states[b].velocity = Vec3(along, 30.0, -3.0);  // sidewards and down do not count
    }
    char name[40];
    std::snprintf(name, sizeof name, "dump/blocks_%09ld.csv", step);
    write_snapshot(temporary_.path() / name, run.blocks, now);
  };
  write(1000, 0.01, 1.0, 1.0);
  write(1500, 0.02, 2.0, 0.5);
  report_profile(ResultFolder(temporary_.path()), {kCube, 0.125}, {});
  const CsvTable face = CsvTable::read(temporary_.path() / "face_velocity.csv");
  ASSERT_EQ(face.rows(), 10U);
  double fastest = 0.0;
  for (size_t band = 0; band < face.rows(); ++band) {
    const double low = 1.05 * static_cast<double>(band), high = low + 1.05;
    double sum = 0.0;
    int cubes = 0;
    for (double height = 0.25; height < kBenchHeight; height += kCube) {
      if (height < low || height > high) continue;
      sum += speed(height, height < 2.0 ? 2.0 : 1.0);
      ++cubes;
    }
    const bool late = high < 2.2;  // cubes of its two bands lie below 2 m
    EXPECT_NEAR(face.number(band, face.column("height_low_m")), low, 1e-5);
    EXPECT_NEAR(face.number(band, face.column("height_high_m")), high, 1e-5);
    EXPECT_NEAR(face.number(band, face.column("velocity_m_s")), sum / cubes, 1e-4) << band;
    EXPECT_NEAR(face.number(band, face.column("velocity_at_s")), late ? 0.02 : 0.01, 1e-9) << band;
    fastest = std::max(fastest, sum / cubes);
  }
  EXPECT_NEAR(summary()["face_velocity_m_s"], fastest, 1e-6);
}

// A block 60 m up as the pile rests, which falls at 20 m/s: no part of the pile. Of a run that is
// not still it is.
TEST_F(BenchReports, BlockInTheAirIsNoPartOfAPileAtRest) {
  const ResultFolder folder(temporary_.path());
  BenchRun run = bench_run();
  const auto block = static_cast<size_t>(
      std::ranges::max_element(run.last.states, {},
                               [](const BlockState& s) { return s.centre.x(); }) -
      run.last.states.begin());
  run.last.states[block].centre += Vec3(-6.0, 0.0, 60.0);
  run.last.states[block].velocity = Vec3(0.0, 0.0, -20.0);
  write_snapshot(folder.dump("blocks_000002000.csv"), run.blocks, run.last);
  report_profile(folder, {kCube, 0.125}, {});
  EXPECT_NEAR(summary()["pile_height_m"], kSteps * kLayer, 1e-7);
  EXPECT_EQ(summary()["blocks_on_the_move"], 1);
  std::string text = text_of(folder.dump("run.json"));
  write_text(folder.dump("run.json"), text.replace(text.find("true"), 4, "false"));
  report_profile(folder, {kCube, 0.125}, {});
  EXPECT_TRUE(summary()["pile_height_m"].is_null());
  const CsvTable table = CsvTable::read(folder.file("profile.csv"));
  double highest = 0.0;
  for (size_t row = 0; row < table.rows(); ++row)
    highest = std::max(highest, table.number(row, table.column("broken_rock_m")));
  EXPECT_GT(highest, 12.0);  // mean over a width of four cubes
  EXPECT_EQ(summary()["blocks_on_the_move"], 0);
}

// Pixels of the warning's colour in the line of the title.
int red_in_title(const std::filesystem::path& path) {
  constexpr int kTitle = 66;  // [px]
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  const auto level = [&](int x, int y, int c) {
    return std::lround(reader->GetOutput()->GetScalarComponentAsDouble(x, y, 0, c));
  };
  int red = 0;
  for (int y = size[1] - kTitle; y < size[1]; ++y) {  // VTK counts from below
    for (int x = 0; x < size[0]; ++x)
      red += level(x, y, 0) == 204 && level(x, y, 1) == 33 && level(x, y, 2) == 33;
  }
  return red;
}

TEST_F(BenchReports, RunThatIsNotStillHasNoPileAndSaysSo) {
  const ResultFolder folder(temporary_.path());
  report_profile(folder, {kCube, 0.125}, {});
  EXPECT_EQ(red_in_title(folder.file("profile.png")), 0);
  std::string text = text_of(folder.dump("run.json"));
  write_text(folder.dump("run.json"), text.replace(text.find("true"), 4, "false"));
  report_profile(folder, {kCube, 0.125}, {});
  report_fragments(folder, {kCube, {}});
  report_energy(folder);
  PictureOptions small;
  small.width = 400;
  small.height = 200;
  report_picture(folder, small);
  for (const char* name : {"profile.png", "fragments.png", "energy.png", "pile3d.png"})
    EXPECT_GT(red_in_title(folder.file(name)), 200) << name;
  const auto keys = summary();
  for (const char* key :
       {"repose_angle_deg", "front_slope_deg", "swell_factor", "pile_bulk_volume_m3",
        "pile_solid_volume_m3", "pile_toe_m", "pile_toe_98_m", "pile_height_m", "pile_height_x_m",
        "beyond_toe_fraction_collapse"}) {
    ASSERT_TRUE(keys.contains(key)) << key;
    EXPECT_TRUE(keys[key].is_null()) << key;
  }
  EXPECT_TRUE(keys["throw_cg_m"].is_number());
  EXPECT_EQ(keys["still_note"].get<std::string>().rfind("STILL MOVING at 4.5 s: ", 0), 0U);
}

// Half of the pile's rock holds together in one piece, then every block is for itself.
TEST_F(BenchReports, FragmentsSayWhenTheyAreTheBlocks) {
  const ResultFolder folder(temporary_.path());
  report_fragments(folder, {kCube, {}});
  EXPECT_DOUBLE_EQ(summary()["fragments_single_block_share"], 1.0);
  EXPECT_EQ(summary()["fragments_note"], "block sizes: the input, not a prediction");
  BenchRun run = bench_run();
  const std::vector<char> moved = broken_out(run.blocks, run.last.states, kCube);
  int joined = 0;
  for (size_t b = 0; b < run.blocks.size() && joined < 420; ++b) {
    if (moved[b] == 0) continue;
    run.last.states[b].fragment = 1473;
    ++joined;
  }
  write_snapshot(folder.dump("blocks_000002000.csv"), run.blocks, run.last);
  report_fragments(folder, {kCube, {}});
  EXPECT_NEAR(summary()["fragments_single_block_share"], 0.5, 1e-9);
  EXPECT_TRUE(summary()["fragments_note"].is_null());
}

TEST_F(BenchReports, FragmentsCountOnlyTheBrokenOutRock) {
  const ResultFolder folder(temporary_.path());
  report_fragments(folder, {kCube, {}});
  const auto keys = summary();
  for (const char* key : {"fragment_p20_m", "fragment_p50_m", "fragment_p80_m"})
    EXPECT_NEAR(keys[key], kCube, 1e-6);
  EXPECT_EQ(keys["fragments_in_pile"], 840);
  EXPECT_NEAR(keys["pile_mass_kg"], 840 * 0.125 * kDensity, 1e-3);
  const CsvTable curve = CsvTable::read(folder.file("fragments.csv"));
  EXPECT_DOUBLE_EQ(curve.number(curve.rows() - 1, curve.column("mass_fraction_passing")), 1.0);
  EXPECT_EQ(CsvTable::read(folder.file("fragments_list.csv")).rows(), 1472U);
  EXPECT_TRUE(facts_of(folder.file("fragments.png")).has_drawing);
}

TEST_F(BenchReports, CommandsKeepEachOthersKeys) {
  const ResultFolder folder(temporary_.path());
  report_fragments(folder, {});
  report_profile(folder, {}, {});
  EXPECT_TRUE(summary().contains("fragment_p50_m"));
  EXPECT_TRUE(summary().contains("throw_cg_m"));
}

TEST_F(BenchReports, RenderWritesThePileAndTheFrames) {
  const ResultFolder folder(temporary_.path());
  PictureOptions options;
  options.width = 320;
  options.height = 180;
  options.frames = 2;
  options.mirror = 1;
  options.colour_by = "speed";
  report_picture(folder, options);
  for (const char* name : {"pile3d.png", "pile3d_0000.png", "pile3d_0001.png"}) {
    const PictureFacts picture = facts_of(folder.file(name));
    EXPECT_EQ(picture.width, 320);
    EXPECT_EQ(picture.height, 180);
    EXPECT_TRUE(picture.has_drawing);
  }
}

TEST_F(BenchReports, SeriesHoldsThePosedBlocksAndTheirTimes) {
  const ResultFolder folder(temporary_.path());
  EXPECT_EQ(write_vtk_series(folder, 1), 3);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((temporary_.path() / "vtk" / "blocks_000002000.vtu").c_str());
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  ASSERT_EQ(grid->GetNumberOfCells(), 1472);
  for (const char* name : {"id", "fragment_id", "velocity_m_s", "size_m", "start_m",
                           "displacement_m", "broken_fraction"}) {
    EXPECT_NE(grid->GetCellData()->GetArray(name), nullptr) << name;
  }
  double bounds[6];
  grid->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 14.0, 1e-5);  // single precision
  EXPECT_EQ(write_vtk_series(folder, 2), 2);
  EXPECT_TRUE(std::filesystem::exists(temporary_.path() / "vtk" / "blocks.pvd"));
}

TEST_F(BenchReports, RunFileWithoutAKeyIsNamed) {
  write_text(temporary_.path() / "dump" / "run.json", "{\"blocks\": 1, \"spheres\": 9}");
  try {
    static_cast<void>(common_keys(ResultFolder(temporary_.path())));
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("run.json: has no key 'joints'"), std::string::npos);
  }
}

TEST_F(BenchReports, CraterRefusesABench) {
  EXPECT_THROW(report_crater(ResultFolder(temporary_.path()), {}, {}), InputError);
}

TEST(CraterReport, WritesItsKeysTableAndPicture) {
  TemporaryFolder temporary;
  write_crater(temporary.path());
  const ResultFolder folder(temporary.path());
  EXPECT_THROW(report_profile(folder, {}, {}), InputError);
  report_crater(folder, {}, {});
  const auto keys = read_json_object(temporary.path() / "summary.json");
  EXPECT_NEAR(keys["crater_radius_m"], 4.0, 0.5 * kCube);  // the rim is ragged by half a cube
  EXPECT_NEAR(keys["apparent_crater_depth_m"], 2.0, 1e-6);
  EXPECT_TRUE(keys["crater_volume_m3"].is_number());
  EXPECT_TRUE(keys["ejecta_p50_m"].is_number());
  EXPECT_GT(CsvTable::read(folder.file("crater.csv")).rows(), 10U);
  EXPECT_GT(CsvTable::read(folder.file("launch.csv")).rows(), 10U);
  EXPECT_TRUE(facts_of(folder.file("crater.png")).has_drawing);
}

// What rock in flight will fill and where it will land is open; what has left its place has left
// it.
TEST(CraterReport, OfARunThatIsNotStillHasNeitherApparentCraterNorEjecta) {
  TemporaryFolder temporary;
  write_crater(temporary.path());
  const ResultFolder folder(temporary.path());
  std::string text = text_of(folder.dump("run.json"));
  write_text(folder.dump("run.json"), text.replace(text.find("true"), 4, "false"));
  report_crater(folder, {}, {});
  const auto keys = read_json_object(temporary.path() / "summary.json");
  for (const char* key :
       {"apparent_crater_radius_m", "apparent_crater_depth_m", "apparent_crater_volume_m3",
        "ejecta_mass_kg", "ejecta_p50_m", "ejecta_p90_m", "ejecta_max_m"}) {
    ASSERT_TRUE(keys.contains(key)) << key;
    EXPECT_TRUE(keys[key].is_null()) << key;
  }
  EXPECT_NEAR(keys["crater_radius_m"], 4.0, 0.5 * kCube);
  EXPECT_TRUE(keys["crater_depth_m"].is_number());
  EXPECT_TRUE(keys["crater_volume_m3"].is_number());
}

TEST(HeapReport, WritesItsKeysTableAndPicture) {
  TemporaryFolder temporary;
  write_heap(temporary.path());
  const ResultFolder folder(temporary.path());
  report_heap(folder, {kCube, 0.125}, {});
  const auto keys = read_json_object(temporary.path() / "summary.json");
  EXPECT_NEAR(keys["pile_height_m"], kSteps * kLayer, 1e-7);
  EXPECT_NEAR(keys["swell_factor"], kLayer / kCube, 1e-7);
  // Nine steps of eight columns each, worked out in PileShape.FindsTheSlopeOfTheSteps.
  EXPECT_NEAR(std::tan(keys["front_slope_deg"].get<double>() * M_PI / 180.0),
              kLayer * (81.0 - 1.0) / (81.0 - 1.0 / 64.0), 1e-7);
  EXPECT_EQ(CsvTable::read(folder.file("heap.csv")).number(0, 4), 0.0);
  EXPECT_TRUE(facts_of(folder.file("heap.png")).has_drawing);
}

TEST(HeapReport, OfAHeapInMotionHasNoAngle) {
  TemporaryFolder temporary;
  write_heap(temporary.path());
  const ResultFolder folder(temporary.path());
  std::string text = text_of(folder.dump("run.json"));
  write_text(folder.dump("run.json"), text.replace(text.find("true"), 4, "false"));
  report_heap(folder, {kCube, 0.125}, {});
  const auto keys = read_json_object(temporary.path() / "summary.json");
  for (const char* key : {"repose_angle_deg", "front_slope_deg", "pile_toe_m", "swell_factor"})
    EXPECT_TRUE(keys[key].is_null()) << key;
}

TEST_F(BenchReports, HeapRefusesABench) {
  EXPECT_THROW(report_heap(ResultFolder(temporary_.path()), {}, {}), InputError);
}

TEST_F(BenchReports, EnergyDrawsTheAuditBelow) {
  const ResultFolder folder(temporary_.path());
  report_energy(folder);
  const int plain = facts_of(folder.file("energy.png")).height;
  auto run = nlohmann::ordered_json::parse(text_of(folder.dump("run.json")));
  run["energy_audit_J"] = {{"explosive", 4e6}, {"wall_work", 1e6}, {"rock_heat", 3e6}};
  run["energy_audit_error"] = 0.001;
  write_text(folder.dump("run.json"), run.dump());
  report_energy(folder);
  EXPECT_GT(facts_of(folder.file("energy.png")).height, plain + 100);
  EXPECT_DOUBLE_EQ(summary()["energy_audit_J"]["rock_heat"], 3e6);
  EXPECT_DOUBLE_EQ(summary()["energy_audit_error"], 0.001);
  EXPECT_FALSE(summary().contains("energy_audit_error_worst_hole"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("energy_holes.csv")));
}

TEST_F(BenchReports, EnergyWritesTheAuditOfEachHole) {
  const ResultFolder folder(temporary_.path());
  auto run = nlohmann::ordered_json::parse(text_of(folder.dump("run.json")));
  const nlohmann::ordered_json held = {{"energy_audit_J", {{"explosive", 4e6}, {"stemming", 5e4}}},
                                       {"energy_audit_error", 0.001},
                                       {"stemming_speed_m_s", 3.0}};
  auto left = held;
  left["energy_audit_error"] = -0.002;
  left["stemming_out_s"] = 0.015;
  left["stemming_speed_m_s"] = 120.0;
  run["holes"] = {held, left};
  write_text(folder.dump("run.json"), run.dump());
  report_energy(folder);
  EXPECT_EQ(text_of(folder.file("energy_holes.csv")),
            "hole,explosive_J,stemming_J,error_share,stemming_out_s,stemming_speed_m_s\n"
            "1,4e+06,50000,0.001,,3\n2,4e+06,50000,-0.002,0.015,120\n");
  EXPECT_DOUBLE_EQ(summary()["energy_audit_error_worst_hole"], -0.002);
  EXPECT_DOUBLE_EQ(summary()["stemming_out_s"], 0.015);
  EXPECT_DOUBLE_EQ(summary()["stemming_speed_m_s"], 120.0);
}

TEST_F(BenchReports, EnergyDrawsTheLedger) {
  const ResultFolder folder(temporary_.path());
  report_energy(folder);
  EXPECT_TRUE(facts_of(folder.file("energy.png")).has_drawing);
  EXPECT_EQ(summary()["joints"], 4000);
}

}  // namespace
}  // namespace muckpile
