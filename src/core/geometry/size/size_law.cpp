// SPDX-License-Identifier: GPL-2.0-or-later
// The size laws and the reader of the two-column size table.
// Scope: validation here, so that a SizeLaw that exists is usable at every distance.
#include "geometry/size/size_law.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string_view>

#include "args/require.h"

namespace muckpile {
namespace {

void require_valid(const SizeLimits& limits) {
  require_positive("size law: smallest block", "m", limits.smallest);
  require_positive("size law: largest block", "m", limits.largest);
  require(
      limits.largest >= limits.smallest,
      "size law: largest block must be >= smallest block (" + number_text(limits.smallest) + " m)",
      limits.largest);
}

double raw_size(const HarriesParameters& p, double distance) {
  return distance <= 0.0 ? 0.0 : harries_spacing(p, distance);
}

double raw_size(const PowerParameters& p, double distance) {
  return p.coefficient * std::pow(distance, p.exponent);
}

double raw_size(const SizeTable& points, double distance) {
  const auto above = std::upper_bound(points.begin(), points.end(), distance,
                                      [](double d, const auto& point) { return d < point.first; });
  if (above == points.begin()) return points.front().second;
  if (above == points.end()) return points.back().second;
  const auto [d0, s0] = *(above - 1);
  const auto [d1, s1] = *above;
  return s0 + (s1 - s0) * (distance - d0) / (d1 - d0);
}

double raw_size(const SizeBands& p, double distance) {
  for (const auto& [radius, size] : p.bands)
    if (distance <= radius) return size;
  return p.bands.back().second;
}

/// Pairs of distance and size.
void require_growing(const SizeTable& pairs, const std::string& what) {
  if (pairs.empty()) throw InputError("size law: the " + what + " must have at least one pair");
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto [distance, size] = pairs[k];
    require(std::isfinite(distance) && distance >= 0.0,
            "size law: " + what + " distance must be >= 0 m", distance);
    require_positive("size law: " + what + " size", "m", size);
    if (k == 0) continue;
    require(distance > pairs[k - 1].first, "size law: " + what + " distances must grow", distance);
    require(size >= pairs[k - 1].second, "size law: " + what + " sizes must not fall with distance",
            size);
  }
}

[[noreturn]] void fail_at(const std::string& name, int line, const std::string& rule,
                          std::string_view text) {
  throw InputError("size table '" + name + "' line " + std::to_string(line) + ": " + rule +
                   ", got '" + std::string(text) + "'");
}

double parse_number(const std::string& word, const std::string& name, int line) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    fail_at(name, line, "a finite number is expected", word);
  }
  return value;
}

void append_pair(SizeTable& points, double distance, double size, const std::string& name,
                 int line) {
  if (distance < 0.0) fail_at(name, line, "distance must be >= 0 m", number_text(distance));
  if (size <= 0.0) fail_at(name, line, "size must be > 0 m", number_text(size));
  if (!points.empty() && distance <= points.back().first) {
    fail_at(name, line, "distance must grow from line to line", number_text(distance));
  }
  if (!points.empty() && size < points.back().second) {
    fail_at(name, line, "size must not fall with distance", number_text(size));
  }
  points.emplace_back(distance, size);
}

}  // namespace

double harries_cracks(const HarriesParameters& p, double distance) {
  if (std::isinf(distance)) return 0.0;  // rock without a charge
  const double ratio = distance / p.hole_radius;
  return p.wall_strain / p.breaking_strain / ratio * std::exp(-p.absorption * ratio);
}

double harries_spacing(const HarriesParameters& p, double distance) {
  return 2.0 * std::numbers::pi * distance / harries_cracks(p, distance);
}

double harries_reach(const HarriesParameters& p) {
  double low = 0.0, high = p.hole_radius * p.wall_strain / p.breaking_strain;  // exact at alpha = 0
  for (int halving = 0; halving < 100; ++halving) {  // the count falls with distance
    const double middle = 0.5 * (low + high);
    (harries_cracks(p, middle) > 1.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

SizeLaw::SizeLaw(Kind kind, const SizeLimits& limits) : kind_(std::move(kind)), limits_(limits) {
  require_valid(limits_);
}

SizeLaw SizeLaw::uniform(double size) { return {PowerParameters{size, 0.0}, {size, size}}; }

SizeLaw SizeLaw::harries(const HarriesParameters& p, const SizeLimits& limits) {
  require_positive("size law: hole radius", "m", p.hole_radius);
  require_positive("size law: wall strain", "", p.wall_strain);
  require_positive("size law: breaking strain", "", p.breaking_strain);
  require(
      p.wall_strain > p.breaking_strain,
      "size law: wall strain must be > breaking strain (" + number_text(p.breaking_strain) + ")",
      p.wall_strain);
  require(std::isfinite(p.absorption) && p.absorption >= 0.0, "size law: absorption must be >= 0",
          p.absorption);
  return {p, limits};
}

SizeLaw SizeLaw::power(const PowerParameters& p, const SizeLimits& limits) {
  require_positive("size law: coefficient", "m^(1-exponent)", p.coefficient);
  require(std::isfinite(p.exponent) && p.exponent >= 0.0, "size law: exponent must be >= 0",
          p.exponent);
  return {p, limits};
}

SizeLaw SizeLaw::table(const SizeTable& points, const SizeLimits& limits) {
  require_growing(points, "table");
  return {points, limits};
}

SizeLaw SizeLaw::bands(const SizeBands& bands, const SizeLimits& limits) {
  require_growing(bands.bands, "bands");
  return {bands, limits};
}

double SizeLaw::raw(double distance) const {
  return std::visit([&](const auto& p) { return raw_size(p, distance); }, kind_);
}

double SizeLaw::at(double distance) const {
  return std::clamp(raw(distance), limits_.smallest, limits_.largest);
}

double SizeLaw::superposed(std::span<const double> distances) const {
  double per_length = 0.0;
  for (const double distance : distances) per_length += 1.0 / raw(distance);
  return std::clamp(1.0 / per_length, limits_.smallest, limits_.largest);
}

SizeTable read_size_table(std::istream& in, const std::string& name) {
  SizeTable points;
  std::string text;
  for (int line = 1; std::getline(in, text); ++line) {
    std::istringstream words(text.substr(0, text.find('#')));
    std::string first, second, extra;
    if (!(words >> first)) continue;
    if (!(words >> second) || (words >> extra)) {
      fail_at(name, line, "two numbers are expected: distance [m] and size [m]", text);
    }
    append_pair(points, parse_number(first, name, line), parse_number(second, name, line), name,
                line);
  }
  if (in.bad()) throw InputError("size table '" + name + "': reading failed");
  if (points.empty()) throw InputError("size table '" + name + "': no pairs found");
  return points;
}

SizeTable read_size_table_file(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw InputError("size table '" + path + "': cannot be opened");
  return read_size_table(in, path);
}

}  // namespace muckpile
