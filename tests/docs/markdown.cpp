// SPDX-License-Identifier: GPL-2.0-or-later
// Headings and links of a Markdown page.
// Scope: see the header.
#include "markdown.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace muckpile {
namespace {

namespace fs = std::filesystem;

/// The line without what stands between backticks.
std::string without_code(const std::string& line) {
  std::string rest;
  bool code = false;
  for (const char c : line) {
    if (c == '`') {
      code = !code;
    } else if (!code) {
      rest += c;
    }
  }
  return rest;
}

/// GitHub's name of a heading: lower case, without punctuation, blanks as hyphens.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(letter));
    } else if (c == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

void add_links(const std::string& line, int number, std::vector<Link>& links) {
  for (std::size_t at = line.find("]("); at != std::string::npos; at = line.find("](", at + 2)) {
    const std::size_t end = line.find(')', at);
    if (end != std::string::npos) links.push_back({number, line.substr(at + 2, end - at - 2)});
  }
}

}  // namespace

std::string text_of(const fs::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return text.str();
}

Page read_page(const fs::path& path) {
  std::istringstream in(text_of(path));
  Page page;
  std::map<std::string, int> seen;
  bool fenced = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.starts_with("```")) fenced = !fenced;
    if (fenced || line.starts_with("    ")) continue;
    const std::size_t level = line.find_first_not_of('#');
    if (level > 0 && level < line.size() && line[level] == ' ') {
      std::string anchor = anchor_of(line.substr(level + 1));
      if (const int times = seen[anchor]++; times > 0)
        anchor.append("-").append(std::to_string(times));
      page.anchors.insert(anchor);
    }
    add_links(without_code(line), number, page.links);
  }
  return page;
}

std::vector<fs::path> pages_of(const fs::path& root) {
  std::vector<fs::path> pages;
  const auto take = [&pages](const fs::path& path) {
    if (path.extension() == ".md") pages.push_back(path);
  };
  for (const auto& entry : fs::directory_iterator(root)) take(entry.path());
  for (const char* folder : {"docs", "inputs"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) take(entry.path());
  std::sort(pages.begin(), pages.end());
  return pages;
}

}  // namespace muckpile
