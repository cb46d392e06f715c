// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of what broken facets remember: access to one facet at a time.
// Scope: see the header.
#include "bond/network/contact_rows.h"

#include <algorithm>

namespace muckpile {

void ContactRows::reset(std::size_t groups) {
  rows_.clear();
  rows_.resize(groups);
  known_.assign(groups, 0);
}

void ContactRows::drop(std::size_t f) {
  if (!exists(f)) return;
  const std::size_t group = f / kGroup;
  set(f, {});
  known_[group] = static_cast<std::uint8_t>(known_[group] & ~bit(f));
  if (known_[group] == 0) rows_[group].drop();
}

void ContactRows::set_offset(std::size_t f, std::size_t p, const Vec3& offset) {
  set_lane(remember(f).offset[p], f % kGroup, offset);
}

double ContactRows::closes_at(std::size_t f) const {
  double first = offset(f, 0).x();
  for (std::size_t p = 1; p < kFacetPoints; ++p) first = std::max(first, offset(f, p).x());
  return first;
}

ContactMemory ContactRows::get(std::size_t f) const {
  ContactMemory memory;
  for (std::size_t p = 0; p < kFacetPoints; ++p) memory.offset[p] = offset(f, p);
  memory.fade = fade(f);
  return memory;
}

void ContactRows::set(std::size_t f, const ContactMemory& memory) {
  for (std::size_t p = 0; p < kFacetPoints; ++p) set_offset(f, p, memory.offset[p]);
  set_fade(f, memory.fade);
}

double ContactRows::memory_usage() const {
  auto bytes = static_cast<double>(rows_.capacity() * sizeof(rows_[0]) + known_.capacity());
  for (const Sparse<ContactGroup>& rows : rows_)
    bytes += rows.exists() ? sizeof(ContactGroup) : 0.0;
  return bytes;
}

}  // namespace muckpile
