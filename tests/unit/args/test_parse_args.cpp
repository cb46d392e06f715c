// SPDX-License-Identifier: GPL-2.0-or-later
// A style's words are read strictly: values, defaults, groups, and the text of every refusal.
// Scope: args/parse_args.h.
#include <gtest/gtest.h>

#include <stdexcept>

#include "args/parse_args.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

const std::string kWhere = "fix muckpile/blast 'gas1'";
const std::string kKnown = " (known: decay_time, seed, law, mesh, vent, hole, pick)";

ArgTable blast_table() {
  ArgTable table("fix muckpile/blast");
  table.real("decay_time", "s", Range::positive(), std::nullopt, "e-folding time of the gas")
      .integer("seed", "", Range::at_least(1), 7, "random seed")
      .word("law", {"harries", "table"}, "harries", "size law")
      .word("mesh", {}, "none", "mesh id")
      .flag("vent", true, "let the gas out")
      .group("hole", 3, 3, true, "x y r")
      .group("pick", 1, 3, false, "names");
  return table;
}

ArgValues parse(const std::vector<std::string>& words) {
  return parse_args(blast_table(), kWhere, words);
}

std::string error_of(const std::vector<std::string>& words) {
  return input_error_of([&] { (void)parse(words); });
}

TEST(ParseArgs, ReadsEveryKindInAnyOrder) {
  const ArgValues values = parse({"vent", "no", "mesh", "m1", "law", "table", "seed", "11", "hole",
                                  "1", "2", "0.1", "decay_time", "2e-3", "hole", "3", "4", "0.2"});
  EXPECT_EQ(values.real("decay_time"), 2e-3);
  EXPECT_EQ(values.integer("seed"), 11);
  EXPECT_EQ(values.word("law"), "table");
  EXPECT_EQ(values.word("mesh"), "m1");
  EXPECT_FALSE(values.flag("vent"));
  const std::vector<std::vector<std::string>> holes = {{"1", "2", "0.1"}, {"3", "4", "0.2"}};
  EXPECT_EQ(values.groups("hole"), holes);
  EXPECT_TRUE(values.given("hole"));
  EXPECT_FALSE(values.given("pick"));
}

TEST(ParseArgs, FillsInDefaults) {
  const ArgValues values = parse({"decay_time", "1"});
  EXPECT_EQ(values.integer("seed"), 7);
  EXPECT_EQ(values.word("law"), "harries");
  EXPECT_TRUE(values.flag("vent"));
  EXPECT_FALSE(values.given("seed"));
  EXPECT_TRUE(values.groups("hole").empty());
}

TEST(ParseArgs, EndsAGroupOfVariableLengthAtTheNextKeyword) {
  const ArgValues values = parse({"pick", "a", "b", "decay_time", "1"});
  const std::vector<std::vector<std::string>> picks = {{"a", "b"}};
  EXPECT_EQ(values.groups("pick"), picks);
  EXPECT_EQ(values.real("decay_time"), 1.0);
}

TEST(ParseArgs, TakesAMistypedKeywordBehindAGroupForWhatItIs) {
  EXPECT_EQ(error_of({"pick", "a", "decy_time", "1"}),
            kWhere + ": unknown keyword 'decy_time'; did you mean 'decay_time'?" + kKnown);
  const std::vector<std::vector<std::string>> picks = {{"decy_time", "colour", "5"}};
  EXPECT_EQ(parse({"pick", "decy_time", "colour", "5", "decay_time", "1"}).groups("pick"), picks);
}

TEST(ParseArgs, RefusesAnUnknownKeywordAndSuggestsOne) {
  EXPECT_EQ(error_of({"decy_time", "1"}),
            kWhere + ": unknown keyword 'decy_time'; did you mean 'decay_time'?" + kKnown);
  EXPECT_EQ(error_of({"colour", "red"}), kWhere + ": unknown keyword 'colour'" + kKnown);
}

TEST(ParseArgs, RefusesAWordLeftOver) {
  EXPECT_EQ(error_of({"decay_time", "1", "2"}),
            kWhere + ": expected a keyword after '1', got '2'" + kKnown);
  EXPECT_EQ(error_of({"-3.5"}), kWhere + ": expected a keyword, got '-3.5'" + kKnown);
}

TEST(ParseArgs, RefusesAMissingKeyword) {
  EXPECT_EQ(error_of({"seed", "1"}),
            kWhere + ": keyword decay_time is missing (e-folding time of the gas, in s)");
}

TEST(ParseArgs, RefusesAMissingValue) {
  EXPECT_EQ(error_of({"seed", "1", "decay_time"}),
            kWhere + ": decay_time has no value after it (e-folding time of the gas, in s)");
  EXPECT_EQ(error_of({"decay_time", "seed", "1"}),
            kWhere + ": decay_time must be a number in s, got 'seed'");
}

TEST(ParseArgs, RefusesAKeywordGivenTwice) {
  const std::string none =
      "; words that a variable adds to a command replace none of those that it has";
  EXPECT_EQ(error_of({"decay_time", "1", "decay_time", "2"}),
            kWhere + ": decay_time is given twice, as '1' and as '2'" + none);
  EXPECT_EQ(error_of({"decay_time", "1", "decay_time"}),
            kWhere + ": decay_time is given twice" + none);
  EXPECT_EQ(error_of({"pick", "a", "seed", "1", "pick", "b"}),
            kWhere + ": pick is given twice" + none);
}

TEST(ParseArgs, RefusesAValueOutsideItsRule) {
  EXPECT_EQ(error_of({"decay_time", "-2e-3"}), kWhere + ": decay_time must be > 0 s, got '-2e-3'");
  EXPECT_EQ(error_of({"decay_time", "nan"}),
            kWhere + ": decay_time must be a finite number in s, got 'nan'");
  EXPECT_EQ(error_of({"seed", "0"}), kWhere + ": seed must be >= 1, got '0'");
  EXPECT_EQ(error_of({"law", "tabel"}),
            kWhere + ": law must be one of harries, table, got 'tabel'; did you mean 'table'?");
  EXPECT_EQ(error_of({"vent", "on"}), kWhere + ": vent must be one of yes, no, got 'on'");
}

TEST(ParseArgs, RefusesAGroupThatIsTooShort) {
  EXPECT_EQ(error_of({"decay_time", "1", "hole", "1", "2"}),
            kWhere + ": hole needs 3 words (x y r), got '1 2'");
  EXPECT_EQ(error_of({"hole", "1", "decay_time", "1"}),
            kWhere + ": hole needs 3 words (x y r), got '1'");
  EXPECT_EQ(error_of({"pick", "seed", "1"}),
            kWhere + ": pick needs at least 1 words (names), got ''");
}

TEST(ParseArgs, RefusesAGroupThatIsTooLong) {
  EXPECT_EQ(error_of({"hole", "1", "2", "3", "4"}),
            kWhere + ": expected a keyword after '3', got '4'" + kKnown);
}

TEST(ArgValues, EchoesWhatWasUnderstood) {
  EXPECT_EQ(parse({"decay_time", "2e-3", "hole", "1", "2", "3"}).echo(),
            kWhere +
                ":\n  decay_time 2e-3 s\n  seed 7 (default)\n  law harries (default)\n"
                "  mesh none (default)\n  vent yes (default)\n  hole 1 2 3\n");
}

TEST(ArgValues, RefusesToGiveWhatTheTableDoesNotHave) {
  const ArgValues values = parse({"decay_time", "1"});
  EXPECT_THROW((void)values.real("decay"), std::logic_error);
  EXPECT_THROW((void)values.real("seed"), std::logic_error);
  EXPECT_THROW((void)values.given("decay"), std::logic_error);
}

}  // namespace
}  // namespace muckpile
