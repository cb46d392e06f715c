// SPDX-License-Identifier: GPL-2.0-or-later
// Strength of jointed specimens: prisms of Voronoi blocks in tension and compression under four
// confining pressures, in three sizes.
// Scope: reported, not required: joints at all angles make a specimen weaker than its facets.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "framework/cases.h"
#include "framework/press.h"
#include "framework/rock_samples.h"

namespace muckpile::verification {
namespace {

constexpr std::array kConfinements = {0.0, 2e6, 5e6, 10e6};  // [Pa]
constexpr std::array kSizes = {3, 5, 7};                     // blocks across; twice as high

RockSample prism(int across, unsigned long seed) {
  const double w = across;
  return uniform_rock({w, w, 2.0 * w}, seed);
}

std::string name_of(int across, unsigned long seed) {
  std::string name = "prism, ";
  name += std::to_string(across) + " blocks across, cut " + std::to_string(seed);
  return name;
}

const PlotFrame kEnvelope{"triaxial_envelope", "Strength of prisms of Voronoi blocks",
                          "confining pressure [MPa]", "axial stress at failure [MPa]"};

struct Envelope {
  double cohesion, friction_angle;  ///< [Pa], [deg]
};

/// Line through strength against confinement by least squares, as cohesion and angle.
Envelope fit(const std::vector<Vec2>& points) {
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p / static_cast<double>(points.size());
  double xx = 0.0, xy = 0.0;
  for (const Vec2& p : points) {
    xx += std::pow(p.x() - mean.x(), 2);
    xy += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  const double cone = std::sqrt(xy / xx), unconfined = mean.y() - xy / xx * mean.x();
  return {unconfined / (2.0 * cone),
          2.0 * (std::atan(cone) - 0.25 * std::numbers::pi) * 180.0 / std::numbers::pi};
}

void compression(Report& report, int across, unsigned long seed, int colour) {
  const std::string name = name_of(across, seed);
  PlotCurve strengths{std::to_string(across) + " blocks across", CurveStyle::kPoints, colour, {}};
  if (seed > 1) strengths.label.clear();
  std::vector<Vec2> points;
  for (const double confinement : kConfinements) {
    Press press(prism(across, seed), weak_rock(), confinement);
    const double peak = press.squeeze();
    report.measured({name, "strength at " + spelled(confinement * 1e-6) + " MPa around", "Pa", ""},
                    peak);
    points.emplace_back(confinement, peak);
    strengths.points.emplace_back(1e-6 * confinement, 1e-6 * peak);
    if (seed > 1 || across != kSizes.back()) continue;
    press.squeeze_on();
    report.measured(
        {name, "stress at 3 times the strain, " + spelled(confinement * 1e-6) + " MPa around", "Pa",
         ""},
        press.path().back().y());
    PlotCurve path{spelled(confinement * 1e-6) + " MPa around", CurveStyle::kLine, colour, {}};
    path.colour = static_cast<int>(points.size());
    for (const Vec2& p : press.path()) path.points.emplace_back(1e3 * p.x(), 1e-6 * p.y());
    report.curve(
        {"triaxial_paths", "Compression of a prism, " + std::to_string(across) + " blocks across",
         "axial strain [1e-3]", "axial stress [MPa]"},
        path);
  }
  const Envelope e = fit(points);
  report.measured({name, "cohesion of the fitted envelope", "Pa", ""}, e.cohesion);
  report.measured({name, "friction angle of the fitted envelope", "deg", ""}, e.friction_angle);
  report.curve(kEnvelope, strengths);
}

void compression_of_all(Report& report) {
  int colour = 1;
  for (const int across : kSizes) compression(report, across, 1, colour++);
  colour = 1;
  for (const int across : {kSizes[0], kSizes[1]}) compression(report, across, 2, colour++);
  const double cone =
      std::pow(std::tan(0.25 * std::numbers::pi + 0.5 * weak_rock().friction_angle), 2);
  PlotCurve law{"Mohr-Coulomb with the facets' strength", CurveStyle::kDashed, 0, {}};
  for (const double confinement : kConfinements) {
    law.points.emplace_back(
        1e-6 * confinement,
        1e-6 * (2.0 * weak_rock().cohesion * std::sqrt(cone) + cone * confinement));
  }
  report.curve(kEnvelope, law);
}

void tension(Report& report) {
  for (const int across : kSizes) {
    Press press(prism(across, 1), weak_rock(), 0.0);
    report.measured({name_of(across, 1), "direct tensile strength", "Pa", ""}, press.pull());
  }
}

const Cases kCases = {{"compression", compression_of_all}, {"tension", tension}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("specimens", muckpile::verification::kCases, argc, argv);
}
