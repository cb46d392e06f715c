// SPDX-License-Identifier: GPL-2.0-or-later
// What a facet remembers: which of its points broke, and what they carry since.
// Scope: data; all of it travels with the facet from rank to rank and through restart files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bond/cohesion.h"
#include "bond/facet.h"
#include "bond/quiet_ground.h"
#include "bond/rare.h"
#include "math/types.h"

namespace muckpile {

/// State of a facet; it only ever moves down this list.
enum class FacetState : std::uint8_t {
  intact,   ///< every integration point holds
  cracked,  ///< at least one point broke; the facet itself carries what contact there is
  fading,   ///< slid or turned so far that sphere contact acts beside the fading facet
  retired   ///< the facet carries nothing any more
};

/// What few facets remember: those that soften, and supports whose ground has moved.
struct RareMemory {
  std::array<Cohesion, kFacetPoints> cohesion{};  ///< broken point: what it still holds
  GroundMemory ground;                            ///< of a support only
};

/// What facets with a broken point remember of their contact.
struct ContactMemory {
  std::array<Vec3, kFacetPoints> offset{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  ///< broken point: jump at zero force, along the normal, the first half axis and across [m]; of
  ///< one that slips, what it has slipped
  double fade = 1.0;  ///< 1 while the faces match, falls to 0 as they slide or turn away
};

/// What every facet remembers.
struct FacetTraces {
  std::array<bool, kFacetPoints> broken{false, false, false};
  FacetState state = FacetState::intact;
  bool open = false;          ///< broken and so far open that its points were left alone last time
  bool gas = false;           ///< broken, and not yet so wide that gas in it is in the open
  std::uint8_t slipping = 0;  ///< bit per point: broken, but closed and still in the dilatations

  [[nodiscard]] bool slips(std::size_t p) const { return (slipping >> p & 1u) != 0; }
  /// Broken, and out of the dilatations.
  [[nodiscard]] bool is_contact(std::size_t p) const { return broken[p] && !slips(p); }

  /// Nothing acts through it any more.
  [[nodiscard]] bool over() const { return state == FacetState::retired && !gas; }
};

/// What a facet remembers; all of it travels with the facet.
struct FacetMemory : FacetTraces {
  Rare<ContactMemory> contact;
  Rare<RareMemory> rare;
  [[nodiscard]] const GroundMemory& ground() const { return rare.get().ground; }
  [[nodiscard]] const std::array<Cohesion, kFacetPoints>& cohesion() const {
    return rare.get().cohesion;
  }
};

}  // namespace muckpile
