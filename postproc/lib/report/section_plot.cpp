// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of a vertical section: blocks in true shape, lines over them, metres with equal scales.
// Scope: 1600 px wide; the height follows from the equal scales.
#include "report/section_plot.h"

#include <algorithm>
#include <cmath>

#include "draw/clip.h"
#include "draw/text.h"
#include "draw/title.h"

namespace muckpile {
namespace {

constexpr int kWidth = 1600;
constexpr double kLeft = 105.0, kRight = 30.0, kAbove = 185.0, kBelow = 97.0;  // margins [px]
constexpr double kMostHeight = 900.0, kLeastHeight = 260.0;  // of the plot area [px]
constexpr double kTitleSize = 30.0, kTextSize = 20.0;

// Widens one of the ranges so that the plot area keeps to its height limits; returns that height
// [px].
double fit_equal_scales(AxisRange& x, AxisRange& z) {
  const double width = kWidth - kLeft - kRight;
  double height = width * (z.high - z.low) / (x.high - x.low);
  if (height > kMostHeight) {
    const double more = (z.high - z.low) * width / kMostHeight - (x.high - x.low);
    x = {x.low - 0.5 * more, x.high + 0.5 * more};
    height = kMostHeight;
  } else if (height < kLeastHeight) {
    z.high = z.low + (x.high - x.low) * kLeastHeight / width;
    height = kLeastHeight;
  }
  return height;
}

void draw_blocks(const SectionPlot& plot, const Axes& axes, Canvas& canvas) {
  for (const SectionPolygon& polygon : plot.polygons) {
    const std::vector<Vec2> seen = clipped(polygon.outline, plot.x, plot.z);
    if (seen.empty()) continue;
    const bool moved = plot.moved[polygon.block] != 0;
    const Colour colour = moved ? plot.colours.of_block[polygon.block] : kRockInPlace;
    std::vector<Vec2> outline = axes.places(seen);
    canvas.fill(outline, colour);
    outline.push_back(outline.front());
    canvas.polyline(outline, 0.7, moved ? scaled(colour, 0.45) : kGrey);
  }
}

void draw_lines(const SectionPlot& plot, const Axes& axes, Canvas& canvas) {
  for (const SectionLine& line : plot.lines) {
    std::vector<Vec2> inside;
    for (const Vec2& p : line.points) {
      if (p.x() >= plot.x.low && p.x() <= plot.x.high)
        inside.push_back(axes.place(p.x(), std::clamp(p.y(), plot.z.low, plot.z.high)));
    }
    if (line.dashed) {
      canvas.dashes(inside, line.thickness, 9.0, line.colour);
    } else {
      canvas.polyline(inside, line.thickness, line.colour);
    }
  }
}

// A bar is at least this wide, so that a 0.1 m hole shows in an 80 m section.
constexpr double kLeastBar = 5.0;

void draw_bars(const SectionPlot& plot, const Axes& axes, Canvas& canvas) {
  const double metre = axes.place(1.0, 0.0).x() - axes.place(0.0, 0.0).x();  // [pixels]
  const auto fill = [&](const SectionBar& bar, double rim, Colour colour, double opacity) {
    const Vec2 half(std::max(bar.half, 0.5 * kLeastBar / metre) + rim / metre, 0.0),
        end(0.0, rim / metre);
    const std::vector<Vec2> seen = clipped(
        {bar.low - half - end, bar.low + half - end, bar.high + half + end, bar.high - half + end},
        plot.x, plot.z);
    if (!seen.empty()) canvas.fill(axes.places(seen), colour, opacity);
  };
  for (const SectionBar& bar : plot.bars) {
    fill(bar, 1.0, kWhite, 0.8);
    fill(bar, 0.0, bar.colour, 1.0);
  }
}

void draw_key(const SectionPlot& plot, Canvas& canvas) {
  constexpr double kY = kAbove - 22.0, kStroke = 44.0;
  double x = kLeft;
  const auto label = [&](const std::string& name) {
    canvas.text({x + kStroke + 8.0, kY + 7.0}, name, kTextSize, kInk);
    x += kStroke + 36.0 + text_mask(name, kTextSize, 0.0).advance.x();
  };
  for (const SectionLine& line : plot.lines) {
    if (line.name.empty()) continue;
    const Vec2 from(x, kY), to(x + kStroke, kY);
    if (line.dashed) {
      const Vec2 stroke[] = {from, to};
      canvas.dashes(stroke, line.thickness, 9.0, line.colour);
    } else {
      canvas.line(from, to, line.thickness, line.colour);
    }
    label(line.name);
  }
  for (const SectionBar& bar : plot.bars) {
    if (bar.name.empty()) continue;
    canvas.rectangle({x, kY - 5.0}, {x + kStroke, kY + 5.0}, bar.colour);
    label(bar.name);
  }
}

}  // namespace

std::string section_note(double y, double time) {
  return "section at y = " + spelled(y) + " m, t = " + spelled(time) +
         " s; rock that stayed is grey";
}

Canvas draw_section(SectionPlot plot) {
  const double height = fit_equal_scales(plot.x, plot.z);
  Canvas canvas(kWidth, static_cast<int>(std::lround(kAbove + height + kBelow)), kWhite);
  const Axes axes({kLeft, kAbove}, {kWidth - kRight, kAbove + height}, plot.x, plot.z);
  axes.draw_grid(canvas);
  draw_blocks(plot, axes, canvas);
  draw_lines(plot, axes, canvas);
  draw_bars(plot, axes, canvas);
  axes.draw_frame(canvas, plot.x_label, "height [m]");
  draw_title({kLeft, 48.0}, plot.title, plot.warning, kTitleSize, canvas);
  canvas.text({kLeft, 88.0}, plot.subtitle, kTextSize + 2.0, kInk);
  draw_key(plot, canvas);
  draw_legend(plot.colours, {kWidth - kRight - 310.0, 22.0}, canvas);
  if (!plot.note.empty()) {
    canvas.text({kWidth - kRight, kAbove + height + kBelow - 12.0}, plot.note, kTextSize - 2.0,
                kGrey, Anchor::kRight);
  }
  return canvas;
}

}  // namespace muckpile
