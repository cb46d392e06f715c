// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/contact/history: storage per atom and its passage between ranks and restarts.
// Scope: see the header.
#include "fixes/contact/fix_muckpile_contact_history.h"

#include <atom.h>
#include <comm.h>
#include <modify.h>
#include <mpi.h>

#include <algorithm>

#include "fixes/contact/sphere_list.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "fixes/engine/style_name.h"

namespace muckpile {

FixMuckpileContactHistory::FixMuckpileContactHistory(LAMMPS_NS::LAMMPS* engine_object, int narg,
                                                     char** arg)
    : Fix(engine_object, narg, arg) {
  restart_peratom = restart_global = 1;
  create_attribute = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

FixMuckpileContactHistory::~FixMuckpileContactHistory() {
  atom->delete_callback(id, 0);
  atom->delete_callback(id, 1);
}

void FixMuckpileContactHistory::set_source(ContactSource* source) {
  if (source_ == nullptr) {
    source->losses().friction += restored_.losses.friction;
    source->losses().damping += restored_.losses.damping;
    if (restored_.polyhedra >= 0) resume_pace(*source);
  }
  source_ = source;
}

/// A run in which nobody looks at the step any more takes all of them alike.
void FixMuckpileContactHistory::resume_pace(ContactSource& source) const {
  source.pace().resume(restored_.pace);
  if (modify->find_fix_style_strict("muckpile/timestep", 0) == nullptr) source.pace().act_every(1);
}

int FixMuckpileContactHistory::setmask() { return LAMMPS_NS::FixConst::PRE_EXCHANGE; }

void FixMuckpileContactHistory::setup_pre_exchange() { pre_exchange(); }

void FixMuckpileContactHistory::pre_exchange() {
  if (source_ != nullptr) source_->store_contacts(*this);
}

void FixMuckpileContactHistory::store(const std::vector<int>& owners,
                                      const std::vector<Record>& records) {
  std::fill(range_.begin(), range_.end(), Range{0, 0});
  for (const int owner : owners) ++range_[static_cast<std::size_t>(owner)].count;
  int next = 0;
  most_records_ = 0;
  for (Range& range : range_) {
    most_records_ = std::max(most_records_, range.count);
    range.first = next;
    next += range.count;
    range.count = 0;
  }
  records_.resize(records.size());
  for (std::size_t k = 0; k < records.size(); ++k) {
    Range& range = range_[static_cast<std::size_t>(owners[k])];
    records_[static_cast<std::size_t>(range.first + range.count++)] = records[k];
  }
  // The engine sizes its exchange buffer by the largest fix; what ours needs is per atom.
  comm->maxexchange_fix =
      std::max(comm->maxexchange_fix,
               engine::numbers_of_sphere_list<Record>(static_cast<std::size_t>(most_records_)));
}

const ContactState* FixMuckpileContactHistory::find(int index, int partner) const {
  const Range range = range_[static_cast<std::size_t>(index)];
  for (int k = range.first; k < range.first + range.count; ++k) {
    const Record& record = records_[static_cast<std::size_t>(k)];
    if (record.partner == partner) return &record.state;
  }
  return nullptr;
}

void FixMuckpileContactHistory::grow_arrays(int nmax) {
  range_.resize(static_cast<std::size_t>(nmax), Range{0, 0});
}

void FixMuckpileContactHistory::copy_arrays(int from, int to, int /*delflag*/) {
  range_[static_cast<std::size_t>(to)] = range_[static_cast<std::size_t>(from)];
}

void FixMuckpileContactHistory::set_arrays(int index) {
  range_[static_cast<std::size_t>(index)] = Range{0, 0};
}

int FixMuckpileContactHistory::pack(int index, double* buf) const {
  const Range range = range_[static_cast<std::size_t>(index)];
  const std::span<const Record> all = records_;
  return engine::put_sphere_list(
      all.subspan(static_cast<std::size_t>(range.first), static_cast<std::size_t>(range.count)),
      buf);
}

int FixMuckpileContactHistory::unpack(int index, std::span<const double> numbers) {
  const std::size_t first = records_.size();
  const int taken = engine::get_sphere_list(records_, numbers, engine::name_of(*this), *error);
  const auto count = static_cast<int>(records_.size() - first);
  range_[static_cast<std::size_t>(index)] = Range{static_cast<int>(first), count};
  most_records_ = std::max(most_records_, count);
  return taken;
}

int FixMuckpileContactHistory::pack_exchange(int index, double* buf) { return pack(index, buf); }

int FixMuckpileContactHistory::unpack_exchange(int index, double* buf) {
  return unpack(index, engine::sent_with_sphere(buf));
}

int FixMuckpileContactHistory::pack_restart(int index, double* buf) { return pack(index, buf); }

void FixMuckpileContactHistory::unpack_restart(int index, int nth) {
  (void)unpack(index, engine::stored_with_sphere(*atom, index, nth));
}

/// Called before the records are asked for: a file may be written in the middle of a run.
void FixMuckpileContactHistory::write_restart(FILE* file) {
  ContactsState state;
  if (source_ != nullptr) {
    source_->store_contacts(*this);
    state = {source_->losses(), source_->polyhedra() ? 1 : 0, source_->pace().state()};
  }
  for (double* mine : {&state.losses.friction, &state.losses.damping})
    *mine = engine::sum_over_ranks(*mine, world);
  engine::write_state<ContactRecord>(*lmp, style, file, state, {});
}

/// The records themselves stand with the spheres; here they are told to be of this version.
void FixMuckpileContactHistory::restart(char* state) {
  engine::read_state<ContactRecord>(*lmp, style, state, restored_, [](const ContactRecord&) {});
  for (double* all : {&restored_.losses.friction, &restored_.losses.damping})
    *all = engine::share_of_total(*lmp, *all);
}

int FixMuckpileContactHistory::size_restart(int index) {
  const Range range = range_[static_cast<std::size_t>(index)];
  return engine::numbers_of_sphere_list<Record>(static_cast<std::size_t>(range.count));
}

int FixMuckpileContactHistory::maxsize_restart() {
  const int most = engine::greatest_over_ranks(most_records_, world);
  return engine::numbers_of_sphere_list<Record>(static_cast<std::size_t>(most));
}

double FixMuckpileContactHistory::memory_usage() {
  return static_cast<double>(range_.capacity() * sizeof(Range) +
                             records_.capacity() * sizeof(Record));
}

}  // namespace muckpile
