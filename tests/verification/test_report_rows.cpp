// SPDX-License-Identifier: GPL-2.0-or-later
// The rows of verification reports as the page and its files show them.
// Scope: report_rows.h.
#include <gtest/gtest.h>

#include "report_rows.h"

namespace muckpile {
namespace {

Json row(const char* quantity, double value, double error, bool pass) {
  return {{"case", "nu 0, bar"}, {"quantity", quantity}, {"value", value},     {"unit", "Pa"},
          {"reference", 2.0},    {"error", error},       {"tolerance", 0.005}, {"pass", pass}};
}

Json for_information() {
  Json last = row("G", 3.0, 0.0, true);
  last["reference"] = last["error"] = last["tolerance"] = nullptr;
  return last;
}

TEST(ReportRows, ACaseShowsTheFigureNearestToItsBound) {
  const Json rows = {row("E", 2.002, 0.001, true), row("|T|", 1.992, -0.004, true),
                     for_information()};
  EXPECT_EQ(case_row(rows, "bar", "v/bar.csv"),
            "| [bar](v/bar.csv) | 2 of 2 | -0.4 % of 0.5 % |\n");
}

TEST(ReportRows, ACaseWithoutBoundsIsForInformation) {
  EXPECT_EQ(case_row(Json::array({for_information()}), "bar", "v/bar.csv"),
            "| [bar](v/bar.csv) |  | for information |\n");
}

TEST(ReportRows, AFileHasAllFigures) {
  EXPECT_EQ(csv_of({row("E", 2.002, 0.001, true), for_information()}),
            "case,quantity,value,unit,expected,error,allowed,within\n"
            "\"nu 0, bar\",\"E\",2.002,Pa,2,0.001,0.005,yes\n"
            "\"nu 0, bar\",\"G\",3,Pa,,,,\n");
}

TEST(ReportRows, FiguresOutsideTheirBoundsAreListed) {
  const Json good = Json::array({row("E", 2.002, 0.001, true)});
  EXPECT_EQ(not_met(good), "All bounds are met.\n");
  Json bad = Json::array({row("E", 2.02, 0.01, false)});
  bad[0]["note"] = "why";
  EXPECT_EQ(not_met(bad), "- nu 0, bar, E: 1 % instead of 0.5 %; why\n");
}

TEST(ReportRows, FiguresOutsideTheirBoundsShareOneReason) {
  Json bad = {row("E", 2.02, 0.01, false), row("G", 2.04, 0.02, false),
              row("K", 2.02, 0.01, false)};
  bad[0]["note"] = bad[2]["note"] = "why";
  EXPECT_EQ(not_met(bad),
            "- why:\n"
            "  - nu 0, bar, E: 1 % instead of 0.5 %\n"
            "  - nu 0, bar, K: 1 % instead of 0.5 %\n"
            "- nu 0, bar, G: 2 % instead of 0.5 %\n");
}

}  // namespace
}  // namespace muckpile
