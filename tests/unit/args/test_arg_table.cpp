// SPDX-License-Identifier: GPL-2.0-or-later
// The keyword table prints the docs' parameter table and refuses an author's contradictions.
// Scope: args/arg_table.h.
#include <gtest/gtest.h>

#include <stdexcept>

#include "args/arg_table.h"

namespace muckpile {
namespace {

TEST(ArgTable, PrintsTheDocsTable) {
  ArgTable table("fix muckpile/blast");
  table.real("decay_time", "s", Range::positive(), std::nullopt, "e-folding time")
      .integer("seed", "", Range::at_least(1), 7, "random seed")
      .real("share", "", Range::closed(0.0, 0.5), 0.25, "of all")
      .integer("parts", "", Range::closed(1, 9), 2, "of each")
      .real("ratio", "", Range::right_open(0.0, 0.5), 0.25, "Poisson's")
      .word("law", {"harries", "table"}, "harries", "size law")
      .flag("echo", true, "print the values")
      .group("hole", 7, 7, true, "x y z x y z r")
      .group("file", 1, 2, false, "name and column");
  EXPECT_EQ(table.markdown(),
            "| keyword | unit | range | default | meaning |\n"
            "|---|---|---|---|---|\n"
            "| `decay_time` | s | > 0 | required | e-folding time |\n"
            "| `seed` | - | whole, >= 1 | 7 | random seed |\n"
            "| `share` | - | 0 to 0.5 | 0.25 | of all |\n"
            "| `parts` | - | whole, 1 to 9 | 2 | of each |\n"
            "| `ratio` | - | >= 0 and < 0.5 | 0.25 | Poisson's |\n"
            "| `law` | - | harries, table | harries | size law |\n"
            "| `echo` | - | yes, no | yes | print the values |\n"
            "| `hole` | - | 7 words, repeatable | none | x y z x y z r |\n"
            "| `file` | - | 1 to 2 words | none | name and column |\n");
}

TEST(ArgTable, RefusesANameTwice) {
  ArgTable table("s");
  table.flag("a", true, "");
  EXPECT_THROW(table.flag("a", false, ""), std::logic_error);
}

TEST(ArgTable, RefusesADefaultThatBreaksItsOwnRule) {
  ArgTable table("s");
  EXPECT_THROW(table.real("a", "", Range::positive(), 0.0, ""), std::logic_error);
  EXPECT_THROW(table.integer("b", "", Range::at_least(1), 0, ""), std::logic_error);
  EXPECT_THROW(table.word("c", {"x", "y"}, "z", ""), std::logic_error);
  EXPECT_THROW(table.group("d", 3, 2, false, ""), std::logic_error);
}

}  // namespace
}  // namespace muckpile
