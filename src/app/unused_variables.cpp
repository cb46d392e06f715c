// SPDX-License-Identifier: GPL-2.0-or-later
// Mistyped names behind -var.
// Scope: see the header.
#include "unused_variables.h"

#include <glob.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

#include "args/suggestion.h"

namespace muckpile {
namespace {

struct Script {
  std::set<std::string> files;
  std::set<std::string> used;      ///< variables that it sets or reads
  std::vector<std::string> knobs;  ///< variables that -var can set
  bool whole = true;               ///< false once a file could not be found
};

void read_script(const std::string& path, Script& script);

/// A path with variables in it stands for every file that fits. One that is a variable alone could
/// be any file, and is left out.
void read_included(const std::string& path, Script& script) {
  static const std::regex variable(R"(\$\{\w+\}|\$\w)");
  const std::string pattern = std::regex_replace(path, variable, "*");
  if (pattern == "*") return;
  glob_t found{};
  if (glob(pattern.c_str(), 0, nullptr, &found) != 0) script.whole = false;
  for (std::size_t k = 0; k < found.gl_pathc; ++k) read_script(found.gl_pathv[k], script);
  globfree(&found);
}

void read_line(const std::string& line, Script& script) {
  static const std::regex use(R"(\$\{(\w+)\}|\$(\w)|\bv_(\w+)|\b(?:variable|next)\s+(\w+))"),
      knob(R"(\bvariable\s+(\w+)\s+index\b)"), file(R"re(\b(?:include|jump)\s+([^\s"']+))re");
  const std::sregex_iterator end;
  for (std::sregex_iterator at(line.begin(), line.end(), use); at != end; ++at) {
    for (std::size_t form = 1; form < at->size(); ++form)
      if ((*at)[form].matched) script.used.insert((*at)[form]);
  }
  std::smatch match;
  if (std::regex_search(line, match, knob)) script.knobs.push_back(match[1]);
  if (std::regex_search(line, match, file) && match[1] != "SELF") read_included(match[1], script);
}

void read_script(const std::string& path, Script& script) {
  if (!script.files.insert(path).second) return;
  std::ifstream in(path);
  if (!in) script.whole = false;
  for (std::string line; std::getline(in, line);) read_line(line.substr(0, line.find('#')), script);
}

}  // namespace

std::vector<std::string> unused_variables(const std::vector<std::string>& arguments) {
  std::vector<std::string> given, lines;
  std::string input;
  for (std::size_t k = 0; k + 1 < arguments.size(); ++k) {
    const std::string& option = arguments[k];
    if (option == "-var" || option == "-v") given.push_back(arguments[k + 1]);
    if (option == "-in" || option == "-i") input = arguments[k + 1];
  }
  for (auto name = given.begin(); name != given.end(); ++name) {
    if (std::count(given.begin(), name, *name) == 1)
      lines.push_back("-var " + *name + " is given more than once: the first value counts");
  }
  if (input.empty() || given.empty()) return lines;
  Script script;
  read_script(input, script);
  if (!script.whole) return lines;
  for (const std::string& name : given) {
    if (script.used.count(name) != 0) continue;
    lines.push_back("-var " + name + ": " + input + " has no such variable" +
                    did_you_mean(name, script.knobs));
  }
  return lines;
}

}  // namespace muckpile
