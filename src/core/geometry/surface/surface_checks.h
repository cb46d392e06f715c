// SPDX-License-Identifier: GPL-2.0-or-later
// What is refused of a surface that shall bound rock or hold it, with what to do.
// Scope: `where` begins each message; lengths in metres, in the frame of the run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/surface/surface_index.h"

namespace muckpile {

/// From one corner of a box to the other, to a millimetre and with all digits of mine coordinates.
[[nodiscard]] std::string extent_text(const Vec3& lo, const Vec3& hi);

/// Throws InputError where edges have a triangle on one side only, more than two triangles meet at
/// an edge, or two are turned against each other.
void require_closed(const std::vector<StlTriangle>& triangles, const std::string& where);

/// Throws InputError where two triangles that share an edge are turned against each other; `solid`
/// is what all normals are to look out of.
void require_turned_alike(const std::vector<StlTriangle>& triangles, const std::string& where,
                          const std::string& solid);

/// Takes out triangles that others with the same corners and turn repeat; returns how many. Throws
/// InputError where one has the corners of another that is turned the other way.
std::size_t leave_out_doubled(std::vector<StlTriangle>& triangles, const std::string& where);

/// Volume that a closed surface encloses [m3]; negative if its triangles look inward.
[[nodiscard]] double enclosed_volume(const std::vector<StlTriangle>& triangles);

/// Throws InputError for a closed surface whose triangles look inward, or that overlaps itself.
void require_outward(const SurfaceIndex& surface, const std::string& where);

/// Throws InputError for ground that has two heights, more than `apart` [m] from each other, over
/// more than that share of its columns over the box in plan; `so` is what to do. Two layers cover
/// areas, a face that hangs over somewhat lines only.
void require_one_height(const SurfaceIndex& ground, const Vec3& lo, const Vec3& hi, double apart,
                        double share, const std::string& where, const std::string& so);

/// Throws InputError for a terrain that hangs over, or does not cover the box in plan.
void require_height_field(const SurfaceIndex& surface, const Vec3& lo, const Vec3& hi,
                          const std::string& where);

/// Throws InputError for a surface of a size that tells of another unit than the metre, as it
/// stands beside the box. `as_large`: it should be about as large as the box, as a body of rock is.
/// `box` is the word for the box, `knob` the variable of inputs/quarry that sets the unit, or "".
void require_likely_unit(const Vec3& surface_lo, const Vec3& surface_hi, bool as_large,
                         const Vec3& lo, const Vec3& hi, const std::string& where,
                         const std::string& box, const std::string& knob);

/// Throws InputError for a surface that lies beside the box; `so` is what follows from that.
void require_at_box(const Vec3& surface_lo, const Vec3& surface_hi, const Vec3& lo, const Vec3& hi,
                    const std::string& where, const std::string& so,
                    const std::string& box = "region");

}  // namespace muckpile
