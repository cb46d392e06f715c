// SPDX-License-Identifier: GPL-2.0-or-later
// Which blocks of an earlier run become muck, and their bodies.
// Scope: see the header.
#include "rock/muck.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "args/input_error.h"
#include "args/numbers.h"
#include "bond/build/facet_builder.h"
#include "geometry/index/box_tree.h"
#include "geometry/shape/shared_volume.h"
#include "rock/saved_pile.h"

namespace muckpile {
namespace {

/// Of its volume: corners of blocks reach beyond their contact spheres.
constexpr double kMostShared = 0.1;

BoxTree::Item box_around(const Block& block) {
  BoxTree::Item box{block.shape.vertices.front(), block.shape.vertices.front(),
                    block.mass.centroid};
  for (const Vec3& v : block.shape.vertices) {
    box.lo = box.lo.cwiseMin(v);
    box.hi = box.hi.cwiseMax(v);
  }
  return box;
}

class RockInTheWay {
 public:
  explicit RockInTheWay(const std::vector<Block>& rock) : rock_(rock), tree_(boxes(rock), 8) {}

  [[nodiscard]] bool holds(const Block& block) const {
    const BoxTree::Item box = box_around(block);
    const std::vector<FaceGeometry> faces = face_geometries(block.shape);
    const double size = std::cbrt(block.mass.volume);
    double shared = 0.0;
    return tree_.any(
        [&](const BoxTree::Node& node) {
          return (node.lo.array() < box.hi.array()).all() &&
                 (node.hi.array() > box.lo.array()).all();
        },
        [&](std::size_t r) {
          shared += shared_volume(rock_[r].shape, size, faces);
          return shared > kMostShared * block.mass.volume;
        });
  }

 private:
  static std::vector<BoxTree::Item> boxes(const std::vector<Block>& rock) {
    std::vector<BoxTree::Item> all;
    for (const Block& block : rock) all.push_back(box_around(block));
    return all;
  }
  const std::vector<Block>& rock_;
  BoxTree tree_;
};

Block laid(const SavedBlock& saved, const Vec3& shift) {
  Block block;
  block.shape = saved.shape;
  for (Vec3& v : block.shape.vertices)
    v = saved.centre + saved.turn * (v - saved.mass.centroid) + shift;
  const Mat3 turn = saved.turn.toRotationMatrix();
  block.mass = {saved.mass.volume, saved.centre + shift,
                turn * saved.mass.inertia * turn.transpose()};
  block.neighbour.assign(block.shape.faces.size(), kFreeFace);
  block.target_size = std::cbrt(saved.mass.volume);
  return block;
}

/// The spheres are those that the block had in the earlier run: they lie as they came to rest.
RigidBody laid_body(const SavedBlock& saved, const Vec3& shift, const SphereRule& spheres) {
  Block start;
  start.shape = saved.shape;
  start.mass = saved.mass;
  RigidBody body = rigid_body(start, saved.kg / saved.mass.volume, spheres);
  const auto place = [&](const Vec3& p) -> Vec3 {
    return saved.centre + saved.turn * (p - saved.mass.centroid) + shift;
  };
  for (Sphere& sphere : body.spheres) sphere.centre = place(sphere.centre);
  body.centre = place(body.centre);
  body.axes = saved.turn.toRotationMatrix() * body.axes;
  return body;
}

std::string name_of(const MuckSource& source) { return "muck '" + source.folder + "'"; }

/// A block that is no more than its own size from where it began is of the rock of that run.
bool stands(const SavedBlock& block) {
  return (block.centre - block.mass.centroid).norm() <= std::cbrt(block.mass.volume);
}

void require_size(const MuckSource& source, const SavedBlock& saved) {
  const double size = std::cbrt(saved.mass.volume);
  if (size >= source.least_size) return;
  throw InputError(name_of(source) +
                   ": blocks must have a size V^(1/3) >= " + number_text(source.least_size) +
                   " m, half of block_min, for the step of the run, got block " +
                   std::to_string(saved.id) + " of " + number_text(size) + " m");
}

/// Throws where nothing may be left out.
bool beyond_the_box(const MuckSource& source, const SavedBlock& saved, const Block& block) {
  const BoxTree::Item box = box_around(block);
  if ((box.lo.array() >= source.lo.array()).all() && (box.hi.array() <= source.hi.array()).all())
    return false;
  if (source.overlap > 0.0) return true;
  const Vec3& at = block.mass.centroid;
  throw InputError(name_of(source) + ": must lie inside the simulation box, got block " +
                   std::to_string(saved.id) + " around '" + number_text(at.x()) + ' ' +
                   number_text(at.y()) + ' ' + number_text(at.z()) +
                   "' m; take another shift, or make the box larger");
}

/// What rests on the floor has sunk in by its elastic overlap only, below some metres of muck by
/// 0.1 radii in the mean.
bool in_the_floor(const MuckSource& source, const RigidBody& body) {
  constexpr double kMostSunk = 0.25;  // [radii]
  return std::any_of(body.spheres.begin(), body.spheres.end(), [&](const Sphere& sphere) {
    return sphere.centre.z() - (1.0 - kMostSunk) * sphere.radius < source.floor;
  });
}

void require_most_left(const MuckSource& source, const Muck& muck, double mass, int first) {
  if (muck.in_rock.mass > source.overlap * (mass + muck.in_rock.mass))
    throw InputError(name_of(source) + ": at most " + number_text(source.overlap) +
                     " of its mass may lie in the rock, in the floor or beyond the box, got " +
                     std::to_string(muck.in_rock.blocks) + " blocks, " +
                     number_text(muck.in_rock.mass / (mass + muck.in_rock.mass)) +
                     " of it, block " + std::to_string(first) +
                     " first; take another shift, or allow more");
  if (muck.blocks.empty())
    throw InputError(name_of(source) + ": none of its blocks " +
                     (source.moved_only ? "has moved by its own size and lies" : "lies") +
                     " outside of the rock");
}

}  // namespace

Muck lay_muck(const MuckSource& source, const std::vector<Block>& rock, const SphereRule& spheres,
              int first_tag) {
  constexpr double kStill = 0.1;  // [m/s]
  const SavedPile pile = read_saved_pile(source.folder);
  const RockInTheWay in_the_way(rock);
  Muck muck;
  muck.time = pile.time;
  double mass = 0.0, moving = 0.0;
  int first_in_rock = 0;
  for (const SavedBlock& saved : pile.blocks) {
    if (source.moved_only && stands(saved)) {
      muck.standing.add(saved.kg);
      continue;
    }
    require_size(source, saved);
    const Block block = laid(saved, source.shift);
    RigidBody body = laid_body(saved, source.shift, spheres);
    if (beyond_the_box(source, saved, block) || in_the_floor(source, body) ||
        in_the_way.holds(block)) {
      if (muck.in_rock.blocks == 0) first_in_rock = saved.id;
      muck.in_rock.add(saved.kg);
      continue;
    }
    mass += saved.kg;
    if (saved.speed > kStill) moving += saved.kg;
    muck.blocks.push_back(block);
    muck.bodies.push_back(std::move(body));
  }
  require_most_left(source, muck, mass, first_in_rock);
  muck.moving_share = moving / mass;
  muck.faces =
      build_facets(muck.blocks, first_tag, [](const Vec3&) { return Support::free; }).faces;
  return muck;
}

}  // namespace muckpile
