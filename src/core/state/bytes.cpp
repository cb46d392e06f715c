// SPDX-License-Identifier: GPL-2.0-or-later
// Values as bytes: bounds and their messages.
// Scope: see the header.
#include "state/bytes.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace muckpile {

void ByteWriter::put_bytes(const void* first, std::size_t count) {
  const char* from = static_cast<const char*>(first);
  bytes_.insert(bytes_.end(), from, from + count);
}

void ByteReader::get_bytes(void* to, std::size_t count) {
  if (count > left()) {
    fail(std::string("ends too soon: ") + std::to_string(count) + " more bytes expected, " +
         std::to_string(left()) + " there");
  }
  if (count > 0) std::memcpy(to, at_, count);
  at_ += count;
}

std::size_t ByteReader::get_count(std::size_t bytes_each) {
  std::uint64_t count = 0;
  get_bytes(&count, sizeof(count));
  if (count > left() / std::max<std::size_t>(bytes_each, 1)) {
    fail(std::string("ends too soon: ") + std::to_string(count) + " values of at least " +
         std::to_string(bytes_each) + " bytes expected, " + std::to_string(left()) +
         " bytes there");
  }
  return count;
}

void ByteReader::require_end(std::string_view name) const {
  if (empty()) return;
  throw StateError(std::string("'") + std::string(name) +
                   "' is too long: no more bytes expected behind it, " + std::to_string(left()) +
                   " there");
}

void ByteReader::fail(const std::string& fault) const {
  throw StateError(std::string("'") + std::string(name_) + "' " + fault);
}

}  // namespace muckpile
