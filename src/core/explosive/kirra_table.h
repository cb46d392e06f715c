// SPDX-License-Identifier: GPL-2.0-or-later
// Holes that the blast design program Kirra has exported as CSV, as a hole table of ours.
// Scope: collar, toe, diameter and surface tie-up; charges are not in Kirra's file of holes. The
// columns are those of its writer (github.com/brentbuffham/Kirra, src/fileIO/TextIO).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/types.h"

namespace muckpile {

/// How the holes come into the frame of a bench: x = 0, z = 0 is the toe of its face, rock is at
/// x < 0, z is up.
struct KirraFrame {
  double throw_bearing = 0.0;    ///< that the face looks to, from north over east [rad]
  std::optional<Vec3> origin{};  ///< of the frame in the mine's coordinates [m]; else by the holes:
  double burden = 0.0;    ///< the foremost hole stands so far behind the toe, at the floor [m]
  double subdrill = 0.0;  ///< below the floor, where the file has none [m]
};

struct KirraCharge {
  double stemming = 0.0;       ///< along the hole; the rest is charged [m]
  double in_hole_delay = 0.0;  ///< [s]
};

struct ConvertedHoles {
  std::string table;  ///< CSV text that HoleTable reads
  std::size_t holes = 0;
  Vec3 origin;                 ///< that was taken, in the mine's coordinates [m]
  double collar_height = 0.0;  ///< mean, above the floor [m]
};

/// An origin of another mine, or 0 0 0 that was left, would put rock where no hole is: throws
/// InputError that `name` starts.
void require_origin_near(const std::vector<Vec3>& collars, const Vec3& origin,
                         const std::string& name);

/// `text` is Kirra's file: 12 or 14 columns without names, or columns with names. `name` stands for
/// it in messages. Throws InputError with name and line.
[[nodiscard]] ConvertedHoles convert_kirra(const std::string& text, const std::string& name,
                                           const KirraFrame& frame, const KirraCharge& charge);

}  // namespace muckpile
