// SPDX-License-Identifier: GPL-2.0-or-later
// Shapes of the stress-wave pulse; equations in the header.
#include "explosive/pulse_shape.h"

#include <algorithm>
#include <cmath>

#include "args/csv_table.h"
#include "args/require.h"

namespace muckpile {
namespace {

bool earlier(double time, const std::pair<double, double>& point) { return time < point.first; }

double shape_of(const PulseTable& table, double time) {
  const auto above = std::upper_bound(table.begin(), table.end(), time, earlier);
  if (above == table.begin() || above == table.end()) return 0.0;
  const auto [t0, s0] = *(above - 1);
  const auto [t1, s1] = *above;
  return s0 + (s1 - s0) * (time - t0) / (t1 - t0);
}

template <class Law>
double shape_of(const Law& law, double time) {
  return law.shape(time);
}

double share_of(const std::pair<double, double>& point) { return point.second; }

}  // namespace

const std::vector<std::pair<std::string, PulseParameters::Kind>>& pulse_kinds() {
  using Kind = PulseParameters::Kind;
  static const std::vector<std::pair<std::string, Kind>> kinds{
      {"starfield", Kind::starfield},   {"jong", Kind::starfield}, {"duvall", Kind::duvall},
      {"triangular", Kind::triangular}, {"itasca", Kind::itasca},  {"table", Kind::table}};
  return kinds;
}

PulseShape::Law PulseShape::law_of(const PulseParameters& p) {
  switch (p.kind) {
    case PulseParameters::Kind::duvall:
      return DuvallPulse(p.rise_time, p.ratio);
    case PulseParameters::Kind::triangular:
      require_positive("rise_time", "s", p.rise_time);
      if (!(p.end_time > p.rise_time)) refuse_value("pulse_end", "> rise_time", "s", p.end_time);
      return TrianglePulse{p.rise_time, p.end_time};
    case PulseParameters::Kind::itasca:
      require_positive("rise_time", "s", p.rise_time);
      require_positive("pulse_half_time", "s", p.half_time);
      return ItascaPulse{p.rise_time, p.half_time};
    case PulseParameters::Kind::table:
      return p.table;
    case PulseParameters::Kind::starfield:
      break;
  }
  return StarfieldPulse(p.rise_time);
}

DuvallPulse::DuvallPulse(double rise_time, double ratio) {
  require_positive("rise_time", "s", rise_time);
  if (!(std::isfinite(ratio) && ratio > 1.0)) refuse_value("pulse_ratio", "> 1", "", ratio);
  slow_ = std::log(ratio) / ((ratio - 1.0) * rise_time);
  fast_ = ratio * slow_;
  scale_ = 1.0 / (std::exp(-slow_ * rise_time) - std::exp(-fast_ * rise_time));
}

double DuvallPulse::shape(double time) const {
  return time <= 0.0 ? 0.0 : scale_ * (std::exp(-slow_ * time) - std::exp(-fast_ * time));
}

double TrianglePulse::shape(double time) const {
  if (time <= 0.0 || time >= end_time) return 0.0;
  return time < rise_time ? time / rise_time : (end_time - time) / (end_time - rise_time);
}

double ItascaPulse::shape(double time) const {
  if (time <= 0.0) return 0.0;
  return time < rise_time ? time / rise_time : std::exp2(-(time - rise_time) / half_time);
}

PulseTable read_pulse_table(const std::string& path) {
  const CsvTable csv = CsvTable::read(path);
  csv.require_known_columns({"time_s", "share"});
  const size_t time = csv.column("time_s"), share = csv.column("share");
  PulseTable table;
  for (size_t row = 0; row < csv.rows(); ++row) {
    const std::pair point{csv.number(row, time), csv.number(row, share)};
    if (point.first < (table.empty() ? 0.0 : std::nextafter(table.back().first, HUGE_VAL))) {
      throw InputError(csv.where(row) + "time_s must grow from 0 s on, got '" +
                       std::string(csv.word(row, time)) + "'");
    }
    if (point.second < 0.0) {
      throw InputError(csv.where(row) + "share must be >= 0, got '" +
                       std::string(csv.word(row, share)) + "'");
    }
    table.push_back(point);
  }
  if (table.size() < 2 || table.back().second != 0.0 ||
      std::ranges::max(table, {}, share_of).second <= 0.0) {
    throw InputError(path + ": needs two or more rows, a share above 0 and a last share of 0");
  }
  return table;
}

PulseShape::PulseShape(const PulseParameters& parameters)
    : law_(law_of(parameters)), rise_time_(parameters.rise_time) {
  if (parameters.kind != PulseParameters::Kind::table) return;
  rise_time_ = std::ranges::max_element(parameters.table, {}, share_of)->first;
}

double PulseShape::shape(double time) const {
  return std::visit([time](const auto& law) { return shape_of(law, time); }, law_);
}

double PulseShape::ramp(double time) const {
  if (time >= rise_time_) return 1.0;
  const auto* table = std::get_if<PulseTable>(&law_);
  if (table == nullptr) return shape(time);
  double greatest = shape(time);
  for (const auto& [t, share] : *table) {
    if (t <= time) greatest = std::max(greatest, share);
  }
  return greatest / shape(rise_time_);
}

double PulseShape::bound(double time) const {
  const auto* table = std::get_if<PulseTable>(&law_);
  if (table == nullptr) return time < rise_time_ ? 1.0 : shape(time);
  double greatest = shape(time);
  for (const auto& [t, share] : *table) {
    if (t >= time) greatest = std::max(greatest, share);
  }
  return greatest;
}

double PulseShape::end(double share) const {
  double low = rise_time_, high = std::max(2.0 * rise_time_, 1e-9);  // [s]
  while (bound(high) > share) high *= 2.0;
  for (int halving = 0; halving < 60; ++halving) {  // to rounding; bound() never rises
    const double middle = 0.5 * (low + high);
    (bound(middle) > share ? low : high) = middle;
  }
  return high;
}

}  // namespace muckpile
