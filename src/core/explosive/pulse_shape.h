// SPDX-License-Identifier: GPL-2.0-or-later
// The chosen shape of the stress-wave pulse, peak 1.
// Scope: one point of the column, time counted from the arrival of the detonation there.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "explosive/starfield_pulse.h"

namespace muckpile {

/// p/P = xi (e^(-a t) - e^(-b t)), b = ratio a, peak 1 at the rise time: a = ln ratio/((ratio - 1)
/// rise_time) (Duvall 1953). Ratio 2 is Starfield and Pugliese's form; a greater one falls slower.
class DuvallPulse {
 public:
  /// InputError unless rise_time [s] > 0 and ratio > 1.
  DuvallPulse(double rise_time, double ratio);
  [[nodiscard]] double shape(double time) const;  ///< 0 for t <= 0

 private:
  double slow_, fast_;  // [1/s]
  double scale_;
};

/// Straight up to the rise time, straight down to 0 at the end.
struct TrianglePulse {
  double rise_time, end_time;  ///< [s]
  [[nodiscard]] double shape(double time) const;
};

/// Straight up to the rise time, then halved every half_time (Furtney 2016, Itasca's pulse).
struct ItascaPulse {
  double rise_time, half_time;  ///< [s]
  [[nodiscard]] double shape(double time) const;
};

/// Time [s] and share of the peak pressure; straight between, 0 before the first, ends with 0.
using PulseTable = std::vector<std::pair<double, double>>;

/// Columns time_s and share. InputError with file and line: unreadable, times that do not grow, a
/// share below 0 or none above, a last share that is not 0.
[[nodiscard]] PulseTable read_pulse_table(const std::string& path);

struct PulseParameters {
  enum class Kind { starfield, duvall, triangular, itasca, table };
  Kind kind = Kind::starfield;
  double rise_time = 1e-4;  ///< [s]; of a table the time of its peak
  double ratio = 2.0;       ///< duvall
  double end_time = 0.0;    ///< triangular [s]
  double half_time = 0.0;   ///< itasca [s]
  PulseTable table{};
};

/// What a user calls each kind, in the order of the documentation; jong is starfield with this rise
/// time.
[[nodiscard]] const std::vector<std::pair<std::string, PulseParameters::Kind>>& pulse_kinds();

class PulseShape {
 public:
  /// InputError on what the chosen kind cannot use.
  explicit PulseShape(const PulseParameters& parameters);

  /// Pressure over peak pressure, 0 for t <= 0 [s].
  [[nodiscard]] double shape(double time) const;
  /// Greatest shape() so far over the greatest of all: a switch-on without a jump, 1 from the peak
  /// on.
  [[nodiscard]] double ramp(double time) const;
  /// Bound on shape() at that time and later.
  [[nodiscard]] double bound(double time) const;
  /// When no more than a share of the peak is to come [s]; the shape must fall to 0 in time.
  [[nodiscard]] double end(double share) const;
  /// When the peak is reached [s].
  [[nodiscard]] double rise_time() const { return rise_time_; }

 private:
  using Law = std::variant<StarfieldPulse, DuvallPulse, TrianglePulse, ItascaPulse, PulseTable>;
  static Law law_of(const PulseParameters& parameters);

  Law law_;
  double rise_time_;
};

}  // namespace muckpile
