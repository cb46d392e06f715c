// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/joint for zones of rock: zone NAME keyword value ...
// Scope: which words are a zone's; what a zone leaves out is as in the rock beside the zones.
#pragma once

#include <string>
#include <vector>

#include "args/arg_table.h"
#include "args/parse_args.h"

namespace muckpile {

struct ZoneWords {
  std::string name;
  std::vector<std::string> words;  ///< keywords and values, as typed
};
struct SplitWords {
  std::vector<ZoneWords> zones;     ///< in the order in which they were typed
  std::vector<std::string> others;  ///< words that are no zone's
};

/// Takes every `zone NAME keyword value ...` out of `words`. A zone ends before the first word that
/// is no keyword of `zone` but one of `style`. Throws InputError: no name, a name twice.
[[nodiscard]] SplitWords split_zone_words(const ArgTable& zone, const ArgTable& style,
                                          const std::string& where,
                                          const std::vector<std::string>& words);

/// The numbers of a zone: all keywords of `zone`, whose table has real numbers alone, those that
/// are not typed with the value that they have in `rock`. Throws InputError as parse_args() does.
[[nodiscard]] ArgValues zone_values(const ArgTable& zone, const std::string& where,
                                    const ZoneWords& words, const ArgValues& rock);

}  // namespace muckpile
