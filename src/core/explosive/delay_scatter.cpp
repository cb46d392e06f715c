// SPDX-License-Identifier: GPL-2.0-or-later
// Scatter of detonators; see the header.
#include "explosive/delay_scatter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <vector>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "explosive/hole_table.h"
#include "explosive/table_text.h"
#include "math/random.h"
#include "provenance/fingerprint.h"

namespace muckpile {
namespace {

constexpr const char* kColumn = "scatter_s";
constexpr double kCut = 3.0;  // standard deviations

/// What the surface delays on the way to a hole add up to.
class SignalScatter {
 public:
  SignalScatter(const std::vector<Deck>& decks, const DelayScatter& scatter) : scatter_(scatter) {
    for (const Deck& deck : decks) first_.emplace(deck.hole, &deck);
  }

  double at(const std::string& hole) {
    if (const auto known = sums_.find(hole); known != sums_.end()) return known->second;
    const Deck* deck = first_.at(hole);
    const double before = deck->after.empty() ? 0.0 : at(deck->after);
    const double own =
        scatter_.share * deck->surface_delay * cut_normal(scatter_.seed, draw_of(hole, 0));
    return sums_[hole] = before + own;
  }

 private:
  DelayScatter scatter_;
  std::map<std::string, const Deck*> first_;  // of each hole
  std::map<std::string, double> sums_;        // [s]
};

/// Counted from the bottom of its hole up, from 1.
std::size_t number_of(const Deck& deck, const std::vector<Deck>& decks) {
  const auto depth = [](const Deck& d) { return (d.toe - d.hole_toe).squaredNorm(); };
  return 1 + static_cast<std::size_t>(std::ranges::count_if(decks, [&](const Deck& other) {
           return other.hole == deck.hole && depth(other) < depth(deck);
         }));
}

std::vector<double> sums(const std::vector<Deck>& decks, const DelayScatter& scatter) {
  SignalScatter signals(decks, scatter);
  std::vector<double> all;
  for (const Deck& deck : decks) {
    const std::uint64_t draw = draw_of(deck.hole, number_of(deck, decks));
    const double own = scatter.share * deck.in_hole_delay * cut_normal(scatter.seed, draw);
    all.push_back(signals.at(deck.hole) + own);
  }
  return all;
}

/// Pairs of charges of which the one that should fire first fires last.
std::size_t turned_pairs(const std::vector<Deck>& nominal, const std::vector<Deck>& scattered) {
  std::size_t turned = 0;
  for (std::size_t i = 0; i < nominal.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double before = nominal[i].firing_time - nominal[j].firing_time;
      const double now = scattered[i].firing_time - scattered[j].firing_time;
      if (std::abs(before) > kFinestStep && before * now < 0.0) ++turned;
    }
  }
  return turned;
}

}  // namespace

std::uint64_t draw_of(const std::string& hole, std::size_t deck) {
  return Fingerprint().add(std::string_view(hole)).add(std::uint64_t{deck}).value();
}

double cut_normal(std::uint64_t seed, std::uint64_t index) {
  Random draws(random_bits(seed, index));
  for (;;) {  // Box and Muller (1958)
    const double radius = std::sqrt(-2.0 * std::log(1.0 - draws.uniform()));
    const double value = radius * std::cos(2.0 * std::numbers::pi * draws.uniform());
    if (std::abs(value) <= kCut) return value;
  }
}

ScatteredTable scattered(const std::string& text, const std::string& name,
                         const DelayScatter& scatter) {
  const CsvTable csv = CsvTable::parse(text, name);
  if (csv.find_column(kColumn))
    throw InputError(name + ": has a column scatter_s, so scatter must be 0");
  const HoleTable nominal(csv);
  const std::vector<double> all = sums(nominal.decks(), scatter);
  NewColumn column{kColumn, {}};
  for (const double each : all) column.second.push_back(stepped_text(each));
  ScatteredTable made{with_columns(csv, {column}), ""};
  const HoleTable fired(CsvTable::parse(made.text, name));
  const auto [least, most] = std::minmax_element(all.begin(), all.end());
  std::ostringstream report;
  report.precision(3);
  report << "  delays scatter by " << 100.0 * scatter.share << " % of each, seed " << scatter.seed
         << ": charges fire " << 1e3 * *least << " to " << 1e3 * *most << " ms from their time; "
         << turned_pairs(nominal.decks(), fired.decks()) << " pairs in the other order\n";
  made.report = report.str();
  return made;
}

}  // namespace muckpile
