// SPDX-License-Identifier: GPL-2.0-or-later
// The surfaces that bound the rock: from the words of create_blocks to what the cut follows.
// Scope: files of points or triangles in mine coordinates or those of the run.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rock/cut_options.h"

namespace muckpile {

/// Reads `origin`, `x_bearing` and `unit`: they come before all files in mine coordinates. Throws
/// InputError where there are no such files.
void read_mine_frame(CutOptions& options, const ArgValues& args);

/// Of a file, in the frame of the run. Throws InputError as read_survey() does.
[[nodiscard]] SurveyedSurface read_placed(const std::string& file, const CutOptions& options);

/// A closed surface from a file, in the frame of the run. Throws InputError, with `where` before
/// it, for one that is not closed or looks inward.
[[nodiscard]] std::shared_ptr<const SurfaceIndex> read_body(const std::string& file,
                                                            const std::string& where,
                                                            const CutOptions& options);

/// Of block_min, by which two heights of ground at one place differ before that is warned of: what
/// is finer than a block is smoothed anyway.
inline constexpr double kDoubledPlace = 0.25;

/// Reads `surface` and `terrain`. Throws InputError where a file cannot be read or a body is not
/// closed.
void read_surfaces(CutOptions& options, const ArgValues& args);

/// Bounds the rock by them, once its region is known. Throws InputError where they do not fit it.
void lay_surfaces(CutOptions& options);

/// What the blocks make of them.
struct SurfaceOutcome {
  SurfaceFit fit;
  double rock = 0.0;  ///< that the surfaces hold [m3]
  double cut = 0.0;   ///< blocks and crushed zones [m3]
};
[[nodiscard]] SurfaceOutcome surface_outcome(const CutOptions& options, const Tessellation& cut);

/// Points of a grid through the region's box that lie in the rock.
[[nodiscard]] std::vector<Vec3> points_of_rock(const CutOptions& options);

/// Line of the log: where the run lies in the files; "" without any.
[[nodiscard]] std::string describe_mine_frame(const CutOptions& options);

/// Lines of the log; "" without surfaces.
[[nodiscard]] std::string describe_surfaces(const CutOptions& options, const Tessellation& cut);

}  // namespace muckpile
