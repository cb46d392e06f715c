// SPDX-License-Identifier: GPL-2.0-or-later
// A 64-bit hash of bytes.
// Scope: see the header.
#include "provenance/fingerprint.h"

namespace muckpile {

Fingerprint& Fingerprint::add_bytes(const void* first, std::size_t count) {
  const auto* bytes = static_cast<const unsigned char*>(first);
  for (std::size_t k = 0; k < count; ++k) {
    hash_ ^= bytes[k];
    hash_ *= 1099511628211ull;
  }
  return *this;
}

Fingerprint& Fingerprint::add(std::string_view text) {
  add(static_cast<std::uint64_t>(text.size()));
  return add_bytes(text.data(), text.size());
}

std::string Fingerprint::text() const {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string digits(16, '0');
  for (std::size_t k = 0; k < digits.size(); ++k)
    digits[digits.size() - 1 - k] = kDigits[hash_ >> (4 * k) & 15u];
  return digits;
}

}  // namespace muckpile
