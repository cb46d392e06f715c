// SPDX-License-Identifier: GPL-2.0-or-later
// Long lists for the log are cut off after three lines.
// Scope: text only.
#include <gtest/gtest.h>

#include "args/first_lines.h"

namespace muckpile {
namespace {

TEST(FirstLines, AreThreeAndHowManyMoreThereAre) {
  EXPECT_EQ(first_lines({}, "W: ", "faults"), "");
  EXPECT_EQ(first_lines({"a\n", "b\n", "c\n"}, "W: ", "faults"), "a\nb\nc\n");
  EXPECT_EQ(first_lines({"a\n", "b\n", "c\n", "d\n", "e\n"}, "W: ", "faults"),
            "a\nb\nc\nW: and 2 more faults\n");
}

}  // namespace
}  // namespace muckpile
