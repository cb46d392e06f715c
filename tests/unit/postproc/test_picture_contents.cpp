// SPDX-License-Identifier: GPL-2.0-or-later
// What pictures show, read back from their pixels: rock, surfaces, holes and colours where they
// belong, on axes whose numbers are those of the rock.
// Scope: profile, section, heights, plan and pile3d of made-up runs; the size curves of one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw/text.h"
#include "drawn_picture.h"
#include "input_error_of.h"
#include "report/block_colours.h"
#include "report/fragments_plot.h"
#include "report/picture_report.h"
#include "report/picture_view.h"
#include "report/picture_words.h"
#include "report/plan_report.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

constexpr double kTickText = 19.0;  // of axes [px]
constexpr double kLineOff = 2.0;    // half a line's thickness [px]

// From metres of the rock to pixels of a picture with equal scales.
struct Ruler {
  Vec2 origin;  // where (0, 0) is [px]
  double per_metre;
  [[nodiscard]] Vec2 at(double across, double up) const {
    return origin + per_metre * Vec2(across, -up);
  }
  [[nodiscard]] Box box(double across0, double up0, double across1, double up1) const {
    const Vec2 low = at(across0, up0), high = at(across1, up1);
    return {static_cast<int>(low.x()), static_cast<int>(high.y()), static_cast<int>(high.x()),
            static_cast<int>(low.y())};
  }
};

// That of some numbers which a tick's words are most like.
std::string number_at(const DrawnPicture& picture, const Vec2& place, Anchor anchor,
                      const std::vector<std::string>& numbers) {
  return *std::ranges::min_element(numbers, {}, [&](const std::string& number) {
    return picture.misfit(number, kTickText, place, anchor);
  });
}

const std::vector<std::string> kNumbers{"-2", "0", "2", "4", "6", "8", "10", "12", "14"};

// By the numbers 0 and 10 at ticks below the frame, whose lower side is in this row.
Ruler ruler_of_axis(const DrawnPicture& picture, int bottom) {
  const std::vector<double> ticks = picture.lines_across(bottom + 4, 60, picture.width());
  const auto tick_of = [&](const std::string& number) {
    return *std::ranges::min_element(ticks, {}, [&](double tick) {
      return picture.misfit(number, kTickText, {tick, bottom + 6.0 + kTickText}, Anchor::kCentre);
    });
  };
  const double zero = tick_of("0"), ten = tick_of("10");
  return {{zero, 0.0}, (ten - zero) / 10.0};
}

// Height of a line of this colour over a place, from the middle of its pixels [m]; NaN without one.
double height_of_line(const DrawnPicture& picture, const Ruler& ruler, Colour colour, double across,
                      double low, double high) {
  const double half = 1.5 / ruler.per_metre;
  const Box line = picture.extent(colour, ruler.box(across - half, low, across + half, high));
  if (line.width() == 0) return std::nan("");
  return (ruler.origin.y() - line.middle().y()) / ruler.per_metre;
}

// Heights of the pile's steps, each a metre long, `k` from the toe of the bench.
double step_height(int k) { return (kSteps - k) * kLayer; }

class PicturesOfABench : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(temporary_.path()); }
  [[nodiscard]] ResultFolder folder() const { return ResultFolder(temporary_.path()); }
  [[nodiscard]] DrawnPicture picture(const std::string& name) const {
    return DrawnPicture(temporary_.path() / name);
  }

  // The rock that stayed is 8 m long; the bench stands 10.5 m high on the floor, below which
  // the picture shows so much of it [m].
  static Ruler ruler_of_section(const DrawnPicture& section, double below) {
    constexpr int kBelow = 97;  // margin [px]
    const Box plot{108, 188, section.width() - 33, section.height() - kBelow};
    Ruler ruler = ruler_of_axis(section, plot.y1);
    const Box rock = section.extent(kRockInPlace, plot);
    const bool cut = rock.y1 + 3 >= plot.y1;  // by the frame
    ruler.origin.y() = (cut ? plot.y1 : rock.y1) - below * ruler.per_metre;
    EXPECT_NEAR(rock.width(), 8.0 * ruler.per_metre, 4.0);  // less its outlines or the frame
    EXPECT_NEAR(ruler.origin.y() - rock.y0, kBenchHeight * ruler.per_metre, 3.0);
    const Vec2 ten = ruler.at(10.0, 10.0);
    EXPECT_EQ(number_at(section, {94.0, ten.y() + 0.36 * kTickText}, Anchor::kRight, kNumbers),
              "10");
    return ruler;
  }

  // Charge and stemming of the hole, 9 m and 2.5 m from 1 m below the floor.
  static void expect_hole(const DrawnPicture& section, const Ruler& ruler, double across) {
    for (const double height : {-0.8, 0.5, 4.0, 7.7})
      EXPECT_TRUE(section.shows(kSignal, ruler.at(across, height))) << height;
    for (const double height : {8.3, 10.1})
      EXPECT_TRUE(section.shows(kGrey, ruler.at(across, height))) << height;
  }

  TemporaryFolder temporary_;
  BenchRun run_ = bench_run();
};

TEST_F(PicturesOfABench, ProfileHasRockHoleAndSurfacesToScale) {
  SectionOptions options;
  options.y = 0.04;
  report_profile(folder(), {kCube, 0.125}, options);
  const DrawnPicture drawn = picture("profile.png");
  const Ruler ruler = ruler_of_section(drawn, 1.0);
  EXPECT_NEAR(drawn.extent(kRockInPlace, {108, 188, 800, 800}).x0, ruler.at(-8.0, 0.0).x(), 2.0);
  expect_hole(drawn, ruler, -kBurden);
  const double off = kLineOff / ruler.per_metre;
  for (const int k : {0, 3, 8, 12})
    EXPECT_NEAR(height_of_line(drawn, ruler, kSignal, k + 0.5, -0.5, 11.0), step_height(k), off);
  EXPECT_NEAR(height_of_line(drawn, ruler, kSignal, -6.7, -0.5, 11.0), kBenchHeight, off);
  EXPECT_NEAR(height_of_line(drawn, ruler, kSignal, -2.3, -0.5, 11.0), 0.0, off);
  const Box crest = drawn.extent(kBench, ruler.box(-4.8, 0.5, -0.2, 11.0));  // before, dashed
  EXPECT_NEAR(crest.width() / ruler.per_metre, 4.6, 0.4);
  EXPECT_NEAR((ruler.origin.y() - crest.middle().y()) / ruler.per_metre, kBenchHeight, off);
}

TEST_F(PicturesOfABench, ProfileBesideTheRockIsRefused) {
  SectionOptions options;
  for (const double y : {1e6, -2.1, std::nan("")}) {
    options.y = y;
    EXPECT_NE(input_error_of([&] {
                report_profile(folder(), {kCube, 0.125}, options);
              }).find("--y must be where rock lies, from -1 to 1 m, got '"),
              std::string::npos);
  }
}

TEST_F(PicturesOfABench, ProfileHasEachBlockInItsColour) {
  SectionOptions options;
  options.y = 0.04;
  report_profile(folder(), {kCube, 0.125}, options);
  const DrawnPicture drawn = picture("profile.png");
  const Ruler ruler = ruler_of_section(drawn, 1.0);
  const ResultFolder here = folder();
  const BlockColours colours =
      block_colours(BlockFields(here, here.blocks()).of("start_height", run_.last));
  int seen = 0;
  for (size_t b = 0; b < run_.blocks.size(); ++b) {
    const Vec3& at = run_.last.states[b].centre;
    const bool moved = (at - run_.blocks[b].centroid).norm() > 0.5;
    if (!moved || std::abs(at.y() - 0.25) > 0.1) continue;
    EXPECT_TRUE(drawn.shows(colours.of_block[b], ruler.at(at.x(), at.z() - 0.1))) << b;
    ++seen;
  }
  EXPECT_EQ(seen, 210);
}

TEST_F(PicturesOfABench, SectionRunsFromTheFirstPointToTheSecond) {
  LineOptions line;
  line.from = {-8.0, 0.04};
  line.to = {15.0, 0.04};
  report_section(folder(), {kCube, 0.125}, line);
  const DrawnPicture out = picture("section.png");
  constexpr double kBelow = 0.05 * kBenchHeight;  // the picture's room below the floor
  const Ruler ruler = ruler_of_section(out, kBelow);
  const double off = kLineOff / ruler.per_metre;
  for (const int k : {0, 3, 8, 12})
    EXPECT_NEAR(height_of_line(out, ruler, kSignal, 8.5 + k, -0.5, 11.0), step_height(k), off);
  EXPECT_NEAR(height_of_line(out, ruler, kSignal, 1.3, -0.5, 11.0), kBenchHeight, off);
  EXPECT_TRUE(out.shows(kSignal, ruler.at(3.0, 4.0)));  // the charge
  std::swap(line.from, line.to);
  report_section(folder(), {kCube, 0.125}, line);
  const DrawnPicture back = picture("section.png");
  const Ruler from_the_pile = ruler_of_section(back, kBelow);
  for (const int k : {0, 3, 8, 12})  // the toe of the bench is 15 m away
    EXPECT_NEAR(height_of_line(back, from_the_pile, kSignal, 14.5 - k, -0.5, 11.0), step_height(k),
                off);
}

// One hole, at y = 0.6; the picture's y points up.
TEST_F(PicturesOfABench, HeightsHaveTheColoursOfPileAndBenchAndTheHole) {
  write_text(folder().dump("holes.csv"),
             "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,"
             "to_m,surface_delay_s\na,-5,0.6,10.5,-5,0.6,-1,0.1,2.5,11.5,0\n");
  report_heights(folder(), {kCube, 0.125});
  const DrawnPicture drawn = picture("heights.png");
  const ColourMap map = amount_map(0.0, kBenchHeight);
  const Box plot{105, 150, drawn.width(), drawn.height() - 85};
  const Box bench = drawn.extent(mix(map.at(kBenchHeight), kGrey, 0.75), plot);
  Ruler ruler = ruler_of_axis(drawn, plot.y1);
  ruler.origin.y() = bench.middle().y();
  EXPECT_NEAR(bench.x0, ruler.at(-8.0, 0.0).x(), 3.0);  // less its outlines
  EXPECT_NEAR(bench.x1, ruler.at(-5.0, 0.0).x(), 3.0);
  EXPECT_NEAR(bench.height(), 2.0 * ruler.per_metre, 4.0);
  for (const int k : {0, 3, 8, 12}) {
    const Colour colour = map.at(step_height(k));
    const Box step = drawn.extent(colour, plot);
    EXPECT_NEAR(step.x0, ruler.at(k, 0.0).x(), 3.0) << k;
    EXPECT_NEAR(step.x1, ruler.at(k + 1.0, 0.0).x(), 3.0) << k;
    EXPECT_NEAR(step.height(), 2.0 * ruler.per_metre, 4.0) << k;
  }
  const Box gap = ruler.box(-3.4, 0.3, -3.1, 0.7);  // between two lines of the grid
  EXPECT_EQ(drawn.count(kWhite, gap), gap.width() * gap.height());
  const Box hole = drawn.extent(kSignal, plot);
  EXPECT_NEAR((hole.middle() - ruler.at(-5.0, 0.6)).norm(), 0.0, 2.0);
}

// Six holes, of which five times are different.
TEST(PictureOfAPlan, HasHolesWhereTheyAreInTheColoursOfTheirTimes) {
  TemporaryFolder temporary;
  const std::string table = write_text(
      temporary.path() / "holes.csv",
      "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,to_m,"
      "surface_delay_s,in_hole_delay_s\n"
      "a1,-2.5,-3,9,-2.5,-3,0,0.1,3,9,0,0\na2,-2.5,0,9,-2.5,0,0,0.1,3,9,0.017,0\n"
      "a3,-2.5,3,9,-2.5,3,0,0.1,3,9,0.034,0\nb1,-5,-1.5,9,-5,-1.5,0,0.1,3,9,0.001,0\n"
      "b2,-5,1.5,9,-5,1.5,0,0.1,3,9,0.059,0\nb3,-5,4.5,9,-5,4.5,0,0.1,3,9,0.076,0\n");
  report_plan(table);
  const DrawnPicture drawn(temporary.path() / "holes.png");
  const ColourMap map = amount_map(0.0, 76.0);
  const Box plot{105, 150, drawn.width(), drawn.height() - 85};
  const auto disc = [&](double ms) { return drawn.extent(map.at(ms), plot).middle(); };
  const Vec2 a1 = disc(0.0), b3 = disc(76.0);
  const double per_metre = (b3 - a1).norm() / std::hypot(2.5, 7.5);
  const Ruler ruler{a1 - per_metre * Vec2(-2.5, 3.0), per_metre};
  constexpr double kOff = 2.0;  // [px]
  EXPECT_LT((b3 - ruler.at(-5.0, 4.5)).norm(), kOff);
  EXPECT_LT((disc(17.0) - ruler.at(-2.5, 0.0)).norm(), kOff);
  EXPECT_LT((disc(34.0) - ruler.at(-2.5, 3.0)).norm(), kOff);
  EXPECT_LT((disc(1.0) - ruler.at(-5.0, -1.5)).norm(), kOff);
  EXPECT_LT((disc(59.0) - ruler.at(-5.0, 1.5)).norm(), kOff);
  EXPECT_EQ(number_at(drawn, {ruler.at(-2.0, 0.0).x(), plot.y1 + 6.0 + kTickText}, Anchor::kCentre,
                      kNumbers),
            "-2");
  EXPECT_EQ(number_at(drawn, {105.0 - 11.0, ruler.at(0.0, 2.0).y() + 0.36 * kTickText},
                      Anchor::kRight, kNumbers),
            "2");
  EXPECT_TRUE(drawn.reads("59", 18.0, ruler.at(-5.0, 1.5) - Vec2(0.0, 11.0), Anchor::kCentre));
  EXPECT_FALSE(drawn.reads("58", 18.0, ruler.at(-5.0, 1.5) - Vec2(0.0, 11.0), Anchor::kCentre));
}

// Seen from beside, level: the rock's near side is 1 m in front of the middle and shows it to
// scale.
class ViewFromBeside : public PicturesOfABench {
 protected:
  void draw(int width, int height) {
    PictureOptions options;
    options.width = width;
    options.height = height;
    options.azimuth = 90.0;
    options.elevation = 0.0;
    report_picture(folder(), options);
  }
  // Of earth colours, whatever the light.
  [[nodiscard]] static bool is_rock(const DrawnPicture& picture, const Vec2& place) {
    const auto [red, green, blue] =
        picture.at(static_cast<int>(place.x()), static_cast<int>(place.y()));
    return red - blue > 0.25 * red;
  }
  // By the edges of the rock before the blast: its left, and the near ones above and below.
  [[nodiscard]] static Ruler ruler_by_box(const DrawnPicture& picture) {
    Box box{picture.width(), picture.height(), 0, 0};
    for (int y = 100; y < picture.height() - 70; ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        const auto [red, green, blue] = picture.at(x, y);
        if (red > 80 || blue < 120) continue;
        box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1),
               std::max(box.y1, y + 1)};
      }
    }
    const double per_metre = (box.height() - 2.0) / kBenchHeight;  // lines of 2 px
    return {{box.x0 + 1.0 + 8.0 * per_metre, box.y1 - 1.0}, per_metre};
  }
};

TEST_F(ViewFromBeside, HasPileAndBenchToScale) {
  draw(1200, 900);
  const DrawnPicture drawn = picture("pile3d.png");
  const Ruler ruler = ruler_by_box(drawn);
  constexpr double kClear = 0.35;  // [m]: what is farther away seems shifted by up to 0.28 m
  for (const int k : {0, 3, 8, 12}) {
    EXPECT_TRUE(is_rock(drawn, ruler.at(k + 0.7, step_height(k) - kClear))) << k;
    EXPECT_FALSE(is_rock(drawn, ruler.at(k + 0.7, step_height(k) + kClear))) << k;
  }
  EXPECT_TRUE(is_rock(drawn, ruler.at(13.7, 0.3)));
  EXPECT_FALSE(is_rock(drawn, ruler.at(14.3, 0.3)));
  EXPECT_TRUE(is_rock(drawn, ruler.at(-5.3, 10.0)));
  EXPECT_FALSE(is_rock(drawn, ruler.at(-3.5, 5.0)));
}

// Rock from the foot of the bench, which is darker, lies next to it.
TEST_F(ViewFromBeside, HasTheColoursOfWhereRockWas) {
  draw(1200, 900);
  const DrawnPicture drawn = picture("pile3d.png");
  const Ruler ruler = ruler_by_box(drawn);
  const auto red = [&](double x, double z) {
    const Vec2 place = ruler.at(x, z);
    return drawn.at(static_cast<int>(place.x()), static_cast<int>(place.y()))[0];
  };
  EXPECT_LT(1.5 * red(0.35, 5.5), red(12.35, 0.3));
}

// True in the middle of the rock, a metre behind its near side.
TEST_F(ViewFromBeside, ScaleBarIsAsLongAsItSays) {
  draw(1200, 900);
  const DrawnPicture drawn = picture("pile3d.png");
  const auto misfit = [&](const std::string& number) {
    const std::string words = number + " m in the middle of the view";
    const double left =
        1170.0 - text_mask(words, 18.0 * Canvas::kSamples, 0.0).advance.x() / Canvas::kSamples;
    return drawn.misfit(number, 18.0, {left, 855.0}, Anchor::kLeft);
  };
  EXPECT_LT(misfit("2"), std::min(misfit("1"), misfit("5")));
  const Box bar = drawn.extent(kInk, {900, 869, 1200, 871});
  const double length = (bar.width() - 3.0) / ruler_by_box(drawn).per_metre;  // less its end's caps
  EXPECT_NEAR(length, 2.0, 0.05 * 2.0);  // a metre of a distance of 28 m
}

// Neither key nor words are cut off or stand in each other, however narrow the picture.
TEST(PictureWords, FitAnyWidth) {
  const BlockColours colours{{}, "height before the blast [m]", strata_map(-0.75, 10.25)};
  for (const int width : {200, 240, 339, 340, 500, 641, 900, 1600}) {
    SCOPED_TRACE(width);
    Canvas canvas(width, 400, kWhite);
    draw_words({"t = 4.500 s",
                "STILL MOVING",
                {"12345 blocks", "blue: box around the rock before the blast",
                 "grey-green: muck that lay in front"}},
               colours, canvas);
    const DrawnPicture drawn(canvas);
    for (const Box& side : {Box{0, 0, 20, 400}, Box{width - 20, 0, width, 400}})
      EXPECT_EQ(drawn.count(kWhite, side), side.width() * side.height());
    Box bar = drawn.extent(colours.map->at(-0.70), drawn.all());
    EXPECT_GT(bar.height(), 14);
    bar.x1 = drawn.extent(colours.map->at(10.20), drawn.all()).x1;
    EXPECT_GE(bar.width(), std::min(width - 60, 296));
    EXPECT_EQ(drawn.count(kInk, bar) + drawn.count(kSignal, bar) + drawn.count(kWhite, bar), 0);
    const double below = bar.y0 + 16.0 + 1.15 * 18.0;
    EXPECT_TRUE(drawn.reads("10.2", 18.0, {1.0 * bar.x1, below}, Anchor::kRight));
    EXPECT_FALSE(drawn.reads("10.3", 18.0, {1.0 * bar.x1, below}, Anchor::kRight));
    EXPECT_TRUE(drawn.reads("-0.75", 18.0, {1.0 * bar.x0, below}, Anchor::kLeft));
  }
}

bool is_white(const DrawnPicture& picture, int x, int y) { return picture.shows(kWhite, x, y); }

// Pixels of one that lie beside pixels of the other, or on them.
int meetings(const DrawnPicture& one, const DrawnPicture& other) {
  constexpr int kBeside = 2;
  int meet = 0;
  for (int y = kBeside; y < one.height() - kBeside; ++y) {
    for (int x = kBeside; x < one.width() - kBeside; ++x) {
      if (is_white(one, x, y)) continue;
      for (int k = 0; k < (2 * kBeside + 1) * (2 * kBeside + 1); ++k)
        meet += is_white(other, x + k % 5 - kBeside, y + k / 5 - kBeside) ? 0 : 1;
    }
  }
  return meet;
}

// A view in which a metre of the rock is so long.
View view_of_scale(double pixels_per_metre) {
  constexpr int kSize = 200;
  return {Camera::parallel(Vec3(0, 1, 0), Vec3::Zero(), 0.5 * kSize / pixels_per_metre,
                           kSize * Canvas::kSamples),
          Vec3::Zero()};
}

// The longest bars, of 1, 2 and 5 m, and a short one, below captions of any length.
TEST(PictureWords, CaptionAndScaleBarDoNotMeet) {
  constexpr int kHeight = 300;
  const BlockColours colours{{}, "", strata_map(0.0, 1.0)};
  for (const int width : {200, 261, 500, 900}) {
    for (const double per_metre : {40.0, 81.0, 200.0}) {
      Canvas bar(width, kHeight, kWhite);
      draw_scale_bar(view_of_scale(per_metre), bar);
      const DrawnPicture scale(bar);
      for (const Box& side : {Box{0, 0, 20, kHeight}, Box{width - 20, 0, width, kHeight}})
        EXPECT_EQ(scale.count(kWhite, side), side.width() * side.height()) << width;
      for (const size_t letters : {5U, 25U, 45U, 80U}) {
        SCOPED_TRACE(std::to_string(width) + " px, " + std::to_string(per_metre) + " px/m, " +
                     std::to_string(letters));
        Canvas words(width, kHeight, kWhite);
        draw_words({"", "", {std::string(letters, 'g'), "yj"}}, colours, words);
        words.rectangle({0.0, 0.0}, {1.0 * width, 0.5 * kHeight}, kWhite, 1.0);  // the key
        EXPECT_EQ(meetings(DrawnPicture(words), scale), 0);
      }
    }
  }
}

// Blocks from 0.3 m on; what is finer is half a decade of the picture's sizes.
class SizeCurves : public ::testing::Test {
 protected:
  // Around the words that stand there.
  [[nodiscard]] static Box words_in_the_fines(const DrawnPicture& picture) {
    return picture.extent(kInk, {125, 215, 400, 765});
  }
  FragmentCurves curves_{{{0.3, 0.1}, {0.6, 0.5}, {1.2, 1.0}},
                         {{0.35, 0.1}, {0.7, 0.5}, {1.3, 1.0}},
                         {{0.3, 0.2}, {0.6, 0.7}, {1.0, 1.0}},
                         {{0.35, 0.2}, {0.7, 0.7}, {1.1, 1.0}},
                         std::nullopt,
                         std::nullopt,
                         std::nullopt};
};

TEST_F(SizeCurves, WordsOfTheFinesStandInTheMiddleOfTheirHeight) {
  const DrawnPicture drawn(draw_fragments(curves_, "Fragments", ""));
  const Box words = words_in_the_fines(drawn);
  EXPECT_GT(words.height(), 150);
  EXPECT_NEAR(words.middle().y(), 0.5 * (205.0 + 775.0), 5.0);
}

// The formula's curve goes from 30 % to 80 % there.
TEST_F(SizeCurves, WordsOfTheFinesAreClearOfAllCurves) {
  for (const double x50 : {0.1, 0.17, 0.25, 0.4}) {
    SCOPED_TRACE(x50);
    curves_.kuz_ram = KuzRamCurve{x50, 1.0};
    const DrawnPicture drawn(draw_fragments(curves_, "Fragments", ""));
    const Box words = words_in_the_fines(drawn);
    EXPECT_GT(words.height(), 150);
    EXPECT_GT(drawn.count(kSignal, {105, 205, 400, 775}), 100);  // it is there
    EXPECT_EQ(drawn.count(kSignal, words), 0);
  }
}

}  // namespace
}  // namespace muckpile
