// SPDX-License-Identifier: GPL-2.0-or-later
// A prism of jointed rock between two smooth, rigid plates, under pressure on its sides.
// Scope: plates normal to z, moved at a steady rate that is slow against waves; broken facets
// carry contact, blocks do not touch otherwise: good to some permille of strain.
#pragma once

#include "draw/axes.h"
#include "framework/block_run.h"
#include "framework/rock_samples.h"

namespace muckpile::verification {

/// The rock of the strength cases: E 50 GPa, nu 0.25, tension 2 MPa, cohesion 4 MPa, friction 50
/// degrees, residual 35.
[[nodiscard]] JointParameters weak_rock();

class Press {
 public:
  /// Brings plates and sides to `confinement` [Pa].
  Press(const RockSample& sample, const JointParameters& rock, double confinement);

  /// Moves the plates until the stress has fallen by a tenth of its peak; that peak [Pa].
  double pull();
  double squeeze();
  /// Goes on squeezing to three times the strain at which rock without joints would fail.
  void squeeze_on();

  /// Axial strain [-] and stress [Pa] of the last test, positive as pulled or squeezed.
  [[nodiscard]] const std::vector<Vec2>& path() const { return path_; }
  [[nodiscard]] const BlockRun& run() const { return run_; }

 private:
  void start(double direction, double expected);
  void drive(bool until_it_fails);
  void step(double strain, double pressure);

  JointParameters rock_;
  BlockRun run_;
  double height_, confinement_;  ///< [m], [Pa]
  double dt_ = 0.0;              ///< [s]
  double rate_ = 0.0;            ///< of the strain [1/s]
  double strain_ = 0.0, start_strain_ = 0.0;
  double direction_ = 1.0, expected_ = 0.0;  ///< strength that sets the rate [Pa]
  double peak_ = 0.0;                        ///< [Pa]
  std::vector<Vec2> path_;
};

}  // namespace muckpile::verification
