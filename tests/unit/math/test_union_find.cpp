// SPDX-License-Identifier: GPL-2.0-or-later
// Sets that are joined pair by pair.
// Scope: a few things.
#include <gtest/gtest.h>

#include "math/union_find.h"

namespace muckpile {
namespace {

TEST(UnionFind, JoinsWhatHangsTogetherByOthers) {
  UnionFind sets(6);
  sets.join(0, 1);
  sets.join(3, 4);
  sets.join(4, 1);
  EXPECT_EQ(sets.root(0), sets.root(3));
  EXPECT_NE(sets.root(0), sets.root(2));
  EXPECT_EQ(sets.root(5), 5U);
}

}  // namespace
}  // namespace muckpile
