// SPDX-License-Identifier: GPL-2.0-or-later
// Knobs of two runs: what counts as the same value, and what is told of the others.
// Scope: texts; the engine's variables are tested in tests/styles/write_scene.
#include <gtest/gtest.h>

#include "provenance/knobs.h"

namespace muckpile {
namespace {

TEST(Knobs, SpellingsOfOneNumberAreTheSame) {
  for (const char* text : {"3.0", "3.", "03", "+3", "3e0", "0.3e1", "30e-1"})
    EXPECT_TRUE(same_value("3", text)) << text;
  for (const char* text : {"3.0000001", "-3", "3m", "three", "nan", ""})
    EXPECT_FALSE(same_value("3", text)) << text;
  EXPECT_TRUE(same_value("emulsion", "emulsion"));
  EXPECT_FALSE(same_value("nan", "inf"));
}

TEST(Knobs, NumbersAreReadHoweverTheyAreSpelt) {
  EXPECT_EQ(std::get<long>(read_spelling("+1")), 1);
  EXPECT_EQ(std::get<long>(read_spelling("04")), 4);
  EXPECT_EQ(std::get<double>(read_spelling("4.")), 4.0);
  EXPECT_EQ(std::get<double>(read_spelling("1e-3")), 0.001);
  for (const char* word : {"emulsion", "1e400", "nan", "0x10", "3,5", "1 2"})
    EXPECT_EQ(std::get<std::string>(read_spelling(word)), word);
}

TEST(Knobs, TellsWhatIsOtherAndWhatOneSideLacks) {
  const Knobs before{{"burden", "1.8"}, {"out", "a"}, {"friction", std::nullopt}, {"old", "1"}};
  const Knobs now{{"burden", "3"}, {"out", "b"}, {"friction", "0.5"}, {"fresh", "2"}};
  const KnobChanges changes = knob_changes(before, now, {"out"});
  EXPECT_EQ(describe(changes.other), "burden '3' (was '1.8'), friction '0.5' (was computed)");
  EXPECT_EQ(changes.missing, std::vector<std::string>{"old"});
  EXPECT_EQ(changes.added, std::vector<std::string>{"fresh"});
}

TEST(Knobs, WhatBothScriptsComputeIsNoKnob) {
  const KnobChanges changes = knob_changes({{"a", std::nullopt}, {"b", std::nullopt}},
                                           {{"a", std::nullopt}, {"c", std::nullopt}}, {});
  EXPECT_TRUE(changes.other.empty() && changes.missing.empty() && changes.added.empty());
}

TEST(Knobs, EqualKnobsHaveNoChanges) {
  const KnobChanges changes = knob_changes({{"a", "3"}}, {{"a", "3.0"}}, {});
  EXPECT_TRUE(changes.other.empty() && changes.missing.empty() && changes.added.empty());
}

}  // namespace
}  // namespace muckpile
