// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/gauges.
// Scope: points and pace; tests/errors has each refusal as a user meets it.
#include <gtest/gtest.h>

#include "args/input_error.h"
#include "input_error_of.h"
#include "rock/gauge_points.h"

namespace muckpile {
namespace {

GaugeOptions read(const std::vector<std::string>& words) {
  std::vector<std::string> all = {"directory", "out"};
  all.insert(all.end(), words.begin(), words.end());
  return gauge_options(parse_args(gauge_table(), "fix", all), "fix");
}

TEST(GaugePoints, SinglePointsComeFirstAndLinesAreDividedEvenly) {
  const GaugeOptions options = read(
      {"interval", "1e-4", "line", "0", "0", "0", "3", "6", "-3", "4", "gauge", "7", "8", "9"});
  ASSERT_EQ(options.points.size(), 5U);
  EXPECT_EQ(options.points[0], Vec3(7, 8, 9));
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR((options.points[static_cast<std::size_t>(k) + 1] - Vec3(k, 2 * k, -k)).norm(), 0.0,
                1e-12);
  EXPECT_EQ(options.interval, 1e-4);
  EXPECT_EQ(options.every, 0);
  EXPECT_EQ(options.file, "gauges.csv");
}

TEST(GaugePoints, RefuseWhatDoesNotFitTogether) {
  using Words = std::vector<std::string>;
  const auto refused = [](const Words& words) {
    return input_error_of([&] { (void)read(words); });
  };
  EXPECT_NE(refused({"gauge", "0", "0", "0"}).find("either every"), std::string::npos);
  EXPECT_NE(refused({"every", "1", "interval", "1", "gauge", "0", "0", "0"}).find("got both"),
            std::string::npos);
  EXPECT_NE(refused({"every", "1"}).find("got none"), std::string::npos);
  EXPECT_NE(refused({"every", "1", "gauge", "0", "0", "nan"}).find("nan"), std::string::npos);
  EXPECT_NE(refused({"every", "1", "gauge", "0", "0", "2e5"}).find("2e5"), std::string::npos);
  EXPECT_NE(refused({"every", "1", "line", "0", "0", "0", "1", "0", "0", "1"}).find(">= 2"),
            std::string::npos);
  EXPECT_NE(
      refused({"every", "1", "line", "0", "0", "0", "0", "0", "0", "3"}).find("two different"),
      std::string::npos);
  EXPECT_NE(refused({"every", "1", "gauge", "1", "0", "0", "gauge", "1", "0", "0"}).find("1 0 0"),
            std::string::npos);
  for (const char* name : {"a/b.csv", "gauges.txt"})
    EXPECT_NE(refused({"every", "1", "file", name, "gauge", "0", "0", "0"}).find(name),
              std::string::npos);
}

}  // namespace
}  // namespace muckpile
