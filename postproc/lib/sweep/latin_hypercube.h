// SPDX-License-Identifier: GPL-2.0-or-later
// Values of several uncertain quantities for a number of runs, so that few runs cover all ranges.
// Scope: quantities that are independent of each other, each uniform in its range or in the
// logarithm of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace muckpile {

struct SampledRange {
  std::string name;
  double from, to;           // from < to; both > 0 on a logarithmic scale
  bool logarithmic = false;  // uniform in the logarithm
};

// "NAME=FROM..TO" or "NAME=log:FROM..TO". Throws InputError, naming what is wrong.
[[nodiscard]] SampledRange parse_range(const std::string& words);

// Shares in (0, 1): a row for each run, a column for each quantity. Each of `runs` equal parts of
// (0, 1) holds one share of each quantity (McKay, Beckman & Conover 1979). Of several such designs
// it is the one in which the two quantities that are most correlated are so the least. The same for
// the same seed. `runs` >= 1.
[[nodiscard]] std::vector<std::vector<double>> latin_hypercube(size_t runs, size_t quantities,
                                                               std::uint64_t seed);

// The value at a share of a range, as text of four significant digits.
[[nodiscard]] std::string sampled_value(const SampledRange& range, double share);

}  // namespace muckpile
