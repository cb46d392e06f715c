// SPDX-License-Identifier: GPL-2.0-or-later
// The memory of a contact as numbers of the engine, for its exchange buffers and restart files.
// Scope: each place takes or gives one double.
#pragma once

#include "contact/contact_law.h"

namespace muckpile {

inline constexpr int kContactStateNumbers = 8;
static_assert(sizeof(ContactState) == kContactStateNumbers * sizeof(double),
              "put() and get() leave out nothing of ContactState");

inline int put(const Vec3& vector, double* buffer) {
  Vec3::Map(buffer) = vector;
  return 3;
}
inline int get(Vec3& vector, const double* buffer) {
  vector = Vec3::Map(buffer);
  return 3;
}

/// Returns how many numbers it takes.
inline int put(const ContactState& state, double* buffer) {
  int m = put(state.slide, buffer);
  m += put(state.roll, buffer + m);
  buffer[m++] = state.overlap_offset;
  buffer[m++] = state.tangential_stiffness;
  return m;
}
inline int get(ContactState& state, const double* buffer) {
  int m = get(state.slide, buffer);
  m += get(state.roll, buffer + m);
  state.overlap_offset = buffer[m++];
  state.tangential_stiffness = buffer[m++];
  return m;
}

}  // namespace muckpile
