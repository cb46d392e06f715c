// SPDX-License-Identifier: GPL-2.0-or-later
// The fastest block over time as a drawing within a page, in the page's own colours.
// Scope: from dump/history.csv; one curve.
#pragma once

#include <filesystem>
#include <string>

namespace muckpile {

// An svg element. Throws InputError on a malformed history; "" where it has no row after time 0.
std::string speed_chart(const std::filesystem::path& history);

}  // namespace muckpile
