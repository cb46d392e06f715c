// SPDX-License-Identifier: GPL-2.0-or-later
// What a perf program on one core without arguments has to provide; print_measurement.cpp is its
// main(). Scope: programs on the cube of Voronoi blocks.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace muckpile::perf {

inline constexpr double kCubeEdge = 20.0;  // of the cube [m]; its blocks are of 1 m
inline constexpr int kCubeSweeps = 5;

[[nodiscard]] nlohmann::ordered_json measure();

}  // namespace muckpile::perf
