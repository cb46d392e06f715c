// SPDX-License-Identifier: GPL-2.0-or-later
// Reading of blast patterns; see the header.
#include "explosive/hole_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "args/input_error.h"
#include "args/numbers.h"
#include "args/suggestion.h"

namespace muckpile {
namespace {

const std::vector<std::string> kColumns = {"hole",
                                           "collar_x_m",
                                           "collar_y_m",
                                           "collar_z_m",
                                           "toe_x_m",
                                           "toe_y_m",
                                           "toe_z_m",
                                           "diameter_m",
                                           "from_m",
                                           "to_m",
                                           "explosive",
                                           "after",
                                           "primer",
                                           "charge_diameter_m",
                                           "charge_length_m",
                                           "surface_delay_s",
                                           "in_hole_delay_s",
                                           "crushed_radius_m",
                                           "explosive_density_kg_m3",
                                           "vod_m_s",
                                           "coupling",
                                           "scatter_s"};
constexpr double kSamePlace = 1e-6;  // [m]

/// How the signal comes to a hole.
struct Signal {
  std::string after;
  double delay = 0.0;
  size_t row = 0;
};

std::string text(const CsvTable& csv, size_t row, const std::string& name) {
  const auto column = csv.find_column(name);
  return column ? std::string(csv.word(row, *column)) : "";
}

/// Nothing if the column is missing or the field empty.
std::optional<double> number(const CsvTable& csv, size_t row, const std::string& name,
                             Range range) {
  if (text(csv, row, name).empty()) return std::nullopt;
  return csv.real(row, csv.column(name), "", range);
}

double required(const CsvTable& csv, size_t row, const std::string& name, Range range) {
  (void)csv.column(name);
  if (const auto value = number(csv, row, name, range)) return *value;
  throw InputError(csv.where(row) + name + " is missing");
}

std::optional<Coupling> coupling(const CsvTable& csv, size_t row) {
  const std::string word = text(csv, row, "coupling");
  if (word.empty()) return std::nullopt;
  for (std::size_t k = 0; k < kCouplings.size(); ++k) {
    if (word == kCouplings[k]) return static_cast<Coupling>(k);
  }
  throw InputError(csv.where(row) + "coupling must be one of air, water, stemming, got '" + word +
                   "'");
}

Vec3 point(const CsvTable& csv, size_t row, const std::string& end) {
  const Range place = place_range();
  return {required(csv, row, end + "_x_m", place), required(csv, row, end + "_y_m", place),
          required(csv, row, end + "_z_m", place)};
}

/// The chamber's ends along the hole.
void place_chamber(const CsvTable& csv, size_t row, Deck& deck) {
  const double length = (deck.hole_toe - deck.hole_collar).norm();
  if (length < kSamePlace) throw InputError(csv.where(row) + "collar and toe are the same point");
  deck.from = number(csv, row, "from_m", Range::non_negative()).value_or(0.0);
  deck.to = number(csv, row, "to_m", Range::positive()).value_or(length);
  if (deck.to > length + kSamePlace) {
    throw InputError(csv.where(row) + "to_m must be <= " + number_text(length) +
                     " m, the length of the hole, got '" + number_text(deck.to) + "'");
  }
  if (deck.to - deck.from < kSamePlace) {
    throw InputError(csv.where(row) + "to_m must be > from_m, got '" + number_text(deck.to) + "'");
  }
  const Vec3 down = (deck.hole_toe - deck.hole_collar) / length;
  deck.collar = deck.hole_collar + deck.from * down;
  deck.toe = deck.hole_collar + deck.to * down;
}

Deck deck_of(const CsvTable& csv, size_t row) {
  Deck deck;
  deck.hole = text(csv, row, "hole");
  if (deck.hole.empty()) throw InputError(csv.where(row) + "hole is missing");
  deck.hole_collar = point(csv, row, "collar");
  deck.hole_toe = point(csv, row, "toe");
  deck.diameter = required(csv, row, "diameter_m", Range::closed(1e-3, 2.0));
  place_chamber(csv, row, deck);
  if (const std::string name = text(csv, row, "explosive"); !name.empty()) deck.explosive = name;
  deck.charge_diameter = number(csv, row, "charge_diameter_m", Range::closed(1e-3, 2.0));
  deck.charge_length = number(csv, row, "charge_length_m", Range::left_open(0.0, 1e3));
  deck.primer = number(csv, row, "primer", Range::closed(0.0, 1.0));
  deck.crushed_radius = number(csv, row, "crushed_radius_m", Range::left_open(0.0, 10.0));
  deck.explosive_density = number(csv, row, "explosive_density_kg_m3", Range::closed(10.0, 1e4));
  deck.detonation_velocity = number(csv, row, "vod_m_s", Range::closed(100.0, 1e5));
  deck.coupling = coupling(csv, row);
  deck.after = text(csv, row, "after");
  deck.surface_delay = number(csv, row, "surface_delay_s", delay_range()).value_or(0.0);
  deck.in_hole_delay = number(csv, row, "in_hole_delay_s", delay_range()).value_or(0.0);
  return deck;
}

void check_decks_of_one_hole(const CsvTable& csv, size_t row, const Deck& before,
                             const Deck& deck) {
  const bool same = (before.hole_collar - deck.hole_collar).norm() < kSamePlace &&
                    (before.hole_toe - deck.hole_toe).norm() < kSamePlace &&
                    before.diameter == deck.diameter;
  if (!same) {
    throw InputError(csv.where(row) + "hole '" + deck.hole +
                     "' must have the collar, toe and diameter of its first row");
  }
  if (deck.from < before.to - kSamePlace && before.from < deck.to - kSamePlace) {
    throw InputError(csv.where(row) + "the deck overlaps another one of hole '" + deck.hole + "'");
  }
}

/// When the signal reaches each hole: follows `after` back to time 0.
class SignalTimes {
 public:
  SignalTimes(const CsvTable& csv, const std::map<std::string, Signal>& signals)
      : csv_(csv), signals_(signals) {}

  double at(const std::string& hole) {
    if (const auto known = times_.find(hole); known != times_.end()) return known->second;
    const Signal& signal = signals_.at(hole);
    if (!on_the_way_.insert(hole).second) {
      throw InputError(csv_.where(signal.row) + "the surface delays of hole '" + hole +
                       "' lead back to itself");
    }
    const double before = signal.after.empty() ? 0.0 : at(known_hole(signal));
    on_the_way_.erase(hole);
    return times_[hole] = before + signal.delay;
  }

 private:
  const std::string& known_hole(const Signal& signal) const {
    if (signals_.count(signal.after) != 0) return signal.after;
    std::vector<std::string> names;
    for (const auto& entry : signals_) names.push_back(entry.first);
    throw InputError(csv_.where(signal.row) + "after names no hole of the table, got '" +
                     signal.after + "'" + did_you_mean(signal.after, names));
  }

  const CsvTable& csv_;
  const std::map<std::string, Signal>& signals_;
  std::map<std::string, double> times_;
  std::set<std::string> on_the_way_;
};

}  // namespace

Range delay_range() { return Range::closed(0.0, 60.0); }
Range place_range() { return Range::closed(-1e7, 1e7); }

HoleTable::HoleTable(const CsvTable& csv) {
  csv.require_known_columns(kColumns);
  std::map<std::string, Signal> signals;
  for (size_t row = 0; row < csv.rows(); ++row) {
    Deck deck = deck_of(csv, row);
    for (const Deck& before : decks_) {
      if (before.hole == deck.hole) check_decks_of_one_hole(csv, row, before, deck);
    }
    const Signal signal{deck.after, deck.surface_delay, row};
    const auto [place, first] = signals.emplace(deck.hole, signal);
    if (!first && (place->second.after != signal.after || place->second.delay != signal.delay)) {
      throw InputError(csv.where(row) + "hole '" + deck.hole +
                       "' must have the surface delay of its first row");
    }
    decks_.push_back(std::move(deck));
  }
  if (decks_.empty()) refuse(csv.name(), "has no row");
  SignalTimes times(csv, signals);
  for (size_t row = 0; row < decks_.size(); ++row) {
    const double scatter = number(csv, row, "scatter_s", Range::closed(-10.0, 10.0)).value_or(0.0);
    const double nominal = times.at(decks_[row].hole) + decks_[row].in_hole_delay;
    decks_[row].firing_time = std::max(0.0, nominal + scatter);
  }
}

std::size_t HoleTable::holes() const {
  std::set<std::string> names;
  for (const Deck& deck : decks_) names.insert(deck.hole);
  return names.size();
}

double HoleTable::last_firing_time() const {
  double last = 0.0;
  for (const Deck& deck : decks_) last = std::max(last, deck.firing_time);
  return last;
}

Eigen::AlignedBox3d HoleTable::chambers() const {
  Eigen::AlignedBox3d box;
  for (const Deck& deck : decks_) box.extend(deck.toe).extend(deck.collar);
  return box;
}

std::vector<Hole> HoleTable::crushed_zones(double ratio) const {
  std::vector<Hole> zones;
  for (const Deck& deck : decks_) {
    zones.push_back(
        {deck.toe, deck.collar, deck.crushed_radius.value_or(0.5 * deck.diameter * ratio)});
  }
  return zones;
}

}  // namespace muckpile
