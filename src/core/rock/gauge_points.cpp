// SPDX-License-Identifier: GPL-2.0-or-later
// The words of fix muckpile/gauges.
// Scope: see the header.
#include "rock/gauge_points.h"

#include <algorithm>
#include <limits>

#include "args/input_error.h"
#include "args/numbers.h"

namespace muckpile {
namespace {

constexpr double kFarthest = 1e5;  // [m]
constexpr long kMost = 10000;      // gauges, and on one line

Vec3 point_of(const std::vector<std::string>& words, std::size_t first, const std::string& where,
              const std::string& keyword) {
  Vec3 point;
  for (std::size_t d = 0; d < 3; ++d)
    point[static_cast<Eigen::Index>(d)] =
        parse_real(where, keyword, words[first + d], "m", Range::closed(-kFarthest, kFarthest));
  return point;
}

void add_line(const std::vector<std::string>& words, const std::string& where,
              std::vector<Vec3>& points) {
  const Vec3 from = point_of(words, 0, where, "line"), to = point_of(words, 3, where, "line");
  const long count =
      parse_integer(where, "number of points of line", words[6], "", Range::closed(2, kMost));
  if (from == to)
    throw InputError(where + ": line must have two different ends, got '" + place_text(from) +
                     "' twice; give a single point as gauge");
  for (long k = 0; k < count; ++k)
    points.push_back(from + static_cast<double>(k) / static_cast<double>(count - 1) * (to - from));
}

void require_apart(const std::vector<Vec3>& points, const std::string& where) {
  std::vector<Vec3> sorted = points;
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::ranges::sort(sorted, before);
  const auto twice = std::ranges::adjacent_find(sorted);
  if (twice != sorted.end())
    throw InputError(where + ": gauges must be at different places, got two at '" +
                     place_text(*twice) + "' m; leave one out");
}

void read_pace(GaugeOptions& options, const ArgValues& values, const std::string& where) {
  options.every = values.integer("every");
  options.interval = values.real("interval");
  if ((options.every > 0) == (options.interval > 0.0))
    throw InputError(where + ": needs either every [steps] or interval [s], got " +
                     (options.every > 0 ? "both" : "none of them"));
}

}  // namespace

std::string place_text(const Vec3& p) {
  return number_text(p.x()) + " " + number_text(p.y()) + " " + number_text(p.z());
}

const ArgTable& gauge_table() {
  static const ArgTable args =
      ArgTable("fix muckpile/gauges")
          .integer("every", "steps", Range::closed(0, std::numeric_limits<int>::max()), 0,
                   "between samples; 0: by `interval`")
          .real("interval", "s", Range::closed(0.0, 1e6), 0.0,
                "between samples: one is taken at the first step at or after each multiple; 0: by "
                "`every`")
          .word("directory", {}, std::nullopt, "where the file goes")
          .word("file", {}, "gauges.csv",
                "name of the file, which begins with gauges and ends in .csv")
          .group("gauge", 3, 3, true, "x y z of a point in the rock, at the start [m]")
          .group("line", 7, 7, true,
                 "x y z, x y z, N: N points at equal distances from the first point to the second "
                 "[m]; numbered after all single ones");
  return args;
}

GaugeOptions gauge_options(const ArgValues& values, const std::string& where) {
  GaugeOptions options;
  read_pace(options, values, where);
  options.directory = values.word("directory");
  options.file = values.word("file");
  if (options.file.find('/') != std::string::npos || !options.file.starts_with("gauges") ||
      !options.file.ends_with(".csv"))
    throw InputError(where +
                     ": file must be a name that begins with gauges and ends in .csv, in the "
                     "directory, got '" +
                     options.file + "'");
  for (const auto& words : values.groups("gauge"))
    options.points.push_back(point_of(words, 0, where, "gauge"));
  for (const auto& words : values.groups("line")) add_line(words, where, options.points);
  if (options.points.empty())
    throw InputError(where + ": needs a gauge or a line of them, got none");
  if (options.points.size() > static_cast<std::size_t>(kMost))
    throw InputError(where + ": gauges must be at most " + std::to_string(kMost) + ", got '" +
                     std::to_string(options.points.size()) + "'");
  require_apart(options.points, where);
  return options;
}

}  // namespace muckpile
