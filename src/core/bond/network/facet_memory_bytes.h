// SPDX-License-Identifier: GPL-2.0-or-later
// What a facet remembers as bytes, for messages between ranks and restart files.
// Scope: any writer with put(value) and any bounds-checked reader with get<T>() serve. The bytes
// are those of the program that wrote them; kFacetMemoryVersion rises whenever FacetTraces,
// ContactMemory, ExtraMemory or their order change. unpack_memory() throws InputError on bytes of
// another version.
#pragma once

#include <cstdint>
#include <string>

#include "args/input_error.h"
#include "bond/network/facet_memory.h"

namespace muckpile {

inline constexpr std::uint8_t kFacetMemoryVersion = 1;

/// Appends a version and the parts that this facet has.
template <class Writer>
void pack_memory(Writer& out, const FacetMemory& memory) {
  out.put(kFacetMemoryVersion);
  out.put(static_cast<const FacetTraces&>(memory));
  out.put(memory.contact.exists());
  if (memory.contact.exists()) out.put(memory.contact.get());
  out.put(memory.extra.exists());
  if (memory.extra.exists()) out.put(memory.extra.get());
}

template <class Reader>
[[nodiscard]] FacetMemory unpack_memory(Reader& in) {
  const auto version = in.template get<std::uint8_t>();
  if (version != kFacetMemoryVersion)
    throw InputError("memory of facets: must be of version " + std::to_string(kFacetMemoryVersion) +
                     ", got version " + std::to_string(version));
  FacetMemory memory;
  static_cast<FacetTraces&>(memory) = in.template get<FacetTraces>();
  if (in.template get<bool>()) memory.contact.get_or_create() = in.template get<ContactMemory>();
  if (in.template get<bool>()) memory.extra.get_or_create() = in.template get<ExtraMemory>();
  return memory;
}

}  // namespace muckpile
