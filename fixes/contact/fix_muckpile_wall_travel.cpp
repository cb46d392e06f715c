// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/wall: the memory of its contacts goes with the spheres, between ranks and restarts.
// Scope: a sphere's contacts as numbers of the engine.
#include <atom.h>
#include <comm.h>

#include <algorithm>

#include "fixes/contact/fix_muckpile_wall.h"
#include "fixes/contact/sphere_list.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/style_name.h"

namespace muckpile {
namespace {

constexpr int kMostNumbers = engine::numbers_of_sphere_list<WallContact>(WallTouches::kMost);

}  // namespace

/// The engine sizes its exchange buffer by the largest fix.
void FixMuckpileWall::pre_exchange() {
  comm->maxexchange_fix = std::max(comm->maxexchange_fix, kMostNumbers);
}

void FixMuckpileWall::grow_arrays(int nmax) { contacts_.resize(static_cast<std::size_t>(nmax)); }

void FixMuckpileWall::copy_arrays(int from, int to, int /*delflag*/) {
  contacts_[static_cast<std::size_t>(to)] = contacts_[static_cast<std::size_t>(from)];
}

void FixMuckpileWall::set_arrays(int index) { contacts_[static_cast<std::size_t>(index)].clear(); }

int FixMuckpileWall::pack(int index, double* buf) const {
  const std::span<const WallContact> contacts = contacts_[static_cast<std::size_t>(index)];
  return engine::put_sphere_list(contacts, buf);
}

int FixMuckpileWall::unpack(int index, std::span<const double> numbers) {
  std::vector<WallContact>& contacts = contacts_[static_cast<std::size_t>(index)];
  contacts.clear();
  return engine::get_sphere_list(contacts, numbers, engine::name_of(*this), *error);
}

int FixMuckpileWall::pack_exchange(int index, double* buf) { return pack(index, buf); }

int FixMuckpileWall::unpack_exchange(int index, double* buf) {
  return unpack(index, engine::sent_with_sphere(buf));
}

int FixMuckpileWall::pack_restart(int index, double* buf) { return pack(index, buf); }

void FixMuckpileWall::unpack_restart(int index, int nth) {
  (void)unpack(index, engine::stored_with_sphere(*atom, index, nth));
}

int FixMuckpileWall::size_restart(int index) {
  return engine::numbers_of_sphere_list<WallContact>(
      contacts_[static_cast<std::size_t>(index)].size());
}

int FixMuckpileWall::maxsize_restart() { return kMostNumbers; }

void FixMuckpileWall::write_restart(FILE* file) {
  WallState all = books_;
  for (double* mine : {&all.friction, &all.damping, &all.let_go})
    *mine = engine::sum_over_ranks(*mine, world);
  engine::write_state<WallContact>(*lmp, style, file, all, {});
}

/// The contacts themselves stand with the spheres; here they are told to be of this version.
void FixMuckpileWall::restart(char* state) {
  WallState all;
  engine::read_state<WallContact>(*lmp, style, state, all, [](const WallContact&) {});
  books_ = {engine::share_of_total(*lmp, all.friction), engine::share_of_total(*lmp, all.damping),
            engine::share_of_total(*lmp, all.let_go)};
  looked_for_faults_ = true;  // rock may have fallen past the wall since
}

double FixMuckpileWall::memory_usage() {
  double bytes = static_cast<double>(
      contacts_.capacity() * sizeof(contacts_[0]) + candidates_.capacity() * sizeof(Candidate) +
      awake_.capacity() * sizeof(std::size_t) + parts_.capacity() * sizeof(std::size_t));
  for (const std::vector<WallContact>& of_sphere : contacts_)
    bytes += static_cast<double>(of_sphere.capacity() * sizeof(WallContact));
  return bytes;
}

}  // namespace muckpile
