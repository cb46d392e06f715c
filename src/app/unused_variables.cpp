// SPDX-License-Identifier: GPL-2.0-or-later
// Mistyped names behind -var, and in the files that it names.
// Scope: see the header.
#include "unused_variables.h"

#include <glob.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "args/suggestion.h"

namespace muckpile {
namespace {

struct Script {
  std::map<std::string, std::string> given;  ///< behind -var, the first value of each name
  std::map<std::string, std::string> named;  ///< file that such a value names: "NAME VALUE"
  std::set<std::string> files;
  std::set<std::string> used;      ///< variables that it sets or reads
  std::set<std::string> read;      ///< those that it reads
  std::vector<std::string> knobs;  ///< variables that -var can set
  bool whole = true;               ///< false once a file could not be found
};

const std::regex& a_variable() {
  static const std::regex form(R"(\$\{(\w+)\}|\$(\w))");
  return form;
}

void read_script(const std::string& path, Script& script);

/// The file that an included path is by a value behind -var.
void read_named(const std::string& path, Script& script) {
  std::smatch variable;
  if (!std::regex_search(path, variable, a_variable())) return;
  const auto value = script.given.find(variable[1].matched ? variable[1] : variable[2]);
  if (value == script.given.end()) return;
  const std::string file = variable.prefix().str() + value->second + variable.suffix().str();
  if (!std::ifstream(file)) return;
  script.named[file] = value->first + " " + value->second;
  read_script(file, script);
}

/// A path with variables in it stands for every file that fits. One that is a variable alone could
/// be any file, and is left out.
void read_included(const std::string& path, Script& script) {
  read_named(path, script);
  const std::string pattern = std::regex_replace(path, a_variable(), "*");
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
    constexpr std::size_t kSets = 4;  // the form of a variable that is set, or stepped on
    for (std::size_t form = 1; form <= kSets; ++form) {
      if (!(*at)[form].matched) continue;
      script.used.insert((*at)[form]);
      if (form < kSets) script.read.insert((*at)[form]);
    }
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

/// What a name that nothing reads may have been meant for.
std::string meant(const std::string& name, const Script& script) {
  std::vector<std::string> knobs = script.knobs;
  std::erase_if(knobs, [&](const std::string& knob) { return script.read.count(knob) == 0; });
  return did_you_mean(name, knobs);
}

/// A line for each variable that a file sets in vain: nothing reads it, or it is set before.
void tell_of_file(const std::string& path, const Script& script, std::vector<std::string>& lines) {
  static const std::regex sets(R"(^\s*variable\s+(\w+)\s+(\w+))");
  const std::string file = "-var " + script.named.at(path) + ": " + path + " sets ";
  std::set<std::string> there;
  std::ifstream in(path);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_search(line, match, sets) || match[2] == "delete") continue;
    const std::string name = match[1];
    if (!there.insert(name).second && match[2] == "index")
      lines.push_back(file + name + " more than once: the first value counts");
    else if (script.read.count(name) == 0)
      lines.push_back(file + name + ", which nothing reads" + meant(name, script));
  }
}

std::vector<std::string> faults_of(const Script& script, const std::string& input) {
  std::vector<std::string> lines;
  for (const auto& [name, value] : script.given) {
    if (script.used.count(name) != 0) continue;
    lines.push_back("-var " + name + ": " + input + " has no such variable" +
                    did_you_mean(name, script.knobs));
  }
  for (const auto& file : script.named) tell_of_file(file.first, script, lines);
  return lines;
}

}  // namespace

std::vector<std::string> unused_variables(const std::vector<std::string>& arguments) {
  Script script;
  std::vector<std::string> lines;
  std::string input;
  for (std::size_t k = 0; k + 1 < arguments.size(); ++k) {
    const std::string& option = arguments[k];
    if (option == "-in" || option == "-i") input = arguments[k + 1];
    if (option != "-var" && option != "-v") continue;
    const std::string value = k + 2 < arguments.size() ? arguments[k + 2] : "";
    if (!script.given.emplace(arguments[k + 1], value).second)
      lines.push_back("-var " + arguments[k + 1] +
                      " is given more than once: the first value counts");
  }
  if (input.empty() || script.given.empty()) return lines;
  read_script(input, script);
  if (!script.whole) return lines;
  std::ranges::copy(faults_of(script, input), std::back_inserter(lines));
  return lines;
}

}  // namespace muckpile
