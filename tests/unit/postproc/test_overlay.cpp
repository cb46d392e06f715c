// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command overlay: bands of curves on unlike grids, scatter of named rows, and what is refused.
// Scope: sweep/overlay on tables written by hand.
#include <gtest/gtest.h>

#include "draw/colours.h"
#include "draw/curve_plot.h"
#include "drawn_picture.h"
#include "input_error_of.h"
#include "sweep/overlay.h"
#include "sweep/overlay_report.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using namespace testing;

class Overlay : public ::testing::Test {
 protected:
  // A table of run k, 0 first.
  void table(int k, const std::string& name, const std::string& text) const {
    write_text(path(k) + "/" + name, text);
  }
  [[nodiscard]] std::string path(int k) const {
    return (temporary_.path() / ("run" + std::to_string(k))).string();
  }
  [[nodiscard]] OverlayOptions options(const std::string& name, int runs = 3) const {
    OverlayOptions words{{}, name, {}, temporary_.path().string()};
    for (int k = 0; k < runs; ++k) words.runs.push_back(path(k));
    return words;
  }
  [[nodiscard]] std::string written(const std::string& name) const {
    return text_of(temporary_.path() / name);
  }
  [[nodiscard]] std::string refused(const OverlayOptions& words) const {
    return input_error_of([&] { report_overlay(words); });
  }
  TemporaryFolder temporary_;
};

// Heights at x = 1 between the rows: 2, 5 and 8, so P10 is 2.6 and P90 7.4; beyond its last row the
// second run keeps 5.
TEST_F(Overlay, TheBandIsThatOfAllRunsAtEachPlace) {
  table(0, "profile.csv", "x_m,pile_mean_m\n0,1\n2,3\n");
  table(1, "profile.csv", "x_m,pile_mean_m\n0,5\n1,5\n");
  table(2, "profile.csv", "x_m,pile_mean_m\n0,9\n2,7\n");
  const auto files = report_overlay(options("profile.csv"));
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(written("overlay_profile.csv"),
            "column,x_m,runs,mean,standard_deviation,least,p10,p50,p90,largest\n"
            "pile_mean_m,0,3,5,4,1,1.8,5,8.2,9\n"
            "pile_mean_m,1,3,5,3,2,2.6,5,7.4,8\n"
            "pile_mean_m,2,3,5,2,3,3.4,5,6.6,7\n");
  EXPECT_GT(std::filesystem::file_size(files[1]), 2000U);
}

// Middles of the blue lines that a column of a picture crosses, from its top, below the key.
std::vector<double> blue_lines(const DrawnPicture& picture, int column) {
  constexpr int kBelowKey = 100, kBlue = 40;  // [px], steps of 255
  std::vector<double> middles;
  int begin = -1;
  for (int y = kBelowKey; y < picture.height(); ++y) {
    const auto [red, green, blue] = picture.at(column, y);
    const bool is_blue = blue - red > kBlue;
    if (is_blue && begin < 0) begin = y;
    if (!is_blue && begin >= 0) middles.push_back(0.5 * (begin + y));
    if (!is_blue) begin = -1;
  }
  return middles;
}

// P10, P50 and P90 of 0, 1 ... 6 m are 0.6, 3 and 5.4 m. An area between the first and the last
// shows beside six runs, whose lines have colours of their own, and would be hidden by seven.
TEST_F(Overlay, TheBandOfManyRunsHasEdgesOnly) {
  for (int k = 0; k < 7; ++k) {
    const std::string height = std::to_string(k);
    table(k, "profile.csv", "x_m,pile_mean_m\n0," + height + "\n2," + height + "\n");
  }
  const Colour area = mix(kWhite, colour_of_curve(0), 0.25);
  const DrawnPicture few(report_overlay(options("profile.csv", 6))[1]);
  EXPECT_GT(few.count(area, few.all()), few.width() * few.height() / 5);
  const DrawnPicture many(report_overlay(options("profile.csv", 7))[1]);
  EXPECT_EQ(many.count(area, many.all()), 0);
  const std::vector<double> lines = blue_lines(many, many.width() / 2);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NEAR(lines[1] - lines[0], lines[2] - lines[1], 1.5);  // [px], rounded
  EXPECT_GT(lines[1] - lines[0], 0.2 * many.height());
}

// Recovered 0.9 and 0.7: mean 0.8, deviation sqrt(0.02), P10 0.72.
TEST_F(Overlay, NamedRowsHaveTheScatterOfEach) {
  const std::string head = "polygon,recovered_fraction,dilution_fraction\n";
  table(0, "polygons.csv", head + "A,0.9,0.1\nB,0.5,\n");
  table(1, "polygons.csv", head + "B,0.5,0.2\nA,0.7,0.3\n");
  const auto files = report_overlay(options("polygons.csv", 2));
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[1].filename(), "overlay_polygons.png");
  EXPECT_GT(std::filesystem::file_size(files[1]), 2000U);
  EXPECT_EQ(written("overlay_polygons.csv"),
            "polygon,column,runs,mean,standard_deviation,least,p10,p50,p90,largest\n"
            "A,recovered_fraction,2,0.8,0.141421,0.7,0.72,0.8,0.88,0.9\n"
            "A,dilution_fraction,2,0.2,0.141421,0.1,0.12,0.2,0.28,0.3\n"
            "B,recovered_fraction,2,0.5,0,0.5,0.5,0.5,0.5,0.5\n"
            "B,dilution_fraction,1,0.2,,0.2,0.2,0.2,0.2,0.2\n");
}

TEST_F(Overlay, PartsOfABenchAreToldApartByAllTheirBands) {
  const std::string head = "level_low_m,level_high_m,from_face_m,to_face_m,moved_m\n";
  table(0, "movement.csv", head + "0,2,0,1,5\n0,2,1,2,4\n");
  table(1, "movement.csv", head + "0,2,0,1,7\n0,2,1,2,4\n");
  const OverlaidRows all =
      overlaid_rows({path(0) + "/movement.csv", path(1) + "/movement.csv"}, {});
  ASSERT_EQ(all.over.size(), 4U);
  ASSERT_EQ(all.rows.size(), 2U);
  EXPECT_DOUBLE_EQ(all.rows[0].spread.mean, 6.0);
  EXPECT_DOUBLE_EQ(all.rows[1].spread.mean, 4.0);
}

TEST_F(Overlay, SizesStandOnALogarithmicAxisOfChosenColumns) {
  for (int k = 0; k < 8; ++k)
    table(k, "sieve.csv", "sieve_m,mass_fraction_passing,swebrec\n0.1,0.1,\n1,1,\n");
  OverlayOptions words = options("sieve.csv", 8);
  report_overlay(words);  // a column that is empty in all is left out
  EXPECT_EQ(written("overlay_sieve.csv").find("swebrec"), std::string::npos);
  words.columns = {"swebrec"};
  EXPECT_NE(refused(words).find("has no value in a column 'swebrec'"), std::string::npos);
}

TEST_F(Overlay, UnlikeTablesAreRefused) {
  table(0, "profile.csv", "x_m,pile_mean_m\n0,1\n");
  table(1, "profile.csv", "y_m,pile_mean_m\n0,1\n");
  EXPECT_NE(refused(options("profile.csv", 1)).find("needs two runs at least, got 1"),
            std::string::npos);
  EXPECT_NE(refused(options("profile.csv", 2)).find("is a table over 'y_m', the first one over"),
            std::string::npos);
  EXPECT_NE(refused(options("profile.csv", 3)).find("run1/profile.csv"), std::string::npos);
  table(1, "profile.csv", "x_m,pile_mean_m\n0,1\n0.5\n");
  EXPECT_NE(refused(options("profile.csv", 2)).find("run1/profile.csv:3"), std::string::npos);
  table(0, "polygons.csv", "polygon,moved_m\nA,1\n");
  table(1, "polygons.csv", "hole,moved_m\nA,1\n");
  EXPECT_NE(refused(options("polygons.csv", 2)).find("must name its rows by polygon"),
            std::string::npos);
  OverlayOptions words = options("polygons.csv", 2);
  words.out = path(7);
  EXPECT_EQ(refused(words), "overlay: --out must be a folder that exists, got '" + path(7) + "'");
  words.out = path(0);
  table(1, "polygons.csv", "polygon,moved_m\nA,1\n");
  words.columns = {"move_m"};
  EXPECT_NE(refused(words).find("has no column 'move_m'; did you mean 'moved_m'?"),
            std::string::npos);
}

}  // namespace
}  // namespace muckpile
