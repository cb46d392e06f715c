// SPDX-License-Identifier: GPL-2.0-or-later
// CPU times for the perf programs.
// Scope: see the header.
#include "timing.h"

#include <algorithm>
#include <ctime>
#include <fstream>

namespace muckpile::perf {
namespace {

/// CPU time of this thread [s].
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double least_time(const std::function<void()>& body, int rounds) {
  double least = 1e30;
  for (int round = 0; round < rounds; ++round) {
    const double start = now();
    body();
    least = std::min(least, now() - start);
  }
  return least;
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace muckpile::perf
