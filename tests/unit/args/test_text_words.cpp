// SPDX-License-Identifier: GPL-2.0-or-later
// Words and numbers of a text.
// Scope: args/text_words.
#include <gtest/gtest.h>

#include "args/text_words.h"

namespace muckpile {
namespace {

TEST(TextWords, StandBetweenBlanksOfAnyKind) {
  TextWords text("  one\ttwo\r\n\nthree ");
  EXPECT_EQ(text.word(), "one");
  EXPECT_EQ(text.word(), "two");
  EXPECT_EQ(text.word(), "three");
  EXPECT_EQ(text.word(), "");
  EXPECT_EQ(text.word(), "");
}

TEST(TextWords, AreNumbersAsAWholeOrNot) {
  TextWords text("-1.5e3 7 nan 7.5 7x +1");
  double real = 0.0;
  int whole = 0;
  EXPECT_TRUE(text.number(real));
  EXPECT_EQ(real, -1500.0);
  EXPECT_TRUE(text.number(whole));
  EXPECT_EQ(whole, 7);
  EXPECT_FALSE(text.number(real));
  for (int k = 0; k < 4; ++k) EXPECT_FALSE(text.number(whole)) << k;  // the last one at the end
}

TEST(TextWords, LeaveTheRestOfALine) {
  TextWords text("title of it\nname int 1\nlast");
  EXPECT_EQ(text.line(), "title of it");
  EXPECT_EQ(text.word(), "name");
  EXPECT_EQ(text.line(), " int 1");
  EXPECT_EQ(text.line(), "last");
  EXPECT_EQ(text.line(), "");
}

}  // namespace
}  // namespace muckpile
