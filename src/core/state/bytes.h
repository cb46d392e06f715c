// SPDX-License-Identifier: GPL-2.0-or-later
// Values as bytes, for restart files and for messages between ranks.
// Scope: the bytes are read by the program that wrote them, on the same kind of machine. How a type
// lies in them is in state/encoding.h, which users of these classes include.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "args/input_error.h"

namespace muckpile {

template <class T>
struct Encoding;

/// Bytes are not what the reader was told to expect: cut short, too long, or of another version.
class StateError : public InputError {
 public:
  using InputError::InputError;
};

class ByteWriter {
 public:
  template <class T>
  void put(const T& value) {
    Encoding<T>::put(*this, value);
  }
  void put_bytes(const void* first, std::size_t count);
  [[nodiscard]] std::vector<char>& bytes() { return bytes_; }

 private:
  std::vector<char> bytes_;
};

/// Does not own the bytes. Throws a StateError that names the type instead of reading beyond them.
class ByteReader {
 public:
  explicit ByteReader(const std::vector<char>& bytes) : ByteReader(bytes.data(), bytes.size()) {}
  ByteReader(const char* first, std::size_t count) : at_(first), end_(first + count) {}

  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  [[nodiscard]] bool empty() const { return at_ == end_; }
  template <class T>
  [[nodiscard]] T get() {
    T value{};
    get(value);
    return value;
  }
  template <class T>
  void get(T& value) {
    Encoding<T>::get(*this, value);
  }
  void get_bytes(void* to, std::size_t count);
  /// How many values follow, each of `bytes_each` bytes at least: no more than there are bytes for.
  [[nodiscard]] std::size_t get_count(std::size_t bytes_each);
  /// Throws if bytes are left behind what is called `name`.
  void require_end(std::string_view name) const;
  /// Throws with the name of the type that is being read before `fault`.
  [[noreturn]] void fail(const std::string& fault) const;

  /// Names the type that is read while it lives.
  class Naming {
   public:
    Naming(ByteReader& reader, std::string_view name) : reader_(reader), outer_(reader.name_) {
      reader.name_ = name;
    }
    Naming(const Naming&) = delete;
    Naming& operator=(const Naming&) = delete;
    ~Naming() { reader_.name_ = outer_; }

   private:
    ByteReader& reader_;
    std::string_view outer_;
  };

 private:
  const char* at_;
  const char* end_;
  std::string_view name_ = "value";
};

}  // namespace muckpile
