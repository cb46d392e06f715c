// SPDX-License-Identifier: GPL-2.0-or-later
// Scatter of detonators: the distribution, sums along the tie-up, and what stays as it was.
// Scope: core only.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "explosive/delay_scatter.h"
#include "explosive/hole_table.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

// b after a, c after b, by 17 ms each; in-hole delays of 500 ms, two decks in c.
const std::string kPlan =
    "# a plan\n"
    "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,after,"
    "surface_delay_s,in_hole_delay_s\n"
    "a,0,0,10,0,0,0,0.1,2,10,,0,0.5\n"
    "b,0,3,10,0,3,0,0.1,2,10,a,0.017,0.5\n"
    "c,0,6,10,0,6,0,0.1,6,10,b,0.017,0.5\n"
    "c,0,6,10,0,6,0,0.1,2,5,b,0.017,0.525\n";

HoleTable table(const std::string& text) { return HoleTable(CsvTable::parse(text, "t")); }

TEST(DelayScatter, TenThousandDrawsHaveMeanZeroAndTheDeviationOfACutNormal) {
  const int count = 10000;
  double sum = 0.0, squares = 0.0, most = 0.0;
  for (int k = 0; k < count; ++k) {
    const double value = cut_normal(7, static_cast<std::uint64_t>(k));
    sum += value;
    squares += value * value;
    most = std::max(most, std::abs(value));
  }
  const double deviation = std::sqrt(squares / count);
  std::printf("mean %.4f, standard deviation %.4f, largest %.4f\n", sum / count, deviation, most);
  EXPECT_NEAR(sum / count, 0.0, 0.03);  // 3 of its own deviations, 1/sqrt(10000)
  // sqrt(1 - 2 3 phi(3)/(2 Phi(3) - 1)) = sqrt(1 - 6 x 0.0044318/0.9973) = 0.9866
  EXPECT_NEAR(deviation, 0.9866, 0.03 * 0.9866);
  EXPECT_LE(most, 3.0);
}

TEST(DelayScatter, ElementsAddUpAlongTheTieUp) {
  const DelayScatter scatter{0.02, 5};
  const HoleTable fired = table(scattered(kPlan, "t", scatter).text), plan = table(kPlan);
  // c's first row is its lower deck, 6 to 10 m from the collar
  const auto draw = [](const char* hole, std::size_t deck) {
    return cut_normal(5, draw_of(hole, deck));
  };
  const double b = 0.02 * 0.017 * draw("b", 0), c = b + 0.02 * 0.017 * draw("c", 0);
  const std::array<double, 4> expected{0.02 * 0.5 * draw("a", 1), b + 0.02 * 0.5 * draw("b", 1),
                                       c + 0.02 * 0.5 * draw("c", 1),
                                       c + 0.02 * 0.525 * draw("c", 2)};
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(fired.decks()[k].firing_time - plan.decks()[k].firing_time, expected[k], 2e-9);
}

// Rows from the last to the first, remark and header as they were.
std::string turned_over(const std::string& text) {
  std::istringstream in(text);
  std::string line, head, rows;
  while (std::getline(in, line)) {
    if (line[0] == '#' || line.starts_with("hole,"))
      head += line + '\n';
    else
      rows = line + '\n' + rows;
  }
  return head + rows;
}

TEST(DelayScatter, AnotherOrderOfRowsHasTheSameTimes) {
  const HoleTable here = table(scattered(kPlan, "t", {0.02, 5}).text),
                  there = table(scattered(turned_over(kPlan), "t", {0.02, 5}).text);
  ASSERT_EQ(there.decks().size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(here.decks()[k].hole, there.decks()[3 - k].hole);
    EXPECT_EQ(here.decks()[k].firing_time, there.decks()[3 - k].firing_time);
  }
}

TEST(DelayScatter, HolesAndDecksHaveDrawsOfTheirOwn) {
  double sum = 0.0, squares = 0.0;
  constexpr int kCount = 10000;
  for (int k = 0; k < kCount; ++k) {
    const double value =
        cut_normal(7, draw_of(std::string("H").append(std::to_string(k / 4)), k % 4));
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.9866, 0.03 * 0.9866);
}

TEST(DelayScatter, TheRestOfTheTableStaysAndTheSeedDecides) {
  const std::string text = scattered(kPlan, "t", {0.02, 5}).text;
  EXPECT_EQ(text, scattered(kPlan, "t", {0.02, 5}).text);
  EXPECT_NE(text, scattered(kPlan, "t", {0.02, 6}).text);
  EXPECT_EQ(text.find("# a plan\nhole,collar_x_m,"), 0u);
  EXPECT_NE(text.find("in_hole_delay_s,scatter_s\na,0,0,10,0,0,0,0.1,2,10,,0,0.5,"),
            std::string::npos);
  const HoleTable none = table(scattered(kPlan, "t", {0.0, 5}).text);
  for (std::size_t k = 0; k < 4; ++k)
    EXPECT_EQ(none.decks()[k].firing_time, table(kPlan).decks()[k].firing_time);
}

TEST(DelayScatter, PairsInTheOtherOrderAreCounted) {
  // detonators of 500 ms that scatter by 10 ms turn some of five pairs of 17 to 59 ms
  std::size_t turned = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::string report = scattered(kPlan, "t", {0.02, seed}).report;
    const HoleTable fired = table(scattered(kPlan, "t", {0.02, seed}).text);
    std::size_t here = 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (fired.decks()[j].firing_time > fired.decks()[i].firing_time) ++here;
    EXPECT_NE(report.find("; " + std::to_string(here) + " pairs in the other order"),
              std::string::npos)
        << report;
    turned += here;
  }
  EXPECT_GT(turned, 0u);
}

TEST(DelayScatter, ASecondScatterIsRefused) {
  const std::string once = scattered(kPlan, "t", {0.02, 5}).text;
  EXPECT_EQ(input_error_of([&] {
              (void)scattered(once, "t", {0.02, 5});
            }),
            "t: has a column scatter_s, so scatter must be 0");
}

}  // namespace
}  // namespace muckpile
