// SPDX-License-Identifier: GPL-2.0-or-later
// What has pushed each block, and by how much: impulses by cause, summed over the steps.
// Scope: forces are given; the kicks are those of the leapfrog of body_motion.h, so the impulses of
// a block add up to its change of momentum but for rounding. A block that has come from another
// rank begins a row here: the rows of all ranks with one tag add up to the block's. SI units.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "math/types.h"

namespace muckpile {

/// `before`: momentum as the sums began. `joints`: forces of joints other than those of gas and of
/// blast, between blocks and from supports. `contacts`: all that is left, as contact of spheres,
/// walls and what other fixes put on spheres.
enum class ImpulsePart { before, wave, hole_gas, joint_gas, joints, contacts, weight };
inline constexpr std::size_t kImpulseParts = 7;
/// As they are called in files.
inline constexpr std::array<std::string_view, kImpulseParts> kImpulseNames = {
    "before", "wave", "hole_gas", "joint_gas", "joints", "contacts", "weight"};

/// One vector per part: forces [N] or impulses [N s].
struct ByPart {
  std::array<Vec3, kImpulseParts> parts;

  ByPart() { parts.fill(Vec3::Zero()); }
  [[nodiscard]] Vec3& operator[](ImpulsePart part) { return parts[static_cast<std::size_t>(part)]; }
  [[nodiscard]] const Vec3& operator[](ImpulsePart part) const {
    return parts[static_cast<std::size_t>(part)];
  }
  [[nodiscard]] Vec3 sum() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& part : parts) sum += part;
    return sum;
  }
  void add(const ByPart& other, double times = 1.0) {
    for (std::size_t k = 0; k < kImpulseParts; ++k) parts[k] += times * other.parts[k];
  }
};

struct ImpulseRow {
  int tag = 0;  ///< of the block
  ByPart impulse;
};

class ImpulseSums {
 public:
  /// The blocks of this rank from now on, and one row of forces for each to be written [N].
  std::span<ByPart> forces_on(std::span<const int> tags);
  /// Momenta of the blocks that have these forces, as the sums begin [kg m/s].
  void begin(std::span<const Vec3> momenta);
  /// Half a kick of the forces written last. `half`: half a step [s].
  void kick(double half);

  [[nodiscard]] const std::vector<ImpulseRow>& rows() const { return rows_; }

 private:
  std::vector<ImpulseRow> rows_;
  std::unordered_map<int, std::size_t> row_of_;  // by tag
  std::vector<int> tags_;                        // of `places_` and `forces_`
  std::vector<std::size_t> places_;
  std::vector<ByPart> forces_;
};

/// Rows of several ranks, one row per block, in the order of tags.
[[nodiscard]] std::vector<ImpulseRow> added_up(std::vector<ImpulseRow> rows);

}  // namespace muckpile
