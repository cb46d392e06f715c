// SPDX-License-Identifier: GPL-2.0-or-later
// What the blast load needs to know of the joints: the block faces that lie on crushed-zone
// cylinders. Scope: an interface only; fix muckpile/joint implements it, fix muckpile/blast drives
// it.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/block_model.h"
#include "math/types.h"

namespace muckpile {

/// One block face on a crushed-zone cylinder, as it was at the start (side wall or end cap).
struct LoadedFacet {
  int hole;          ///< index of the hole, 0 .. hole_count() - 1
  double area;       ///< [m2]
  Vec3 start_point;  ///< centroid [m]
};

/// The loaded faces of the blocks that this rank owns. Every face is owned by exactly one rank, so
/// a sum over ranks counts each face once. Only swept_volume() and the works need a sum over ranks.
class BlastSurface {
 public:
  virtual ~BlastSurface() = default;

  /// Holes of the whole model, the same on every rank and in the order of the input script; known
  /// from the implementing fix's constructor on.
  [[nodiscard]] virtual int hole_count() const = 0;
  /// Crushed-zone cylinder of a hole: the axis runs along the charge from toe to collar.
  [[nodiscard]] virtual const Hole& hole(int index) const = 0;

  /// Valid, and in the same order, until loaded_facets_version() changes (at reneighbouring).
  [[nodiscard]] virtual std::span<const LoadedFacet> loaded_facets() const = 0;
  /// Grows by at least one whenever the list may have changed; pressures are zero after that.
  [[nodiscard]] virtual std::uint64_t loaded_facets_version() const = 0;

  /// Pressure [Pa], one per loaded facet and positive when it pushes the block away from the hole,
  /// for the coming force computation. It stays until it is set again. The force on the block is -p
  /// A n at the face's centroid, n its outward normal, both turning with the block; the pressure
  /// also enters the block's dilatation. A block that gas flows round feels a share of it, down to
  /// nothing. Called in pre_force, used in post_force.
  /// wave_share, one per facet: share of the pressure's work that counts as the wave's; the rest
  /// counts as the gas's.
  virtual void set_pressure(std::span<const double> pressure,
                            std::span<const double> wave_share) = 0;

  /// Volume [m3] swept since the start by the faces of each hole, this rank's faces only, positive
  /// outward; a function of the present state, with the condensed displacement of the face.
  /// Writes hole_count() values; they belong to the last force computation, so call it after that
  /// and before the next reneighbouring.
  virtual void swept_volume(std::span<double> per_hole) const = 0;

  /// Says whether set_pressure() will be called again. If not, faces without pressure cost nothing.
  virtual void expect_pressure(bool expected) = 0;

  /// Of the rock as soft as it is now [Pa].
  [[nodiscard]] virtual double shear_modulus() const = 0;
  /// Its stiffness over that at the start [-].
  [[nodiscard]] virtual double softened() const = 0;
  /// Takes all pressure off softened rock: what unloading would give back is part of what softening
  /// has counted as lost.
  virtual void unload_softened() = 0;

  /// Work [J] of the last force computation's pressures on the faces of each hole, this rank's
  /// faces only; hole_count() values.
  virtual void work_of_step(std::span<double> per_hole) const = 0;
  /// Work done by the pressure so far on this rank's faces [J].
  [[nodiscard]] virtual double pressure_work() const = 0;
  /// The wave's part of pressure_work() [J].
  [[nodiscard]] virtual double wave_work() const = 0;
};

}  // namespace muckpile
