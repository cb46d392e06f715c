// SPDX-License-Identifier: GPL-2.0-or-later
// Which blocks rest: kept where they are, until something near them moves.
// Scope: an interface only; fix muckpile/sleep implements it, the integrator and the contact style
// read it, fix muckpile/ledger books what they lost, block_motion wakes them.
#pragma once

#include <cstdint>
#include <span>

namespace muckpile {

class RestingBlocks {
 public:
  virtual ~RestingBlocks() = default;
  /// True if any block of this rank's bodies or spheres rests.
  [[nodiscard]] virtual bool any_rests() const = 0;
  /// True if a body rests; `body` is its index in fix multisphere on this rank.
  [[nodiscard]] virtual bool body_rests(int body) const = 0;
  /// Per sphere, owned ones and ghosts: 1 if its block rests.
  [[nodiscard]] virtual std::span<const char> resting_spheres() const = 0;
  /// Grows whenever one of these may have changed.
  [[nodiscard]] virtual std::uint64_t rests_version() const = 0;
  /// All blocks move freely until they have rested anew.
  virtual void wake_blocks() = 0;
  /// Kinetic energy of the blocks as they came to rest so far, of this rank [J].
  [[nodiscard]] virtual double energy_taken() const = 0;
};

}  // namespace muckpile
