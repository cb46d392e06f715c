// SPDX-License-Identifier: GPL-2.0-or-later
// Files of scanners and drawings: LAS and DXF in, DXF out, and every damaged file that is refused.
// Scope: files made byte by byte.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <functional>

#include "geometry/files/dxf_file.h"
#include "geometry/files/las_file.h"
#include "geometry/files/survey_file.h"
#include "input_error_of.h"
#include "io/dxf_writer.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

using namespace testing;

void expect_in(const std::string& part, const std::string& whole) {
  EXPECT_NE(whole.find(part), std::string::npos) << whole;
}

template <class Number>
void put(std::string& bytes, size_t place, Number value) {
  if (bytes.size() < place + sizeof value) bytes.resize(place + sizeof value, '\0');
  std::memcpy(bytes.data() + place, &value, sizeof value);
}

struct LasPoint {
  std::int32_t x, y, z;
  std::uint8_t kind = 2;
  bool withheld = false;
};

// Millimetres about (355000, 6200000, 400); the box is that of the points.
std::string las(const std::vector<LasPoint>& points, int minor = 2, int format = 1) {
  const size_t header = minor == 4 ? 375 : 227, first = header + 10;
  const size_t length = format == 0 ? 20 : format == 1 ? 28 : 30;
  std::string bytes("LASF");
  put(bytes, 24, std::uint8_t{1});
  put(bytes, 25, static_cast<std::uint8_t>(minor));
  put(bytes, 94, static_cast<std::uint16_t>(header));
  put(bytes, 96, static_cast<std::uint32_t>(first));
  put(bytes, 104, static_cast<std::uint8_t>(format));
  put(bytes, 105, static_cast<std::uint16_t>(length));
  put(bytes, 107, static_cast<std::uint32_t>(minor == 4 ? 0 : points.size()));
  const double offsets[3] = {355000.0, 6200000.0, 400.0};
  for (size_t axis = 0; axis < 3; ++axis) {
    put(bytes, 131 + 8 * axis, 0.001);
    put(bytes, 155 + 8 * axis, offsets[axis]);
    double low = 1e300, high = -1e300;
    for (const LasPoint& p : points) {
      const double value = (axis == 0 ? p.x : axis == 1 ? p.y : p.z) * 0.001 + offsets[axis];
      low = std::min(low, value), high = std::max(high, value);
    }
    put(bytes, 179 + 16 * axis, high);
    put(bytes, 187 + 16 * axis, low);
  }
  if (minor == 4) put(bytes, 247, static_cast<std::uint64_t>(points.size()));
  bytes.resize(first, '\0');
  for (const LasPoint& p : points) {
    const size_t at = bytes.size();
    bytes.resize(at + length, '\0');
    put(bytes, at, p.x), put(bytes, at + 4, p.y), put(bytes, at + 8, p.z);
    if (format < 6) {
      put(bytes, at + 15, static_cast<std::uint8_t>(p.kind | (p.withheld ? 0x80 : 0)));
    } else {
      put(bytes, at + 15, static_cast<std::uint8_t>(p.withheld ? 0x04 : 0));
      put(bytes, at + 16, p.kind);
    }
  }
  return bytes;
}

const std::vector<LasPoint> kFour{{1000, 2000, -500}, {4000, 0, 250}, {0, 0, 0}, {7, 8, 9}};

class SurveyFiles : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name, const std::string& text) const {
    return write_text(temporary_.path() / name, text);
  }
  [[nodiscard]] std::string las_refused(std::string bytes) const {
    return input_error_of([&] { (void)read_las(file("a.las", bytes)); });
  }
  [[nodiscard]] std::string las_refused(const std::function<void(std::string&)>& harm) const {
    std::string bytes = las(kFour);
    harm(bytes);
    return las_refused(bytes);
  }
  [[nodiscard]] std::string dxf_refused(const std::string& text) const {
    return input_error_of([&] { (void)read_dxf(file("a.dxf", text)); });
  }
  TemporaryFolder temporary_;
};

TEST_F(SurveyFiles, LasPointsAreScaledAndOffset) {
  for (const auto& [minor, format] : {std::pair(2, 0), std::pair(2, 1), std::pair(4, 6)}) {
    const std::vector<Vec3> points = read_las(file("a.las", las(kFour, minor, format)));
    ASSERT_EQ(points.size(), 4U);
    EXPECT_NEAR((points[0] - Vec3(355001.0, 6200002.0, 399.5)).norm(), 0.0, 1e-8);
    EXPECT_NEAR((points[3] - Vec3(355000.007, 6200000.008, 400.009)).norm(), 0.0, 1e-8);
  }
}

TEST_F(SurveyFiles, NoiseAndWithheldPointsOfLasAreLeftOut) {
  std::vector<LasPoint> points = kFour;
  points.push_back({0, 0, 90000, 7, false});
  points.push_back({0, 0, 90000, 2, true});
  EXPECT_EQ(read_las(file("a.las", las(points, 2, 1))).size(), 4U);
  points.push_back({0, 0, 90000, 18, false});
  EXPECT_EQ(read_las(file("a.las", las(points, 4, 6))).size(), 4U);
}

TEST_F(SurveyFiles, LasIsASurfaceInTheUnitOfItsNumbers) {
  const SurveyedSurface surface = read_survey(file("a.LAS", las(kFour)), 0.3048);
  ASSERT_EQ(surface.points.size(), 4U);
  EXPECT_TRUE(surface.triangles.empty());
  EXPECT_NEAR(surface.points[0].z(), 399.5 * 0.3048, 1e-9);
}

TEST_F(SurveyFiles, DamagedLasIsRefused) {
  const std::string whole = las(kFour);
  expect_in("a.las: is no LAS file: it does not begin with LASF", las_refused("x y z"));
  expect_in("a.las: is cut: it has 100 bytes, its header alone 227",
            las_refused(whole.substr(0, 100)));
  expect_in("is cut: its header tells 4 points, " + std::to_string(whole.size() - 1),
            las_refused(whole.substr(0, whole.size() - 1)));
  expect_in("must be LAS 1.0 to 1.4, got 2.2", las_refused([](auto& b) { b[24] = 2; }));
  expect_in("is compressed (LAZ)", las_refused([](auto& b) { b[104] = static_cast<char>(129); }));
  expect_in("format 0 to 3 or 6 to 8, got 4", las_refused([](auto& b) { b[104] = 4; }));
  expect_in("at least 28 bytes per point of format 1, got 20",
            las_refused([](auto& b) { b[105] = 20; }));
  expect_in("points that begin within its header",
            las_refused([](auto& b) { put(b, 96, std::uint32_t{100}); }));
  expect_in("no scale > 0", las_refused([](auto& b) { put(b, 139, 0.0); }));
  expect_in("no finite numbers", las_refused([](auto& b) { put(b, 163, std::nan("")); }));
  expect_in("point 2 lies outside of the box",
            las_refused([](auto& b) { b[237 + 28 + 3] = 1; }));  // x of the second point
  expect_in("three points at least that are neither withheld nor noise, got 2",
            las_refused(las({kFour[0], kFour[1]})));
}

std::string drawing(const std::string& entities) {
  return "  0\nSECTION\n  2\nHEADER\n  9\n$INSUNITS\n 70\n 6\n  0\nENDSEC\n"
         "  0\nSECTION\n  2\nENTITIES\n" +
         entities + "  0\nENDSEC\n  0\nEOF\n";
}

std::string corner(int code, double x, double y, double z) {
  return std::to_string(code) + "\n" + std::to_string(x) + "\n " + std::to_string(code + 10) +
         "\n" + std::to_string(y) + "\n " + std::to_string(code + 20) + "\n" + std::to_string(z) +
         "\n";
}

TEST_F(SurveyFiles, FacesOfThreeAndFourCornersAreTriangles) {
  const std::string face =
      "  0\n3DFACE\n  8\nPILE\n" + corner(10, 0, 0, 1) + corner(11, 2, 0, 1) + corner(12, 2, 2, 1);
  const DxfSurface surface =
      read_dxf(file("a.dxf", drawing(face + corner(13, 2, 2, 1) + face + corner(13, 0, 2, 3))));
  ASSERT_EQ(surface.triangles.size(), 3U);
  EXPECT_EQ(surface.triangles[0][1], Vec3(2, 0, 1));
  EXPECT_EQ(surface.triangles[2][2], Vec3(0, 2, 3));
  EXPECT_TRUE(surface.points.empty());
}

TEST_F(SurveyFiles, PolyfaceMeshesArePlacesThenFacesByNumber) {
  const auto place = [](double x, double y) {
    return "  0\nVERTEX\n  8\n0\n 70\n192\n" + corner(10, x, y, 5);
  };
  const std::string mesh = "  0\nPOLYLINE\n 66\n1\n 70\n64\n" + place(0, 0) + place(1, 0) +
                           place(1, 1) + place(0, 1) + "  0\nVERTEX\n 70\n128\n" +
                           corner(10, 0, 0, 0) + " 71\n1\n 72\n2\n 73\n-3\n 74\n4\n" +
                           "  0\nSEQEND\n";
  const DxfSurface surface = read_dxf(file("a.dxf", drawing(mesh)));
  ASSERT_EQ(surface.triangles.size(), 2U);
  EXPECT_EQ(surface.triangles[1][2], Vec3(0, 1, 5));
  std::string wrong = mesh;
  expect_in("the face names vertex 9 of 4",
            dxf_refused(drawing(wrong.replace(wrong.find("-3"), 2, " 9"))));
}

TEST_F(SurveyFiles, PointsOfADrawingAreASurfaceWhereItHasNoFaces) {
  std::string points;
  for (const double x : {1.0, 2.0, 3.0}) points += "  0\nPOINT\n" + corner(10, x, 0, 7);
  const SurveyedSurface surface = read_survey(file("a.dxf", drawing(points)), 0.01);
  ASSERT_EQ(surface.points.size(), 3U);
  EXPECT_NEAR((surface.points[2] - Vec3(0.03, 0, 0.07)).norm(), 0.0, 1e-15);
}

TEST_F(SurveyFiles, DamagedDxfIsRefused) {
  const std::string face = "  0\n3DFACE\n" + corner(10, 0, 0, 1) + corner(11, 2, 0, 1);
  expect_in("a.dxf:16: 3DFACE has no group 12", dxf_refused(drawing(face)));
  std::string text = drawing(face + corner(12, 2, 2, 1));
  expect_in("without EOF: it is cut", dxf_refused(text.substr(0, text.size() - 8)));
  expect_in("3DFACE group 20 must be a finite number, got 'x.000000'",
            dxf_refused(text.replace(text.find("0.000000\n 30"), 1, "x")));
  expect_in("is no DXF: it must begin with a group code, got 'solid pile'",
            dxf_refused("solid pile\n"));
  expect_in("is a binary DXF", dxf_refused("AutoCAD Binary DXF\r\n\x1a"));
  expect_in("neither 3DFACE", dxf_refused(drawing("")));
  expect_in("none.dxf: cannot be opened",
            input_error_of([&] { (void)read_dxf(temporary_.path() / "none.dxf"); }));
}

TEST_F(SurveyFiles, TheWriterKeepsToReleaseTwelve) {
  const auto path = temporary_.path() / "out.dxf";
  {
    DxfWriter drawing(path);
    drawing.line("level 1", {355000.125, 0, 0}, {1, 2, 3});
    drawing.outline("A", {{0, 0, 9}, {1, 0, 9}, {0, 1, 9}});
  }
  const std::string text = text_of(path);
  EXPECT_TRUE(text.starts_with("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"));
  expect_in("0\nLINE\n8\nlevel_1\n10\n355000.125\n20\n0\n30\n0\n11\n1\n21\n2\n31\n3\n", text);
  expect_in("0\nPOLYLINE\n8\nA\n66\n1\n70\n9\n10\n0\n20\n0\n30\n0\n0\nVERTEX\n8\nA\n10\n0\n", text);
  EXPECT_TRUE(text.ends_with("0\nSEQEND\n8\nA\n0\nENDSEC\n0\nEOF\n")) << text;
  expect_in("neither 3DFACE", input_error_of([&] { (void)read_dxf(path); }));  // read to its end
}

}  // namespace
}  // namespace muckpile
