// SPDX-License-Identifier: GPL-2.0-or-later
// Panels to triangles, and triangles to text.
// Scope: see the header.
#include "geometry/files/panel_mesh.h"

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/surface/ground_panels.h"

namespace muckpile {
namespace {

constexpr std::size_t kCoordinates = 12;

/// 15 digits, as numbers that LIGGGHTS prints, so that rounding does not part points that panels
/// share; no negative zero.
void append(std::string& text, const char* word, const Vec3& v) {
  constexpr int kDigits = 15;
  text += word;
  for (const double value : v) text.append(" ").append(rounded_text(value + 0.0, kDigits));
  text += '\n';
}

void append_triangle(std::string& text, const Vec3& a, const Vec3& b, const Vec3& c) {
  append(text, "facet normal", (b - a).cross(c - a).normalized());
  text += "outer loop\n";
  for (const Vec3& corner : {a, b, c}) append(text, "vertex", corner);
  text += "endloop\nendfacet\n";
}

/// The point at the shares s from corner 1 to 2 and t from corner 1 to 4: on each edge a mean of
/// its two ends.
Vec3 point_of(const Panel& panel, double s, double t) {
  const auto& [a, b, c, d] = panel.corners;
  return (1.0 - t) * ((1.0 - s) * a + s * b) + t * ((1.0 - s) * d + s * c);
}

void append_panel(std::string& text, const Panel& panel) {
  const auto at = [&panel](int i, int j) {
    return point_of(panel, static_cast<double>(i) / panel.along,
                    static_cast<double>(j) / panel.across);
  };
  for (int i = 0; i < panel.along; ++i) {
    for (int j = 0; j < panel.across; ++j) {
      append_triangle(text, at(i, j), at(i + 1, j), at(i + 1, j + 1));
      append_triangle(text, at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
}

Panel panel_of(const std::vector<std::string>& words, const std::string& where) {
  if (words.size() == kCoordinates + 1)
    throw InputError(where + ": panel needs 12 coordinates, and two numbers of parts or none");
  Panel panel;
  const auto real = [&](std::size_t k) {
    return parse_real(where, "panel", words[k], "m", Range::closed(-1e7, 1e7));
  };
  for (std::size_t k = 0; k < 4; ++k)
    panel.corners[k] = {real(3 * k), real(3 * k + 1), real(3 * k + 2)};
  if (words.size() > kCoordinates) {
    const auto parts = [&](std::size_t k) {
      return static_cast<int>(
          parse_integer(where, "panel", words[k], "parts", Range::closed(1, 10000)));
    };
    panel.along = parts(kCoordinates);
    panel.across = parts(kCoordinates + 1);
  }
  const auto& [a, b, c, d] = panel.corners;
  const Vec3 halves[2] = {(b - a).cross(c - a), (c - a).cross(d - a)};
  if (!(halves[0].dot(halves[1]) > 0.0)) {
    throw InputError(where +
                     ": panel needs four corners in order around it, none within the triangle of "
                     "the others");
  }
  return panel;
}

}  // namespace

ArgTable write_panels_table() {
  ArgTable table("write_panels");
  table.word("file", {}, {}, "STL file to write; its folder must be there")
      .word("name", {}, "panels", "of the solid in the file")
      .group("panel", kCoordinates, kCoordinates + 2, true,
             "x y z of four corners [m], anticlockwise seen from where blocks are; then numbers of "
             "parts from corner 1 to 2 and from 1 to 4, else 1 and 1");
  return add_ground_words(table);
}

std::vector<Panel> panels_of(const ArgValues& words, const std::string& where) {
  if (!words.given("panel") && !words.given("ground"))
    throw InputError(where + ": needs a panel, or ground");
  std::vector<Panel> panels;
  for (const std::vector<std::string>& group : words.groups("panel"))
    panels.push_back(panel_of(group, where));
  return panels;
}

std::string stl_text(const std::string& name, std::span<const Panel> panels,
                     std::span<const StlTriangle> triangles) {
  std::string text = "solid ";
  text.append(name).append("\n");
  for (const Panel& panel : panels) append_panel(text, panel);
  for (const auto& [a, b, c] : triangles) append_triangle(text, a, b, c);
  return text.append("endsolid ").append(name).append("\n");
}

}  // namespace muckpile
