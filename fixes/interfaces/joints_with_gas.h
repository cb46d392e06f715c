// SPDX-License-Identifier: GPL-2.0-or-later
// What the gas in broken joints needs of them, and what it does to them.
// Scope: an interface only; fix muckpile/joint implements it, fix muckpile/gas drives it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bond/network/joint_rooms.h"
#include "fixes/engine/block_halo.h"

namespace muckpile {

class JointsWithGas {
 public:
  virtual ~JointsWithGas() = default;
  /// As the last force computation left them, blocks of this rank first, in the order of their
  /// bodies; good until lists_version() grows.
  [[nodiscard]] virtual JointRooms rooms() const = 0;
  /// Grows whenever the lists of blocks and joints in rooms() may have changed.
  [[nodiscard]] virtual std::uint64_t lists_version() const = 0;
  /// Tags of the owned blocks, in the order of their bodies.
  [[nodiscard]] virtual std::vector<int> block_tags() const = 0;
  /// Sends numbers of blocks to the ranks that have copies of them.
  [[nodiscard]] virtual const engine::BlockHalo& halo() const = 0;

  /// From now on joints that break keep room for gas, also those that carry nothing any more.
  virtual void keep_gas_in_joints() = 0;
  /// No joint holds gas any more, nor will; the pressure is taken off.
  virtual void release_gas() = 0;
  /// The gas in these joints is in the open.
  virtual void release_gas(std::span<const std::uint32_t> joints) = 0;

  /// Work rate of the gas on the bodies of this rank, with the forces of the last force computation
  /// and the bodies' velocities of now [W].
  [[nodiscard]] virtual double gas_power() const = 0;
  /// Adds work of the gas on this rank [J] to that of the pressure.
  virtual void book_gas_work(double work) = 0;

  [[nodiscard]] virtual int hole_count() const = 0;
  [[nodiscard]] virtual double shear_modulus() const = 0;  ///< as BlastSurface has it [Pa]
  [[nodiscard]] virtual double softened() const = 0;       ///< as BlastSurface has it [-]
  virtual void unload_softened() = 0;                      ///< as BlastSurface has it
};

}  // namespace muckpile
