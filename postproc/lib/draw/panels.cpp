// SPDX-License-Identifier: GPL-2.0-or-later
// Several plots of the same curves in one picture.
// Scope: see the header.
#include "draw/panels.h"

#include <algorithm>
#include <cmath>

#include "draw/title.h"

namespace muckpile {
namespace {

constexpr size_t kColumns = 2;
constexpr double kWidth = 1200.0, kFrameWidth = 465.0, kFrameHeight = 290.0;      // [px]
constexpr double kLeft = 95.0, kAbove = 40.0, kBelow = 80.0;                      // of a frame
constexpr double kTitleSize = 28.0, kTextSize = 20.0, kTop = 42.0, kLine = 34.0;  // [px]

}  // namespace

Canvas draw_panels(const Panels& panels) {
  const std::vector<PlotCurve>& curves = panels.plots.front().curves;
  double top = kTop + 0.5 * kLine;
  const double remark_line = top + kTextSize;
  if (!panels.remark.empty()) top += kLine;
  const double key_top = top, right = kWidth - 0.3 * kLeft;
  if (std::ranges::any_of(curves, [](const PlotCurve& curve) { return !curve.label.empty(); }))
    top += lay_out_key(curves, kLeft, right, key_top, nullptr);
  // One alone takes the width.
  const double frame_width = panels.plots.size() > 1 ? kFrameWidth : right - kLeft;
  const size_t rows = (panels.plots.size() + kColumns - 1) / kColumns;
  const double row_height = kAbove + kFrameHeight + kBelow;
  const double height = top + static_cast<double>(rows) * row_height;
  Canvas canvas(static_cast<int>(kWidth), static_cast<int>(std::lround(height)), kWhite);
  draw_title({kLeft, kTop}, panels.title, panels.warning, kTitleSize, canvas);
  if (!panels.remark.empty()) canvas.text({kLeft, remark_line}, panels.remark, kTextSize, kInk);
  lay_out_key(curves, kLeft, right, key_top, &canvas);
  for (size_t k = 0; k < panels.plots.size(); ++k) {
    const CurvePlot& plot = panels.plots[k];
    const double x = kLeft + static_cast<double>(k % kColumns) * kWidth / kColumns;
    const double y = top + kAbove + static_cast<double>(k / kColumns) * row_height;
    draw_frame_of(plot, {x, y}, {x + frame_width, y + kFrameHeight}, canvas);
    canvas.text({x + frame_width, y - 8.0}, plot.title, kTextSize, kInk, Anchor::kRight);
  }
  return canvas;
}

}  // namespace muckpile
