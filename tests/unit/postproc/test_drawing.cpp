// SPDX-License-Identifier: GPL-2.0-or-later
// The software pictures: covered pixels, hidden surfaces, shadows, ticks and text.
// Scope: draw/, and blocks in a section.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "draw/axes.h"
#include "draw/camera.h"
#include "draw/canvas.h"
#include "draw/clip.h"
#include "draw/curve_plot.h"
#include "draw/panels.h"
#include "draw/scene.h"
#include "draw/text.h"
#include "report/section_plot.h"

namespace muckpile {
namespace {

struct Pixel {
  int red, green, blue;
};

Pixel pixel(const Canvas& canvas, int x, int y) {
  const auto bytes = canvas.bytes();
  const size_t at =
      3 * (static_cast<size_t>(y) * static_cast<size_t>(canvas.width()) + static_cast<size_t>(x));
  return {bytes[at], bytes[at + 1], bytes[at + 2]};
}

TEST(Canvas, FillsTheWholePixelsInsideAndHalfTheRim) {
  Canvas canvas(20, 20, kWhite);
  canvas.rectangle({5.0, 5.0}, {10.0, 10.0 + 1.0 / 3.0}, {0.0F, 0.0F, 0.0F});
  EXPECT_EQ(pixel(canvas, 5, 5).red, 0);
  EXPECT_EQ(pixel(canvas, 9, 9).red, 0);
  EXPECT_EQ(pixel(canvas, 10, 9).red, 255);
  EXPECT_EQ(pixel(canvas, 9, 10).red, 170);  // a third is covered
}

TEST(CurvePlot, TellsTwentyFourSetsOfPointsApart) {
  std::set<std::tuple<float, float, float, int>> looks;
  for (int number = 0; number < 24; ++number) {
    const Colour colour = colour_of_curve(number);
    looks.insert({colour.red, colour.green, colour.blue, marker_corners(number)});
  }
  EXPECT_EQ(looks.size(), 24U);
}

// A square in a frame three times as wide as high.
TEST(CurvePlot, OfOneScaleShowsASquareAsOne) {
  CurvePlot plot;
  plot.one_scale = true;
  plot.curves.push_back({"", CurveStyle::kLine, 0, {{1, 5}, {3, 5}, {3, 7}, {1, 7}, {1, 5}}});
  Canvas canvas(800, 300, kWhite);
  draw_frame_of(plot, {100, 20}, {700, 220}, canvas);
  const auto bytes = canvas.bytes();
  Vec2 low(800, 300), high(0, 0);
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 800; ++x) {
      const size_t at = 3 * static_cast<size_t>(y * canvas.width() + x);
      if (bytes[at + 2] <= bytes[at] + 50) continue;  // no bluer than red
      low = low.cwiseMin(Vec2(x, y));
      high = high.cwiseMax(Vec2(x, y));
    }
  }
  EXPECT_GT(high.x() - low.x(), 100.0);
  EXPECT_NEAR(high.x() - low.x(), high.y() - low.y(), 2.0);
}

TEST(Canvas, BlendsByOpacity) {
  Canvas canvas(4, 4, kWhite);
  canvas.rectangle({0, 0}, {4, 4}, {1.0F, 0.0F, 0.0F}, 0.5);
  EXPECT_EQ(pixel(canvas, 1, 1).red, 255);
  EXPECT_NEAR(pixel(canvas, 1, 1).blue, 128, 1);
}

TEST(Canvas, TextStandsOnItsBaseLineAtItsAnchor) {
  const auto ink_in = [](const Canvas& canvas, int x0, int x1, int y0, int y1) {
    int ink = 0;
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) ink += 255 - pixel(canvas, x, y).red;
    }
    return ink;
  };
  Canvas left(60, 40, kWhite), right(60, 40, kWhite);
  left.text({30.0, 30.0}, "H", 20.0, kInk, Anchor::kLeft);
  right.text({30.0, 30.0}, "H", 20.0, kInk, Anchor::kRight);
  EXPECT_GT(ink_in(left, 30, 60, 10, 31), 2000);
  EXPECT_EQ(ink_in(left, 0, 29, 0, 40), 0);
  EXPECT_EQ(ink_in(left, 0, 60, 32, 40), 0);  // nothing below the base line
  EXPECT_GT(ink_in(right, 0, 31, 10, 31), 2000);
  EXPECT_EQ(ink_in(right, 32, 60, 0, 40), 0);
}

TEST(Text, IsLongerForMoreWordsAndTurns) {
  const TextMask one = text_mask("pile", 30.0, 0.0), two = text_mask("pile pile", 30.0, 0.0);
  EXPECT_GT(two.advance.x(), 1.9 * one.advance.x());
  const TextMask up = text_mask("pile", 30.0, 90.0);
  EXPECT_NEAR(up.advance.y(), -one.advance.x(), 2.0);  // whole pixels
}

TEST(Axes, TicksAreRoundNumbersInsideTheRange) {
  EXPECT_EQ(straight_ticks({-8.0, 31.0}, 4), (std::vector<double>{0.0, 10.0, 20.0, 30.0}));
  const auto fine = straight_ticks({0.0, 1.0}, 5);
  ASSERT_EQ(fine.size(), 6U);
  EXPECT_NEAR(fine[3], 0.6, 1e-12);
  const auto wide = logarithmic_ticks({0.01, 1.0});  // 0.01, 0.02, 0.05, 0.1 ...
  ASSERT_EQ(wide.size(), 7U);
  EXPECT_NEAR(wide[2], 0.05, 1e-12);
  const auto narrow = logarithmic_ticks({0.15, 0.45});  // 0.2, 0.3, 0.4
  ASSERT_EQ(narrow.size(), 3U);
  EXPECT_NEAR(narrow[1], 0.3, 1e-12);
}

TEST(Axes, PlacesDataLinearlyAndByLogarithm) {
  const Axes straight({100, 50}, {300, 150}, {0.0, 10.0}, {0.0, 5.0});
  EXPECT_NEAR((straight.place(5.0, 5.0) - Vec2(200, 50)).norm(), 0.0, 1e-12);
  const Axes logarithmic({100, 50}, {300, 150}, {0.01, 1.0}, {0.0, 5.0}, Scale::kLogarithmic);
  EXPECT_NEAR(logarithmic.place(0.1, 0.0).x(), 200.0, 1e-9);
}

// How many words stand in these rows, with a gap of at least `gap` columns between them.
int words_in_rows(const Canvas& canvas, int top, int bottom, int gap) {
  const auto bytes = canvas.bytes();
  int words = 0, blank = gap;
  for (int x = 0; x < canvas.width(); ++x) {
    bool ink = false;
    for (int y = top; y < bottom; ++y)
      ink = ink || bytes[3 * static_cast<size_t>(y * canvas.width() + x)] < 128;
    if (ink && blank >= gap) ++words;
    blank = ink ? 0 : blank + 1;
  }
  return words;
}

// Ticks at 0.0005, 0.0006 ... 0.001, 0.002 some 30 px apart, words of 60 px: 0.0005, 0.001, 0.002
// and, as not all have room that are between, none of these.
TEST(Axes, WordsOfTicksDoNotOverlap) {
  Canvas canvas(500, 200, kWhite);
  const Axes axes({100, 20}, {450, 120}, {4.5e-4, 2.2e-3}, {0.0, 1.0}, Scale::kLogarithmic);
  axes.draw_frame(canvas, "", "");
  EXPECT_EQ(words_in_rows(canvas, 130, 148, 8), 3);
  Canvas wide(1500, 200, kWhite);
  const Axes room({100, 20}, {1450, 120}, {4.5e-4, 2.2e-3}, {0.0, 1.0}, Scale::kLogarithmic);
  room.draw_frame(wide, "", "");
  EXPECT_EQ(words_in_rows(wide, 130, 148, 8), 7);
}

// Five decades in 600 px: the powers of ten alone have room; in 250 px every second of them.
TEST(Axes, WordsOfManyDecadesAreEven) {
  for (const auto& [width, words] : {std::pair{600.0, 6}, {250.0, 3}}) {
    Canvas canvas(800, 200, kWhite);
    const Axes axes({100, 20}, {100 + width, 120}, {1e-5, 1.0}, {0.0, 1.0}, Scale::kLogarithmic);
    axes.draw_frame(canvas, "", "");
    EXPECT_EQ(words_in_rows(canvas, 130, 148, 8), words);
  }
}

double area_of(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return 0.5 * twice;
}

TEST(Clip, KeepsThePartInsideTheFrame) {
  const AxisRange x{0.0, 4.0}, y{0.0, 3.0};
  const std::vector<Vec2> inside = {{1, 1}, {2, 1}, {2, 2}};
  EXPECT_EQ(clipped(inside, x, y), inside);
  EXPECT_TRUE(clipped({{5, 1}, {6, 1}, {6, 2}}, x, y).empty());
  EXPECT_TRUE(clipped({{-2, 4}, {-1, 4}, {-1, 5}}, x, y).empty());
  // A square of side 2 about each of: the middle of an edge, a corner, the whole frame.
  const auto square = [](double cx, double cy, double half) {
    return std::vector<Vec2>{{cx - half, cy - half},
                             {cx + half, cy - half},
                             {cx + half, cy + half},
                             {cx - half, cy + half}};
  };
  EXPECT_NEAR(area_of(clipped(square(4, 1.5, 1), x, y)), 2.0, 1e-12);
  EXPECT_NEAR(area_of(clipped(square(0, 3, 1), x, y)), 1.0, 1e-12);
  EXPECT_NEAR(area_of(clipped(square(2, 1.5, 10), x, y)), 12.0, 1e-12);
  // A triangle whose tip sticks out at the top: (1,2) (3,2) (2,4) less its upper quarter.
  EXPECT_NEAR(area_of(clipped({{1, 2}, {3, 2}, {2, 4}}, x, y)), 2.0 - 0.5, 1e-12);
}

TEST(SectionPlot, BlockAcrossTheFrameIsCutAtIt) {
  SectionPlot plot{"", "", "", {0.0, 10.0}, {0.0, 5.0}, {}, {1}, {{{0.0F, 0.0F, 0.0F}}, "", {}},
                   {}, {}, ""};
  plot.polygons = {{0, {{8.0, 1.0}, {12.0, 1.0}, {12.0, 4.0}, {8.0, 4.0}}}};
  const Canvas canvas = draw_section(plot);
  // The plot area ends 30 px left of the picture's edge and is 1465 px wide.
  const int middle = 185 + 1465 / 4;
  EXPECT_EQ(pixel(canvas, 105 + 1465 * 9 / 10, middle).red, 0);
  EXPECT_EQ(pixel(canvas, 105 + 1465 * 3 / 4, middle).red, 255);
  EXPECT_EQ(pixel(canvas, 1600 - 15, middle).red, 255);
}

TEST(Camera, PlaceAndPointAreInverse) {
  const Vec3 p(3.0, -2.0, 1.0);
  for (const Camera& camera : {Camera::perspective({20, -30, 15}, {0, 0, 0}, 0.5, 1600, 900),
                               Camera::parallel({-1, 0.5, -2}, {0, 0, 0}, 40.0, 1000)}) {
    EXPECT_NEAR((camera.point(camera.place(p), camera.nearness(p)) - p).norm(), 0.0, 1e-9);
  }
}

TEST(Camera, NearnessOfAPlaneIsLinearOverThePicture) {
  const Vec3 p(3.0, -2.0, 1.0), normal = Vec3(0.3, -0.2, 1.0).normalized();
  const Vec3 other = p + 4.0 * normal.unitOrthogonal();
  for (const Camera& camera : {Camera::perspective({20, -30, 15}, {0, 0, 0}, 0.5, 1600, 900),
                               Camera::parallel({-1, 0.5, -2}, {0, 0, 0}, 40.0, 1000)}) {
    const Vec3 plane = camera.nearness_of_plane(p, normal);
    const Vec2 place = camera.place(other);
    EXPECT_NEAR(plane.x() + plane.y() * place.x() + plane.z() * place.y(), camera.nearness(other),
                1e-9);
  }
}

ScenePolygon level_square(double half, double z, Colour colour, int object) {
  return {{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, colour, object};
}

struct Drawing {
  explicit Drawing(const Scene& scene) {
    const Camera camera = Camera::perspective({0.0, -30.0, 40.0}, {0, 0, 0}, 0.5,
                                              canvas.sample_width(), canvas.sample_height());
    draw_scene(scene, camera, canvas);
  }
  Canvas canvas{90, 60, kWhite};
};

constexpr Colour kRed{1.0F, 0.0F, 0.0F}, kGreen{0.0F, 1.0F, 0.0F};

TEST(Scene, NearerPolygonHidesTheFartherInAnyOrder) {
  for (const bool near_first : {true, false}) {
    Scene scene{
        {level_square(10, 0, kRed, 0), level_square(3, 5, kGreen, 1)}, {}, {0.0, 0.0, 1.0}, 1.0};
    if (near_first) std::swap(scene.polygons[0], scene.polygons[1]);
    const Drawing d(scene);
    const Pixel middle = pixel(d.canvas, 45, 22);
    EXPECT_GT(middle.green, 150);
    EXPECT_EQ(middle.red, 0);
  }
}

TEST(Scene, PolygonSeenFromBehindIsNotDrawn) {
  Scene scene{
      {level_square(10, 0, kRed, 0), level_square(3, 5, kGreen, 1)}, {}, {0.0, 0.0, 1.0}, 1.0};
  std::reverse(scene.polygons[1].corners.begin(), scene.polygons[1].corners.end());
  EXPECT_EQ(pixel(Drawing(scene).canvas, 45, 22).green, 0);
}

TEST(Scene, RoofThrowsAShadowBesideItself) {
  // Sun at 45 degrees from +x: the roof at 5 m shades the ground 5 m towards -x.
  Scene bare{{level_square(12, 0, kRed, 0)}, {}, Vec3(1.0, 0.0, 1.0).normalized(), 1.0};
  Scene roofed = bare;
  roofed.polygons.push_back(level_square(2, 5, kGreen, 1));
  const Camera camera = Camera::perspective({0.0, -30.0, 40.0}, {0, 0, 0}, 0.5, 270, 180);
  const Vec2 shaded = camera.place({-5.0, 0.0, 0.0}) / Canvas::kSamples,
             lit = camera.place({6.0, 0.0, 0.0}) / Canvas::kSamples;
  const auto red = [](const Scene& scene, const Vec2& p) {
    return pixel(Drawing(scene).canvas, static_cast<int>(p.x()), static_cast<int>(p.y())).red;
  };
  EXPECT_LT(red(roofed, shaded), 0.7 * red(bare, shaded));
  EXPECT_EQ(red(roofed, lit), red(bare, lit));
}

// A level line goes to the end of its frame: three quarters across the picture there is one if the
// frame is alone, and in the second of two frames.
TEST(Panels, AFrameAloneTakesTheWidth) {
  CurvePlot plot;
  plot.x = {0.0, 1.0};
  plot.y = {0.0, 2.0};
  plot.curves.push_back({"", CurveStyle::kLine, 0, {{0.0, 1.0}, {1.0, 1.0}}});
  const auto coloured = [](const Canvas& canvas, int x) {
    for (int y = 100; y < 350; ++y) {
      const Pixel p = pixel(canvas, x, y);
      if (p.blue > p.red + 50) return true;
    }
    return false;
  };
  Panels panels;
  panels.plots = {plot};
  const Canvas alone = draw_panels(panels);
  for (const int x : {200, 600, 1100}) EXPECT_TRUE(coloured(alone, x)) << x;
  panels.plots = {plot, plot};
  const Canvas two = draw_panels(panels);
  EXPECT_EQ(alone.width(), two.width());
  EXPECT_FALSE(coloured(two, 600));  // between them
  EXPECT_TRUE(coloured(two, 900));
}

}  // namespace
}  // namespace muckpile
