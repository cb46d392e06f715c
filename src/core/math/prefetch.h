// SPDX-License-Identifier: GPL-2.0-or-later
// Asking for memory ahead of its use.
// Scope: speed alone; no result depends on it.
#pragma once

#include <cstddef>

namespace muckpile {

// The empty statements keep functions that do nothing else: GCC takes them for pure ones, as if a
// prefetch had no effect, and drops the calls.

/// The cache line of `place`.
[[gnu::always_inline]] inline void prefetch(const void* place) {
  __builtin_prefetch(place);
  asm volatile("");
}
/// For one that will be written.
[[gnu::always_inline]] inline void prefetch_to_write(const void* place) {
  __builtin_prefetch(place, 1);
  asm volatile("");
}

/// All lines of a value; of none where there is no value.
template <class T>
[[gnu::always_inline]] inline void prefetch_all(const T* value) {
  constexpr std::size_t kLine = 64;
  const auto* bytes = reinterpret_cast<const char*>(value);
  for (std::size_t k = 0; bytes != nullptr && k < sizeof(T); k += kLine) prefetch(bytes + k);
}

}  // namespace muckpile
