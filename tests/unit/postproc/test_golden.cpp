// SPDX-License-Identifier: GPL-2.0-or-later
// The tables that the sub-commands write for made-up runs, against those of golden/.
// Scope: what a table holds is worked out in the tests of each sub-command; here no column, unit,
// order or digit may change unseen. With MUCKPILE_WRITE_GOLDEN set the files are written anew.
#include <gtest/gtest.h>

#include <sstream>

#include "golden_files.h"
#include "report/damage_report.h"
#include "report/plan_report.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

class Golden : public ::testing::Test {
 protected:
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  void expect_tables(std::initializer_list<const char*> files, const std::string& scene) const {
    for (const char* file : files) {
      SCOPED_TRACE(file);
      expect_golden(folder().file(file), scene + "_" + std::filesystem::path(file).stem().string());
    }
  }
  void add_to_scene(const std::string& words) const {
    const auto scene = folder().dump("scene.json");
    std::string text = text_of(scene);
    write_text(scene, text.insert(1, words));
  }
  static void keep_lines(const std::filesystem::path& path, int count) {
    std::istringstream in(text_of(path));
    std::string line, kept;
    for (int k = 0; k < count && std::getline(in, line); ++k) kept += line + '\n';
    write_text(path, kept);
  }
  TemporaryFolder temporary_;
};

TEST_F(Golden, TablesOfABench) {
  write_bench(temporary_.path());
  report_profile(folder(), {kCube, 0.25}, {});
  report_movement(folder(), {kCube, 0.25}, {});
  report_fragments(folder(), {kCube, {}});
  report_energy(folder());
  expect_tables({"profile.csv", "face_velocity.csv", "movement.csv", "movement.dxf",
                 "fragments.csv", "sieve.csv", "energy.csv"},
                "bench");
}

TEST_F(Golden, PolygonsThatWereCarried) {
  write_bench(temporary_.path());
  write_text(temporary_.path() / "ore.csv",
             "polygon,x_m,y_m\nlode,-4,-1\nlode,-2,-1\nlode,-2,1\nlode,-4,1\n");
  write_text(temporary_.path() / "lines.csv",
             "polygon,x_m,y_m\neast,4,-1\neast,9,-1\neast,9,1\neast,4,1\n");
  MovementOptions options;
  options.polygons = (temporary_.path() / "ore.csv").string();
  options.dig = (temporary_.path() / "lines.csv").string();
  report_movement(folder(), {kCube, 0.25}, options);
  expect_tables({"polygons.csv", "polygons_moved.csv", "polygons.dxf", "dig.csv"}, "bench");
}

TEST_F(Golden, SectionTroughAndOverALine) {
  write_bench(temporary_.path());
  LineOptions line;
  line.from = {-8.0, -0.9};
  line.to = {14.0, 0.9};
  report_section(folder(), {kCube, 0.5}, line);
  line.from = {5.0, 1.0};
  line.to = {6.0, -1.0};
  report_over(folder(), {kCube, 0.5}, line);
  report_trough(folder(), {kCube, 0.25}, {0.5});
  expect_tables({"section.csv", "over.csv", "trough.csv"}, "bench");
}

TEST_F(Golden, TablesOfAPattern) {
  write_bench(temporary_.path());
  write_text(folder().dump("holes.csv"),
             "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
             "surface_delay_s\n"
             "back,-7.6,0,10.5,-7.6,0,-1,0.1,2.5,11.5,0.042\n"
             "left,-5,-0.5,10.5,-5,-0.5,-1,0.1,2.5,11.5,0\n"
             "right,-5,0.5,10.5,-5,0.5,-1,0.1,2.5,11.5,0.005\n");
  add_to_scene("\"explosive_density_kg_m3\": 800, ");
  report_rows(folder(), {kCube, 0.125});
  report_heights(folder(), {kCube, 0.5});
  report_flyrock(folder());
  report_plan(temporary_.path());
  expect_tables({"rows.csv", "face_velocity.csv", "heights.csv", "flyrock.csv", "plan.csv"},
                "pattern");
}

// Not the list of all fragments and blocks, whose digits would fill the folder: its first ones.
TEST_F(Golden, TablesWithOptions) {
  write_bench(temporary_.path());
  FragmentOptions fragments;
  fragments.boulder = 0.3;
  fragments.fines_radius = 10.0;
  report_fragments(folder(), {kCube, 0.25}, fragments);
  MovementOptions movement;
  movement.model = write_text(temporary_.path() / "model.csv",
                              "name,x_m,y_m,z_m,grade\nore,-0.2,0.25,0.25,3.1\nair,5,0,0,0\n");
  report_movement(folder(), {kCube, 0.25}, movement);
  PictureOptions picture;
  picture.width = picture.height = 200;
  report_picture(folder(), picture);
  for (const char* file : {"fragments_list.csv", "boulders.csv", "pile3d.csv"})
    keep_lines(folder().file(file), 25);
  expect_tables(
      {"fragments_list.csv", "boulders.csv", "fines.csv", "model_moved.csv", "pile3d.csv"},
      "bench");
}

TEST_F(Golden, TablesOfACrater) {
  write_crater(temporary_.path());
  report_crater(folder(), {}, {});
  expect_tables({"crater.csv"}, "crater");
}

TEST_F(Golden, TablesOfAHeap) {
  write_heap(temporary_.path());
  report_heap(folder(), {kCube, 0.25}, {});
  expect_tables({"heap.csv"}, "heap");
}

// A plane that falls by 1 m in 2 m, from 8 m at x = -8 on.
TEST_F(Golden, DifferenceFromASurvey) {
  write_bench(temporary_.path());
  std::ostringstream points;
  for (double x = -10.0; x <= 16.0; x += 0.5)
    for (double y = -2.0; y <= 2.0; y += 0.5)
      points << x << ' ' << y << ' ' << std::max(0.0, 4.0 - 0.5 * x) << '\n';
  SurveyOptions options;
  options.surface = write_text(temporary_.path() / "survey.xyz", points.str());
  report_survey(folder(), {kCube, 0.5}, options);
  expect_tables({"survey.csv"}, "bench");
}

TEST_F(Golden, TablesOfGauges) {
  write_bench(temporary_.path());
  add_to_scene("\"charge_mass_kg\": 64.0, ");
  std::ostringstream rows;
  rows << "step,time_s,gauge,block,x_m,y_m,z_m,ux_m,uy_m,uz_m,vx_m_s,vy_m_s,vz_m_s,sxx_Pa,syy_Pa,"
          "szz_Pa,sxy_Pa,syz_Pa,szx_Pa,pressure_Pa,run_id\n";
  for (int k = 0; k < 4; ++k)
    for (int g = 1; g <= 4; ++g)
      rows << k << ',' << 1e-3 * k << ',' << g << ',' << 6 + g << ',' << -5 - g << ",0,4,0,0,0,"
           << k * (3 - k) / (0.5 + g * g) << ",0,0," << -3e5 * k / g << ",0,0," << 1e5 * k
           << ",0,0," << 1e5 * k / g << ",\n";
  write_text(temporary_.path() / "dump/gauges.csv", rows.str());
  report_waves(folder());
  expect_tables({"waves.csv", "ppv.csv"}, "bench");
}

}  // namespace
}  // namespace muckpile
