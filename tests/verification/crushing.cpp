// SPDX-License-Identifier: GPL-2.0-or-later
// Cracked rock whose walls crush or do not: prisms between plates under pressure on their sides,
// and cubes sheared without change of volume, beside the strength of the faces and of a rock mass.
// Scope: cohesion and tension are 0. There is no closed form of the strength; what must hold:
// - Without crushing no stress has a scale: the greatest axial stress goes with the confinement.
// - Walls that crush make rock no stronger, and weaker walls none stronger than harder ones.
// - Faces that ride over each other bear more than their friction alone (Mohr-Coulomb).
// - Walls as strong as the rock, or weaker, leave cracked rock no stronger than a rock mass
//   (Hoek-Brown), whose faces hold in part.
// - Sheared, no principal stress becomes a pull; walls stronger than the pressure take nothing.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "framework/cases.h"
#include "framework/press.h"
#include "framework/rock_samples.h"

namespace muckpile::verification {
namespace {

constexpr double kStrength = 100e6;  // of intact rock, UCS [Pa]
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::array kWalls = {kNever, 3.0 * kStrength, kStrength, kStrength / 3.0};  // [Pa]

JointParameters cracked_rock(double wall_strength) {
  JointParameters p = weak_rock();
  p.tension = p.cohesion = 0.0;
  p.friction_angle = p.residual_friction_angle;
  p.wall_strength = wall_strength;
  return p;
}

std::string name_of(double wall_strength) {
  if (wall_strength == kNever) return "walls do not crush";
  std::string name = "walls crush at ";
  return name + spelled(wall_strength * 1e-6) + " MPa";
}

/// Greatest stress of a rock mass at that least stress (Hoek, Carranza-Torres & Corkum 2002), all
/// in Pa: blocky, with rough faces (GSI 60), of granite (m_i 32).
double hoek_brown(double least) {
  constexpr double kGsi = 60.0, kIntact = 32.0;
  const double m = kIntact * std::exp((kGsi - 100.0) / 28.0), s = std::exp((kGsi - 100.0) / 9.0),
               a = 0.5 + (std::exp(-kGsi / 15.0) - std::exp(-20.0 / 3.0)) / 6.0;
  return least + kStrength * std::pow(m * least / kStrength + s, a);
}

/// Of a value above what it may be at most, as a share; 0: it is not.
double excess(double value, double most) { return std::max(0.0, value / most - 1.0); }

double mohr_coulomb(double least) {
  const double cone = std::tan(0.25 * std::numbers::pi + 0.5 * cracked_rock(kNever).friction_angle);
  return cone * cone * least;
}

void triaxial(Report& report) {
  const PlotFrame frame{"cracked_envelope", "Cracked prisms of Voronoi blocks",
                        "confining pressure [MPa]", "greatest axial stress [MPa]"};
  constexpr std::array kConfinements = {5e6, 10e6, 20e6};  // [Pa]
  PlotCurve faces{"Mohr-Coulomb with the faces' friction", CurveStyle::kDashed, 0, {}},
      mass{"Hoek-Brown, GSI 60, m_i 32, UCS 100 MPa", CurveStyle::kLine, 0, {}};
  int colour = 1;
  std::array<double, kConfinements.size()> harder{};  // of the walls before
  for (const double walls : kWalls) {
    PlotCurve curve{name_of(walls), CurveStyle::kPoints, colour++, {}};
    for (std::size_t k = 0; k < kConfinements.size(); ++k) {
      const double confinement = kConfinements[k];
      const std::string name =
          "cracked prism, " + name_of(walls) + ", " + spelled(confinement * 1e-6) + " MPa around";
      Press press(uniform_rock({3.0, 3.0, 6.0}), cracked_rock(walls), confinement);
      press.squeeze();
      press.squeeze_on();
      double most = 0.0;
      for (const Vec2& at : press.path()) most = std::max(most, at.y());
      report.measured({name, "greatest axial stress", "Pa", ""}, most);
      report.measured({name, "over the faces' friction (Mohr-Coulomb)", "", ""},
                      most / mohr_coulomb(confinement));
      report.measured({name, "over a rock mass (Hoek-Brown)", "", ""},
                      most / hoek_brown(confinement));
      report.at_most({name, "short of the faces' friction", "", "Mohr-Coulomb"},
                     excess(mohr_coulomb(confinement), most), 0.0);
      if (walls == kNever)
        report.relative({name, "over confinement, beside that at 5 MPa", "", "no scale of stress"},
                        most * kConfinements[0] / confinement, k == 0 ? most : harder[0], 0.01);
      else
        report.at_most({name, "above that of harder walls", "", ""}, excess(most, harder[k]), 0.01);
      if (walls <= kStrength)
        report.at_most({name, "above a rock mass", "", "Hoek-Brown"},
                       excess(most, hoek_brown(confinement)), 0.02);
      harder[k] = most;
      curve.points.emplace_back(1e-6 * confinement, 1e-6 * most);
    }
    report.curve(frame, curve);
  }
  for (double least = 0.0; least <= 20e6; least += 1e6) {
    faces.points.emplace_back(1e-6 * least, 1e-6 * mohr_coulomb(least));
    mass.points.emplace_back(1e-6 * least, 1e-6 * hoek_brown(least));
  }
  report.curve(frame, faces);
  report.curve(frame, mass);
}

/// A cube between smooth walls: longer along x by half the shear, shorter along z by the same.
class ShearCell {
 public:
  ShearCell(const JointParameters& rock, double pressure)
      : sample_(uniform_rock({4.0, 4.0, 4.0})),
        run_(sample_.blocks, {rock}, walls_with(Vec3::Ones(), sample_.box)) {
    run_.compute();
    dt_ = 0.4 * run_.stable_step();
    const double closer = pressure * (1.0 - 2.0 * rock.poisson_ratio) / rock.youngs_modulus;
    strain(-closer * Mat3::Identity(), kRate);
  }
  /// To that shear [-]; the volume stays.
  void shear(double whole) {
    strain(0.5 * (whole - shear_) * Vec3(1.0, 0.0, -1.0).asDiagonal().toDenseMatrix(), kRate);
    shear_ = whole;
  }
  /// Half the difference of greatest and least compression, the mean and the least one [Pa].
  [[nodiscard]] double deviator() const {
    const Mat3 stress = run_.average_stress();
    return 0.5 * (stress(0, 0) - stress(2, 2));
  }
  [[nodiscard]] double mean() const { return -run_.average_stress().trace() / 3.0; }
  [[nodiscard]] double least() const {
    return -Eigen::SelfAdjointEigenSolver<Mat3>(run_.average_stress()).eigenvalues()[2];
  }
  [[nodiscard]] const JointLosses& lost() const { return run_.network().losses(); }

 private:
  static constexpr double kRate = 0.05;  // [1/s]
  void strain(const Mat3& by, double rate) {
    const double time = by.cwiseAbs().maxCoeff() / rate;
    const int steps = static_cast<int>(time / dt_) + 1;
    const Mat3 per_second = by / (steps * dt_);
    for (std::size_t b = 0; b < run_.size(); ++b)
      run_.set_motion(b, per_second * run_.start(b), Vec3::Zero());
    for (int n = 0; n < steps; ++n) {
      strain_ += by / steps;
      run_.set_average_strain(strain_);
      run_.step(dt_);
    }
  }
  RockSample sample_;
  BlockRun run_;
  Mat3 strain_ = Mat3::Zero();
  double dt_ = 0.0, shear_ = 0.0;
};

void pure_shear(Report& report) {
  constexpr double kStart = 20e6;  // mean compression [Pa]
  const PlotFrame frame{"cracked_shear", "Cracked rock sheared without change of volume",
                        "shear [1e-3]", "shear stress [MPa]"};
  int colour = 1;
  double harder = kNever;  // shear stress of the walls before
  for (const double walls : kWalls) {
    const std::string name = "cracked cube in pure shear, " + name_of(walls);
    ShearCell cell(cracked_rock(walls), kStart);
    PlotCurve curve{name_of(walls), CurveStyle::kLine, colour++, {}};
    for (double shear = 0.0; shear < 8.01e-3; shear += 2.5e-4) {
      cell.shear(shear);
      curve.points.emplace_back(1e3 * shear, 1e-6 * cell.deviator());
    }
    report.measured({name, "shear stress at 8e-3", "Pa", ""}, cell.deviator());
    report.measured({name, "mean compression at 8e-3", "Pa", ""}, cell.mean());
    const double share = cell.lost().crushing / cell.lost().friction;
    report.measured({name, "taken by crushing, over all friction", "", ""}, share);
    report.at_most({name, "above the shear stress of harder walls", "", ""},
                   excess(cell.deviator(), harder), 0.01);
    report.at_most({name, "pull over the mean compression", "", "no tension"},
                   std::max(0.0, -cell.least() / cell.mean()), 0.01);
    if (walls > kStrength)
      report.at_most({name, "taken by crushing below the walls' strength", "", ""}, share, 0.0);
    else
      report.difference({name, "share of crushing between 0.3 and 1", "", ""}, share, 0.65, 0.35);
    harder = cell.deviator();
    report.curve(frame, curve);
  }
}

const Cases kCases = {{"triaxial", triaxial}, {"pure_shear", pure_shear}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("crushing", muckpile::verification::kCases, argc, argv);
}
