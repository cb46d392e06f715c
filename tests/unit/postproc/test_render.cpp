// SPDX-License-Identifier: GPL-2.0-or-later
// Sub-command render: what a picture frames, what a section leaves, films.
// Scope: report/picture_view, picture_scene, film, and small pictures of made-up runs.
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "draw/depth_buffer.h"
#include "drawn_picture.h"
#include "geometry/files/block_file.h"
#include "input_error_of.h"
#include "measure/start_extent.h"
#include "report/block_colours.h"
#include "report/picture_report.h"
#include "report/picture_scene.h"
#include "report/picture_view.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

Vec3 normal_of(const std::vector<Vec3>& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

// Rock within 4 m of the axis was thrown 20 m: the rim is framed, its ejecta are not.
TEST(PictureOfACrater, ShowsTheRimAndNotTheFarthestEjecta) {
  const BenchRun run = crater_run();
  const std::vector<Vec3> points = framed_crater(run.blocks, run.last);
  double reach = 0.0;
  for (const Vec3& p : points) reach = std::max(reach, p.head<2>().norm());
  EXPECT_GT(reach, 1.5 * 3.7);
  EXPECT_LT(reach, 2.5 * 4.0);
}

TEST(PictureOfACrater, WithoutOneShowsAllRock) {
  const BenchRun run = crater_run();
  EXPECT_TRUE(framed_crater(run.blocks, start_snapshot(run.blocks)).empty());
}

TEST(PictureOfABench, IsFramedWithoutTheFewBlocksThatFlewFarthest) {
  BenchRun run = bench_run();
  run.last.states[5].centre = {300.0, -80.0, 0.0};
  const Extent box = framed_box(run.blocks, run.last);
  EXPECT_LT(box.high.x(), 16.0);
  EXPECT_NEAR(box.low.y(), -1.75, 0.01);  // a metre beside the cubes at -0.75
  EXPECT_NEAR(box.low.x(), -8.75, 0.01);
}

TEST(View, GoesToItsFocusAndComesNearer) {
  const Canvas canvas(320, 180, kWhite);
  const std::vector<Vec3> points{{0, 0, 0}, {10, 0, 0}, {0, 5, 3}};
  const Vec3 to_eye = direction_of_eye(90.0, 30.0);
  EXPECT_NEAR((to_eye - Vec3(0.0, -std::sqrt(0.75), 0.5)).norm(), 0.0, 1e-12);
  PictureOptions options;
  const View whole = framing_view(points, to_eye, options, canvas);
  options.zoom = 2.0;
  options.focus = {10.0, 0.0, 0.0};
  const View near = framing_view(points, to_eye, options, canvas);
  EXPECT_NEAR((near.target - Vec3(10.0, 0.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(near.camera.depth(near.target), 0.5 * whole.camera.depth(whole.target), 1e-9);
  const Vec2 middle = near.camera.place(near.target);
  EXPECT_NEAR(middle.x(), 0.5 * canvas.sample_width(), 1e-9);
  EXPECT_NEAR(middle.y(), 0.5 * canvas.sample_height(), 1e-9);
}

// The scale bar begins at most 230 px from the right, and the words end some pixels before.
TEST(PictureOfABench, WordsBelowEndBeforeTheScaleBar) {
  TemporaryFolder temporary;
  write_bench(temporary.path());
  PictureOptions options;
  options.width = 641;
  options.height = 401;
  report_picture(ResultFolder(temporary.path()), options);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((temporary.path() / "pile3d.png").c_str());
  reader->Update();
  const auto dark = [&](int from, int to) {
    int count = 0;
    for (int y = 12; y < 38; ++y)  // VTK counts from below
      for (int x = from; x < to; ++x)
        count += reader->GetOutput()->GetScalarComponentAsDouble(x, y, 0, 0) < 80.0;
    return count;
  };
  EXPECT_GT(dark(28, 385), 200);
  EXPECT_EQ(dark(393, 409), 0);
  EXPECT_GT(dark(409, 620), 200);
}

// Two cubes side by side along y, cut through the first at y = 0.25.
class DrawnSection : public ::testing::Test {
 protected:
  void cut(bool keep_high) {
    const CutPlane plane{{{0.0, 0.25}, {1.0, 0.25}}, keep_high};
    const std::vector<Colour> colours(blocks_.size(), kGrey);
    const Snapshot start = start_snapshot(blocks_);
    add_blocks(blocks_, start, colours, Reflection(0, extent_of(blocks_, start.states)), scene_);
    cut_away(plane, scene_);
    add_cut_faces(plane, blocks_, start, colours, scene_);
  }
  std::vector<StartBlock> blocks_ = as_start_blocks(cubes_in({0, 0, 0}, {0.5, 1.0, 0.5}));
  Scene scene_;
};

TEST_F(DrawnSection, LeavesWhatIsBehindItAndAFaceTowardsTheEye) {
  cut(true);
  ASSERT_EQ(scene_.polygons.size(), 5U + 6U + 1U);  // the first cube has lost its front
  for (const ScenePolygon& polygon : scene_.polygons)
    for (const Vec3& p : polygon.corners) EXPECT_GE(p.y(), 0.25 - 1e-12);
  EXPECT_EQ(scene_.polygons.back().object, 0);
  EXPECT_NEAR(normal_of(scene_.polygons.back().corners).normalized().y(), -1.0, 1e-12);
}

TEST_F(DrawnSection, FacesAnEyeOnTheOtherSideToo) {
  cut(false);
  ASSERT_EQ(scene_.polygons.size(), 5U + 1U);
  EXPECT_NEAR(normal_of(scene_.polygons.back().corners).normalized().y(), 1.0, 1e-12);
}

// A solid of 6 x 6 x 6 cubes, of which the inner ones are hidden.
TEST(DepthBuffer, LeavesOutHiddenObjectsWithoutATrace) {
  const auto blocks = as_start_blocks(cubes_in({0, 0, 0}, {3, 3, 3}));
  const Snapshot start = start_snapshot(blocks);
  const std::vector<Colour> grey(blocks.size(), kGrey);
  Scene scene;
  add_blocks(blocks, start, grey, Reflection(0, extent_of(blocks, start.states)), scene);
  const std::vector<Vec3> normals = normals_of(scene.polygons);
  const std::vector<SceneObject> objects = objects_of(scene.polygons);
  ASSERT_EQ(objects.size(), blocks.size());
  const Camera camera = Camera::perspective({9, -7, 6}, {1.5, 1.5, 1.5}, 0.6, 150, 117);
  const auto drawn = [&](const std::vector<SceneObject>& some) {
    DepthBuffer buffer(150, 117);
    const SceneParts parts{scene.polygons, normals, some};
    buffer.look_at(parts, camera, true);
    for (size_t band = 0; band < buffer.bands(); ++band) buffer.draw_band(band, parts, camera);
    return buffer;
  };
  const DepthBuffer all = drawn(objects);
  std::vector<double> nearest(150 * 117, -std::numeric_limits<double>::infinity());
  for (const SceneObject& object : objects) {  // alone, so that nothing hides it
    const DepthBuffer one = drawn({object});
    for (int y = 0; y < 117; ++y)
      for (int x = 0; x < 150; ++x) {
        double& here = nearest[static_cast<size_t>(150 * y + x)];
        here = std::max(here, one.near(x, y));
      }
  }
  int seen = 0;
  for (int y = 0; y < 117; ++y)
    for (int x = 0; x < 150; ++x) {
      ASSERT_EQ(all.near(x, y), nearest[static_cast<size_t>(150 * y + x)]) << x << ' ' << y;
      seen += all.polygon(x, y) >= 0 ? 1 : 0;
    }
  EXPECT_GT(seen, 3000);
}

class Fields : public ::testing::Test {
 protected:
  void SetUp() override { write_bench(temporary_.path()); }
  [[nodiscard]] BlockField field(const std::string& name) const {
    const ResultFolder folder(temporary_.path());
    const Snapshot last = read_snapshot(folder.snapshots().back(), folder.blocks());
    return BlockFields(folder, folder.blocks()).of(name, last);
  }
  TemporaryFolder temporary_;
  BenchRun run_ = bench_run();
};

TEST_F(Fields, OfMotionAreThoseOfTheSnapshots) {
  const BlockField along = field("moved_x"), launch = field("launch_speed");
  EXPECT_EQ(launch.column, "launch_speed_m_s");
  for (size_t b = 0; b < run_.blocks.size(); ++b) {
    const Vec3& start = run_.blocks[b].centroid;
    EXPECT_NEAR(along.values[b], run_.last.states[b].centre.x() - start.x(), 1e-7);
    const bool prism = start.x() > -kBurden && start.z() > 0.0;
    EXPECT_NEAR(launch.values[b], !prism ? 0.0 : start.x() > -1.0 ? 14.0 : 6.0, 1e-7);
  }
}

// Each block of the made-up run is a fragment of its own; here all that stayed are one.
// Frames share the range of the whole run: the prism moves in the middle one only.
TEST_F(Fields, HaveOneRangeForAllFrames) {
  const ResultFolder folder(temporary_.path());
  const BlockFields fields(folder, folder.blocks());
  const auto range = fields.range_of_run("vx");
  ASSERT_TRUE(range.has_value());
  EXPECT_NEAR((*range)[0], 0.0, 1e-12);
  EXPECT_NEAR((*range)[1], 14.0, 1e-9);
  const BlockColours colours =
      block_colours(fields.of("vx", start_snapshot(folder.blocks())), range);
  EXPECT_NEAR(colours.map->high(), 14.0, 1e-9);
  EXPECT_FALSE(fields.range_of_run("start_height").has_value());
}

TEST_F(Fields, ZonesThatAreNoNumbersAreRefused) {
  const auto path = temporary_.path() / "dump/blocks.vtk";
  std::string text = text_of(path) + "SCALARS zone int 1\nLOOKUP_TABLE default\n1.5\n";
  for (size_t b = 1; b < run_.blocks.size(); ++b) text += "0\n";
  write_text(path, text);
  EXPECT_NE(input_error_of([&] {
              (void)ResultFolder(temporary_.path()).blocks();
            }).find("zone must be a whole number from 0 to 255, got '1.5"),
            std::string::npos);
}

TEST_F(Fields, SizeOfAFragmentIsThatOfAllItsBlocks) {
  int standing = 0;
  for (size_t b = 0; b < run_.blocks.size(); ++b) {
    if ((run_.last.states[b].centre - run_.blocks[b].centroid).norm() > 0.1) continue;
    if (standing++ == 0) continue;
    run_.last.states[b].fragment = run_.last.states[0].fragment;
  }
  write_snapshot(temporary_.path() / "dump/blocks_000002000.csv", run_.blocks, run_.last);
  const BlockField sizes = field("fragment_size");
  EXPECT_NEAR(sizes.values[0], std::cbrt(standing * 0.125), 1e-9);
  EXPECT_NEAR(std::ranges::min(sizes.values), kCube, 1e-9);
}

TEST_F(Fields, HoleIsTheNearestByName) {
  write_text(temporary_.path() / "dump/holes.csv",
             "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,"
             "to_m,surface_delay_s\n"
             "left,-5,-0.6,10.5,-5,-0.6,-1,0.1,2.5,11.5,0\n"
             "right,-5,0.6,10.5,-5,0.6,-1,0.1,2.5,11.5,0\n");
  const BlockField holes = field("hole");
  for (size_t b = 0; b < run_.blocks.size(); ++b)
    EXPECT_EQ(holes.names.at(static_cast<int>(holes.values[b])),
              run_.blocks[b].centroid.y() > 0.0 ? "right" : "left");
  const BlockColours colours = block_colours(holes);
  ASSERT_EQ(colours.names.size(), 2U);
  EXPECT_FALSE(colours.map.has_value());
}

TEST_F(Fields, ZonesHaveTheNamesOfTheInput) {
  const std::vector<double> density{kDensity, 3400.0};
  std::vector<std::uint8_t> zones;
  for (const StartBlock& block : run_.blocks) zones.push_back(block.centroid.z() > 5.0 ? 1 : 0);
  write_blocks((temporary_.path() / "dump/blocks.vtk").string(), run_.shapes, 1, density, zones,
               "");
  const auto scene = temporary_.path() / "dump/scene.json";
  std::string text = text_of(scene);
  write_text(scene, text.insert(1,
                                "\"knobs\": {\"plane_words\": \"natural_joints 85 0 2 1 zone "
                                "cap 3400 above 0 0 5 0 0\"}, "));
  const BlockField named = field("zone");
  EXPECT_EQ(named.names.at(1), "cap");
  EXPECT_EQ(named.values.front(), 0.0);
  EXPECT_EQ(named.values.back(), 1.0);
  EXPECT_NEAR(field("density").values.back(), 3400.0, 0.01);
}

TEST(BlockColours, OfSignedFieldsArePaleAtZero) {
  const BlockField way{"way [m]", "way_m", FieldScale::kSigned, {-1.0, 4.0, 0.0}};
  const BlockColours colours = block_colours(way);
  EXPECT_EQ(colours.map->low(), -4.0);
  EXPECT_EQ(colours.map->high(), 4.0);
  const Colour& pale = colours.of_block[2];
  EXPECT_GT(std::min({pale.red, pale.green, pale.blue}), 0.9F);
  EXPECT_EQ(block_colours(way, std::nullopt, std::array{0.0, 2.0}).map->low(), 0.0);
}

class Render : public ::testing::Test {
 protected:
  void SetUp() override {
    write_heap(temporary_.path());
    options_.width = 320;
    options_.height = 180;
  }
  ~Render() override { setenv("PATH", path_.c_str(), 1); }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const {
    return temporary_.path() / name;
  }
  void draw() const { report_picture(ResultFolder(temporary_.path()), options_); }
  // A program that writes its words to the film in place of ffmpeg.
  void install_ffmpeg(const std::string& body) const {
    write_text(file("bin/ffmpeg"), "#!/bin/sh\n" + body + "\n");
    std::filesystem::permissions(file("bin/ffmpeg"), std::filesystem::perms::owner_all);
    setenv("PATH", (file("bin").string() + ":" + path_).c_str(), 1);
  }
  TemporaryFolder temporary_;
  PictureOptions options_;
  std::string path_ = std::getenv("PATH");
};

TEST_F(Render, DrawsASectionInTheBrokenShare) {
  options_.colour_by = "broken";
  draw();
  const std::string whole = text_of(file("pile3d.png"));
  options_.section = 0.0;
  draw();
  EXPECT_GT(std::filesystem::file_size(file("pile3d.png")), 2000U);
  EXPECT_NE(text_of(file("pile3d.png")), whole);
}

TEST_F(Render, RefusesACutBesideTheRock) {
  for (const double y : {1e6, -1e6, std::nan("")}) {
    options_.section = y;
    EXPECT_NE(input_error_of([&] { draw(); }).find("render: a cut must meet rock"),
              std::string::npos);
  }
  options_.section.reset();
  LineOptions line;
  line.from = {500.0, 0.0};
  line.to = {500.0, 1.0};
  EXPECT_NE(input_error_of([&] {
              report_picture(ResultFolder(temporary_.path()), options_, line);
            }).find("render: a cut must meet rock, which lies from x = "),
            std::string::npos);
}

TEST_F(Render, DrawsASectionAlongAnyLine) {
  options_.section = 0.0;
  draw();
  const std::string across_y = text_of(file("pile3d.png"));
  options_.section.reset();
  LineOptions line;
  line.from = {3.0, 1.0};
  line.to = {4.0, -1.0};
  const auto draw_along = [&] { report_picture(ResultFolder(temporary_.path()), options_, line); };
  draw_along();
  EXPECT_NE(text_of(file("pile3d.png")), across_y);
  line.to = line.from;
  EXPECT_NE(input_error_of(draw_along).find("render: --from and --to must be two points"),
            std::string::npos);
}

// A box of 4 m x 2 m x 1 m cut along its diagonal: half of the volume stays, and the cut face is
// sqrt(20) m x 1 m, with the normal to the eye.
TEST(PictureScene, CutAlongADiagonalLeavesHalfAndItsFace) {
  std::vector<StartBlock> blocks = as_start_blocks(cubes_in({0, 0, 0}, {4, 2, 1}));
  const Snapshot start = start_snapshot(blocks);
  const std::vector<Colour> colours(blocks.size(), kGrey);
  for (const Vec3& to_eye : {Vec3(1, -3, 1), Vec3(-1, 3, 1)}) {
    const CutPlane plane = cut_along({{0, 0}, {4, 2}}, to_eye);
    Scene scene;
    add_blocks(blocks, start, colours, Reflection(0, extent_at_start(blocks)), scene);
    cut_away(plane, scene);
    const Vec3 normal = Vec3(1, -2, 0).normalized() * (to_eye.y() < 0.0 ? 1.0 : -1.0);
    for (const ScenePolygon& polygon : scene.polygons)
      for (const Vec3& p : polygon.corners) EXPECT_LE(normal.dot(p), 1e-12);
    const size_t before = scene.polygons.size();
    add_cut_faces(plane, blocks, start, colours, scene);
    Vec3 face = Vec3::Zero();  // area, times the normal
    double volume = 0.0;       // of what is closed by all polygons
    for (size_t k = 0; k < scene.polygons.size(); ++k) {
      const std::vector<Vec3>& c = scene.polygons[k].corners;
      for (size_t v = 1; v + 1 < c.size(); ++v) {
        const Vec3 area = 0.5 * (c[v] - c[0]).cross(c[v + 1] - c[0]);
        if (k >= before) face += area;
        volume += area.dot(c[0]) / 3.0;
      }
    }
    EXPECT_NEAR(face.norm(), std::sqrt(20.0), 1e-9);
    EXPECT_NEAR(face.normalized().dot(normal), 1.0, 1e-9);
    EXPECT_NEAR(volume, 4.0, 1e-9);
  }
}

TEST_F(Render, WithoutFfmpegSaysWhatToInstallAndDrawsNothing) {
  setenv("PATH", file("nowhere").c_str(), 1);
  options_.film = file("film.mp4");
  EXPECT_NE(input_error_of([&] { draw(); }).find("not installed (Debian and Ubuntu: apt install"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("pile3d.png")));
}

TEST_F(Render, MakesAFilmOfAllSnapshotsAndLeavesNoFrames) {
  install_ffmpeg("for last; do :; done; ls \"${8%/*}\" > \"$last\"");
  options_.film = file("film.mp4");
  draw();
  EXPECT_EQ(text_of(file("film.mp4")), "pile3d_0000.png\npile3d_0001.png\n");
  EXPECT_FALSE(std::filesystem::exists(file(".film")));
  EXPECT_FALSE(std::filesystem::exists(file("pile3d_0000.png")));
}

// On the mean of all pixels [steps of 255]: 2.5 between a frame and what its coding leaves of it,
// 4.7 between the two snapshots.
double mean_difference(const DrawnPicture& a, const DrawnPicture& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      for (size_t k = 0; k < 3; ++k) sum += std::abs(a.at(x, y).at(k) - b.at(x, y).at(k));
  return sum / (3.0 * a.width() * a.height());
}

TEST_F(Render, TheFilmThatFfmpegMakesShowsTheSnapshots) {
  if (std::system("ffmpeg -loglevel quiet -version >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "ffmpeg is not installed";
  options_.frames = 2;
  options_.film = file("film.mp4");
  options_.height = 181;  // a film has an even number
  draw();
  const std::string unpack = "ffmpeg -loglevel error -nostdin -i '" + file("film.mp4").string() +
                             "' '" + file("unpacked_%d.png").string() + "'";
  ASSERT_EQ(std::system(unpack.c_str()), 0);
  EXPECT_FALSE(std::filesystem::exists(file("unpacked_3.png")));
  const DrawnPicture first(file("pile3d_0000.png")), last(file("pile3d_0001.png"));
  const DrawnPicture filmed(file("unpacked_1.png")), filmed_last(file("unpacked_2.png"));
  EXPECT_EQ(filmed.width(), 320);
  EXPECT_EQ(filmed.height(), 182);
  EXPECT_LT(mean_difference(first, filmed), 4.0);
  EXPECT_LT(mean_difference(last, filmed_last), 4.0);
  EXPECT_LT(mean_difference(first, filmed), mean_difference(last, filmed));
  EXPECT_LT(mean_difference(last, filmed_last), mean_difference(first, filmed_last));
}

TEST_F(Render, MakesAFilmOfItsOwnFramesAlone) {
  install_ffmpeg("for last; do :; done; echo \"$*\" > \"$last\"");
  write_text(file("pile3d_0003.png"), "of an earlier call");
  options_.film = file("film.mp4");
  options_.frames = 3;
  draw();
  EXPECT_NE(text_of(file("film.mp4")).find(" -frames:v 3 "), std::string::npos);
}

TEST_F(Render, RefusesARangeForColoursThatOnlyName) {
  options_.colour_by = "fragment";
  options_.colour_range = {0.0, 10.0};
  EXPECT_NE(input_error_of([&] { draw(); }).find("--colour-range"), std::string::npos);
}

TEST_F(Render, ColoursByAnyFieldAndTellsItsColumn) {
  const ResultFolder folder(temporary_.path());
  const BlockFields fields(folder, folder.blocks());
  for (const std::string& name : field_names()) {
    if (name == "zone" || name == "hole") continue;  // a heap has neither
    const BlockField field = fields.of(name, start_snapshot(folder.blocks()));
    EXPECT_FALSE(field.column.empty()) << name;
    EXPECT_EQ(block_colours(field).of_block.size(), folder.blocks().size()) << name;
  }
  options_.colour_by = "moved_x";
  draw();
  const std::string table = text_of(file("pile3d.csv"));
  EXPECT_EQ(table.substr(0, table.find('\n')), "block,x_m,y_m,z_m,moved_x_m");
}

TEST_F(Render, NamesWhatThereIsToColourBy) {
  options_.colour_by = "sped";
  const std::string error = input_error_of([&] { draw(); });
  EXPECT_NE(error.find("--colour: must be a field, got 'sped'; did you mean 'speed'? (fields: "),
            std::string::npos)
      << error;
  EXPECT_NE(error.find("displacement, moved_x,"), std::string::npos) << error;
  options_.colour_by = "zone";
  EXPECT_NE(input_error_of([&] { draw(); }).find("the run has no zones"), std::string::npos);
  options_.colour_by = "hole";
  EXPECT_NE(input_error_of([&] { draw(); }).find("neither holes.csv nor holes in run.json"),
            std::string::npos);
}

TEST_F(Render, TellsThatFfmpegFailed) {
  install_ffmpeg("exit 4");
  options_.film = file("film.mp4");
  EXPECT_NE(input_error_of([&] { draw(); })
                .find("film.mp4: cannot be written: ffmpeg ended with "
                      "status 4"),
            std::string::npos);
}

}  // namespace
}  // namespace muckpile
