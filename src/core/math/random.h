// SPDX-License-Identifier: GPL-2.0-or-later
// A small random generator with the same numbers on every platform and library.
// Scope: splitmix64 (Steele, Lea, Flood 2014); good enough for seeds, not for cryptography.
#pragma once

#include <cstdint>

namespace muckpile {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  // Uniform in [0, 1), 53 bits.
  [[nodiscard]] double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

 private:
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace muckpile
