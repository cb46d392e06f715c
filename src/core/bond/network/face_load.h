// SPDX-License-Identifier: GPL-2.0-or-later
// The free and loaded faces of a facet network: pressure on them and the volume that they sweep.
// Scope: owns the faces, in the order in which they were set; SI units, pressure in Pa beyond the
// atmosphere. The gas of a crushed zone presses on the faces there until it flows round their
// blocks (wall_balance.h); what it then presses behind them is not followed here (core/gas does).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "bond/network/block_fields.h"
#include "bond/network/facet_kinematics.h"
#include "bond/network/joint_books.h"
#include "bond/network/wall_balance.h"

namespace muckpile {

class FaceLoad {
 public:
  /// The facets beside them are set.
  void set(std::vector<BoundaryFace> faces, const FacetTables& tables, const FacetHistory& history);
  /// The faces, which are here no longer.
  [[nodiscard]] std::vector<BoundaryFace> give_up();
  [[nodiscard]] std::vector<BoundaryFace>& faces() { return faces_; }
  [[nodiscard]] const std::vector<BoundaryFace>& faces() const { return faces_; }

  /// Whether faces will be under pressure again. While none is expected nor there, they sweep
  /// nothing.
  void expect_pressure(bool expected);
  /// The rock has become softer since the faces were loaded last.
  void note_softening() { softer_since_ = true; }
  [[nodiscard]] bool moved_unseen() const { return watch_ != Watch::on; }
  [[nodiscard]] bool softer_since() const { return softer_since_; }
  void resume(bool moved_unseen, bool softer_since) {
    watch_ = moved_unseen ? Watch::anew : Watch::on;
    softer_since_ = softer_since;
  }

  /// Adds what the pressures of `faces()` add to BlockSums::loaded.
  void squeeze(BlockFields& blocks);
  /// What they store in owned blocks beside the dilatations, the sum of A d p^2/(4G), as the last
  /// squeeze() found it [J].
  [[nodiscard]] double energy() const { return energy_; }
  /// Adds forces and torques of the pressures, books their work.
  void load(const FacetKinematics& facets, BlockFields& blocks, JointBooks& books);
  /// Work of the pressures of each hole on owned blocks in the last load() [J]; a hole beyond the
  /// end has none.
  [[nodiscard]] std::span<const double> work_per_hole() const { return hole_work_; }
  /// Of the last load(), hole faces alone: adds the force on each block, the share that counts as
  /// the wave's to `wave`, the rest to `gas`; a row per block that owns a face [N].
  void add_forces(std::span<Vec3> wave, std::span<Vec3> gas) const;
  /// By a loaded face since the start [m3].
  [[nodiscard]] static double volume_swept(const BoundaryFace& face, const BlockFields& blocks);

  [[nodiscard]] double bytes_of_faces() const {
    return static_cast<double>(faces_.capacity() * sizeof(BoundaryFace));
  }
  [[nodiscard]] double bytes_of_walls() const { return walls_ ? walls_->bytes() : 0.0; }

 private:
  /// How the faces' way is followed: step by step; again from the next step on; not while no
  /// pressure is expected nor there.
  enum class Watch { on, anew, off };

  void book_of_hole(std::size_t hole, double work) {
    if (hole >= hole_work_.size()) hole_work_.resize(hole + 1, 0.0);
    hole_work_[hole] += work;
  }
  void look_anew(const BlockFields& blocks);
  void share_load(const FacetHistory& history) {
    if (walls_) walls_->share_load(history, faces_);
  }

  std::vector<BoundaryFace> faces_;
  std::optional<WallBalance> walls_;
  Watch watch_ = Watch::on;
  bool pressure_expected_ = true, softer_since_ = false;
  double energy_ = 0.0;
  std::vector<double> hole_work_;  // in the last load() [J]
};

}  // namespace muckpile
