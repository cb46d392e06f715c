// SPDX-License-Identifier: GPL-2.0-or-later
// Independent parts of a task on all cores.
// Scope: parallel/in_parallel.
#include <gtest/gtest.h>

#include <numeric>

#include "args/input_error.h"
#include "parallel/in_parallel.h"

namespace muckpile {
namespace {

TEST(InParallel, EachPartIsDoneOnce) {
  std::vector<int> done(10007, 0);
  each_in_parallel(done.size(), [&](size_t k) { ++done[k]; });
  EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 10007);
  EXPECT_EQ(*std::ranges::max_element(done), 1);
  in_parallel(0, [](size_t) { FAIL(); });
}

TEST(InParallel, TheFirstFaultIsThrown) {
  for (int turn = 0; turn < 20; ++turn) {
    try {
      in_parallel(40, [](size_t k) {
        if (k >= 3) throw InputError(std::to_string(k));
      });
      FAIL();
    } catch (const InputError& error) {
      EXPECT_STREQ(error.what(), "3");
    }
  }
}

}  // namespace
}  // namespace muckpile
