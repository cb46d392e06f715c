// SPDX-License-Identifier: GPL-2.0-or-later
// argument_tables check|write ROOT: the arguments tables of docs/styles are those by which the
// styles parse. `write` puts the present ones into the pages.
// Scope: tables between <!-- arguments of STYLE --> and <!-- end of arguments -->.
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "fixes/interfaces/keyword_tables.h"
#include "markdown.h"

namespace fs = std::filesystem;

namespace {

constexpr const char* kEnd = "<!-- end of arguments -->";

std::string head_of(const std::string& style) { return "<!-- arguments of " + style + " -->\n"; }

/// The page of docs/styles that has the table of a style.
fs::path page_with(const std::string& head, const fs::path& styles) {
  for (const auto& entry : fs::directory_iterator(styles))
    if (muckpile::text_of(entry.path()).find(head) != std::string::npos) return entry.path();
  throw std::runtime_error("no page in " + styles.string() + " has the line " + head);
}

/// True if the page had another table.
bool renew(const muckpile::ArgTable& table, const fs::path& styles, bool write) {
  const std::string head = head_of(table.style());
  const fs::path path = page_with(head, styles);
  std::string text = muckpile::text_of(path);
  const std::size_t begin = text.find(head) + head.size(), end = text.find(kEnd, begin);
  if (end == std::string::npos) throw std::runtime_error(path.string() + ": lacks " + kEnd);
  if (text.compare(begin, end - begin, table.markdown()) == 0) return false;
  if (write) {
    std::ofstream(path) << text.replace(begin, end - begin, table.markdown());
  } else {
    std::printf("%s: the table of %s must be\n%s", path.c_str(), table.style().c_str(),
                table.markdown().c_str());
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
