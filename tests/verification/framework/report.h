// SPDX-License-Identifier: GPL-2.0-or-later
// What a verification case hands in: rows of measured against expected, and curves for plots.
// Scope: one case writes one JSON file; make_page joins them into summary.json, plots and the page.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "draw/curve_plot.h"

namespace muckpile::verification {

struct Quantity {
  std::string case_name, quantity, unit;
  std::string source;  ///< of the reference
};

/// Frame of a plot; every case that adds curves to it gives the same one.
struct PlotFrame {
  std::string name;  ///< of the PNG file, without extension
  std::string title, x_label, y_label;
  Scale x_scale = Scale::kStraight, y_scale = Scale::kStraight;
};

class Report {
 public:
  explicit Report(std::string name) : name_(std::move(name)) {}

  /// Passes if |value / reference - 1| <= tolerance.
  void relative(const Quantity& what, double value, double reference, double tolerance);
  /// Passes if |value - reference| <= tolerance: for shares of a whole.
  void difference(const Quantity& what, double value, double reference, double tolerance);
  /// Passes if |value| <= bound: the ideal is 0.
  void at_most(const Quantity& what, double value, double bound);
  /// A figure without a requirement.
  void measured(const Quantity& what, double value);
  /// Says why the last row may fail: it stays in the page as failed, but does not stop the command.
  void known_shortfall(const std::string& why);

  void curve(const PlotFrame& frame, const PlotCurve& curve);

  /// True unless a row without a known shortfall failed.
  [[nodiscard]] bool acceptable() const;
  [[nodiscard]] const nlohmann::ordered_json& rows() const { return rows_; }
  /// Writes `folder`/<name>.json; prints every row.
  void write(const std::filesystem::path& folder, double seconds) const;

 private:
  void add(const Quantity& what, double value, double reference, double error, double tolerance,
           bool pass);

  std::string name_;
  nlohmann::ordered_json rows_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json curves_ = nlohmann::ordered_json::array();
};

}  // namespace muckpile::verification
