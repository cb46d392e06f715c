// SPDX-License-Identifier: GPL-2.0-or-later
// The known word that a mistyped one most likely meant.
// Scope: see suggestion.h. Distance: optimal string alignment (Damerau 1964, each place once).
#include "args/suggestion.h"

#include <algorithm>
#include <numeric>

#include "args/small_letters.h"

namespace muckpile {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> before_last(width), last(width), row(width);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j < width; ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replace, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::string closest_word(const std::string& word, const std::vector<std::string>& known) {
  const std::string small = in_small_letters(word);
  std::string best;
  std::size_t best_distance = 0;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(small, in_small_letters(candidate));
    if (distance > candidate.size() / 3) continue;
    if (!best.empty() && distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  if (!best.empty() || word.size() < 2) return best;
  const auto starts = [&small](const std::string& candidate) {
    return in_small_letters(candidate).starts_with(small);
  };
  if (std::count_if(known.begin(), known.end(), starts) == 1)
    best = *std::find_if(known.begin(), known.end(), starts);
  return best;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  const std::string near = closest_word(word, known);
  return near.empty() ? "" : "; did you mean '" + near + "'?";
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string result;
  for (const std::string& word : words) {
    if (!result.empty()) result += separator;
    result += word;
  }
  return result;
}

}  // namespace muckpile
