// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks of pair muckpile/block in their own shape.
// Scope: see the header.
#include "fixes/contact/solid_blocks.h"

#include <atom.h>

#include <unordered_map>

#include "fixes/engine/block_directory.h"
#include "fixes/engine/particle_vectors.h"

namespace muckpile {
namespace {

constexpr std::size_t kWidth = 9;  // numbers of a body's axes

}  // namespace

void SolidBlocks::keep_keys(const LAMMPS_NS::Atom& atom, std::span<const int> block_tag,
                            const BlockShapes& shapes, std::vector<int>& atom_block) {
  shapes_.clear();
  without_shape_ = 0;
  for (const int tag : block_tag) {
    shapes_.push_back(shapes.shape(tag));
    if (shapes_.back() == nullptr) ++without_shape_;
  }
  of_step_.resize(block_tag.size());
  step_of_.assign(block_tag.size(), step_);
  begin_step();
  reaches_.assign(atom_block.size(), 0.0);
  for (std::size_t k = 0; k < atom_block.size(); ++k) {
    if (atom_block[k] < 0) continue;
    const ShapedBlock* const shape = shapes_[at(atom_block[k])];
    if (shape != nullptr && atom.tag[k] == shape->key)
      reaches_[k] = shape->reach;
    else
      atom_block[k] = -1;
  }
}

/// Periodic images of a block are blocks of their own, of one body.
void SolidBlocks::plan(LAMMPS_NS::FixMultisphere& fix, std::span<const int> block_tag,
                       MPI_Comm world) {
  int ranks = 1;
  MPI_Comm_size(world, &ranks);
  several_ = ranks > 1;
  const engine::Bodies bodies(fix);
  std::vector<int> mine, wanted;
  std::unordered_map<int, int> strange;
  for (int b = 0; b < bodies.count(); ++b) mine.push_back(bodies.tag(b));
  own_ = bodies.count();
  places_.clear();
  for (const int tag : block_tag) {
    places_.push_back(fix.data().map(tag));
    if (places_.back() >= 0) continue;
    const auto [entry, is_new] = strange.emplace(tag, own_ + static_cast<int>(wanted.size()));
    if (is_new) wanted.push_back(tag);
    places_.back() = entry->second;
  }
  if (!several_) return;
  halo_ = engine::BlockHalo(mine, wanted, engine::BlockDirectory(mine, world), world);
  axes_.assign(halo_.size() * kWidth, 0.0);
}

void SolidBlocks::update(const engine::Bodies& bodies) {
  if (!several_) return;
  for (int b = 0; b < bodies.count(); ++b)
    Mat3::Map(axes_.data() + kWidth * static_cast<std::size_t>(b)) = bodies.axes(b);
  halo_.forward(axes_, kWidth);
}

SolidBody SolidBlocks::body(const engine::Bodies& bodies, const LAMMPS_NS::Atom& atom, int block,
                            int key) const {
  const ShapedBlock& shape = *shapes_[at(block)];
  const int place = places_[at(block)];
  SolidBody body;
  body.solid = &shape.solid;
  body.pose.axes = place < own_
                       ? bodies.axes(place)
                       : Mat3(Mat3::Map(axes_.data() + kWidth * static_cast<std::size_t>(place)));
  const Vec3 arm = body.pose.axes * shape.key_offset;  // from the centre to the key
  body.spin = engine::vector_of(atom.omega[0], key);
  body.pose.centre = engine::vector_of(atom.x[0], key) - arm;
  body.velocity = engine::vector_of(atom.v[0], key) - body.spin.cross(arm);
  body.mass = atom.rmass[key];
  return body;
}

const SolidBody& SolidBlocks::body_of_step(const engine::Bodies& bodies,
                                           const LAMMPS_NS::Atom& atom, int block, int key) {
  if (step_of_[at(block)] != step_) {
    of_step_[at(block)] = body(bodies, atom, block, key);
    step_of_[at(block)] = step_;
  }
  return of_step_[at(block)];
}

}  // namespace muckpile
