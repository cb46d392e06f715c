// SPDX-License-Identifier: GPL-2.0-or-later
// Words of create_blocks for natural joints; see the header.
#include "rock/natural_joints.h"

#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "args/suggestion.h"
#include "explosive/hole_table.h"
#include "math/random.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"

namespace muckpile {
namespace {

using Words = std::vector<std::string>;

const std::string kSet = "natural_joints";

std::uint8_t class_of(const std::string& keyword, const std::string& word) {
  return static_cast<std::uint8_t>(cut_whole(keyword, word, Range::closed(0, 255)));
}

/// The optional words of a set, one name with its values after the other.
class SetWords {
 public:
  SetWords(const Words& words, std::size_t first) : words_(words), at_(first) {}

  [[nodiscard]] bool at_end() const { return at_ == words_.size(); }
  [[nodiscard]] const std::string& name() {
    name_ = at_++;
    return words_[name_];
  }
  [[nodiscard]] const std::string& value(const std::string& what) {
    if (!at_end()) return words_[at_++];
    refuse(kCreateBlocks, kSet + " " + words_[name_] + " needs " + what + " after it, got nothing");
  }
  [[nodiscard]] double real(const std::string& what, const char* unit, const Range& range) {
    return cut_real(kSet + " " + words_[name_] + ", " + what, value(what), unit, range);
  }

 private:
  const Words& words_;
  std::size_t at_, name_ = 0;
};

/// 0, or at least block_min.
double spacing_of(const std::string& word, const SizeLimits& limits) {
  const double spacing = cut_real(kSet + " spacing", word, "m", Range::closed(0.0, 1e4));
  const Range range = Range::closed(limits.smallest, 1e4);
  if (spacing == 0.0 || range.contains(spacing)) return spacing;
  refuse(kCreateBlocks,
         kSet + " spacing must be " + range.text() + " m, got '" + word + "'; 0 is allowed too");
}

void read_persistence(NaturalJointSet& set, SetWords& words, const SizeLimits& limits) {
  set.persistence = words.real("the share of the planes", "", Range::left_open(0.0, 1.0));
  set.radius = words.real("the radius of the discs", "m", Range::closed(limits.smallest, 1e7));
}

void read_spacings(NaturalJointSet& set, SetWords& words) {
  const Words known = {"exponential", "even"};
  const std::string how = words.value("exponential or even");
  if (how != "exponential" && how != "even") {
    refuse(kCreateBlocks, kSet + " spacings must be exponential or even, got '" + how + "'" +
                              did_you_mean(how, known));
  }
  if (how == "even") set.least_spacing = set.spacing;
}

/// To three digits, upwards, so that a least value is accepted as it is printed.
std::string rounded_up(double value) {
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return rounded_text(std::ceil(value / step) * step);
}

/// `discs`: of this set and those before it; `here`: of this set.
void check_discs(const NaturalJointSet& set, const Vec3& lo, const Vec3& hi, double discs,
                 double here) {
  if (discs <= kMostDiscs) return;
  const double least = least_radius(set, lo, hi, kMostDiscs - (discs - here));
  refuse(kCreateBlocks,
         kSet + " persistence must be at most " + std::to_string(kMostDiscs) +
             " discs, all sets together, got up to '" + number_text(std::ceil(discs)) +
             "' with the set of spacing " + number_text(set.spacing) + " m and radius " +
             number_text(set.radius) + " m; take " +
             (std::isfinite(least) ? "a radius of at least " + rounded_up(least) + " m"
                                   : "wider discs in the sets before it"));
}

}  // namespace

JointPlane joint_plane_of(const Words& words) {
  const auto metres = [&](std::size_t k, const Range& range) {
    return cut_real("joint_plane", words[k], "m", range);
  };
  JointPlane plane;
  plane.point = {metres(0, place_range()), metres(1, place_range()), metres(2, place_range())};
  plane.normal = normal_of_dip(cut_radians("joint_plane", words[3], 90.0),
                               cut_radians("joint_plane", words[4], 360.0));
  plane.joint_class = class_of("joint_plane", words[5]);
  if (words.size() > 6) plane.radius = metres(6, Range::left_open(0.0, 1e7));
  return plane;
}

std::optional<NaturalJointSet> natural_joint_set_of(const Words& words, const SizeLimits& limits) {
  NaturalJointSet set;
  set.normal = normal_of_dip(cut_radians(kSet + " dip", words[0], 90.0),
                             cut_radians(kSet + " dip direction", words[1], 360.0));
  set.spacing = spacing_of(words[2], limits);
  set.least_spacing = kLeastSpacing * limits.smallest;
  set.joint_class = class_of(kSet + " class", words[3]);
  Words taken;
  for (SetWords rest(words, 4); !rest.at_end();) {
    const std::string name = rest.name();
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
      refuse(kCreateBlocks, kSet + " takes " + name + " once");
    taken.push_back(name);
    if (name == "persistence") {
      read_persistence(set, rest, limits);
    } else if (name == "fisher") {
      set.concentration = rest.real("the constant K", "", Range::closed(5.0, 1e6));
    } else if (name == "spacings") {
      read_spacings(set, rest);
    } else {
      const Words known = {"persistence", "fisher", "spacings"};
      refuse(kCreateBlocks, kSet + " takes " + joined(known) + " after its class, got '" + name +
                                "'" + did_you_mean(name, known));
    }
  }
  if (set.spacing == 0.0) return std::nullopt;
  return set;
}

void lay_natural_joint_sets(CutOptions& options) {
  constexpr std::uint64_t kStream = 0x6e61747572616c00;  // apart from the seeds of the cut
  const Vec3 &lo = options.rock.lo, &hi = options.rock.hi;
  double planes = 0.0, discs = 0.0;
  for (std::size_t k = 0; k < options.natural_joint_sets.size(); ++k) {
    const NaturalJointSet& set = options.natural_joint_sets[k];
    planes += most_planes(set, lo, hi);
    if (planes > kMostPlanes) {
      refuse(kCreateBlocks, kSet + " must be at most " + std::to_string(kMostPlanes) +
                                " planes through the rock, all sets together, got up to '" +
                                number_text(std::ceil(planes)) + "' with the set of spacing " +
                                number_text(set.spacing) + " m; take a wider spacing");
    }
    const double here = most_discs(set, lo, hi);
    discs += here;
    check_discs(set, lo, hi, discs, here);
    const std::uint64_t seed = random_bits(kStream + options.rock.seed, k);
    for (JointPlane& plane : planes_of(set, lo, hi, seed)) {
      options.rock.planes.push_back({plane.point, plane.normal});
      options.natural_joints.push_back(std::move(plane));
    }
  }
}

}  // namespace muckpile
