// SPDX-License-Identifier: GPL-2.0-or-later
// main() of a verification program: runs one of its named cases.
// Scope: see the header.
#include "framework/cases.h"

#include <chrono>
#include <cstdio>
#include <exception>

namespace muckpile::verification {

int run_case(const std::string& topic, const Cases& cases, int argc, char** argv) {
  const auto found = argc == 3 ? cases.find(argv[1]) : cases.end();
  if (found == cases.end()) {
    std::fprintf(stderr, "usage: %s CASE FOLDER, CASE one of:", argv[0]);
    for (const auto& [name, body] : cases) std::fprintf(stderr, " %s", name.c_str());
    std::fprintf(stderr, "\n");
    return 2;
  }
  try {
    const auto start = std::chrono::steady_clock::now();
    Report report(topic + "." + found->first);
    found->second(report);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    report.write(argv[2], taken.count());
    return report.acceptable() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s %s: %s\n", topic.c_str(), argv[1], error.what());
    return 2;
  }
}

}  // namespace muckpile::verification
