// SPDX-License-Identifier: GPL-2.0-or-later
// A part of a restart file: which stored types it holds, in which versions, and then the values.
// Scope: bytes; whose part it is, and how it gets into the file, is the caller's.
#pragma once

#include "state/encoding.h"

namespace muckpile {

/// Puts the mark of our parts and the names, versions and layouts of `types`.
void put_types(ByteWriter& out, const StoredTypes& types);

/// Throws a StateError that names the first type of which the file has another version than this
/// program, or none; so it does for bytes that are no part of ours at all.
void require_types(ByteReader& in, const StoredTypes& types);

/// `value` behind its types.
template <class T>
void put_part(ByteWriter& out, const T& value) {
  put_types(out, stored_types<T>());
  out.put(value);
}

template <class T>
[[nodiscard]] T get_part(ByteReader& in) {
  require_types(in, stored_types<T>());
  return in.get<T>();
}

}  // namespace muckpile
