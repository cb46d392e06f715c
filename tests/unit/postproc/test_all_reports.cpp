// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command all: the reports of each scene, and what is shown of a summary.
// Scope: report/all_reports on made-up runs; test_reports.cpp checks the reports themselves.
#include <gtest/gtest.h>

#include "args/input_error.h"
#include "report/all_reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;
using Names = std::vector<std::string>;

class AllReports : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directory(temporary_.path() / "dump"); }
  ResultFolder folder_with(const std::string& scene) {
    write_text(temporary_.path() / "dump/scene.json", scene);
    return ResultFolder(temporary_.path());
  }
  TemporaryFolder temporary_;
};

TEST_F(AllReports, EachCaseHasItsOwn) {
  EXPECT_EQ(reports_of(folder_with(R"({"case": "bench"})"), false),
            (Names{"profile", "movement", "fragments", "energy", "render", "report"}));
  EXPECT_EQ(reports_of(folder_with(R"({"case": "crater"})"), false),
            (Names{"crater", "fragments", "energy", "render", "report"}));
  EXPECT_EQ(reports_of(folder_with(R"({"case": "heap"})"), false),
            (Names{"heap", "energy", "render", "report"}));
  EXPECT_EQ(reports_of(folder_with(R"({"case": "other"})"), false),
            (Names{"fragments", "energy", "render", "report"}));
}

TEST_F(AllReports, TheSeriesIsMadeWhereItIsAskedFor) {
  EXPECT_EQ(reports_of(folder_with(R"({"case": "heap"})"), true),
            (Names{"heap", "energy", "render", "series", "report"}));
}

TEST_F(AllReports, AKnobMayHaveTheNameOfTheCase) {
  const Names heap = reports_of(folder_with(R"({"case": "heap"})"), false);
  EXPECT_EQ(reports_of(folder_with(R"({"knobs": {"case": "bench"}, "case": "heap"})"), false), heap);
  EXPECT_EQ(reports_of(folder_with(R"({ "case" : "heap", "knobs": {"case": "bench"}})"), false), heap);
}

TEST_F(AllReports, AHoleTableIsDrawnToo) {
  write_text(temporary_.path() / "dump/holes.csv", "hole\n");
  const Names names = reports_of(folder_with(R"({"case": "bench"})"), false);
  EXPECT_EQ((Names{names.end() - 2, names.end()}), (Names{"plan", "report"}));
}

TEST_F(AllReports, GaugesAreMeasuredToo) {
  write_text(temporary_.path() / "dump/gauges.csv", "step,run_id\n");
  const Names names = reports_of(folder_with(R"({"case": "bench"})"), false);
  EXPECT_EQ((Names{names.end() - 2, names.end()}), (Names{"waves", "report"}));
}

TEST_F(AllReports, AnotherCaseIsRefusedByName) {
  for (const char* scene : {R"({"case": "quarry"})", "{}", R"({"knobs": {"case": "bench"}})"})
    EXPECT_THROW(reports_of(folder_with(scene), false), InputError) << scene;
}

TEST_F(AllReports, TheSummaryIsShownKeyByKey) {
  const ResultFolder folder = folder_with("{}");
  write_text(temporary_.path() / "summary.json",
             R"({"throw_cg_m": 8.5, "note": "a, \"b\"", "pile_toe_m": null})");
  EXPECT_EQ(summary_lines(folder),
            "  throw_cg_m                   8.5\n"
            "  note                         a, \"b\"\n"
            "  pile_toe_m                   null\n");
}

TEST_F(AllReports, OfAHeapLeaveTheirFiles) {
  TemporaryFolder temporary;
  write_heap(temporary.path());
  const ResultFolder folder(temporary.path());
  for (const std::string& name : reports_of(folder, true)) {
    if (name != "render") make_report(folder, name);  // seconds at its full size
  }
  Names pictures;
  for (const auto& picture : pictures_in(folder)) pictures.push_back(picture.filename().string());
  EXPECT_EQ(pictures, (Names{"energy.png", "heap.png"}));
  EXPECT_TRUE(std::filesystem::exists(folder.file("vtk/blocks.pvd")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("report.html")));
  EXPECT_TRUE(read_json_object(folder.file("summary.json")).contains("vtk_snapshots"));
}

}  // namespace
}  // namespace muckpile
