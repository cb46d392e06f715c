// SPDX-License-Identifier: GPL-2.0-or-later
// What broken facets remember of their contact, beside each other in the groups of facet_group.h.
// Scope: storage. A group has rows once one of its facets has something to remember, until none
// has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bond/network/facet_group.h"
#include "bond/network/facet_memory.h"
#include "bond/network/sparse.h"

namespace muckpile {

/// ContactMemory of the facets of a group; its default for those that remember nothing.
struct alignas(64) ContactGroup {
  std::array<FacetRows<double>, kFacetPoints> offset{};
  FacetRow<double> fade = all(1.0);

  [[nodiscard]] static constexpr FacetRow<double> all(double value) {
    FacetRow<double> row{};
    row.fill(value);
    return row;
  }
};

/// ContactMemory of all facets of a network.
class ContactRows {
 public:
  void reset(std::size_t groups);

  [[nodiscard]] bool exists(std::size_t f) const { return (known_[f / kGroup] & bit(f)) != 0; }
  /// The rows of a group, to read.
  [[nodiscard]] const ContactGroup& of(std::size_t group) const { return rows_[group].get(); }
  /// From now on `lanes` of a group remember.
  [[nodiscard]] ContactGroup& remember(std::size_t group, unsigned lanes) {
    known_[group] = static_cast<std::uint8_t>(known_[group] | lanes);
    return rows_[group].get_or_create();
  }
  void drop(std::size_t f);
  /// Prefetches what one of `lanes` of a group remembers, ahead of its use.
  void fetch(std::size_t group, unsigned lanes) const {
    if ((known_[group] & lanes) != 0) rows_[group].fetch();
  }

  /// Prefetches how far the points of a group were open as they broke, ahead of its use.
  void fetch_openings(std::size_t group) const {
    if (known_[group] == 0) return;
    for (const FacetRows<double>& offset : of(group).offset) prefetch(offset[0].data());
  }

  // Of one facet.
  [[nodiscard]] double fade(std::size_t f) const { return of(f / kGroup).fade[f % kGroup]; }
  void set_fade(std::size_t f, double fade) { remember(f).fade[f % kGroup] = fade; }
  [[nodiscard]] Vec3 offset(std::size_t f, std::size_t p) const {
    return at_lane(of(f / kGroup).offset[p], f % kGroup);
  }
  void set_offset(std::size_t f, std::size_t p, const Vec3& offset);
  /// Opening at which the first of its points carries a pressure [m].
  [[nodiscard]] double closes_at(std::size_t f) const;
  [[nodiscard]] ContactMemory get(std::size_t f) const;
  void set(std::size_t f, const ContactMemory& memory);

  [[nodiscard]] double memory_usage() const;  ///< [bytes]

 private:
  [[nodiscard]] static std::uint8_t bit(std::size_t f) {
    return static_cast<std::uint8_t>(1u << f % kGroup);
  }
  [[nodiscard]] ContactGroup& remember(std::size_t f) { return remember(f / kGroup, bit(f)); }

  std::vector<Sparse<ContactGroup>> rows_;  // per group
  std::vector<std::uint8_t> known_;         // per group: bit per facet that remembers
};

}  // namespace muckpile
