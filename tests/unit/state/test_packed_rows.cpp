// SPDX-License-Identifier: GPL-2.0-or-later
// Packed rows of a snapshot: what goes in comes out, velocities to the digits of a float, and
// damage is told. Scope: state/packed_rows.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "input_error_of.h"
#include "state/packed_rows.h"

namespace muckpile {
namespace {

BlockRow row_of(int id) {
  return {.id = id,
          .centre = Vec3(1234567.123456789, -0.25, 1e-9),
          .turn = Quat(0.1, -0.7, 0.5, 0.5).normalized(),
          .velocity = Vec3(12.3, -4.56, 7e-5),
          .spin = Vec3(0.1, 0.0, -200.0),
          .fragment = id + 5,
          .broken_share = 1.0 / 3.0};
}

std::string packed(const std::vector<BlockRow>& rows) {
  std::string text(packed_header());
  for (const BlockRow& row : rows) pack(row, text);
  return text;
}

TEST(PackedRows, ComeBackToTheDigitsThatTheyKeep) {
  constexpr double kFloat = 1e-7;
  const std::string text = packed({row_of(7), row_of(2000000000)});
  const PackedRows rows(text, "file");
  ASSERT_EQ(rows.count(), 2U);
  const BlockRow got = rows.at(1), put = row_of(2000000000);
  EXPECT_EQ(got.id, put.id);
  EXPECT_EQ(got.fragment, put.fragment);
  EXPECT_EQ(got.centre, put.centre);
  EXPECT_LT((got.turn.coeffs() - put.turn.coeffs()).norm(), 1e-9);
  EXPECT_LT((got.velocity - put.velocity).norm(), kFloat * put.velocity.norm());
  EXPECT_LT((got.spin - put.spin).norm(), kFloat * put.spin.norm());
  EXPECT_NEAR(got.broken_share, put.broken_share, kFloat);
}

TEST(PackedRows, TakeLessThanHalfOfTheText) {
  // A row of text has 170 bytes in a blast.
  EXPECT_EQ(packed({row_of(1)}).size() - packed_header().size(), 76U);
}

TEST(PackedRows, RefuseARowThatIsCutShort) {
  const std::string text = packed({row_of(1), row_of(2)});
  EXPECT_EQ(input_error_of([&] { PackedRows(text.substr(0, text.size() - 1), "file"); }),
            "file: the last of its packed rows of 76 bytes is cut short");
}

TEST(PackedRows, RefuseADamagedHeader) {
  std::string text = packed({row_of(1)});
  text[3] = '?';
  EXPECT_EQ(input_error_of([&] { PackedRows(text, "file"); }),
            "file: the second line of packed rows must name their numbers; the file is damaged");
}

TEST(PackedRows, RefuseWhatIsNoPose) {
  BlockRow no_number = row_of(1);
  no_number.velocity.y() = std::numeric_limits<double>::quiet_NaN();
  std::string text = packed({row_of(3), no_number, row_of(4)});
  text[packed_header().size() + 2 * 76 + 28 + 7] = '\0';  // the highest byte of qx
  const PackedRows rows(text, "file");
  EXPECT_NO_THROW((void)rows.at(0));
  for (const size_t row : {1U, 2U})
    EXPECT_EQ(input_error_of([&] { (void)rows.at(row); }),
              "file: row " + std::to_string(row + 1) +
                  ": numbers must be finite and qw, qx, qy, qz a unit quaternion; the file is "
                  "damaged");
}

}  // namespace
}  // namespace muckpile
