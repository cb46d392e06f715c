// SPDX-License-Identifier: GPL-2.0-or-later
// Tables against those of golden/.
// Scope: see the header.
#include "golden_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "temporary_folder.h"

namespace muckpile::testing {
namespace {

const std::filesystem::path kGolden = MUCKPILE_GOLDEN_FOLDER;
constexpr double kLastDigit = 2e-6;  // tables have six digits
constexpr double kNothing = 1e-9;    // rounding about zero, in units of metres, radians, joules

std::vector<std::string> words_of(std::string text) {
  for (char& c : text)
    if (c == ',') c = ' ';
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

bool are_same(const std::string& a, const std::string& b) {
  if (a == b) return true;
  char *end_a = nullptr, *end_b = nullptr;
  const double x = std::strtod(a.c_str(), &end_a), y = std::strtod(b.c_str(), &end_b);
  return *end_a == 0 && *end_b == 0 &&
         std::abs(x - y) <= kNothing + kLastDigit * std::max(std::abs(x), std::abs(y));
}

}  // namespace

void expect_golden(const std::filesystem::path& made, const std::string& name) {
  const std::filesystem::path golden = kGolden / (name + made.extension().string());
  if (std::getenv("MUCKPILE_WRITE_GOLDEN") != nullptr) write_text(golden, text_of(made));
  std::istringstream got(text_of(made)), wanted(text_of(golden));
  std::string line, expected;
  for (int number = 1; std::getline(wanted, expected); ++number) {
    ASSERT_TRUE(std::getline(got, line)) << golden << " has more lines";
    ASSERT_EQ(std::ranges::count(line, ','), std::ranges::count(expected, ',')) << golden << number;
    const auto words = words_of(line), others = words_of(expected);
    ASSERT_EQ(words.size(), others.size()) << golden << ':' << number << ": " << line;
    for (size_t k = 0; k < words.size(); ++k)
      ASSERT_TRUE(are_same(words[k], others[k])) << golden << ':' << number << ": got\n"
                                                 << line << "\nnot\n"
                                                 << expected;
  }
  EXPECT_FALSE(std::getline(got, line)) << golden << " has fewer lines";
}

}  // namespace muckpile::testing
