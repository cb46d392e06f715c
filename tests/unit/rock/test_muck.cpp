// SPDX-License-Identifier: GPL-2.0-or-later
// Muck in front of the rock: blocks lie where the snapshot of an earlier run has them, with their
// mass and spheres; which are left out; what is refused.
// Scope: boxes of 0.5 m and a hand-made folder of results.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <sstream>

#include "../geometry/shapes.h"
#include "args/numbers.h"
#include "geometry/files/block_file.h"
#include "input_error_of.h"
#include "rock/cut_table.h"
#include "rock/rock_model.h"
#include "state/packed_rows.h"
#include "temporary_folder.h"

namespace muckpile {
namespace {

constexpr const char* kId = "0123456789abcdef";

Block box_block(const Vec3& lo, double edge = 0.5) {
  Block block;
  block.shape = test::box(lo, lo + Vec3::Constant(edge));
  block.mass = mass_properties(block.shape);
  block.neighbour.assign(6, kFreeFace);
  return block;
}

struct Pose {
  Vec3 centre;
  Quat turn = Quat::Identity();
  double speed = 0.0;
};

std::string row(int id, const Pose& at) {
  std::ostringstream text;
  text.precision(12);
  text << id << ',' << at.centre.x() << ',' << at.centre.y() << ',' << at.centre.z() << ','
       << at.turn.w() << ',' << at.turn.x() << ',' << at.turn.y() << ',' << at.turn.z() << ','
       << at.speed << ",0,0,0,0,0," << id << ",0\n";
  return text.str();
}

class MuckOfAnEarlierRun : public ::testing::Test {
 protected:
  /// Three boxes side by side along x, of which the first one has not moved.
  void SetUp() override {
    for (const double x : {0.0, 0.5, 1.0}) boxes_.push_back(box_block({x, 0.0, 0.0}));
    write(kId);
    write_blocks((dump() / "blocks.vtk").string(), boxes_, 7, 2000.0, kId);
  }
  void write(const std::string& id, const std::string& name = "blocks_000000200.csv") {
    std::string text = "# step=200 time_s=1.5 run=" + id +
                       "\nid,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_"
                       "s,fragment_id,broken_fraction\n";
    for (int k = 0; k < 3; ++k) text += row(7 + k, poses_[static_cast<std::size_t>(k)]);
    testing::write_text(dump() / name, text);
  }
  [[nodiscard]] std::filesystem::path dump() const { return folder_.path() / "dump"; }
  [[nodiscard]] MuckSource source() const {
    MuckSource source;
    source.folder = folder_.path().string();
    return source;
  }
  [[nodiscard]] Muck lay(const MuckSource& from, const std::vector<Block>& rock = {}) const {
    return lay_muck(from, rock, {.count = 4, .growth = 1.19}, 20);
  }
  [[nodiscard]] std::string refusal(const MuckSource& from, const std::vector<Block>& rock = {}) {
    return input_error_of([&] { (void)lay(from, rock); });
  }

  testing::TemporaryFolder folder_;
  std::vector<Block> boxes_;
  std::vector<Pose> poses_{
      {{0.25, 0.25, 0.25}},
      {{3.0, 0.25, 0.4}, Quat(Eigen::AngleAxisd(0.25 * std::numbers::pi, Vec3::UnitY()))},
      {{5.0, 0.25, 0.25}, Quat::Identity(), 0.3}};
};

TEST_F(MuckOfAnEarlierRun, LiesWhereTheSnapshotHasIt) {
  MuckSource from = source();
  from.shift = Vec3(1.0, 0.0, -0.1);
  const Muck muck = lay(from);
  ASSERT_EQ(muck.blocks.size(), 3u);
  EXPECT_EQ(muck.time, 1.5);
  EXPECT_NEAR(muck.moving_share, 1.0 / 3.0, 1e-12);
  EXPECT_LT((muck.bodies[1].centre - Vec3(4.0, 0.25, 0.3)).norm(), 1e-9);
  // Turned by 45 degrees a box of 0.5 m is 0.707 m wide and high.
  double lowest = 1e9;
  for (const Vec3& v : muck.blocks[1].shape.vertices) lowest = std::min(lowest, v.z());
  EXPECT_NEAR(lowest, 0.3 - 0.25 * std::sqrt(2.0), 1e-9);
  const MassProperties mass = mass_properties(muck.blocks[1].shape);
  EXPECT_NEAR(mass.volume, 0.125, 1e-9);
  EXPECT_LT((mass.inertia - muck.blocks[1].mass.inertia).norm(), 1e-9);
}

TEST_F(MuckOfAnEarlierRun, LiesAlikeWhereTheSnapshotIsPacked) {
  const Muck text = lay(source());
  std::string rows("# step=200 time_s=1.5 run=" + std::string(kId) + "\n");
  rows += packed_header();
  for (int k = 0; k < 3; ++k) {
    const Pose& pose = poses_[static_cast<std::size_t>(k)];
    pack({7 + k, pose.centre, pose.turn, Vec3(pose.speed, 0.0, 0.0), Vec3::Zero(), 7 + k, 0.0},
         rows);
  }
  std::filesystem::remove(dump() / "blocks_000000200.csv");
  testing::write_text(dump() / "blocks_000000200.bin", rows);
  const Muck packed = lay(source());
  EXPECT_EQ(packed.time, 1.5);
  EXPECT_NEAR(packed.moving_share, text.moving_share, 1e-12);
  ASSERT_EQ(packed.bodies.size(), text.bodies.size());
  for (std::size_t k = 0; k < text.bodies.size(); ++k)
    EXPECT_LT((packed.bodies[k].centre - text.bodies[k].centre).norm(), 1e-6);
}

TEST_F(MuckOfAnEarlierRun, KeepsMassAndTurnsTheSpheresOfItsBlocks) {
  const Muck muck = lay(source());
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_NEAR(muck.bodies[b].mass, 250.0, 1e-9);  // 2000 kg/m3 of 0.125 m3
    const RigidBody start = rigid_body(boxes_[b], 2000.0, {.count = 4, .growth = 1.19});
    for (std::size_t s = 0; s < 4; ++s) {
      const Vec3 arm = start.spheres[s].centre - start.centre;
      EXPECT_LT((poses_[b].centre + poses_[b].turn * arm - muck.bodies[b].spheres[s].centre).norm(),
                1e-7);
      EXPECT_NEAR(start.spheres[s].radius, muck.bodies[b].spheres[s].radius, 1e-12);
    }
  }
}

TEST_F(MuckOfAnEarlierRun, HasFreeFacesAndNoJoints) {
  const Muck muck = lay(source());
  ASSERT_EQ(muck.faces.size(), 18u);
  EXPECT_EQ(muck.faces.front().tag, 20);
  EXPECT_EQ(muck.faces.back().tag, 22);
  for (const BoundaryFace& face : muck.faces) EXPECT_EQ(face.hole, -1);
}

TEST_F(MuckOfAnEarlierRun, LeavesOutWhatStandsAndWhatIsInRock) {
  MuckSource from = source();
  from.moved_only = true;
  from.overlap = 0.5;
  const Muck muck = lay(from, {box_block({4.5, 0.0, 0.0}, 1.0)});
  ASSERT_EQ(muck.blocks.size(), 1u);
  EXPECT_EQ(muck.standing.blocks, 1u);
  EXPECT_NEAR(muck.standing.mass, 250.0, 1e-9);
  EXPECT_EQ(muck.in_rock.blocks, 1u);
  const std::string text = describe_muck(muck, from);
  EXPECT_NE(text.find("1 blocks of 0.5 m"), std::string::npos) << text;
  EXPECT_NE(text.find("250 kg, in what is rock or floor now, or beyond the box"), std::string::npos)
      << text;
}

TEST_F(MuckOfAnEarlierRun, IsRefusedWhereBlocksAreTooSmallForTheStep) {
  MuckSource from = source();
  from.least_size = 0.49;
  EXPECT_EQ(lay(from).blocks.size(), 3u);
  from.least_size = 0.51;
  EXPECT_NE(refusal(from).find("must have a size V^(1/3) >= 0.51 m, half of block_min"),
            std::string::npos);
}

TEST_F(MuckOfAnEarlierRun, LeavesOutWhatIsInTheFloor) {
  MuckSource from = source();  // spheres of 0.3 m in boxes whose lower faces are at 0, 0.05 and 0
  from.overlap = 0.7;
  for (const double floor : {-0.06, 0.01}) {  // 0.01: a sphere has sunk in by 0.2 of its radius
    from.floor = floor;
    EXPECT_EQ(lay(from).blocks.size(), 3u) << floor;
  }
  from.floor = 0.05;
  const Muck muck = lay(from);
  EXPECT_EQ(muck.in_rock.blocks, 2u);
  ASSERT_EQ(muck.blocks.size(), 1u);
  EXPECT_NEAR(muck.bodies[0].centre.x(), 3.0, 1e-9);
}

TEST_F(MuckOfAnEarlierRun, MayTouchRockWithACorner) {
  // The corner of the turned box reaches 0.05 m into the rock: 0.05^2 x 0.5 m3, 1 % of the box.
  const double corner = 3.0 + 0.25 * std::sqrt(2.0);
  EXPECT_EQ(lay(source(), {box_block({corner - 0.05, -0.5, 0.0}, 1.0)}).blocks.size(), 3u);
}

TEST_F(MuckOfAnEarlierRun, IsRefusedInRock) {
  EXPECT_EQ(refusal(source(), {box_block({4.5, 0.0, 0.0}, 1.0)}),
            "muck '" + folder_.path().string() +
                "': at most 0 of its mass may lie in the rock, in the floor or beyond the box, got "
                "1 blocks, " +
                number_text(1.0 / 3.0) +
                " of it, block 9 first; take another shift, or allow more");
  MuckSource from = source();
  from.moved_only = true;
  from.overlap = 1.0;
  EXPECT_NE(refusal(from, {box_block({2.0, -2.0, -2.0}, 5.0)})
                .find("none of its blocks has moved by its own size and lies outside of the rock"),
            std::string::npos);
}

TEST_F(MuckOfAnEarlierRun, IsRefusedBeyondTheBox) {
  MuckSource from = source();
  from.hi = Vec3(5.0, 9.0, 9.0);
  EXPECT_NE(
      refusal(from).find("must lie inside the simulation box, got block 9 around '5 0.25 0.25'"),
      std::string::npos)
      << refusal(from);
  from.overlap = 0.5;
  EXPECT_EQ(lay(from).in_rock.blocks, 1u);
}

TEST_F(MuckOfAnEarlierRun, IsThatOfTheRunOfItsBlocks) {
  poses_[0].centre.z() = 8.0;
  write("00000000ffffffff", "blocks_000000900.csv");  // left by another run
  EXPECT_NEAR(lay(source()).bodies[0].centre.z(), 0.25, 1e-9);
  std::filesystem::remove(dump() / "blocks_000000200.csv");
  EXPECT_NE(refusal(source()).find("has no snapshot blocks_<step>.csv or .bin of the run"),
            std::string::npos);
}

TEST_F(MuckOfAnEarlierRun, IsRefusedWithoutFilesRowsOrMass) {
  MuckSource elsewhere = source();
  elsewhere.folder = "/no/such/folder";
  EXPECT_EQ(
      refusal(elsewhere),
      "muck must be a folder of results with dump/blocks.vtk, other than the one of this run, got "
      "'/no/such/folder'");
  testing::write_text(dump() / "blocks_000000200.csv",
                      std::string("# step=200 time_s=1 run=") + kId + "\nid,x_m\n7,1\n");
  EXPECT_NE(refusal(source()).find("blocks_000000200.csv"), std::string::npos);
  write(kId);
  write_blocks((dump() / "blocks.vtk").string(), boxes_, 8, 2000.0, kId);
  EXPECT_NE(refusal(source()).find("block 10 has no row"), std::string::npos) << refusal(source());
  write_blocks((dump() / "blocks.vtk").string(), boxes_, 7, 0.0, kId);
  EXPECT_NE(refusal(source()).find("block 7: mass_kg must be > 0 kg"), std::string::npos);
  std::string text = testing::text_of(dump() / "blocks.vtk");
  text.replace(text.find("mass_kg"), 7, "density");
  testing::write_text(dump() / "blocks.vtk", text);
  EXPECT_NE(refusal(source()).find("has no cell data 'mass_kg'"), std::string::npos);
}

TEST_F(MuckOfAnEarlierRun, IsRefusedWhereItsBlocksAreNone) {
  const std::string file = (dump() / "blocks.vtk").string();
  std::string text = testing::text_of(file);
  const std::size_t ids = text.find("SCALARS id int");
  ASSERT_NE(ids, std::string::npos);
  const std::size_t second = text.find("\n8\n", ids) + 1;
  testing::write_text(file, std::string(text).replace(second, 1, "7"));
  EXPECT_NE(refusal(source()).find("blocks.vtk: block 7 is there twice"), std::string::npos)
      << refusal(source());
  boxes_[1].shape.vertices[0] += Vec3(0.05, 0.05, 0.05);  // a corner that is pushed in
  write_blocks(file, boxes_, 7, 2000.0, kId);
  EXPECT_NE(refusal(source()).find("blocks.vtk: block 8 is not "), std::string::npos)
      << refusal(source());
}

TEST_F(MuckOfAnEarlierRun, IsRefusedWhereABlockHasTwoRows) {
  poses_.push_back(poses_[1]);
  write(kId);
  std::string text = testing::text_of(dump() / "blocks_000000200.csv");
  testing::write_text(dump() / "blocks_000000200.csv", text + row(8, poses_[1]));
  EXPECT_NE(refusal(source()).find("block 8 has a second row"), std::string::npos)
      << refusal(source());
}

TEST_F(MuckOfAnEarlierRun, FollowsTheRockInARockModel) {
  std::istringstream stream(
      "density 2500 block_min 0.5 block_max 0.5 size uniform 0.5 spheres_per_block 4 muck " +
      folder_.path().string() + " 2 0 0 all");
  const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  CutOptions options = cut_options(parse_args(cut_table(), kCreateBlocks, words), 1ull << 33);
  options.rock.lo = Vec3(0.0, -1.0, 0.0);
  options.rock.hi = Vec3(2.0, 1.0, 1.0);
  const RockModel model = cut_rock(options, 5, [](const Vec3&) { return Support::free; });
  ASSERT_EQ(model.muck.bodies.size(), 3u);
  const int first = 5 + static_cast<int>(model.rock.blocks.size());
  EXPECT_EQ(model.muck.faces.front().tag, first);
  for (const Facet& facet : model.facets.facets) EXPECT_LT(facet.tag_j, first);
}

TEST(BulkVolume, IsThatUnderTheSurface) {
  // A step of boxes of 1 m: two on each other, one beside; and one that bridges a void.
  std::vector<Block> boxes{box_block({0, 0, 0}, 1.0), box_block({0, 0, 1}, 1.0),
                           box_block({1, 0, 0}, 1.0)};
  EXPECT_NEAR(bulk_volume(boxes, 0.0, 0.25), 3.0, 1e-9);
  boxes.push_back(box_block({2, 0, 0.5}, 1.0));
  EXPECT_NEAR(bulk_volume(boxes, 0.0, 0.25), 4.5, 1e-9);
  boxes.push_back(box_block({3, 0, 3}, 1.0));  // lies on something else: no void of the muck's
  EXPECT_NEAR(bulk_volume(boxes, 0.0, 0.25), 5.5, 1e-9);
}

}  // namespace
}  // namespace muckpile
