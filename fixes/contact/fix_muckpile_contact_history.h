// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/contact/history: carries the memory of contacts with the spheres.
// Scope: internal; pair muckpile/block creates it, fills it before atoms move between ranks and
// reads it back when it has built its new list. Holds nothing between those two moments.
#pragma once

#include <fix.h>

#include <span>
#include <vector>

#include "contact/contact_law.h"
#include "contact/contact_pace.h"
#include "state/encoding.h"

namespace muckpile {

class FixMuckpileContactHistory;

/// Energy lost in contacts so far, kept in restart files [J].
struct ContactLosses {
  double friction = 0.0, damping = 0.0;
};
template <>
struct Stored<ContactLosses> {
  static constexpr std::string_view kName = "contact_losses";
  static constexpr int kVersion = 1;
  static auto fields(auto& losses) { return std::tie(losses.friction, losses.damping); }
};

/// Of all contacts, in restart files.
struct ContactsState {
  ContactLosses losses;
  int polyhedra = 0;  ///< 1: the memory is that of contacts between polyhedra
  ContactPace::State pace{};
};
template <>
struct Stored<ContactsState> {
  static constexpr std::string_view kName = "contacts_state";
  static constexpr int kVersion = 2;
  static auto fields(auto& state) { return std::tie(state.losses, state.polyhedra, state.pace); }
};

/// What a sphere remembers of one of its contacts; stored per sphere, as numbers of the engine.
struct ContactRecord {
  int partner = 0;  ///< tag of the other sphere
  ContactState state;
};
template <>
struct Stored<ContactRecord> {
  static constexpr std::string_view kName = "contact_record";
  static constexpr int kVersion = 2;
  static auto fields(auto& record) {
    return std::tie(record.partner, record.state.slide, record.state.roll,
                    record.state.overlap_offset, record.state.tangential_stiffness);
  }
};

/// Owns the contacts while they are computed with (pair muckpile/block).
class ContactSource {
 public:
  virtual ~ContactSource() = default;
  /// Called before atoms are exchanged: put every live contact into `history`.
  virtual void store_contacts(FixMuckpileContactHistory& history) = 0;
  [[nodiscard]] virtual ContactLosses& losses() = 0;
  [[nodiscard]] virtual ContactPace& pace() = 0;
  [[nodiscard]] virtual bool polyhedra() const = 0;  ///< or spheres
};

class FixMuckpileContactHistory : public LAMMPS_NS::Fix {
 public:
  using Record = ContactRecord;

  FixMuckpileContactHistory(LAMMPS_NS::LAMMPS* engine_object, int narg, char** arg);
  FixMuckpileContactHistory(const FixMuckpileContactHistory&) = delete;
  FixMuckpileContactHistory& operator=(const FixMuckpileContactHistory&) = delete;
  ~FixMuckpileContactHistory() override;

  void set_source(ContactSource* source);
  /// Whether the contacts of the restart file are of the other shape than those of the source.
  [[nodiscard]] bool of_other_shape() const {
    return restored_.polyhedra >= 0 && (restored_.polyhedra == 1) != source_->polyhedra();
  }

  /// Replaces everything by `records`; owners[k] is the owned atom that carries records[k].
  void store(const std::vector<int>& owners, const std::vector<Record>& records);

  /// What atom `index` remembers of its contact with sphere `partner`, nullptr if nothing.
  [[nodiscard]] const ContactState* find(int index, int partner) const;

  int setmask() override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  void grow_arrays(int nmax) override;
  void copy_arrays(int from, int to, int delflag) override;
  void set_arrays(int index) override;
  int pack_exchange(int index, double* buf) override;
  int unpack_exchange(int index, double* buf) override;
  int pack_restart(int index, double* buf) override;
  void unpack_restart(int index, int nth) override;
  int size_restart(int index) override;
  int maxsize_restart() override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;
  double memory_usage() override;

 private:
  struct Range {
    int first, count;
  };
  void resume_pace(ContactSource& source) const;
  int pack(int index, double* buf) const;
  int unpack(int index, std::span<const double> numbers);

  ContactSource* source_ = nullptr;
  ContactsState restored_{{}, -1, {}};  ///< of a restart file; polyhedra -1: there was none
  std::vector<Range> range_;            ///< per atom: its records in the pool
  std::vector<Record> records_;         ///< the pool; leavers leave holes until the next store()
  int most_records_ = 0;                ///< of one atom
};

}  // namespace muckpile
