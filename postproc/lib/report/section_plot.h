// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of a vertical section: blocks in true shape, lines over them, metres with equal scales.
// Scope: the caller says what the lines are; this places and draws.
#pragma once

#include <string>
#include <vector>

#include "draw/axes.h"
#include "draw/canvas.h"
#include "measure/section.h"
#include "report/block_colours.h"

namespace muckpile {

struct SectionLine {
  std::vector<Vec2> points;  // (x, z) [m]
  Colour colour;
  double thickness;  // [px]
  bool dashed;
  std::string name;  // in the legend; an empty one is left out of it
};

struct SectionBar {  // e.g. charge or stemming
  Vec2 low, high;    // ends of its axis (x, z) [m]
  double half;       // of its level width [m]
  Colour colour;
  std::string name;  // in the legend; an empty one is left out of it
};

struct SectionPlot {
  std::string title, subtitle, x_label;
  AxisRange x, z;  // [m]
  std::vector<SectionPolygon> polygons;
  std::vector<char> moved;  // per block; blocks that stayed are grey
  BlockColours colours;
  std::vector<SectionLine> lines;
  std::vector<SectionBar> bars;
  std::string note;       // at the lower right, may be empty
  std::string warning{};  // behind the title, may be empty
};

// Where and when a section is cut [m], [s].
std::string section_note(double y, double time);

Canvas draw_section(SectionPlot plot);

}  // namespace muckpile
