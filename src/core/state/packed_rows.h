// SPDX-License-Identifier: GPL-2.0-or-later
// Rows of a snapshot as bytes: what a row of blocks_<step>.csv holds, in less than half of its
// size. Scope: numbers and bytes; a file's first line and its name are provenance/run_files.h.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "math/types.h"

namespace muckpile {

/// One block of a snapshot.
struct BlockRow {
  int id;
  Vec3 centre;          // [m]
  Quat turn;            // from the start orientation
  Vec3 velocity, spin;  // [m/s], [rad/s]
  int fragment;
  double broken_share;
};

/// The line before the rows: names of the numbers, and how each is kept.
[[nodiscard]] std::string_view packed_header();

/// Appends a row: the centre in doubles, the turn in 2147483647ths, other reals in floats, integers
/// of four bytes, the lower byte first. The turn must be no zero.
void pack(const BlockRow& row, std::string& rows);

/// Rows behind such a line. The text must outlive it.
class PackedRows {
 public:
  /// Of a text that begins with the line. Throws InputError, naming the file, where it does not, or
  /// the last row is cut short.
  PackedRows(std::string_view text, std::string file);

  [[nodiscard]] std::size_t count() const;
  /// Throws InputError where a number is not finite or the turn is no unit quaternion.
  [[nodiscard]] BlockRow at(std::size_t row) const;
  /// "FILE: row 3: "
  [[nodiscard]] std::string where(std::size_t row) const;

 private:
  std::string_view rows_;
  std::string file_;
};

}  // namespace muckpile
