// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/joint for zones of rock.
// Scope: see the header.
#include "bond/law/zone_words.h"

#include <algorithm>

#include "args/input_error.h"
#include "args/numbers.h"

namespace muckpile {
namespace {

constexpr const char* kZone = "zone";

/// The words of one zone from `at` on, which moves behind them. A word that neither table knows is
/// the zone's, whose parser then tells what is wrong.
std::vector<std::string> take(const ArgTable& zone, const ArgTable& style,
                              const std::vector<std::string>& words, std::size_t& at) {
  std::vector<std::string> mine;
  while (at < words.size()) {
    const bool known = zone.find(words[at]) != nullptr;
    if (!known && style.find(words[at]) != nullptr) break;
    mine.push_back(words[at++]);
    if (at < words.size()) mine.push_back(words[at++]);
    if (!known) break;
  }
  return mine;
}

}  // namespace

SplitWords split_zone_words(const ArgTable& zone, const ArgTable& style, const std::string& where,
                            const std::vector<std::string>& words) {
  SplitWords split;
  for (std::size_t at = 0; at < words.size();) {
    if (words[at] != kZone) {
      split.others.push_back(words[at++]);
      continue;
    }
    if (++at == words.size()) throw InputError(where + ": zone must be followed by a name");
    const std::string& name = words[at++];
    if (std::ranges::find(split.zones, name, &ZoneWords::name) != split.zones.end())
      throw InputError(where + ": zone '" + name + "' is given twice");
    split.zones.push_back({name, take(zone, style, words, at)});
  }
  return split;
}

ArgValues zone_values(const ArgTable& zone, const std::string& where, const ZoneWords& words,
                      const ArgValues& rock) {
  std::vector<std::string> all = words.words;
  for (const Keyword& keyword : zone.keywords()) {
    bool typed = false;
    for (std::size_t k = 0; k < words.words.size(); k += 2)
      typed = typed || words.words[k] == keyword.name;
    if (!typed) all.insert(all.end(), {keyword.name, number_text(rock.real(keyword.name))});
  }
  return parse_args(zone, where + ": zone '" + words.name + "'", all);
}

}  // namespace muckpile
