// SPDX-License-Identifier: GPL-2.0-or-later
// Motion of the bodies that other ranks move: plan by sphere tag, messages by BlockHalo.
// Scope: one sphere stands for each body, the first here; periodic images of a ghost count once.
#include "fixes/engine/strange_bodies.h"

#include <atom.h>

#include <unordered_set>

#include "fixes/engine/bodies.h"

namespace muckpile::engine {
namespace {

constexpr std::size_t kWidth = 9;  // numbers of a BodyState

}  // namespace

StrangeBodies::StrangeBodies(LAMMPS_NS::FixMultisphere& bodies, const LAMMPS_NS::Atom& atom,
                             MPI_Comm world) {
  std::vector<int> lent, wanted;  // spheres by tag
  std::unordered_set<int> known;
  for (int k = 0; k < atom.nlocal + atom.nghost; ++k) {
    const int tag = bodies.belongs_to(k);
    if (tag < 0) continue;
    const bool moved_here = bodies.data().map(tag) >= 0;
    if (k < atom.nlocal) {
      if (moved_here || !places_.emplace(tag, static_cast<int>(wanted.size())).second) continue;
      wanted.push_back(atom.tag[k]);
    } else if (moved_here && known.insert(atom.tag[k]).second) {
      lent.push_back(atom.tag[k]);
      lent_tags_.push_back(tag);
    }
  }
  states_.resize(wanted.size());
  halo_ = BlockHalo(lent, wanted, BlockDirectory(lent, world), world);
  values_.resize(halo_.size() * kWidth);
}

void StrangeBodies::update(LAMMPS_NS::FixMultisphere& fix) {
  const Bodies bodies(fix);
  double* number = values_.data();
  for (const int tag : lent_tags_) {
    const int b = fix.data().map(tag);
    for (const Vec3& vector :
         {Vec3(bodies.centre(b)), Vec3(bodies.velocity(b)), Vec3(bodies.spin(b))}) {
      Vec3::Map(number) = vector;
      number += 3;
    }
  }
  halo_.forward(values_, kWidth);
  for (BodyState& state : states_) {
    state = {Vec3::Map(number), Vec3::Map(number + 3), Vec3::Map(number + 6)};
    number += kWidth;
  }
}

const BodyState* StrangeBodies::find(int tag) const {
  const auto place = places_.find(tag);
  return place == places_.end() ? nullptr : &states_[static_cast<std::size_t>(place->second)];
}

}  // namespace muckpile::engine
