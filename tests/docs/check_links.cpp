// SPDX-License-Identifier: GPL-2.0-or-later
// check_links ROOT: every link of the pages leads to a file, and to a heading of it; every term of
// the glossary is linked by a page.
// Scope: links within the project; those to the web are not followed.
#include <cstdio>
#include <exception>
#include <map>

#include "markdown.h"

namespace fs = std::filesystem;
using muckpile::Link, muckpile::Page;

namespace {

struct Check {
  std::map<fs::path, Page> pages;
  std::set<std::string> linked_terms{};
  int faults = 0;
};

void complain(Check& check, const fs::path& page, const Link& link, const char* what) {
  std::printf("%s:%d: '%s' %s\n", page.c_str(), link.line, link.target.c_str(), what);
  ++check.faults;
}

void check_link(Check& check, const fs::path& page, const Link& link, const fs::path& glossary) {
  if (link.target.find("://") != std::string::npos || link.target.starts_with("mailto:")) return;
  const std::size_t hash = link.target.find('#');
  const std::string file = link.target.substr(0, hash);
  const fs::path target = file.empty() ? page : (page.parent_path() / file).lexically_normal();
  if (!fs::exists(target)) return complain(check, page, link, "leads to no file");
  if (hash == std::string::npos) return;
  const std::string anchor = link.target.substr(hash + 1);
  const auto found = check.pages.find(target);
  if (found == check.pages.end() || !found->second.anchors.contains(anchor))
    return complain(check, page, link, "leads to no heading");
  if (target == glossary && page != glossary) check.linked_terms.insert(anchor);
}

int faults_under(const fs::path& root) {
  Check check;
  for (const fs::path& path : muckpile::pages_of(root))
    check.pages[path] = muckpile::read_page(path);
  const fs::path glossary = root / "docs" / "glossary.md";
  for (const auto& [path, page] : check.pages)
    for (const Link& link : page.links) check_link(check, path, link, glossary);
  for (const std::string& term : check.pages.at(glossary).anchors) {
    if (term == "glossary" || check.linked_terms.contains(term)) continue;
    std::printf("%s: no page links to '%s'\n", glossary.c_str(), term.c_str());
    ++check.faults;
  }
  return check.faults;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s ROOT\n", argv[0]);
    return 2;
  }
  try {
    return faults_under(fs::canonical(argv[1])) == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "check_links: %s\n", error.what());
    return 1;
  }
}
