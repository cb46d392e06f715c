// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of large files are those that std::from_chars reads, to the last bit.
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <type_traits>

#include "io/plain_number.h"

namespace muckpile {
namespace {

// Whether the text is read as std::from_chars reads it, where that takes all of it.
template <class Number>
void expect_as_from_chars(const std::string& text) {
  Number expected{}, got{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
  const bool whole = error == std::errc() && stop == text.data() + text.size();
  const std::string line = text + ",7";
  const char* at = line.data();
  const bool read = read_number(at, line.data() + line.size(), got, ',');
  ASSERT_EQ(read, whole && std::isfinite(static_cast<double>(expected))) << text;
  if (!read) return;
  EXPECT_EQ(at, line.data() + text.size() + 1) << text;
  if constexpr (std::is_same_v<Number, double>)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(expected)) << text;
  else
    EXPECT_EQ(got, expected) << text;
}

std::string printed(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

TEST(PlainNumber, DecimalsOfAnySizeAreThoseOfFromChars) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> sign(-1.0, 1.0), magnitude(-6.0, 7.0);
  for (int k = 0; k < 50000; ++k) {
    const double value = sign(random) * std::pow(10.0, magnitude(random));
    for (const char* format : {"%.17g", "%.9g", "%.6f", "%.15f"})
      expect_as_from_chars<double>(printed(format, value));
  }
}

// Digits that lie halfway between two doubles, or beside that, are where rounding twice goes wrong.
TEST(PlainNumber, TiesAreRoundedOnce) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 30000; ++k) {
    const std::uint64_t odd =
        ((std::uint64_t{1} << 53) + random() % (std::uint64_t{1} << 53)) * 2 + 1;
    for (const std::uint64_t digits : {odd - 1, odd, odd + 1}) {
      const std::string all = std::to_string(digits);
      for (const size_t point : {size_t{1}, size_t{2}, all.size() - 3, all.size()})
        expect_as_from_chars<double>(all.substr(0, point) + "." + all.substr(point));
    }
  }
}

TEST(PlainNumber, OtherWordsAreReadAsFromCharsDoes) {
  for (const char* text : {"0",
                           "-0",
                           "0.0",
                           "-0.0",
                           "5.",
                           ".5",
                           "-.5",
                           ".",
                           "",
                           "-",
                           "+1",
                           "--1",
                           "1e3",
                           "1.5E-3",
                           "-2e+2",
                           "1e400",
                           "1e-400",
                           "nan",
                           "inf",
                           "-inf",
                           " 1",
                           "1 ",

                           "1.2.3",
                           "0x10",
                           "00000000000000000000.5",
                           "0.00000000000000000001",
                           "12345678901234567890",
                           "9223372036854775808.5",
                           "18446744073709551615",
                           "18446744073709551616.1",
                           "9007199254740993",
                           "9007199254740992.5",
                           "123456789.123456789123456789",
                           "1234567812345678",
                           "12345678",
                           "1234567:"})
    expect_as_from_chars<double>(text);
  for (const char* text : {"0", "7", "-7", "2147483647", "2147483648", "-2147483648", "999999999",
                           "1000000000", "0000000000012", "", "-", "1.5", "1e3", "a"})
    expect_as_from_chars<int>(text);
}

TEST(PlainNumber, WhatStandsBehindMustBeThere) {
  const std::string line = "1.5 2";
  const char *at = line.data(), *end = at + line.size();
  double value = 0.0;
  EXPECT_FALSE(read_number(at, end, value, ','));
  EXPECT_EQ(at, line.data());
  EXPECT_TRUE(read_number(at, end, value, ' '));
  EXPECT_EQ(value, 1.5);
  EXPECT_FALSE(read_number(at, end, value, ' '));  // the text ends
}

}  // namespace
}  // namespace muckpile
