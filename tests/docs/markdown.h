// SPDX-License-Identifier: GPL-2.0-or-later
// What tests of the docs read of a Markdown page: its lines, headings and links.
// Scope: the Markdown of these pages; fenced code and `code` hold neither headings nor links.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace muckpile {

struct Link {
  int line = 0;        ///< from 1
  std::string target;  ///< as written
};

struct Page {
  std::set<std::string> anchors;  ///< of its headings, as GitHub makes them
  std::vector<Link> links;        ///< pictures, too
};

/// Throws std::runtime_error if the file cannot be read.
[[nodiscard]] std::string text_of(const std::filesystem::path& path);
[[nodiscard]] Page read_page(const std::filesystem::path& path);

/// Pages that users read: those in the root, docs and inputs.
[[nodiscard]] std::vector<std::filesystem::path> pages_of(const std::filesystem::path& root);

}  // namespace muckpile
