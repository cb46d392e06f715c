// SPDX-License-Identifier: GPL-2.0-or-later
// What blocks can be coloured by: a number or a name for each of them, by the name of the field.
// Scope: columns of blocks.vtk and of the snapshots, and what follows from them.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/result_folder.h"

namespace muckpile {

// How a field's values make colours.
enum class FieldScale {
  kOrigin,    // earth tones from the least to the largest
  kAmount,    // from the least to the largest
  kFromZero,  // from 0 to the largest
  kShare,     // from 0 to 1
  kSigned,    // both ways from 0
  kNames      // each value another colour
};

struct BlockField {
  std::string label;   // with unit
  std::string column;  // in a table, with unit
  FieldScale scale;
  std::vector<double> values;             // by index of the block
  std::map<int, std::string> names = {};  // of values, where they name something that has a name
  size_t muck = 0;                        // how many blocks at the end are muck (io/muck.h)

  // Of muck where there is no rock.
  [[nodiscard]] std::span<const double> of_rock() const {
    return std::span<const double>(values).first(values.size() - (muck < values.size() ? muck : 0));
  }
};

// In the order of the help.
std::vector<std::string> field_names();
// What is wrong with a name that is none of them, with those that there are; else "".
std::string wrong_field(const std::string& name);

class BlockFields {
 public:
  // Both must outlive it.
  BlockFields(const ResultFolder& folder, const std::vector<StartBlock>& blocks)
      : folder_(folder), blocks_(blocks) {}

  // Throws InputError with the names that there are for an unknown name, and with what is missing
  // for a field that the run does not have.
  [[nodiscard]] BlockField of(const std::string& name, const Snapshot& snapshot) const;

  // The least and the largest value over all snapshots, so that pictures share one range; none
  // where that does not depend on the snapshot.
  [[nodiscard]] std::optional<std::array<double, 2>> range_of_run(const std::string& name) const;

 private:
  [[nodiscard]] BlockField find(const std::string& name, const Snapshot& snapshot) const;
  [[nodiscard]] BlockField holes() const;
  [[nodiscard]] BlockField zones() const;
  [[nodiscard]] BlockField launch_speeds() const;

  const ResultFolder& folder_;
  const std::vector<StartBlock>& blocks_;
  mutable std::map<std::string, BlockField> of_run_;  // those that no snapshot changes
};

}  // namespace muckpile
