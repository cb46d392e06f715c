// SPDX-License-Identifier: GPL-2.0-or-later
// The hash of seals and run ids: known values, and what makes it differ.
// Scope: FNV-1a of 64 bits.
#include <gtest/gtest.h>

#include "provenance/fingerprint.h"

namespace muckpile {
namespace {

/// From the authors' own list of test values: "" and "foobar".
TEST(Fingerprint, MatchesPublishedValues) {
  EXPECT_EQ(Fingerprint().text(), "cbf29ce484222325");
  EXPECT_EQ(Fingerprint().add_bytes("foobar", 6).text(), "85944171f73967e8");
}

TEST(Fingerprint, WordsAreNotRunTogether) {
  EXPECT_NE(Fingerprint().add("ab").add("c").text(), Fingerprint().add("a").add("bc").text());
}

TEST(Fingerprint, TextHasSixteenDigitsOfTheValue) {
  const Fingerprint print = Fingerprint().add(1.5).add(std::uint64_t{7});
  EXPECT_EQ(std::stoull(print.text(), nullptr, 16), print.value());
  EXPECT_EQ(print.text().size(), 16u);
}

}  // namespace
}  // namespace muckpile
