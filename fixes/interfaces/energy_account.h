// SPDX-License-Identifier: GPL-2.0-or-later
// The account of the run's energy.
// Scope: an interface only. fix muckpile/ledger implements it and fix muckpile/progress reads it;
// block_motion books what it gives to blocks, and a fix that ends hands over its books.
#pragma once

namespace muckpile {

/// Energies of the whole run [J]; losses and works are cumulative.
struct EnergyLedger {
  double kinetic = 0.0, joint_elastic = 0.0, contact_elastic = 0.0, gravity = 0.0;
  double blast_work = 0.0;
  double fracture = 0.0, joint_friction = 0.0, joint_damping = 0.0;
  double contact_friction = 0.0, contact_damping = 0.0, walls = 0.0;
  double quiet = 0.0;  ///< given to the rock behind quiet boundaries
  double sleep = 0.0;  ///< kinetic energy of blocks as they were laid to rest
  double given = 0.0;  ///< by block_motion since the first run began

  /// What is in the system and what left it, less what came in.
  [[nodiscard]] double residual() const {
    return kinetic + joint_elastic + contact_elastic + gravity + fracture + joint_friction +
           joint_damping + contact_friction + contact_damping + walls + quiet + sleep - blast_work -
           given;
  }
};

class EnergyAccount {
 public:
  virtual ~EnergyAccount() = default;
  /// Summed over ranks. Collective; computed once per step.
  [[nodiscard]] virtual const EnergyLedger& ledger() = 0;
  /// The larger of |residual - its start value| and of what walls gave, if none of them moves, over
  /// the largest energy of one kind that was seen so far. Collective.
  [[nodiscard]] virtual double balance_error() = 0;
  /// False if that error is larger than `allowed`, and not merely rounding of rock at rest.
  /// Collective.
  [[nodiscard]] virtual bool balanced(double allowed) = 0;
  /// Of the fastest block [m/s]. Collective.
  [[nodiscard]] virtual double fastest_block() = 0;
  /// Kinetic energy [J] that a command has given to blocks of this rank.
  virtual void book_given(double energy) = 0;
  /// The fix of the joints ends: its losses and works of this rank so far [J] stay in the account,
  /// and so does what its joints store, unless another fix takes them over before the next run.
  virtual void keep_books_of_joints(const EnergyLedger& ended) = 0;
  /// The fix that lays blocks to rest ends, having taken that energy of this rank [J].
  virtual void keep_books_of_sleep(double taken) = 0;
};

}  // namespace muckpile
