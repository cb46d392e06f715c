// SPDX-License-Identifier: GPL-2.0-or-later
// A 64-bit hash of bytes, for seals of files and ids of runs.
// Scope: against mistakes and damage, not against intent. FNV-1a (Fowler, Noll & Vo 1991).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace muckpile {

/// Each step is one-to-one: no single changed byte goes unseen.
class Fingerprint {
 public:
  Fingerprint& add_bytes(const void* first, std::size_t count);
  Fingerprint& add(double value) { return add_bytes(&value, sizeof(value)); }
  Fingerprint& add(std::uint64_t value) { return add_bytes(&value, sizeof(value)); }
  /// With its length: "ab" and "c" are not "a" and "bc".
  Fingerprint& add(std::string_view text);

  [[nodiscard]] std::uint64_t value() const { return hash_; }
  /// 16 hexadecimal digits in lower case.
  [[nodiscard]] std::string text() const;

 private:
  std::uint64_t hash_ = 14695981039346656037ull;
};

}  // namespace muckpile
