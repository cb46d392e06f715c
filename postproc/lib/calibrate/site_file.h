// SPDX-License-Identifier: GPL-2.0-or-later
// A site file: fitted constants as a piece of an input script.
// Scope: lines `variable NAME index VALUE`, and remarks; inputs include it by -var site FILE.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace muckpile {

using SiteConstants = std::vector<std::pair<std::string, std::string>>;  // name, value as text

// `remarks` stand above, a line each; `beside` behind each constant. Throws InputError if the file
// cannot be written.
void write_site_file(const std::filesystem::path& path, const std::vector<std::string>& remarks,
                     const SiteConstants& constants, const std::vector<std::string>& beside);

// Throws InputError, with file and line, on a line that is neither blank, a remark, nor of that
// form, and on a file without a constant.
[[nodiscard]] SiteConstants read_site_file(const std::filesystem::path& path);

}  // namespace muckpile
