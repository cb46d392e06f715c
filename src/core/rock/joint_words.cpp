// SPDX-License-Identifier: GPL-2.0-or-later
// Words of fix muckpile/joint beside those of create_blocks; see the header.
#include "rock/joint_words.h"

#include <algorithm>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "rock/cut_table.h"

namespace muckpile {
namespace {

using Words = std::vector<std::string>;

/// What stands behind each word of this name.
Words named(const Words& words, const std::string& name) {
  Words found;
  for (std::size_t k = 0; k + 1 < words.size(); ++k)
    if (words[k] == name) found.push_back(words[k + 1]);
  return found;
}

/// A class of the rock, and who has it.
struct Asked {
  int joint_class = 0;
  std::string by;
};

std::vector<Asked> asked_for(const CutOptions& options) {
  std::vector<Asked> asked;
  for (const JointPlane& plane : options.natural_joints)
    asked.push_back({plane.joint_class, "joint_plane"});
  for (const NaturalJointSet& set : options.natural_joint_sets)
    asked.push_back({set.joint_class, "natural_joints"});
  for (const Fault& fault : options.faults)
    asked.push_back({fault.joint_class, "fault " + fault.file});
  for (const RockZone& zone : options.zones)
    asked.push_back({zone.joint_class, "zone '" + zone.name + "'"});
  return asked;
}

}  // namespace

void require_joint_words(const CutOptions& options, const std::string& knob, const Words& words) {
  const Words classes = named(words, "joint_class"), zones = named(words, "zone");
  const std::string of_fix = knob + ", words of fix muckpile/joint, must have ",
                    got = ", got '" + joined(words, " ") + "'";
  for (const Asked& asked : asked_for(options)) {
    const std::string number = std::to_string(asked.joint_class);
    if (asked.joint_class == 0 || std::ranges::find(classes, number) != classes.end()) continue;
    refuse(kCreateBlocks, of_fix + "'joint_class " + number + " law NAME ...' for " + asked.by +
                              " of that class" + got + "; joint_class " + number +
                              " law coulomb friction_angle 35 residual_friction_angle 35, say");
  }
  Words known;
  for (const RockZone& zone : options.zones) {
    known.push_back(zone.name);
    if (std::ranges::find(zones, zone.name) != zones.end()) continue;
    refuse(kCreateBlocks,
           of_fix + "'zone " + zone.name + " KEYWORD VALUE ...' for that zone" + got);
  }
  for (const std::string& zone : zones) {
    if (std::ranges::find(known, zone) != known.end()) continue;
    refuse(kCreateBlocks, knob +
                              ", words of fix muckpile/joint, must have zones of the rock only (" +
                              (known.empty() ? std::string("there are none") : joined(known)) +
                              "), got '" + zone + "'" + did_you_mean(zone, known));
  }
}

}  // namespace muckpile
