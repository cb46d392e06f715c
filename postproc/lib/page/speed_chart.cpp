// SPDX-License-Identifier: GPL-2.0-or-later
// The fastest block over time as a drawing within a page.
// Scope: see the header.
#include "page/speed_chart.h"

#include <algorithm>
#include <cstdio>

#include "args/csv_table.h"
#include "draw/axes.h"

namespace muckpile {
namespace {

constexpr double kWidth = 720.0, kHeight = 260.0;
constexpr double kLeft = 48.0, kRight = 12.0, kTop = 12.0, kBelow = 44.0;

std::string at(const Vec2& place) {
  char text[48];
  std::snprintf(text, sizeof text, "%.1f,%.1f ", place.x(), place.y());
  return text;
}

std::string label(const Vec2& place, const char* anchor, const std::string& words) {
  return "<text x=\"" + spelled(place.x(), 4) + "\" y=\"" + spelled(place.y(), 4) +
         "\" text-anchor=\"" + anchor + "\">" + words + "</text>\n";
}

std::string grid_line(const Vec2& from, const Vec2& to) {
  return "<polyline class=\"grid\" points=\"" + at(from) + at(to) + "\"/>\n";
}

}  // namespace

std::string speed_chart(const std::filesystem::path& history) {
  const CsvTable table = CsvTable::read(history);
  const size_t time = table.column("time_s"), speed = table.column("fastest_block_m_s");
  std::vector<Vec2> points;
  double fastest = 0.0;
  for (size_t row = 0; row < table.rows(); ++row) {
    points.emplace_back(table.number(row, time), table.number(row, speed));
    fastest = std::max(fastest, points.back().y());
  }
  if (points.size() < 2 || !(points.back().x() > 0.0) || !(fastest > 0.0)) return {};
  const AxisRange x{0.0, points.back().x()}, y{0.0, 1.08 * fastest};
  const Axes axes({kLeft, kTop}, {kWidth - kRight, kHeight - kBelow}, x, y);
  std::string svg =
      "<svg class=\"chart\" viewBox=\"0 0 720 260\" role=\"img\" "
      "aria-label=\"speed of the fastest block over time\">\n";
  for (const double tick : straight_ticks(y, 5)) {
    svg += grid_line(axes.place(x.low, tick), axes.place(x.high, tick));
    svg += label(axes.place(x.low, tick) + Vec2(-6.0, 5.0), "end", spelled(tick));
  }
  for (const double tick : straight_ticks(x, 8)) {
    svg += grid_line(axes.place(tick, y.low), axes.place(tick, y.high));
    svg += label(axes.place(tick, y.low) + Vec2(0.0, 18.0), "middle", spelled(tick));
  }
  svg += "<polyline class=\"curve\" points=\"";
  for (const Vec2& place : axes.places(points)) svg += at(place);
  svg += "\"/>\n" + label({0.5 * kWidth, kHeight - 6.0}, "middle", "time [s]") + "</svg>\n";
  return svg;
}

}  // namespace muckpile
