// SPDX-License-Identifier: GPL-2.0-or-later
// A value that few of many objects have: eight bytes where there is none.
// Scope: copies are deep; reading a value that is not there gives the default one.
#pragma once

#include <cstddef>
#include <memory>

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

}  // namespace muckpile
