// SPDX-License-Identifier: GPL-2.0-or-later
// A part of a restart file is read by a program with the same types only; else the message names
// the type that differs.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "state/part.h"

namespace muckpile {

struct Tree {
  double height = 0.0;
  int rings = 0;
};
template <>
struct Stored<Tree> {
  static constexpr std::string_view kName = "tree";
  static constexpr int kVersion = 2;
  static auto fields(auto& tree) { return std::tie(tree.height, tree.rings); }
};

namespace {

/// A file with a tree of that version and layout.
std::string fault_of(const std::string& name, int version, const std::string& layout) {
  ByteWriter out;
  put_types(out, {{name, version, layout}});
  out.put(Tree{12.0, 80});
  try {
    ByteReader in(out.bytes());
    (void)get_part<Tree>(in);
  } catch (const StateError& error) {
    return error.what();
  }
  return "";
}

TEST(Part, ComesBackAsItWentIn) {
  ByteWriter out;
  put_part(out, Tree{12.0, 80});
  ByteReader in(out.bytes());
  const auto tree = get_part<Tree>(in);
  EXPECT_EQ(tree.height, 12.0);
  EXPECT_EQ(tree.rings, 80);
  EXPECT_TRUE(in.empty());
}

TEST(Part, OfAnotherVersionIsRefused) {
  EXPECT_EQ(fault_of("tree", 2, "f8 i4"), "");
  EXPECT_EQ(fault_of("tree", 1, "f8"), "'tree': version 2 expected, version 1 in the file");
  EXPECT_EQ(fault_of("bush", 2, "f8 i4"), "'tree': version 2 expected, none in the file");
  EXPECT_EQ(fault_of("tree", 2, "f4 i4"),
            "'tree': version 2 expected, with the fields f8 i4, the file has f4 i4");
}

TEST(Part, ThatIsNoneOfOursIsRefused) {
  for (const std::size_t length : {0u, 3u, 8u, 100u}) {
    const std::vector<char> other(length, 'x');
    ByteReader in(other);
    EXPECT_THROW((void)get_part<Tree>(in), StateError) << length;
  }
}

TEST(Part, CutShortAnywhereIsRefused) {
  ByteWriter out;
  put_part(out, Tree{12.0, 80});
  for (std::size_t length = 0; length < out.bytes().size(); ++length) {
    ByteReader in(out.bytes().data(), length);
    EXPECT_THROW((void)get_part<Tree>(in), StateError) << length;
  }
}

}  // namespace
}  // namespace muckpile
