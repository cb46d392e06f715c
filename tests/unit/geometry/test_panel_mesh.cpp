// SPDX-License-Identifier: GPL-2.0-or-later
// Panels as STL text: triangles, areas, normals and shared points, and what the words refuse.
// Scope: no engine; that LIGGGHTS takes such floors is in tests/regression/floors.sh.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "args/input_error.h"
#include "geometry/files/panel_mesh.h"

namespace muckpile {
namespace {

struct Triangle {
  Vec3 normal, corners[3];
  [[nodiscard]] Vec3 area() const {
    return 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  }
};

std::vector<Triangle> triangles_in(const std::string& text) {
  std::vector<Triangle> found;
  std::istringstream in(text);
  int corner = 0;
  for (std::string word; in >> word;) {
    if (word == "normal") {
      found.emplace_back();
      corner = 0;
    }
    if (word != "normal" && word != "vertex") continue;
    Vec3& to = word == "normal" ? found.back().normal : found.back().corners[corner++];
    in >> to.x() >> to.y() >> to.z();
  }
  return found;
}

std::vector<Panel> panels(const std::vector<std::string>& words) {
  std::vector<std::string> all{"file", "out.stl"};
  all.insert(all.end(), words.begin(), words.end());
  return panels_of(parse_args(write_panels_table(), "write_panels", all), "write_panels");
}

std::string refusal_of(const std::vector<std::string>& words) {
  try {
    (void)panels(words);
  } catch (const InputError& refused) {
    return refused.what();
  }
  return "";
}

/// 4 m along x, 3 m along y, 2 m above z = 0.
const std::vector<std::string> kFloor{"panel", "0", "0", "2", "4", "0", "2",
                                      "4",     "3", "2", "0", "3", "2"};

TEST(PanelMesh, WritesTwoTrianglesWithTheNormalOfTheirCorners) {
  EXPECT_EQ(stl_text("floor", panels(kFloor)),
            "solid floor\n"
            "facet normal 0 0 1\nouter loop\nvertex 0 0 2\nvertex 4 0 2\nvertex 4 3 2\n"
            "endloop\nendfacet\n"
            "facet normal 0 0 1\nouter loop\nvertex 0 0 2\nvertex 4 3 2\nvertex 0 3 2\n"
            "endloop\nendfacet\n"
            "endsolid floor\n");
}

TEST(PanelMesh, CutsAPanelIntoPartsOfItsArea) {
  std::vector<std::string> words = kFloor;
  words.insert(words.end(), {"5", "2"});
  const std::vector<Triangle> all = triangles_in(stl_text("floor", panels(words)));
  ASSERT_EQ(all.size(), 20u);  // 2 * 5 * 2
  for (const Triangle& t : all) {
    EXPECT_NEAR(t.area().z(), 4.0 * 3.0 / 20.0, 1e-12);
    EXPECT_EQ(t.normal, Vec3(0, 0, 1));
  }
}

/// A trapezium from 1 m to 3 m wide, 1 m high: 2 m2.
TEST(PanelMesh, TakesAnyConvexQuadrilateral) {
  const std::vector<Triangle> all = triangles_in(stl_text(
      "side",
      panels({"panel", "1", "1", "0", "2", "3", "0", "2", "0", "0", "1", "0", "0", "3", "4"})));
  double area = 0.0;
  for (const Triangle& t : all) {
    EXPECT_EQ(t.normal, Vec3(0, 0, -1));
    area += t.area().norm();
  }
  EXPECT_NEAR(area, 0.5 * (1.0 + 3.0) * 1.0, 1e-12);
}

/// A floor and the step below it, both cut into three along their common edge.
TEST(PanelMesh, NeighboursShareTheirPoints) {
  std::vector<std::string> words{"panel", "0.1", "-1.3", "0",   "7", "-1.3", "0", "7",
                                 "1.4",   "0",   "0.1",  "1.4", "0", "2",    "3", "panel"};
  words.insert(words.end(), {"0.1", "-1.3", "-2", "0.1", "-1.3", "0", "0.1", "1.4", "0", "0.1",
                             "1.4", "-2", "1", "3"});
  std::set<std::pair<double, double>> on_edge;
  for (const Triangle& t : triangles_in(stl_text("floor", panels(words))))
    for (const Vec3& c : t.corners)
      if (c.x() < 0.2 && c.z() > -1.0) on_edge.insert({c.x(), c.y()});
  EXPECT_EQ(on_edge.size(), 4u);
}

TEST(PanelMesh, RefusesWordsThatMakeNoPanel) {
  EXPECT_EQ(refusal_of({"name", "floor"}), "write_panels: needs a panel, or ground");
  std::vector<std::string> words = kFloor;
  words.push_back("2");
  EXPECT_EQ(refusal_of(words),
            "write_panels: panel needs 12 coordinates, and two numbers of parts or none");
  words.push_back("0");
  EXPECT_EQ(refusal_of(words), "write_panels: panel must be >= 1 and <= 10000 parts, got '0'");
  words = kFloor;
  words[1] = "left";
  EXPECT_EQ(refusal_of(words), "write_panels: panel must be a number in m, got 'left'");
  // Corners 3 and 4 changed about.
  EXPECT_EQ(refusal_of({"panel", "0", "0", "2", "4", "0", "2", "0", "3", "2", "4", "3", "2"}),
            "write_panels: panel needs four corners in order around it, none within the triangle "
            "of the others");
}

}  // namespace
}  // namespace muckpile
