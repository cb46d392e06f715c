// SPDX-License-Identifier: GPL-2.0-or-later
// What a facet remembers: which of its points broke, and what they carry since.
// Scope: data of one facet in SI units; all of it travels with the facet from rank to rank and
// through restart files. Where a network keeps it is facet_history.h.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "bond/facet.h"
#include "bond/ground/quiet_ground.h"
#include "bond/law/cohesion.h"
#include "bond/law/joint_law.h"
#include "bond/network/sparse.h"
#include "math/types.h"

namespace muckpile {

/// State of a facet; it only ever moves down this list.
enum class FacetState : std::uint8_t {
  intact,   ///< every integration point holds
  cracked,  ///< at least one point broke; the facet itself carries what contact there is
  fading,   ///< slid or turned so far that sphere contact acts beside the fading facet
  retired   ///< the facet carries nothing any more
};

/// What few facets remember: those that soften, those whose joint law is not grouped, and supports
/// whose ground has moved.
struct ExtraMemory {
  std::array<Cohesion, kFacetPoints> cohesion{};   ///< broken point: what it still holds
  GroundMemory ground;                             ///< of a support only
  std::array<JointHistory, kFacetPoints> joint{};  ///< of a law that is not grouped
};

/// What facets with a broken point remember of their contact.
struct ContactMemory {
  std::array<Vec3, kFacetPoints> offset{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  ///< broken point: jump at zero force, along the normal, the first half axis and across [m]; of
  ///< one that slips, what it has slipped
  double fade = 1.0;  ///< 1 while the faces match, falls to 0 as they slide or turn away
};

/// Some points of a facet.
class PointSet {
 public:
  PointSet() = default;
  [[nodiscard]] static PointSet all() { return PointSet((1u << kFacetPoints) - 1u); }

  [[nodiscard]] bool operator[](std::size_t p) const { return (bits_ >> p & 1u) != 0; }
  void set(std::size_t p, bool in = true) {
    bits_ = static_cast<std::uint8_t>((bits_ & ~(1u << p)) | (in ? 1u : 0u) << p);
  }
  [[nodiscard]] int count() const { return std::popcount(bits_); }
  [[nodiscard]] bool any() const { return bits_ != 0; }
  [[nodiscard]] unsigned bits() const { return bits_; }  ///< bit per point
  [[nodiscard]] PointSet without(PointSet others) const {
    return PointSet(bits() & ~others.bits());
  }

 private:
  explicit PointSet(unsigned bits) : bits_(static_cast<std::uint8_t>(bits)) {}
  std::uint8_t bits_ = 0;
};

/// What every facet remembers.
struct FacetTraces {
  PointSet broken, slipping;  ///< slipping: broken, but closed and still in the dilatations
  FacetState state = FacetState::intact;
  bool open : 1 = false;  ///< broken and so far open that its points were left alone last time
  bool gas : 1 = false;   ///< broken, and not yet so wide that gas in it is in the open

  /// Broken, and out of the dilatations.
  [[nodiscard]] PointSet contact() const { return broken.without(slipping); }
  [[nodiscard]] bool is_contact(std::size_t p) const { return contact()[p]; }

  /// Nothing acts through it any more.
  [[nodiscard]] bool over() const { return state == FacetState::retired && !gas; }
};

/// What a facet remembers; all of it travels with the facet.
struct FacetMemory : FacetTraces {
  Sparse<ContactMemory> contact;
  Sparse<ExtraMemory> extra;
  [[nodiscard]] const GroundMemory& ground() const { return extra.get().ground; }
  [[nodiscard]] const std::array<Cohesion, kFacetPoints>& cohesion() const {
    return extra.get().cohesion;
  }
};

}  // namespace muckpile
