// SPDX-License-Identifier: GPL-2.0-or-later
// Words of fix muckpile/joint that do not fit those of create_blocks.
// Scope: core only; the engine repeats one message in tests/errors.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "input_error_of.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"
#include "rock/joint_words.h"

namespace muckpile {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string message(const std::string& cut, const std::string& joints) {
  const CutOptions options = cut_options(
      parse_args(cut_table(), kCreateBlocks,
                 words_of("density 2700 block_min 0.1 block_max 0.5 size uniform 0.3 " + cut)),
      8'000'000'000);
  return input_error_of([&] { require_joint_words(options, "joint_words", words_of(joints)); });
}

const std::string kNone = "contact_check yes";
const std::string kLaw = "joint_class 1 law coulomb friction_angle 35";
const std::string kZone = "zone seam 2300 layer 0 0 1 0 0 0.5";

TEST(JointWords, FitRockWithoutClassesAndZones) {
  EXPECT_EQ(message("joint_plane 0 0 0 30 90 0 natural_joints 85 0 0 1", kNone), "");
}

TEST(JointWords, MustHaveTheClassOfNaturalJoints) {
  EXPECT_EQ(
      message("natural_joints 85 0 2 1", kNone),
      "create_blocks: joint_words, words of fix muckpile/joint, must have 'joint_class 1 law "
      "NAME ...' for natural_joints of that class, got 'contact_check yes'; joint_class 1 law "
      "coulomb friction_angle 35 residual_friction_angle 35, say");
  EXPECT_EQ(message("natural_joints 85 0 2 1", kLaw), "");
  EXPECT_NE(message("joint_plane 0 0 0 30 90 2", kLaw)
                .find("'joint_class 2 law NAME ...' for "
                      "joint_plane of that class"),
            std::string::npos);
  EXPECT_NE(message(kZone + " class 2", kLaw + " zone seam tension 0")
                .find("'joint_class 2 law NAME ...' for zone 'seam' of that class"),
            std::string::npos);
}

TEST(JointWords, MustHaveTheZonesOfTheRockAndNoOthers) {
  EXPECT_EQ(message(kZone, "zone seam tension 0"), "");
  EXPECT_NE(
      message(kZone, kNone).find("must have 'zone seam KEYWORD VALUE ...' for that zone, got"),
      std::string::npos);
  EXPECT_NE(message(kZone, "zone seam tension 0 zone saem tension 0")
                .find("must have zones of the rock only (seam), got 'saem'; did you mean 'seam'?"),
            std::string::npos);
  EXPECT_NE(message("", "zone seam tension 0").find("(there are none), got 'seam'"),
            std::string::npos);
}

}  // namespace
}  // namespace muckpile
