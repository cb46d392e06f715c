// SPDX-License-Identifier: GPL-2.0-or-later
// Byte buffers and their exchange between ranks.
// Scope: same machine type on every rank; values are copied as they lie in memory.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "math/types.h"

namespace muckpile::engine {

/// Types whose bytes may be copied: plain data, and structs of plain data and fixed-size vectors,
/// which Eigen keeps as plain arrays although the language does not call them trivial.
template <typename T>
inline constexpr bool kCopyable = std::is_trivially_destructible_v<T> && !std::is_pointer_v<T>;

class ByteWriter {
 public:
  template <typename T>
  void put(const T& value) {
    static_assert(kCopyable<T>);
    const std::size_t size = bytes_.size();
    bytes_.resize(size + sizeof(T));
    std::memcpy(bytes_.data() + size, static_cast<const void*>(&value), sizeof(T));
  }
  template <typename T>
  void put_all(const std::vector<T>& values) {
    put(values.size());
    for (const T& value : values) put(value);
  }
  [[nodiscard]] std::vector<char>& bytes() { return bytes_; }

 private:
  std::vector<char> bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(const std::vector<char>& bytes)
      : at_(bytes.data()), end_(at_ + bytes.size()) {}
  ByteReader(const char* first, std::size_t size) : at_(first), end_(first + size) {}
  [[nodiscard]] bool empty() const { return at_ == end_; }
  template <typename T>
  [[nodiscard]] T get() {
    static_assert(kCopyable<T>);
    T value;
    std::memcpy(static_cast<void*>(&value), at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  template <typename T>
  [[nodiscard]] std::vector<T> get_all() {
    std::vector<T> values(get<std::size_t>());
    for (T& value : values) value = get<T>();
    return values;
  }

 private:
  const char* at_;
  const char* end_;
};

/// Moves the buffers out of the writers.
[[nodiscard]] std::vector<std::vector<char>> bytes_of(std::vector<ByteWriter>& writers);

/// The values of all ranks, in the order of ranks, on every rank. Collective.
[[nodiscard]] std::vector<double> gather_all(const std::vector<double>& mine, MPI_Comm world);

/// The text of the first rank, on every rank. Collective.
[[nodiscard]] std::string of_first_rank(std::string text, MPI_Comm world);

/// Sends outgoing[r] to rank r and returns what each rank sent here. Collective. Goes in rounds of
/// at most `most_at_once` bytes (below 2 GiB) to or from a rank, or, with more ranks than that, one
/// byte between each two.
[[nodiscard]] std::vector<std::vector<char>> exchange_bytes(
    const std::vector<std::vector<char>>& outgoing, MPI_Comm world,
    std::size_t most_at_once = std::size_t{1} << 30);

}  // namespace muckpile::engine
