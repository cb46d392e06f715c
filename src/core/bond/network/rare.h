// SPDX-License-Identifier: GPL-2.0-or-later
// A value that few of many objects have: eight bytes where there is none.
// Scope: copies are deep; reading a value that is not there gives the default one.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace muckpile {

template <class T>
class Rare {
 public:
  Rare() = default;
  Rare(const Rare& other) { *this = other; }
  Rare(Rare&&) noexcept = default;
  Rare& operator=(const Rare& other) {
    if (this != &other) value_ = other.value_ ? std::make_unique<T>(*other.value_) : nullptr;
    return *this;
  }
  Rare& operator=(Rare&&) noexcept = default;
  ~Rare() = default;

  [[nodiscard]] bool exists() const { return value_ != nullptr; }
  [[nodiscard]] const T& get() const {
    static const T none{};
    return value_ ? *value_ : none;
  }
  [[nodiscard]] T& made() {
    if (!value_) value_ = std::make_unique<T>();
    return *value_;
  }
  void drop() { value_.reset(); }
  /// Asks for the value, if there is one, ahead of its use.
  void fetch() const {
    constexpr std::size_t kLine = 64;
    const auto* bytes = reinterpret_cast<const char*>(value_.get());
    for (std::size_t k = 0; bytes != nullptr && k < sizeof(T); k += kLine)
      __builtin_prefetch(bytes + k);
  }

 private:
  std::unique_ptr<T> value_;
};

/// Rare values of many objects by their number: one byte each where there is none in their row.
template <class T>
class RareTable {
 public:
  void reset(std::size_t count) {
    rows_.clear();
    rows_.resize((count + kRow - 1) / kRow);
  }
  [[nodiscard]] bool exists(std::size_t k) const { return at(k).exists(); }
  [[nodiscard]] const T& get(std::size_t k) const { return at(k).get(); }
  [[nodiscard]] T& made(std::size_t k) { return rows_[k / kRow].made()[k % kRow].made(); }
  void drop(std::size_t k) {
    if (exists(k)) rows_[k / kRow].made()[k % kRow].drop();
  }
  /// Calls `of` with each value that there is, in order.
  template <class Of>
  void each(const Of& of) {
    for (Rare<Row>& row : rows_) {
      if (!row.exists()) continue;
      for (Rare<T>& value : row.made())
        if (value.exists()) of(value.made());
    }
  }
  [[nodiscard]] double memory_usage() const {  // [bytes]
    auto bytes = static_cast<double>(rows_.capacity() * sizeof(rows_[0]));
    for (const Rare<Row>& row : rows_) {
      if (!row.exists()) continue;
      bytes += sizeof(Row);
      for (const Rare<T>& value : row.get()) bytes += value.exists() ? sizeof(T) : 0.0;
    }
    return bytes;
  }

 private:
  static constexpr std::size_t kRow = 8;
  using Row = std::array<Rare<T>, kRow>;
  [[nodiscard]] const Rare<T>& at(std::size_t k) const { return rows_[k / kRow].get()[k % kRow]; }

  std::vector<Rare<Row>> rows_;
};

}  // namespace muckpile
