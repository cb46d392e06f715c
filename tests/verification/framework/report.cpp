// SPDX-License-Identifier: GPL-2.0-or-later
// What a verification case hands in: rows of measured against expected, and curves for plots.
// Scope: see the header.
#include "framework/report.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace muckpile::verification {
namespace {

const char* word(Scale scale) { return scale == Scale::kStraight ? "straight" : "logarithmic"; }

const char* word(CurveStyle style) {
  if (style == CurveStyle::kLine) return "line";
  return style == CurveStyle::kDashed ? "dashed" : "points";
}

}  // namespace

void Report::add(const Quantity& what, double value, double reference, double error,
                 double tolerance, bool pass) {
  rows_.push_back({{"case", what.case_name},
                   {"quantity", what.quantity},
                   {"unit", what.unit},
                   {"value", value},
                   {"reference", reference},
                   {"source", what.source},
                   {"error", error},
                   {"tolerance", tolerance},
                   {"pass", pass}});
}

void Report::relative(const Quantity& what, double value, double reference, double tolerance) {
  const double error = value / reference - 1.0;
  add(what, value, reference, error, tolerance, std::abs(error) <= tolerance);
}

void Report::difference(const Quantity& what, double value, double reference, double tolerance) {
  const double error = value - reference;
  add(what, value, reference, error, tolerance, std::abs(error) <= tolerance);
}

void Report::at_most(const Quantity& what, double value, double bound) {
  add(what, value, 0.0, value, bound, std::abs(value) <= bound);
}

void Report::measured(const Quantity& what, double value) {
  add(what, value, 0.0, 0.0, 0.0, true);
  for (const char* key : {"reference", "error", "tolerance"}) rows_.back()[key] = nullptr;
}

void Report::known_shortfall(const std::string& why) {
  if (!rows_.back()["pass"].get<bool>()) rows_.back()["note"] = why;
}

void Report::curve(const PlotFrame& frame, const PlotCurve& curve) {
  nlohmann::ordered_json points = nlohmann::ordered_json::array();
  for (const Vec2& p : curve.points) points.push_back({p.x(), p.y()});
  curves_.push_back({{"plot", frame.name},
                     {"title", frame.title},
                     {"x_label", frame.x_label},
                     {"y_label", frame.y_label},
                     {"x_scale", word(frame.x_scale)},
                     {"y_scale", word(frame.y_scale)},
                     {"label", curve.label},
                     {"style", word(curve.style)},
                     {"colour", curve.colour},
                     {"points", std::move(points)}});
}

bool Report::acceptable() const {
  for (const auto& row : rows_) {
    if (!row["pass"].get<bool>() && !row.contains("note")) return false;
  }
  return true;
}

void Report::write(const std::filesystem::path& folder, double seconds) const {
  for (const auto& row : rows_) {
    const double error = row["error"].is_null() ? 0.0 : row["error"].get<double>();
    std::printf("%-40s %-34s %14.6g %-8s error %+.3e  %s\n", row["case"].get<std::string>().c_str(),
                row["quantity"].get<std::string>().c_str(), row["value"].get<double>(),
                row["unit"].get<std::string>().c_str(), error,
                row["pass"].get<bool>() ? "ok"
                : row.contains("note")  ? "SHORT, known"
                                        : "FAILED");
  }
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = folder / (name_ + ".json");
  std::ofstream out(path);
  const nlohmann::ordered_json all = {
      {"report", name_}, {"seconds", seconds}, {"rows", rows_}, {"curves", curves_}};
  out << all.dump(1) << '\n';
  if (!out) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace muckpile::verification
