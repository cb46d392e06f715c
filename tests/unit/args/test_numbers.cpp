// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers are read as whole words, strictly, and refused with the rule, the unit and the given
// text. Scope: args/numbers.h and args/range.h.
#include <gtest/gtest.h>

#include "args/numbers.h"
#include "args/rounded_text.h"
#include "input_error_of.h"

namespace muckpile {
namespace {

double real(const std::string& text, Range range = Range::any()) {
  return parse_real("fix a 'b'", "decay_time", text, "s", range);
}

long integer(const std::string& text, Range range = Range::any()) {
  return parse_integer("fix a 'b'", "seed", text, "", range);
}

std::string real_error(const std::string& text, Range range = Range::any()) {
  return input_error_of([&] { (void)real(text, range); });
}

std::string integer_error(const std::string& text, Range range = Range::any()) {
  return input_error_of([&] { (void)integer(text, range); });
}

TEST(ParseReal, ReadsTheFormsThatScriptsUse) {
  EXPECT_EQ(real("2.5"), 2.5);
  EXPECT_EQ(real("-2e-3"), -2e-3);
  EXPECT_EQ(real("+7"), 7.0);
  EXPECT_EQ(real("1e+06"), 1e6);
  EXPECT_EQ(real(".5"), 0.5);
}

TEST(ParseReal, RefusesAnythingThatIsNotWhollyANumber) {
  for (const std::string text :
       {"abc", "", "1.0x", "1,5", " 1", "0x10", "1e", "--1", "+-1", "${x}"})
    EXPECT_EQ(real_error(text), "fix a 'b': decay_time must be a number in s, got '" + text + "'");
}

TEST(ParseReal, RefusesNanInfinityAndOverflow) {
  for (const std::string text : {"nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e999"})
    EXPECT_EQ(real_error(text),
              "fix a 'b': decay_time must be a finite number in s, got '" + text + "'");
}

TEST(ParseReal, NamesTheRangeTheUnitAndTheGivenText) {
  EXPECT_EQ(real_error("-2e-3", Range::positive()),
            "fix a 'b': decay_time must be > 0 s, got '-2e-3'");
  EXPECT_EQ(real_error("0.5", Range::right_open(0.0, 0.5)),
            "fix a 'b': decay_time must be >= 0 and < 0.5 s, got '0.5'");
}

TEST(ParseReal, LeavesTheUnitOfAPureNumberOut) {
  EXPECT_EQ(input_error_of([] { (void)parse_real("x", "nu", "a", "", Range::any()); }),
            "x: nu must be a number, got 'a'");
  EXPECT_EQ(input_error_of([] { (void)parse_real("x", "nu", "-1", "", Range::non_negative()); }),
            "x: nu must be >= 0, got '-1'");
}

TEST(ParseInteger, ReadsWholeNumbersOnly) {
  EXPECT_EQ(integer("-12"), -12);
  EXPECT_EQ(integer("+12"), 12);
  for (const std::string text : {"3.0", "1e3", "nan", "x", "", "7 "})
    EXPECT_EQ(integer_error(text), "fix a 'b': seed must be a whole number, got '" + text + "'");
}

TEST(ParseInteger, RefusesWhatDoesNotFit) {
  EXPECT_EQ(integer_error("99999999999999999999"),
            "fix a 'b': seed must be a whole number of at most 18 digits, got "
            "'99999999999999999999'");
  EXPECT_EQ(integer_error("0", Range::at_least(1)), "fix a 'b': seed must be >= 1, got '0'");
}

TEST(Range, KnowsWhichEndsBelongToIt) {
  EXPECT_TRUE(Range::closed(0, 1).contains(0) && Range::closed(0, 1).contains(1));
  EXPECT_FALSE(Range::open(0, 1).contains(0) || Range::open(0, 1).contains(1));
  EXPECT_TRUE(!Range::left_open(0, 1).contains(0) && Range::left_open(0, 1).contains(1));
  EXPECT_TRUE(Range::right_open(0, 1).contains(0) && !Range::right_open(0, 1).contains(1));
  EXPECT_FALSE(Range::positive().contains(0));
  EXPECT_TRUE(Range::non_negative().contains(0));
  EXPECT_FALSE(Range::non_negative().contains(-1e-300));
}

TEST(Range, SaysItself) {
  EXPECT_EQ(Range::any().text(), "");
  EXPECT_EQ(Range::open(0, 0.5).text(), "> 0 and < 0.5");
  EXPECT_EQ(Range::closed(-1, 2).text(), ">= -1 and <= 2");
  EXPECT_EQ(Range::above(3).text(), "> 3");
}

TEST(NumberText, ReadsBackToTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3.0, 6.02e23, -1e-300, 0.0})
    EXPECT_EQ(real(number_text(value)), value);
  EXPECT_EQ(number_text(0.1), "0.1");
}

TEST(RoundedText, HasSixDigits) {
  EXPECT_EQ(rounded_text(0.1), "0.1");
  EXPECT_EQ(rounded_text(9.999999999999999e-06), "1e-05");
  EXPECT_EQ(rounded_text(123456789.0), "1.23457e+08");
}

}  // namespace
}  // namespace muckpile
