// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/ledger: where the energy is and where it went.
// Scope: fix multisphere bodies under fix muckpile/joint, fix gravity, walls and pair
// muckpile/block, whichever of them the run has.
#pragma once

#include <fix.h>

#include <array>

#include "fixes/interfaces/energy_account.h"
#include "state/encoding.h"

namespace LAMMPS_NS {
class FixGravity;
class FixMultisphere;
}  // namespace LAMMPS_NS

namespace muckpile {

class ContactWork;
class JointEnergies;
class RestingBlocks;

/// What a restart file holds of the fix; works and losses are sums over ranks [J].
struct LedgerState {
  bool started = false;
  double start_residual = 0.0, start_gravity = 0.0, largest = 0.0;
  int last_tag = 0;
  double sphere_work = 0.0, contact_work = 0.0, walls_before = 0.0;
  std::array<double, 9> former{};  ///< of fixes and contact styles that have ended
  double given = 0.0, laid_to_rest = 0.0;
};
template <>
struct Stored<LedgerState> {
  static constexpr std::string_view kName = "ledger_state";
  static constexpr int kVersion = 3;
  static auto fields(auto& state) {
    return std::tie(state.started, state.start_residual, state.start_gravity, state.largest,
                    state.last_tag, state.sphere_work, state.contact_work, state.walls_before,
                    state.former, state.given, state.laid_to_rest);
  }
};

class FixMuckpileLedger : public LAMMPS_NS::Fix, public EnergyAccount {
 public:
  FixMuckpileLedger(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int n) override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

  [[nodiscard]] const EnergyLedger& ledger() override;
  [[nodiscard]] double balance_error() override;
  [[nodiscard]] bool balanced(double allowed) override;
  [[nodiscard]] double fastest_block() override;
  void book_given(double energy) override;
  void keep_books_of_joints(const EnergyLedger& ended) override;
  void keep_books_of_sleep(double taken) override;

 private:
  [[nodiscard]] double work_rate_of_spheres() const;
  void keep_books_of_contacts();
  void keep_books_of_former_sleep();
  void let_go_of_joints();
  void require_joints_before() const;
  void begin();
  void take_in_new_blocks();
  [[nodiscard]] double walls() const { return contact_work_ - sphere_work_; }
  [[nodiscard]] double out_of_balance();
  [[nodiscard]] double of_pair(const char* name) const;

  LAMMPS_NS::FixMultisphere* multisphere_ = nullptr;
  LAMMPS_NS::FixGravity* gravity_ = nullptr;
  JointEnergies* joints_ = nullptr;
  RestingBlocks* sleep_ = nullptr;
  ContactWork* contacts_ = nullptr;
  bool walls_may_move_ = false;
  // Taken by fix muckpile/sleep so far, in the run before a restart file, too; this rank [J].
  double laid_to_rest_ = 0.0;
  EnergyLedger ledger_;
  // This rank, since the start, by all forces on spheres, and by those of the contact style [J].
  double sphere_work_ = 0.0, contact_work_ = 0.0;
  double walls_before_ = 0.0;  // this rank's part of `walls` when one of them moved last [J]
  EnergyLedger former_;        // of fixes and contact styles that have ended; this rank
  std::array<double, 2> contact_losses_{};  // friction, dashpots at the last step; this rank [J]
  double given_ = 0.0;                      // this rank, since the start [J]
  double start_residual_ = 0.0, start_gravity_ = 0.0;
  double largest_ = 0.0;    // energy of one kind that was seen [J]
  int last_tag_ = 0;        // of the blocks that the account has taken in
  bool had_a_run_ = false;  ///< in this process
  bool started_ = false;
  LAMMPS_NS::bigint computed_at_ = -1;
};

}  // namespace muckpile
