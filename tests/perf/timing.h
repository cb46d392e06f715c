// SPDX-License-Identifier: GPL-2.0-or-later
// CPU times for the perf programs.
// Scope: one thread; the least of several rounds, so that other programs on the machine disturb
// little.
#pragma once

#include <functional>
#include <string>

namespace muckpile::perf {

inline constexpr int kRounds = 7;

[[nodiscard]] double least_time(const std::function<void()>& body, int rounds = kRounds);  ///< [s]

[[nodiscard]] std::string processor();  ///< its name

}  // namespace muckpile::perf
