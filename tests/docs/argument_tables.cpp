// SPDX-License-Identifier: GPL-2.0-or-later
// argument_tables check|write ROOT: the arguments tables of docs/styles are those by which the
// styles parse. `write` puts the present ones into the pages.
// Scope: tables between <!-- arguments of STYLE --> and <!-- end of arguments -->, or, without the
// rows that another page has, between <!-- arguments of STYLE beside OTHER --> and that.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "fixes/interfaces/keyword_tables.h"
#include "markdown.h"

namespace fs = std::filesystem;

namespace {

constexpr const char* kEnd = "<!-- end of arguments -->";

/// Where a table stands in the pages.
struct Place {
  fs::path path;
  std::string other;      // the style whose rows are left out, or none
  std::size_t begin = 0;  // of the table, behind its head
};

Place place_of(const std::string& style, const fs::path& styles) {
  const std::string head = "<!-- arguments of " + style, beside = " beside ", tail = " -->\n";
  for (const auto& entry : fs::directory_iterator(styles)) {
    const std::string text = muckpile::text_of(entry.path());
    for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head, at + 1)) {
      const std::size_t rest = at + head.size(), end = text.find(tail, rest);
      if (end == rest) return {entry.path(), "", end + tail.size()};
      if (end != std::string::npos && text.compare(rest, beside.size(), beside) == 0)
        return {entry.path(), text.substr(rest + beside.size(), end - rest - beside.size()),
                end + tail.size()};
    }
  }
  throw std::runtime_error("no page in " + styles.string() + " has the line " + head + tail);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The table without the rows that `other` has, and a line that names their keywords.
std::string rows_beside(const std::string& table, const muckpile::ArgTable& other,
                        const std::string& other_page) {
  const std::vector<std::string> there = lines_of(other.markdown());
  std::string rows, names;
  for (const std::string& line : lines_of(table)) {
    if (!line.starts_with("| `") || std::find(there.begin(), there.end(), line) == there.end()) {
      rows += line + "\n";
    } else {
      names += (names.empty() ? "" : ", ") + line.substr(2, line.find('`', 3) - 1);
    }
  }
  if (names.empty()) throw std::runtime_error(other.style() + " has no row of the other table");
  return rows + "\nThese are as [" + other.style() + "](" + other_page +
         "#arguments) has them: " + names + ".\n";
}

std::string shown(const muckpile::ArgTable& table, const Place& place, const fs::path& styles) {
  if (place.other.empty()) return table.markdown();
  const Place there = place_of(place.other, styles);
  if (!there.other.empty())
    throw std::runtime_error(there.path.string() + ": leaves out rows of its own, so " +
                             table.style() + " cannot be beside " + place.other);
  for (const muckpile::ArgTable& other : muckpile::keyword_tables())
    if (other.style() == place.other)
      return rows_beside(table.markdown(), other, there.path.filename().string());
  throw std::runtime_error(place.path.string() + ": no style " + place.other);
}

/// True if the page had another table.
bool renew(const muckpile::ArgTable& table, const fs::path& styles, bool write) {
  const Place place = place_of(table.style(), styles);
  std::string text = muckpile::text_of(place.path);
  const std::size_t end = text.find(kEnd, place.begin);
  if (end == std::string::npos) throw std::runtime_error(place.path.string() + ": lacks " + kEnd);
  const std::string must = shown(table, place, styles);
  if (text.compare(place.begin, end - place.begin, must) == 0) return false;
  if (write) {
    std::ofstream(place.path) << text.replace(place.begin, end - place.begin, must);
  } else {
    std::printf("%s: the table of %s must be\n%s", place.path.c_str(), table.style().c_str(),
                must.c_str());
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc == 3 ? argv[1] : "";
  if (mode != "check" && mode != "write") {
    std::fprintf(stderr, "usage: %s check|write ROOT\n", argv[0]);
    return 2;
  }
  try {
    int others = 0;
    for (const muckpile::ArgTable& table : muckpile::keyword_tables())
      others += renew(table, fs::path(argv[2]) / "docs" / "styles", mode == "write") ? 1 : 0;
    return mode == "check" && others > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "argument_tables: %s\n", error.what());
    return 1;
  }
}
