// SPDX-License-Identifier: GPL-2.0-or-later
// Lists of stored values in buffers of numbers.
// Scope: no engine; what the styles store so is in tests/styles/stored_types.
#include <gtest/gtest.h>

#include <vector>

#include "state/number_list.h"

namespace muckpile {

struct Mark {
  int tag = 0;
  double size = 0.0;
};
template <>
struct Stored<Mark> {
  static constexpr std::string_view kName = "mark";
  static constexpr int kVersion = 1;
  static auto fields(auto& mark) { return std::tie(mark.tag, mark.size); }
};

namespace {

TEST(NumberList, ListsBehindEachOtherComeBack) {
  const std::vector<Mark> first{{-7, 0.5}, {8, -2.0}, {9, 1e-300}}, none, last{{3, 4.0}};
  std::vector<double> numbers(64, -1.0);
  int at = 0;
  for (const std::vector<Mark>* list : {&first, &none, &last}) {
    const int taken = put_list(std::span<const Mark>(*list), numbers.data() + at);
    EXPECT_EQ(taken, numbers_of_list<Mark>(list->size()));
    at += taken;
  }
  EXPECT_EQ(at, (1 + 5) + 1 + (1 + 2));  // 3 x 12 bytes are 4.5 numbers
  EXPECT_EQ(numbers[static_cast<std::size_t>(at)], -1.0);
  std::vector<Mark> all;
  int read = 0;
  for (int k = 0; k < 3; ++k)
    read += get_list(all, std::span<const double>(numbers).subspan(static_cast<std::size_t>(read)));
  EXPECT_EQ(read, at);
  ASSERT_EQ(all.size(), 4u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(all[k].tag, first[k].tag);
    EXPECT_EQ(all[k].size, first[k].size);
  }
  EXPECT_EQ(all[3].tag, 3);
}

TEST(NumberList, ListThatEndsTooSoonIsRefused) {
  const std::vector<Mark> marks{{1, 0.5}, {2, 0.25}, {3, 0.125}};
  std::vector<double> numbers(8, 0.0);
  const auto taken =
      static_cast<std::size_t>(put_list(std::span<const Mark>(marks), numbers.data()));
  for (std::size_t room = 0; room < taken; ++room) {
    std::vector<Mark> all;
    EXPECT_THROW((void)get_list(all, std::span<const double>(numbers).first(room)), StateError);
  }
}

}  // namespace
}  // namespace muckpile
