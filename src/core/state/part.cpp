// SPDX-License-Identifier: GPL-2.0-or-later
// A part of a restart file: its head.
// Scope: see the header.
#include "state/part.h"

namespace muckpile {

/// Without the size in memory, which may be that of another compiler.
template <>
struct Stored<StoredType> {
  static constexpr std::string_view kName = "stored_type";
  static constexpr int kVersion = 1;
  static auto fields(auto& type) { return std::tie(type.name, type.version, type.layout); }
};

namespace {

constexpr std::array<char, 8> kMark{'M', 'u', 'c', 'k', 'P', 'a', 'r', 't'};

std::string version_text(const StoredType& type) {
  return std::string("version ") + std::to_string(type.version);
}

void require_same(const StoredType& here, const StoredTypes& in_file) {
  const auto found = std::ranges::find(in_file, here.name, &StoredType::name);
  const std::string expected =
      std::string("'") + here.name + "': " + version_text(here) + " expected, ";
  if (found == in_file.end()) throw StateError(expected + "none in the file");
  if (found->version != here.version)
    throw StateError(expected + version_text(*found) + " in the file");
  if (found->layout != here.layout)
    throw StateError(expected + "with the fields " + here.layout + ", the file has " +
                     found->layout);
}

}  // namespace

void put_types(ByteWriter& out, const StoredTypes& types) {
  out.put(kMark);
  out.put(types);
}

void require_types(ByteReader& in, const StoredTypes& types) {
  if (in.left() < sizeof(kMark) || in.get<std::array<char, 8>>() != kMark)
    throw StateError("the file is of an earlier version of Muckpile, or of another program");
  const auto in_file = in.get<StoredTypes>();
  for (const StoredType& here : types) require_same(here, in_file);
}

}  // namespace muckpile
