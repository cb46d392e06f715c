// SPDX-License-Identifier: GPL-2.0-or-later
// In what the inputs of two runs differ, for whoever compares what came of them.
// Scope: the knobs in dump/scene.json; where results go, and from what a run went on, is no input.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace muckpile {

// "bench_height 10, 8" for each knob whose values differ, or that one run alone has ("none"). Empty
// where one of the two paths is no result folder. Knobs that are `free` may differ.
[[nodiscard]] std::vector<std::string> inputs_apart(const std::filesystem::path& a,
                                                    const std::filesystem::path& b,
                                                    const std::vector<std::string>& free = {});

}  // namespace muckpile
