// SPDX-License-Identifier: GPL-2.0-or-later
// 200 random scenes, both cuts: blocks are convex and closed and fill the rock, faces between
// blocks are in both of them, facets have the area of these faces, and no block is a sliver. Scope:
// some fifty blocks a scene, with graded sizes, up to three holes (their cracks added up or not)
// and up to three natural joints, which may cross; every scene follows from its number.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "bond/build/facet_builder.h"
#include "bond/build/joint_plane.h"
#include "cut_checks.h"
#include "geometry/cut/ground.h"
#include "geometry/cut/joint_set_cut.h"
#include "geometry/holes/hole_surface.h"
#include "math/random.h"

namespace muckpile {
namespace {

constexpr int kScenes = 200;  // half of them by each cut

struct Scene {
  TessellationOptions rock;
  JointSetCut sets;
};

double between(Random& random, double from, double to) {
  return from + (to - from) * random.uniform();
}

Vec3 point_in(Random& random, const Vec3& lo, const Vec3& hi) {
  return {between(random, lo.x(), hi.x()), between(random, lo.y(), hi.y()),
          between(random, lo.z(), hi.z())};
}

Vec3 direction(Random& random) {
  return normal_of_dip(std::acos(random.uniform()), between(random, 0.0, 2.0 * std::numbers::pi));
}

/// Sets that span at least half of what upright ones do.
JointSetCut random_sets(Random& random) {
  JointSetCut how;
  double solid = 0.0;
  while (solid < 0.5) {
    how.sets = {{direction(random)}, {direction(random)}, {direction(random)}};
    solid = std::abs(how.sets[0].normal.dot(how.sets[1].normal.cross(how.sets[2].normal)));
  }
  if (random.uniform() < 0.2) how.sets = {{Vec3::UnitX()}, {Vec3::UnitY()}, {Vec3::UnitZ()}};
  if (random.uniform() < 0.2) how.sets.pop_back();
  for (JointSet& set : how.sets) set.spacing = between(random, 0.7, 1.4);
  return how;
}

/// Holes whose crushed zones keep clear of the box walls and of each other.
void add_holes(Random& random, TessellationOptions& rock) {
  const int count = static_cast<int>(3.999 * random.uniform());
  constexpr double kApart = 1.3;  // [m]
  for (int h = 0; h < count; ++h) {
    const Vec3 toe(1.0 + kApart * h, between(random, 1.0, rock.hi.y() - 1.0), 0.8);
    const Vec3 collar(toe.x() + between(random, -0.1, 0.1),
                      std::clamp(toe.y() + between(random, -0.3, 0.3), 1.0, rock.hi.y() - 1.0),
                      rock.hi.z() - 0.8);
    rock.holes.push_back({toe, collar, between(random, 0.2, 0.3)});
  }
}

void add_planes(Random& random, int most, TessellationOptions& rock) {
  const int count = static_cast<int>((most + 0.999) * random.uniform());
  for (int k = 0; k < count; ++k) {
    // through the middle fifth, so that no part is smaller than a block
    rock.planes.push_back({point_in(random, 0.4 * rock.hi, 0.6 * rock.hi), direction(random)});
  }
}

Scene scene_of(int number) {
  Random random(static_cast<std::uint64_t>(number));
  Scene scene;
  TessellationOptions& rock = scene.rock;
  rock.hi = point_in(random, Vec3(4.6, 2.2, 2.4), Vec3(5.0, 2.8, 3.0));
  add_holes(random, rock);
  const SizeLimits limits{0.4, between(random, 0.6, 0.8)};
  if (random.uniform() < 0.5) {
    rock.size = SizeLaw::power({between(random, 0.5, 1.0), between(random, 0.8, 2.0)}, limits);
  } else {
    rock.size = SizeLaw::harries({0.2, between(random, 6e-3, 2e-2), 1e-3, 0.0}, limits);
    rock.superpose = random.uniform() < 0.5;
  }
  rock.sweeps = 3 + static_cast<int>(6.0 * random.uniform());
  rock.seed = static_cast<unsigned long>(number) + 1;
  scene.sets = random_sets(random);
  return scene;
}

double facet_area(const std::vector<Block>& blocks) {
  const FacetSet set = build_facets(blocks, 1, [](const Vec3&) { return Support::free; });
  double area = 0.0;
  for (const Facet& facet : set.facets) area += facet.area;
  return area;
}

/// Which wall of the box a face lies on: at 0 or at its far corner, and the axis across it.
std::optional<std::pair<std::size_t, Eigen::Index>> wall_of(const Vec3& edge, const Block& block,
                                                            std::size_t f,
                                                            const FaceGeometry& face) {
  if (block.neighbour[f] != kFreeFace) return std::nullopt;
  Eigen::Index along = 0;
  if (face.normal.cwiseAbs().maxCoeff(&along) < 1.0 - 1e-6) return std::nullopt;
  const bool far = face.normal[along] > 0.0;
  if (std::abs(face.centroid[along] - (far ? edge[along] : 0.0)) > 1e-9) return std::nullopt;
  return std::pair(far ? std::size_t{1} : std::size_t{0}, along);
}

/// What voids the boundary shows, per direction [m2]: walls at 0, then at the box's far corner.
std::array<Vec3, 2> walls_of_voids(const Vec3& edge, const std::vector<Block>& blocks) {
  std::array<Vec3, 2> bare;
  bare.fill({edge.y() * edge.z(), edge.z() * edge.x(), edge.x() * edge.y()});
  for (const Block& block : blocks) {
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      const auto wall = wall_of(edge, block, f, face);
      if (wall) bare[wall->first][wall->second] -= face.area;
    }
  }
  return bare;
}

/// Volume of the voids from the faces around them, by the divergence theorem for x/3. Its normal
/// component is 0 on the walls at 0 and constant on the others.
double volume_of_voids(const Vec3& edge, const std::vector<Block>& blocks) {
  double volume = walls_of_voids(edge, blocks)[1].dot(edge) / 3.0;
  for (const Block& block : blocks) {
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] >= 0) continue;
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      if (!wall_of(edge, block, f, face))
        volume -= face.area * face.normal.dot(face.centroid) / 3.0;
    }
  }
  return volume;
}

/// Area of free faces that are not on a wall: a block lost inside the rock would leave them [m2].
/// Those of crushed zones are no free faces.
double free_faces_inside(const Vec3& edge, const std::vector<Block>& blocks) {
  double area = 0.0;
  for (const Block& block : blocks) {
    for (std::size_t f = 0; f < block.neighbour.size(); ++f) {
      if (block.neighbour[f] != kFreeFace) continue;
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      if (!wall_of(edge, block, f, face)) area += face.area;
    }
  }
  return area;
}

bool is_in(const std::vector<FaceGeometry>& faces, const Vec3& point) {
  return std::all_of(faces.begin(), faces.end(), [&](const FaceGeometry& face) {
    return face.normal.dot(point - face.centroid) <= 1e-9;
  });
}

/// How far from the next crushed zone there is rock that no block fills, at points 0.2 m apart, in
/// block sizes: a part of the rock that is lost reaches much farther than the tangent planes of a
/// zone do. Infinite without a zone.
double farthest_bare_rock(const TessellationOptions& rock, const std::vector<Block>& blocks) {
  constexpr double kStep = 0.2;  // [m], half of the smallest block size
  std::vector<std::vector<FaceGeometry>> faces;
  for (const Block& block : blocks) {
    faces.emplace_back();
    for (std::size_t f = 0; f < block.shape.faces.size(); ++f)
      faces.back().push_back(face_geometry(block.shape, static_cast<int>(f)));
  }
  const Ground ground(rock);
  double farthest = 0.0;
  const Eigen::Array3i count = (rock.hi / kStep).array().floor().cast<int>();
  for (int k = 0; k < count.prod(); ++k) {
    const Vec3 place(k % count.x() + 0.5, k / count.x() % count.y() + 0.5,
                     k / (count.x() * count.y()) + 0.5);
    const Vec3 point = kStep * place;
    double away = std::numeric_limits<double>::infinity();
    for (const Hole& hole : rock.holes)
      away = std::min(away, (closest_on_hole(hole, point) - point).norm());
    if (away / ground.size(point) <= farthest) continue;
    if (std::none_of(faces.begin(), faces.end(), [&](const auto& of) { return is_in(of, point); }))
      farthest = away / ground.size(point);
  }
  return farthest;
}

/// Returns what the crushed zones have taken of the boundary, which they should not reach [m2].
double expect_sound(const TessellationOptions& rock, const Tessellation& cut, bool cut_by_sets) {
  constexpr double kRounding = 100.0;  // heights of walls at voids are solved to 1e-9 of a cell
  test::expect_sound_cut(cut.blocks, rock.hi.prod() - volume_of_voids(rock.hi, cut.blocks),
                         kRounding);
  if (rock.planes.empty() || rock.holes.empty() || cut_by_sets) {
    // else parts of a crushed zone beside a plane are free
    EXPECT_LE(free_faces_inside(rock.hi, cut.blocks), 1e-9 * rock.hi.squaredNorm());
  }
  const double both_sides = test::expect_shared_faces(cut.blocks, kRounding);
  // Faces below kSmallestFacetShare of their block carry no facet.
  EXPECT_NEAR(facet_area(cut.blocks), 0.5 * both_sides, 1e-7 * both_sides);
  const std::array<Vec3, 2> bare = walls_of_voids(rock.hi, cut.blocks);
  return bare[0].sum() + bare[1].sum();
}

/// Whether it fills the edge where two natural joints cross: thin if their angle is sharp.
bool is_in_a_wedge(const Block& block, const std::vector<CutPlane>& planes) {
  const auto ends_at = [&](const CutPlane& plane) {
    for (std::size_t f = 0; f < block.shape.faces.size(); ++f) {
      const FaceGeometry face = face_geometry(block.shape, static_cast<int>(f));
      if (std::abs(plane.normal.dot(face.centroid - plane.point)) < 1e-9 &&
          plane.normal.cross(face.normal).norm() < 1e-6)
        return true;
    }
    return false;
  };
  return std::count_if(planes.begin(), planes.end(), ends_at) >= 2;
}

/// Rock thinner than a block between a zone, natural joints and the boundary goes with the zone.
struct Reach {
  int zones = 0;      // scenes where a zone reaches the boundary
  double most = 0.0;  // [m2] of boundary in one of them
  void add(double bare) {
    zones += bare > 1e-7 ? 1 : 0;
    most = std::max(most, bare);
  }
};

TEST(RandomScenes, VoronoiCutsAreSound) {
  double thinnest = 1.0, in_wedges = 1.0;
  std::size_t blocks = 0, merged = 0, lost = 0;
  double farthest = 0.0;
  Reach reach;
  for (int number = 0; number < kScenes / 2; ++number) {
    SCOPED_TRACE(number);
    Scene scene = scene_of(number);
    Random random(static_cast<std::uint64_t>(number));
    add_planes(random, 3, scene.rock);
    const Tessellation cut = tessellate(scene.rock);
    const double bare = expect_sound(scene.rock, cut, false);
    farthest = std::max(farthest, farthest_bare_rock(scene.rock, cut.blocks));
    lost += cut.statistics.lost_parts;
    EXPECT_LT(scene.rock.planes.size() < 2 ? bare : 0.0, 0.05);
    reach.add(bare > 0.05 ? bare : 0.0);
    blocks += cut.blocks.size();
    merged += cut.statistics.merged_parts;
    for (const Block& block : cut.blocks) {
      double& least = is_in_a_wedge(block, scene.rock.planes) ? in_wedges : thinnest;
      least = std::min(least, mean_radius(block.shape) / block.target_size);
    }
  }
  std::printf(
      "%zu blocks, smallest 3 V / A over size %.3f, where joints cross %.3f; %zu slivers merged; "
      "%zu parts lost; %d zones reach the boundary, by %.2f m2 at most; rock without a block up to "
      "%.2f sizes from a zone\n",
      blocks, thinnest, in_wedges, merged, lost, reach.zones, reach.most, farthest);
  // Lloyd sweeps leave no sliver: measured 0.199 where no plane cuts the ring of a zone. There a
  // cell that its wall leaves less than 0.1 of the size goes with the void (VoidWalls::balance);
  // measured 0.117.
  EXPECT_GT(thinnest, 0.1);
  EXPECT_GT(in_wedges, 0.1);
  EXPECT_GT(merged, 0u);
  EXPECT_LE(lost, 1u);         // between a plane and the ring of a zone that it cuts
  EXPECT_LT(farthest, 2.0);    // measured 1.76, where a zone, planes and the boundary meet
  EXPECT_LT(reach.most, 0.5);  // [m2] measured 0.16; a block of 0.8 m has faces of 0.64
  EXPECT_LE(reach.zones, 3);   // as counted, so that a change shows
}

TEST(RandomScenes, JointSetCutsAreSound) {
  std::size_t blocks = 0, left = 0, merged = 0;
  Reach reach;
  for (int number = kScenes / 2; number < kScenes; ++number) {
    SCOPED_TRACE(number);
    Scene scene = scene_of(number);
    Random random(static_cast<std::uint64_t>(number));
    add_planes(random, 3, scene.rock);
    const Tessellation cut = cut_by_joint_sets(scene.rock, scene.sets);
    reach.add(expect_sound(scene.rock, cut, true));
    blocks += cut.blocks.size();
    merged += cut.statistics.merged_parts;
    left += test::slivers(cut.blocks, scene.sets.sliver);
  }
  std::printf(
      "%zu blocks, %zu slivers left, %zu merged; %d zones reach the boundary, by %.3f m2 at most\n",
      blocks, left, merged, reach.zones, reach.most);
  EXPECT_EQ(left, 0u);
  EXPECT_GT(merged, 0u);
  EXPECT_LT(reach.most, 0.05);  // rock thinner than a block of 0.4 m
  EXPECT_LE(reach.zones, 4);    // as counted, so that a change shows; the area is what matters
}

}  // namespace
}  // namespace muckpile
