// SPDX-License-Identifier: GPL-2.0-or-later
// A list of stored values in a buffer of numbers, as engines exchange and store what particles
// carry.
// Scope: the bytes of the encoding, filled up to whole numbers. Types of one size alone.
#pragma once

#include <cstring>
#include <span>
#include <stdexcept>
#include <vector>

#include "state/encoding.h"

namespace muckpile {

/// How many numbers a list of so many values takes.
template <class T>
[[nodiscard]] constexpr int numbers_of_list(std::size_t count) {
  const std::size_t bytes = sizeof(std::uint64_t) + count * Encoding<T>::kLeast;
  return static_cast<int>((bytes + sizeof(double) - 1) / sizeof(double));
}

/// Returns how many numbers it has written.
template <class T>
int put_list(std::span<const T> values, double* numbers) {
  ByteWriter out;
  out.put<std::uint64_t>(values.size());
  for (const T& value : values) out.put(value);
  const int count = numbers_of_list<T>(values.size());
  if (out.bytes().size() != sizeof(std::uint64_t) + values.size() * Encoding<T>::kLeast)
    throw std::logic_error("put_list: values of this type differ in size");
  out.bytes().resize(static_cast<std::size_t>(count) * sizeof(double));
  std::memcpy(numbers, out.bytes().data(), out.bytes().size());
  return count;
}

/// Adds the values to a list; returns how many of the numbers it has read. Throws a StateError if
/// the list does not end within them.
template <class T>
int get_list(std::vector<T>& values, std::span<const double> numbers) {
  ByteReader in(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
  const ByteReader::Naming naming(in, "list of numbers");
  const std::size_t count = in.get_count(Encoding<T>::kLeast);
  for (std::size_t k = 0; k < count; ++k) values.push_back(in.get<T>());
  return numbers_of_list<T>(count);
}

}  // namespace muckpile
