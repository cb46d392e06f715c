// SPDX-License-Identifier: GPL-2.0-or-later
// What a facet remembers comes back from its bytes, every member of it.
// Scope: through the encoding that messages and restart files share; no engine.
#include <gtest/gtest.h>

#include <vector>

#include "bond/network/stored_network.h"

namespace muckpile {
namespace {

/// Numbers that differ from each other and from every default.
class Numbers {
 public:
  double next() { return last_ += 0.125; }
  Vec3 vector() { return {next(), next(), next()}; }

 private:
  double last_ = 1.0;
};

FacetMemory remembering() {
  Numbers numbers;
  FacetMemory memory;
  memory.broken.set(0);
  memory.broken.set(2);
  memory.slipping.set(2);
  memory.state = FacetState::fading;
  memory.open = memory.gas = true;
  ContactMemory& contact = memory.contact.get_or_create();
  for (Vec3& offset : contact.offset) offset = numbers.vector();
  contact.fade = numbers.next();
  ExtraMemory& extra = memory.extra.get_or_create();
  for (Cohesion& c : extra.cohesion)
    c = {numbers.vector(), numbers.next(), numbers.next(),
         numbers.next(),   numbers.next(), numbers.next()};
  extra.ground = {true, numbers.vector(), numbers.vector(), numbers.vector(), numbers.vector(),
                  true};
  for (JointHistory& history : extra.joint)
    history = {numbers.next(), numbers.next(), numbers.next()};
  return memory;
}

FacetMemory through_bytes(const FacetMemory& memory) {
  ByteWriter out;
  out.put(memory);
  const std::vector<char> bytes = out.bytes();
  ByteReader in(bytes);
  auto back = in.get<FacetMemory>();
  EXPECT_TRUE(in.empty());
  return back;
}

TEST(StoredFacets, TracesAndContactComeBack) {
  const FacetMemory sent = remembering(), back = through_bytes(sent);
  EXPECT_EQ(back.broken.bits(), 5u);
  EXPECT_EQ(back.slipping.bits(), 4u);
  EXPECT_EQ(back.state, FacetState::fading);
  EXPECT_TRUE(back.open);
  EXPECT_TRUE(back.gas);
  EXPECT_EQ(back.contact.get().offset, sent.contact.get().offset);
  EXPECT_EQ(back.contact.get().fade, sent.contact.get().fade);
}

TEST(StoredFacets, HistoryOfJointsOfAnotherLawThanCoulombsComesBack) {
  const FacetMemory sent = remembering(), back = through_bytes(sent);
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const JointHistory &a = sent.extra.get().joint[p], &b = back.extra.get().joint[p];
    EXPECT_GT(a.closure, 1.0);
    EXPECT_GT(a.slip, 1.0);
    EXPECT_EQ(b.closure, a.closure);
    EXPECT_EQ(b.slip, a.slip);
    EXPECT_EQ(b.broke_at, a.broke_at);
  }
}

TEST(StoredFacets, CohesionAndGroundComeBack) {
  const FacetMemory sent = remembering(), back = through_bytes(sent);
  for (std::size_t p = 0; p < kFacetPoints; ++p) {
    const Cohesion &a = sent.cohesion()[p], &b = back.cohesion()[p];
    EXPECT_EQ(b.direction, a.direction);
    EXPECT_EQ(b.strength, a.strength);
    EXPECT_EQ(b.first, a.first);
    EXPECT_EQ(b.end, a.end);
    EXPECT_EQ(b.worst, a.worst);
    EXPECT_EQ(b.shift, a.shift);
  }
  const GroundMemory &a = sent.ground(), &b = back.ground();
  EXPECT_TRUE(b.yields);
  EXPECT_TRUE(b.placed);
  EXPECT_EQ(b.displacement, a.displacement);
  EXPECT_EQ(b.static_traction, a.static_traction);
  EXPECT_EQ(b.traction, a.traction);
  EXPECT_EQ(b.arm_j, a.arm_j);
}

TEST(StoredFacets, OneThatRemembersNothingStaysSo) {
  const FacetMemory back = through_bytes({});
  EXPECT_FALSE(back.contact.exists());
  EXPECT_FALSE(back.extra.exists());
  EXPECT_EQ(back.state, FacetState::intact);
}

}  // namespace
}  // namespace muckpile
