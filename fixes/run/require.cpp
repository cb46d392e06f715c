// SPDX-License-Identifier: GPL-2.0-or-later
// require: words to a range, and the check.
// Scope: see the header.
#include "fixes/run/require.h"

#include <comm.h>
#include <error.h>
#include <input.h>
#include <variable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/suggestion.h"
#include "fixes/engine/first_rank.h"
#include "fixes/engine/restart_name.h"
#include "fixes/engine/style_args.h"
#include "provenance/results_folder.h"

namespace muckpile {
namespace {

constexpr const char* kStyle = "require";
constexpr const char* kAuto = "auto";

bool starts_a_rule(const std::string& word) {
  constexpr std::array<const char*, 16> kWords{
      "above",      "at_least", "below",     "at_most", "or",   "whole",
      "unit",       "one_of",   "script_in", "advice",  "file", "file_or_none",
      "outside_of", "as_in",    "script_of", "of_run"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

struct Rule {
  Range range;
  bool whole = false;
  std::string unit;
  std::string advice;               ///< what to do, behind the message
  std::optional<double> exception;  ///< allowed although outside the range
  bool or_auto = false;             ///< the word is allowed
};

std::string joined_with_blanks(std::span<const std::string> words) {
  return joined({words.begin(), words.end()}, " ");
}

Rule read_rule(const std::vector<std::string>& words) {
  Rule rule;
  for (std::size_t k = 0; k < words.size();) {
    const std::string& word = words[k++];
    if (word == "whole") {
      rule.whole = true;
      continue;
    }
    if (k == words.size())
      throw InputError(std::string(kStyle) + ": nothing follows '" + word + "'");
    if (word == "advice") {  // whatever follows: LIGGGHTS puts no variables into quoted text
      rule.advice = joined_with_blanks(std::span(words).subspan(k));
      break;
    }
    const std::string& value = words[k++];
    if (word == "unit") {
      rule.unit = value;
      continue;
    }
    if (word == "or" && value == kAuto) {
      rule.or_auto = true;
      continue;
    }
    const double number = parse_real(kStyle, word, value, "", Range::any());
    if (word == "above" || word == "at_least") {
      rule.range.lo = number;
      rule.range.lo_open = word == "above";
    } else if (word == "below" || word == "at_most") {
      rule.range.hi = number;
      rule.range.hi_open = word == "below";
    } else if (word == "or") {
      rule.exception = number;
    } else {
      throw InputError(
          std::string(kStyle) + ": unknown keyword '" + word +
          "' (known: above, at_least, below, at_most, or, whole, unit, advice, one_of, "
          "script_in, file, script_of, file_or_none, outside_of, as_in, of_run)");
    }
  }
  return rule;
}

void check_range(const std::string& name, const std::string& text, const Rule& rule) {
  const std::string where = "input";
  if (rule.whole)
    (void)parse_integer(where, name, text, rule.unit, rule.range);
  else
    (void)parse_real(where, name, text, rule.unit, rule.range);
}

void check_number(const std::string& name, const std::string& text, const Rule& rule) {
  if (rule.or_auto && text == kAuto) return;
  if (rule.exception && parse_real("input", name, text, rule.unit, Range::any()) == *rule.exception)
    return;
  try {
    check_range(name, text, rule);
  } catch (const InputError& refused) {
    std::string allowed = refused.what();
    if (rule.exception) allowed += "; " + number_text(*rule.exception) + " is allowed too";
    if (rule.or_auto) allowed += std::string("; ") + kAuto + " is allowed too";
    throw InputError(allowed);
  }
}

void check(const std::string& name, const std::string& text, const Rule& rule) {
  try {
    check_number(name, text, rule);
  } catch (const InputError& refused) {
    if (rule.advice.empty()) throw;
    throw InputError(std::string(refused.what()) + "; " + rule.advice);
  }
}

void check_word(const std::string& name, const std::string& word,
                const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), word) != allowed.end()) return;
  throw InputError("input: " + name + " must be one of " + joined(allowed) + ", got '" + word +
                   "'" + did_you_mean(word, allowed));
}

/// Names of the scripts of a folder, without the .in that they end with.
std::vector<std::string> scripts_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable))
    if (entry.path().extension() == ".in") names.push_back(entry.path().stem().string());
  if (unreadable) {
    throw InputError(std::string(kStyle) + ": cannot read the folder '" + folder +
                     "': " + unreadable.message());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The words behind `one_of`, or those for which the folder behind `script_in` has a script.
std::vector<std::string> allowed_words(const std::string& rule, std::vector<std::string> words) {
  if (words.empty()) throw InputError(std::string(kStyle) + ": nothing follows '" + rule + "'");
  if (rule == "one_of") return words;
  if (words.size() > 1) {
    throw InputError(std::string(kStyle) + ": script_in takes one folder, got '" + joined(words) +
                     "'");
  }
  return scripts_in(words.front());
}

/// Throws InputError unless a word is the name of a file that can be read. `allowed`: for the
/// message.
void check_file(const std::string& name, const std::string& word, const std::string& allowed) {
  const bool folder = std::filesystem::is_directory(word);
  if (!folder && std::ifstream(word)) return;
  throw InputError("input: " + name + " must be " + allowed + ", got '" + word + "', which " +
                   (folder ? "is a folder" : "cannot be opened"));
}

/// Throws InputError unless every line of a file begins with one of these commands, or says
/// nothing.
void check_script(const std::string& name, const std::string& file,
                  const std::vector<std::string>& commands) {
  constexpr std::size_t kLongest = 40;  // of a word in the message
  check_file(name, file, "a file");
  std::ifstream in(file);
  std::size_t number = 0;
  bool goes_on = false;  // the line before, by an & at its end
  for (std::string line; std::getline(in, line);) {
    ++number;
    const std::string said = line.substr(0, line.find('#'));
    const bool more = std::exchange(goes_on, said.find_last_not_of(" \t\r") != std::string::npos &&
                                                 said[said.find_last_not_of(" \t\r")] == '&');
    std::string command;
    if (more || !(std::istringstream(said) >> command)) continue;
    if (std::ranges::find(commands, command) != commands.end()) continue;
    throw InputError("input: " + name + " must be a script of lines that begin with " +
                     joined(commands) + ", got '" + file + "', whose line " +
                     std::to_string(number) + " begins with '" + command.substr(0, kLongest) + "'");
  }
}

/// Whether a word is the name of a file that can be read; false for none.
bool is_file(const std::string& name, const std::string& word) {
  if (word == "none") return false;
  check_file(name, word, "a file, or none");
  return true;
}

void check_outside(const std::string& name, const std::string& path, const std::string& folder) {
  if (path != "none" && lies_in(path, folder))
    throw InputError("input: " + name + " must be outside of '" + folder +
                     "', where the results of this run go and replace what is there, got '" + path +
                     "'");
}

/// Throws InputError where a folder has the scene of another run than that of a restart file.
void check_run(const std::string& name, const std::string& folder, const std::string& restart) {
  const auto there = scene_run_id(folder);
  if (!there || (!there->empty() && file_holds(restart, *there))) return;
  throw InputError("input: " + name + " must be the folder of the run that goes on from '" +
                   restart + "', or a new one, got '" + folder + "', which has " +
                   (there->empty() ? "a scene without a run_id that can be read"
                                   : "the scene of another run, " + *there));
}

/// What follows as_in.
struct SceneRule {
  std::string folder, key;
  bool warns = false;
  std::string advice;  ///< what to do, behind the message
};

SceneRule read_scene_rule(std::span<const std::string> words) {
  const bool warns = words.size() == 3 && words[2] == "warn",
             advises = words.size() > 3 && words[2] == "advice";
  if (words.size() != 2 && !warns && !advises)
    throw InputError(std::string(kStyle) +
                     ": as_in takes a folder, a key and perhaps 'warn', or 'advice' and words");
  return {words[0], words[1], warns, advises ? joined_with_blanks(words.subspan(3)) : ""};
}

/// A fault where a number differs from that of the scene of a folder of results, or where that is
/// the scene of another case, which has no such number; "" where there is nothing to compare with.
std::string other_than_in(const std::string& name, const std::string& text, const SceneRule& rule) {
  constexpr double kSame = 1e-6;
  const double value = parse_real("input", name, text, "", Range::any());
  if (rule.folder == "none" || !has_scene(rule.folder)) return "";
  const std::optional<double> theirs = scene_number(rule.folder, rule.key);
  const std::string of_the_run = rule.key + " of the run in '" + rule.folder + "', ",
                    advice = rule.advice.empty() ? "" : "; " + rule.advice;
  if (!theirs) {
    if (rule.warns) return "";
    return "input: " + name + " must be " + of_the_run +
           "which has none: it is of another case or of an earlier version" + advice;
  }
  if (std::abs(value - *theirs) <= kSame * std::max(std::abs(value), std::abs(*theirs))) return "";
  return "input: " + name + " must be " + number_text(*theirs) + ", as " + of_the_run + "got '" +
         text + "'" + advice;
}

}  // namespace

/// LIGGGHTS compares numbers only: a script asks for 1 or 0.
void Require::set_flag(std::string name, bool value) const {
  std::string style = "string", text = value ? "1" : "0";
  std::array<char*, 3> words{name.data(), style.data(), text.data()};
  input->variable->set(static_cast<int>(words.size()), words.data());
}

/// The rule and what follows it.
void Require::look_at_folder(const std::string& name, const std::string& value,
                             const std::vector<std::string>& words) const {
  if (words[0] == "outside_of") {
    if (words.size() != 2) throw InputError(std::string(kStyle) + ": outside_of takes one folder");
    check_outside(name, value, words[1]);
    return;
  }
  const SceneRule rule = read_scene_rule(std::span(words).subspan(1));
  const std::string fault = other_than_in(name, value, rule);
  if (fault.empty()) return;
  if (!rule.warns) throw InputError(fault);
  if (comm->me == 0) error->warning(FLERR, fault.c_str());
}

/// Before a script that goes on writes into the folder. Files in parts have no whole one to look
/// into; read_restart tells what is wrong with them.
void Require::look_at_run(const std::string& name, const std::string& folder,
                          const std::vector<std::string>& words) const {
  if (words.size() != 1)
    throw InputError(std::string(kStyle) + ": of_run takes the name of one restart file");
  const std::string restart = engine::latest_restart(*lmp, words.front());
  if (restart.find('%') != std::string::npos) return;
  engine::on_first_rank(*lmp, [&] {
    check_file(name + " of_run", restart, "a restart file");
    check_run(name, folder, restart);
  });
}

void Require::require_set(char* variable) const {
  if (input->variable->find(variable) < 0)
    throw InputError(std::string("input: the variable ") + variable + " is not set");
}

std::string Require::text_of(char* variable) const {
  require_set(variable);
  const char* text = input->variable->retrieve(variable);
  if (text == nullptr)
    throw InputError(std::string("input: the variable ") + variable + " has no text");
  return text;
}

/// A knob that would be left unheeded: LIGGGHTS cannot compare words with blanks in them.
void Require::look_at_needed(char* name, const std::vector<char*>& words) const {
  if (words.size() != 3 || std::strcmp(words[1], "unless") != 0)
    throw InputError(std::string(kStyle) + ": needs takes a name, 'unless' and a text");
  const std::string text = text_of(name), number = text_of(words[0]);
  if (text == words[2] || parse_real("input", words[0], number, "", Range::any()) > 0.0) return;
  throw InputError(std::string("input: ") + name + " needs " + words[0] + " > 0, got '" + number +
                   "' with " + name + " '" + text + "'");
}

void Require::command(int narg, char** arg) {
  engine::or_engine_error(*lmp, [&] {
    if (narg < 2) throw InputError(std::string(kStyle) + ": needs a name, its value and a rule");
    if (narg == 2 && std::string(arg[1]) == "set") {
      require_set(arg[0]);
      return 0;
    }
    if (std::string(arg[1]) == "needs") {
      look_at_needed(arg[0], {arg + 2, arg + narg});
      return 0;
    }
    // An empty variable leaves no word: its rule has taken the value's place.
    if (starts_a_rule(arg[1])) throw InputError(std::string("input: ") + arg[0] + " has no value");
    const std::string rule = narg > 2 ? arg[2] : "";
    if (rule == "file_or_none") {
      if (narg != 4)
        throw InputError(std::string(kStyle) + ": file_or_none takes the name of a variable");
      set_flag(arg[3], is_file(arg[0], arg[1]));
    } else if (rule == "outside_of" || rule == "as_in") {
      look_at_folder(arg[0], arg[1], {arg + 2, arg + narg});
    } else if (rule == "of_run") {
      look_at_run(arg[0], arg[1], {arg + 3, arg + narg});
    } else if (rule == "file") {
      if (narg != 3) throw InputError(std::string(kStyle) + ": nothing may follow file");
      check_file(arg[0], arg[1], "a file");
    } else if (rule == "script_of") {
      if (narg < 4) throw InputError(std::string(kStyle) + ": nothing follows 'script_of'");
      check_script(arg[0], arg[1], {arg + 3, arg + narg});
    } else if (rule == "one_of" || rule == "script_in") {
      check_word(arg[0], arg[1], allowed_words(rule, {arg + 3, arg + narg}));
    } else {
      check(arg[0], arg[1], read_rule({arg + 2, arg + narg}));
    }
    return 0;
  });
}

}  // namespace muckpile
