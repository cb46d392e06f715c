// SPDX-License-Identifier: GPL-2.0-or-later
// Values come back from their bytes as they went in; bytes that are short, long or wrong are
// refused by the name of what was being read.
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "state/encoding.h"

namespace muckpile {

enum class Colour : std::uint8_t { grey, red };

/// Has 7 bytes of padding behind the colour.
struct Stone {
  Colour colour = Colour::grey;
  double mass = 0.0;
  Vec3 centre = Vec3::Zero();
};
template <>
struct Stored<Stone> {
  static constexpr std::string_view kName = "stone";
  static constexpr int kVersion = 3;
  static auto fields(auto& stone) { return std::tie(stone.colour, stone.mass, stone.centre); }
};

/// Its flags cannot be tied: bit fields have no address.
struct Flags {
  bool wet : 1 = false;
  bool cold : 1 = false;
};
template <>
struct Stored<Flags> {
  static constexpr std::string_view kName = "flags";
  static constexpr int kVersion = 1;
  using Image = std::array<bool, 2>;
  static Image image(const Flags& flags) { return {flags.wet, flags.cold}; }
  static Flags of(const Image& image) { return {image[0], image[1]}; }
};

struct Heap {
  std::string name;
  std::vector<Stone> stones;
  std::optional<double> slope;
  Flags flags;
};
template <>
struct Stored<Heap> {
  static constexpr std::string_view kName = "heap";
  static constexpr int kVersion = 1;
  static auto fields(auto& heap) {
    return std::tie(heap.name, heap.stones, heap.slope, heap.flags);
  }
};

namespace {

Heap some_heap() { return {"north", {{Colour::red, 2.5, Vec3(1, 2, 3)}, {}}, 0.75, {false, true}}; }

std::string fault_of(const std::vector<char>& bytes) {
  try {
    ByteReader in(bytes);
    (void)in.get<Heap>();
  } catch (const StateError& error) {
    return error.what();
  }
  return "";
}

TEST(Bytes, ComeBackAsTheyWentIn) {
  ByteWriter out;
  out.put(some_heap());
  out.put(-7);
  ByteReader in(out.bytes());
  const auto heap = in.get<Heap>();
  EXPECT_EQ(heap.name, "north");
  ASSERT_EQ(heap.stones.size(), 2u);
  EXPECT_EQ(heap.stones[0].colour, Colour::red);
  EXPECT_EQ(heap.stones[0].mass, 2.5);
  EXPECT_EQ(heap.stones[0].centre, Vec3(1, 2, 3));
  EXPECT_EQ(heap.slope, 0.75);
  EXPECT_FALSE(heap.flags.wet);
  EXPECT_TRUE(heap.flags.cold);
  EXPECT_EQ(in.get<int>(), -7);
  EXPECT_TRUE(in.empty());
}

TEST(Bytes, HaveNoPadding) {
  ByteWriter out;
  out.put(Stone{});
  EXPECT_EQ(out.bytes().size(), 1u + 8u + 24u);
  EXPECT_LT(out.bytes().size(), sizeof(Stone));
}

TEST(Bytes, CutShortAnywhereAreRefusedByName) {
  ByteWriter out;
  out.put(some_heap());
  EXPECT_EQ(fault_of(out.bytes()), "");
  for (std::size_t length = 0; length < out.bytes().size(); ++length) {
    const std::vector<char> cut(out.bytes().begin(),
                                out.bytes().begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_NE(fault_of(cut).find("ends too soon"), std::string::npos) << length;
  }
}

TEST(Bytes, FaultTellsTypeExpectedAndFound) {
  ByteWriter out;
  out.put(Colour::red);
  out.put(2.5);
  out.put(1.0);
  ByteReader in(out.bytes());
  try {
    (void)in.get<Stone>();
    FAIL();
  } catch (const StateError& error) {
    EXPECT_STREQ(error.what(), "'stone' ends too soon: 24 more bytes expected, 8 there");
  }
}

TEST(Bytes, HugeCountIsRefusedBeforeMemoryIsAskedFor) {
  ByteWriter out;
  out.put(std::string("north"));
  out.put<std::uint64_t>(1ull << 60);
  EXPECT_EQ(fault_of(out.bytes()),
            "'heap' ends too soon: 1152921504606846976 values of at least 33 bytes expected, 0 "
            "bytes there");
}

TEST(Bytes, YesOrNoIsNothingElse) {
  ByteWriter out;
  out.put<std::uint8_t>(2);
  ByteReader in(out.bytes());
  EXPECT_THROW((void)in.get<bool>(), StateError);
}

TEST(Bytes, LeftOverBytesAreRefused) {
  ByteWriter out;
  out.put(1);
  out.put(2);
  ByteReader in(out.bytes());
  (void)in.get<int>();
  EXPECT_THROW(in.require_end("number"), StateError);
  (void)in.get<int>();
  EXPECT_NO_THROW(in.require_end("number"));
}

TEST(Layouts, TellEachStoredTypeOnceInnerOnesFirst) {
  const StoredTypes types = stored_types<Heap>();
  ASSERT_EQ(types.size(), 3u);
  EXPECT_EQ(types[0].name, "stone");
  EXPECT_EQ(types[0].version, 3);
  EXPECT_EQ(types[0].layout, "e1 f8 f8(3x1)");
  EXPECT_EQ(types[1].name, "flags");
  EXPECT_EQ(types[1].layout, "b1[2]");
  EXPECT_EQ(types[2].name, "heap");
  EXPECT_EQ(types[2].layout, "text stone[] f8? flags");
}

}  // namespace
}  // namespace muckpile
