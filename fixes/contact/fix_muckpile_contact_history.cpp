// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/contact/history: storage per atom and its passage between ranks and restarts.
// Scope: see the header.
#include "fixes/contact/fix_muckpile_contact_history.h"

#include <atom.h>
#include <comm.h>
#include <mpi.h>

#include <algorithm>

#include "fixes/engine/over_ranks.h"
#include "fixes/engine/restart_file.h"
#include "state/number_list.h"

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
  }
  source_ = source;
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
      std::max(comm->maxexchange_fix, numbers_of_list<Record>(std::size_t(most_records_)));
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
  return put_list(
      all.subspan(static_cast<std::size_t>(range.first), static_cast<std::size_t>(range.count)),
      buf);
}

int FixMuckpileContactHistory::unpack(int index, const double* buf) {
  const std::size_t first = records_.size();
  const int numbers = get_list(records_, buf);
  const auto count = static_cast<int>(records_.size() - first);
  range_[static_cast<std::size_t>(index)] = Range{static_cast<int>(first), count};
  most_records_ = std::max(most_records_, count);
  return numbers;
}

int FixMuckpileContactHistory::pack_exchange(int index, double* buf) { return pack(index, buf); }

int FixMuckpileContactHistory::unpack_exchange(int index, double* buf) {
  return unpack(index, buf);
}

int FixMuckpileContactHistory::pack_restart(int index, double* buf) {
  buf[0] = size_restart(index);
  return 1 + pack(index, buf + 1);
}

void FixMuckpileContactHistory::unpack_restart(int index, int nth) {
  const double* extra = atom->extra[index];
  int m = 0;
  for (int k = 0; k < nth; ++k) m += static_cast<int>(extra[m]);
  (void)unpack(index, extra + m + 1);
}

/// Called before the records are asked for: a file may be written in the middle of a run.
void FixMuckpileContactHistory::write_restart(FILE* file) {
  ContactsState state;
  if (source_ != nullptr) {
    source_->store_contacts(*this);
    state = {source_->losses(), source_->polyhedra() ? 1 : 0};
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
  return 1 + numbers_of_list<Record>(static_cast<std::size_t>(range.count));
}

int FixMuckpileContactHistory::maxsize_restart() {
  const int most = engine::greatest_over_ranks(most_records_, world);
  return 1 + numbers_of_list<Record>(static_cast<std::size_t>(most));
}

double FixMuckpileContactHistory::memory_usage() {
  return static_cast<double>(range_.capacity() * sizeof(Range) +
                             records_.capacity() * sizeof(Record));
}

}  // namespace muckpile
