// SPDX-License-Identifier: GPL-2.0-or-later
// Independent parts of a task on all cores.
// Scope: parts that write to places of their own, so that results do not depend on the number of
// cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace muckpile {

inline std::size_t cores() { return std::max(1U, std::thread::hardware_concurrency()); }

// Calls work(0), work(1) ... work(parts - 1), in any order. Throws what the first of them that
// failed has thrown; parts behind it may be left out.
template <class Work>
void in_parallel(std::size_t parts, Work&& work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> faults(parts);
  const auto take_parts = [&] {
    for (std::size_t part = next++; part < parts; part = next++) {
      try {
        work(part);
      } catch (...) {
        faults[part] = std::current_exception();
        next = parts;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < std::min(cores(), parts); ++k) others.emplace_back(take_parts);
    take_parts();
  }
  for (const std::exception_ptr& fault : faults)
    if (fault) std::rethrow_exception(fault);
}

// The same for each of many small items, some hundreds to a part.
template <class Work>
void each_in_parallel(std::size_t items, Work&& work) {
  constexpr std::size_t kTogether = 512;
  in_parallel((items + kTogether - 1) / kTogether, [&](std::size_t part) {
    const std::size_t end = std::min(items, (part + 1) * kTogether);
    for (std::size_t k = part * kTogether; k < end; ++k) work(k);
  });
}

}  // namespace muckpile
