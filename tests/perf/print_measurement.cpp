// SPDX-License-Identifier: GPL-2.0-or-later
// main() of perf programs: prints what measure() found, as JSON, and the name of the processor.
// Scope: programs without arguments and without MPI.
#include <iostream>
#include <nlohmann/json.hpp>

#include "measurement.h"
#include "timing.h"

int main() {
  nlohmann::ordered_json result = {{"processor", muckpile::perf::processor()}};
  result.update(muckpile::perf::measure());
  std::cout << result.dump(2) << '\n';
  return 0;
}
