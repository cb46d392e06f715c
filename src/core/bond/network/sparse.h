// SPDX-License-Identifier: GPL-2.0-or-later
// A value that few of many objects have: it takes eight bytes where there is none.
// Scope: storage without units. A copy is deep. Reading a value that is not there gives the default
// value and allocates nothing; only get_or_create() allocates.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "math/prefetch.h"

namespace muckpile {

template <class T>
class Sparse {
 public:
  Sparse() = default;
  Sparse(const Sparse& other) { *this = other; }
  Sparse(Sparse&&) noexcept = default;
  Sparse& operator=(const Sparse& other) {
    if (this != &other) value_ = other.value_ ? std::make_unique<T>(*other.value_) : nullptr;
    return *this;
  }
  Sparse& operator=(Sparse&&) noexcept = default;
  ~Sparse() = default;

  [[nodiscard]] bool exists() const { return value_ != nullptr; }
  [[nodiscard]] const T& get() const {
    static const T none{};
    return value_ ? *value_ : none;
  }
  [[nodiscard]] T& get_or_create() {
    if (!value_) value_ = std::make_unique<T>();
    return *value_;
  }
  void drop() { value_.reset(); }
  /// Prefetches the value, if there is one, ahead of its use.
  void fetch() const { prefetch_all(value_.get()); }

 private:
  std::unique_ptr<T> value_;
};

/// Such values of many objects by their number: one byte each where there is none in their row.
template <class T>
class SparseTable {
 public:
  void reset(std::size_t count) {
    rows_.clear();
    rows_.resize((count + kRow - 1) / kRow);
  }
  [[nodiscard]] bool exists(std::size_t k) const {
    const Sparse<Row>& row = rows_[k / kRow];
    return row.exists() && row.get()[k % kRow].exists();
  }
  /// Of `Count` objects from `first` on, a multiple of that: bit per object that has a value.
  template <std::size_t Count>
  [[nodiscard]] unsigned existing_of_row(std::size_t first) const {
    static_assert(kRow % Count == 0);
    const Sparse<Row>& row = rows_[first / kRow];
    if (!row.exists()) return 0;
    unsigned bits = 0;
    for (std::size_t k = 0; k < Count; ++k)
      bits |= (row.get()[first % kRow + k].exists() ? 1u : 0u) << k;
    return bits;
  }
  [[nodiscard]] const T& get(std::size_t k) const { return at(k).get(); }
  [[nodiscard]] T& get_or_create(std::size_t k) {
    return rows_[k / kRow].get_or_create()[k % kRow].get_or_create();
  }
  void drop(std::size_t k) {
    if (exists(k)) rows_[k / kRow].get_or_create()[k % kRow].drop();
  }
  /// Calls `of` with each value that there is, in order.
  template <class Of>
  void each(const Of& of) {
    for (Sparse<Row>& row : rows_) {
      if (!row.exists()) continue;
      for (Sparse<T>& value : row.get_or_create())
        if (value.exists()) of(value.get_or_create());
    }
  }
  [[nodiscard]] double memory_usage() const {  // [bytes]
    auto bytes = static_cast<double>(rows_.capacity() * sizeof(rows_[0]));
    for (const Sparse<Row>& row : rows_) {
      if (!row.exists()) continue;
      bytes += sizeof(Row);
      for (const Sparse<T>& value : row.get()) bytes += value.exists() ? sizeof(T) : 0.0;
    }
    return bytes;
  }

 private:
  static constexpr std::size_t kRow = 8;
  using Row = std::array<Sparse<T>, kRow>;
  [[nodiscard]] const Sparse<T>& at(std::size_t k) const { return rows_[k / kRow].get()[k % kRow]; }

  std::vector<Sparse<Row>> rows_;
};

}  // namespace muckpile
