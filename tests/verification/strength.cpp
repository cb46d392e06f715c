// SPDX-License-Identifier: GPL-2.0-or-later
// Strength of facets under known stress: direct shear at five normal stresses, direct tension, and
// what is left after breaking: friction, compression, energy.
// Scope: cuboids, so that the stress is the same in all facets of the section that breaks.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "framework/cases.h"
#include "framework/press.h"
#include "framework/rock_samples.h"

namespace muckpile::verification {
namespace {

constexpr double kTolerance = 0.01;  // of the issue

/// Two cubes of 1 m, one of them moved by hand: the stress between them is even.
class ShearBox {
 public:
  explicit ShearBox(const JointParameters& rock)
      : run_(cuboid_rock({1, 1, 2}, Vec3::Ones()).blocks, {rock},
             [](const Vec3&) { return Wall::free; }) {
    move(Vec3::Zero());
  }

  /// The upper layer stands at `shift` from its start [m]; the work done is summed.
  void move(const Vec3& shift) {
    constexpr double kTime = 1e-6;  // of a move, which no force depends on [s]
    run_.place(1, shift, Vec3::Zero());
    run_.set_motion(1, (shift - shift_) / kTime, Vec3::Zero());
    const Vec3 before = traction_;
    run_.compute(kTime);
    traction_ = -run_.force(1) / kArea;
    work_ += 0.5 * kArea * (before + traction_).dot(shift - shift_);
    shift_ = shift;
  }

  /// Closes the box to this normal stress, tension positive [Pa]: linear until something breaks.
  void press(double normal) {
    constexpr double kProbe = 1e-7;  // [m]
    move({0.0, 0.0, kProbe});
    move({0.0, 0.0, kProbe * normal / traction_.z()});
  }

  [[nodiscard]] double normal() const { return traction_.z(); }
  [[nodiscard]] double shear() const { return traction_.x(); }
  [[nodiscard]] double slip() const { return shift_.x(); }
  [[nodiscard]] double normal_shift() const { return shift_.z(); }
  [[nodiscard]] bool broken() const { return run_.network().broken_count() > 0.0; }
  /// Work less stored energy and losses, over the work [-].
  [[nodiscard]] double energy_missing() const {
    const JointLosses& lost = run_.network().losses();
    return 1.0 - (run_.elastic_energy() + lost.fracture + lost.friction) / work_;
  }

  static constexpr double kArea = 1.0;  // [m2]

 private:
  BlockRun run_;
  Vec3 shift_ = Vec3::Zero(), traction_ = Vec3::Zero();
  double work_ = 0.0;
};

/// A row of four cubes is squeezed to 20 MPa, then its halves slide against each other until the
/// joint between them breaks: what the outer joints' compression changes in that, over it.
double jump_beside_a_slip(const JointParameters& rock) {
  BlockRun run(cuboid_rock({1, 1, 4}, Vec3::Ones()).blocks, {rock},
               [](const Vec3&) { return Wall::free; });
  const auto outer_joint = [&](double squeeze, double slide) {  // compression [Pa]
    for (std::size_t b = 0; b < 4; ++b) {
      const double z = static_cast<double>(b);
      run.place(b, {b < 2 ? 0.0 : slide, 0.0, -squeeze * z}, Vec3::Zero());
    }
    run.compute(0.0);
    return -run.force(0).z();
  };
  const double squeeze = 20e6 * 1e-6 / outer_joint(1e-6, 0.0);  // [m] per joint
  const double start = outer_joint(squeeze, 0.0);
  double slide = 0.0;
  while (run.network().broken_count() == 0.0) outer_joint(squeeze, slide += 1e-5);
  return std::abs(outer_joint(squeeze, slide) / start - 1.0);  // with what broke in the last one
}

const PlotFrame kTorn{"decohesion", "Fracture energy of a bar torn apart in the middle",
                      "block size [m]", "taken by fracture [J/m2]"};

void shear_box(Report& report) {
  constexpr double kEnd = 4e-3;  // slid in all: less than where facets begin to fade [m]
  JointParameters p = weak_rock();
  p.damping = p.contact_damping = 0.0;
  const JointMaterial material(p);
  const double per_jump = 2.0 * material.shear_modulus();  // blocks of 1 m [Pa/m]
  PlotCurve peaks{"peak, measured", CurveStyle::kPoints, 0, {}},
      slides{"after sliding, measured", CurveStyle::kPoints, 1, {}};
  int colour = 0;
  for (const double normal : {-20e6, -10e6, -5e6, 0.0, 1e6}) {
    const std::string name = "shear box, normal stress " + spelled(normal * 1e-6) + " MPa";
    const double strength = p.cohesion - normal * material.tan_friction();
    const double residual = std::max(0.0, -normal) * material.tan_residual_friction();
    ShearBox box(p);
    box.press(normal);
    PlotCurve path{spelled(normal * 1e-6) + " MPa", CurveStyle::kLine, colour++, {}};
    const double fine = 1e-3 * strength / per_jump, coarse = kEnd / 200.0;
    double peak = 0.0, held = 0.0, jump = 0.0;
    while (box.slip() < kEnd) {
      const bool was = box.broken();
      const double before = box.normal();
      box.move({box.slip() + (was ? coarse : fine), 0.0, box.normal_shift()});
      if (!was) peak = std::max(peak, box.shear());
      if (!was && box.broken()) {
        held = box.shear();
        jump = box.normal() - std::min(before, 0.0);
      }
      path.points.emplace_back(1e3 * box.slip(), 1e-6 * box.shear());
    }
    report.relative({name, "peak shear stress", "Pa", "Mohr-Coulomb"}, peak, strength, kTolerance);
    const Quantity left{name, "shear stress after 4 mm of slip", "Pa", "Coulomb"};
    if (residual > 0.0) {
      report.relative(left, box.shear(), residual, kTolerance);
      report.relative({name, "shear stress in the step of breaking", "Pa", "Coulomb"}, held,
                      residual, kTolerance);
    } else {
      report.at_most(left, box.shear(), 1.0);  // [Pa]: of megapascals
    }
    report.at_most({name, "jump of the compression at the break, over the cohesion", "", "0"},
                   jump / p.cohesion, 1e-6);
    report.at_most({name, "work less energy and losses, over the work", "", "0"},
                   box.energy_missing(), kTolerance);
    peaks.points.emplace_back(-1e-6 * normal, 1e-6 * peak);
    slides.points.emplace_back(-1e-6 * normal, 1e-6 * box.shear());
    report.curve({"shear_box", "Direct shear at five normal stresses (tension positive)",
                  "shear displacement [mm]", "shear stress [MPa]"},
                 path);
  }
  report.at_most({"row of four cubes, -20 MPa",
                  "jump of the outer joints' compression as the middle slips, over it", "", "0"},
                 jump_beside_a_slip(p), 1e-6);
  PlotCurve law{"cohesion and friction, given", CurveStyle::kDashed, 0, {}},
      friction{"residual friction, given", CurveStyle::kDashed, 1, {}};
  for (const double normal : {-1.0, 0.0, 20.0}) {
    law.points.emplace_back(normal, 1e-6 * p.cohesion + normal * material.tan_friction());
    friction.points.emplace_back(normal, std::max(0.0, normal) * material.tan_residual_friction());
  }
  const PlotFrame envelope{"shear_envelope", "Direct shear: peak and residual",
                           "compression on the plane [MPa]", "shear stress [MPa]"};
  for (const PlotCurve& curve : {law, friction, peaks, slides}) report.curve(envelope, curve);
}

void tension(Report& report) {
  for (const double nu : {0.0, 0.25, 0.4}) {
    JointParameters p = weak_rock();
    p.poisson_ratio = nu;
    Press press(cuboid_rock({3, 3, 6}, {1.0, 0.8, 1.25}), p, 0.0);
    const double peak = press.pull();
    report.relative({"prism of 3 x 3 x 6 cuboids, nu " + spelled(nu), "direct tensile strength",
                     "Pa", "tension cut-off"},
                    peak, p.tension, kTolerance);
  }
}

/// What the middle joint takes as a bar of 1 m2 and 1 m flies apart at 1 m/s per metre [J], and the
/// worst error of the energy account over the energy at the start.
struct Torn {
  double fracture, account;
};

Torn torn_bar(int blocks, double nu, double toughness) {
  constexpr double kLength = 1.0, kRate = 1.0;  // [m], [1/s]
  JointParameters p = rock(nu);
  p.fracture_energy_tension = toughness;
  const JointClass weak{1e6, 1e30, 0.0, 0.0, p.normal_stiffness, p.shear_stiffness};
  BlockRun run(cuboid_rock({blocks, 1, 1}, {kLength / blocks, 1.0, 1.0}).blocks, {p},
               [](const Vec3&) { return Wall::free; },
               {{weak}, {{Vec3(0.5 * kLength, 0, 0), Vec3::UnitX(), 1}}});
  for (std::size_t b = 0; b < run.size(); ++b)
    run.set_motion(b, kRate * run.start(b).x() * Vec3::UnitX(), Vec3::Zero());
  run.compute();
  const JointLosses& lost = run.network().losses();
  const auto account = [&] {
    return run.kinetic_energy() + run.elastic_energy() + lost.fracture + lost.friction;
  };
  const double start = account(), dt = 0.05 * run.stable_step();
  Torn torn{0.0, 0.0};
  for (double t = 0.0; t < 2e-3; t += dt) {
    run.step(dt);
    torn.account = std::max(torn.account, std::abs(account() / start - 1.0));
  }
  torn.fracture = lost.fracture;
  return torn;
}

void decohesion(Report& report) {
  constexpr double kToughness = 20.0;  // [J/m2]
  PlotCurve given{"given, 20 J/m2", CurveStyle::kDashed, 0, {}};
  int colour = 1;
  for (const double nu : {0.0, 0.25}) {
    for (const double toughness : {0.0, kToughness}) {
      const bool gradual = toughness > 0.0;
      const std::string law = gradual ? "decohesion" : "at once";
      PlotCurve curve{law + ", nu " + spelled(nu), CurveStyle::kPoints, colour++, {}};
      for (const int blocks : {4, 8, 16, 32}) {
        const Torn torn = torn_bar(blocks, nu, toughness);
        const double size = 1.0 / blocks;
        const std::string name =
            "bar torn apart, " + law + ", blocks of " + spelled(size) + " m, nu " + spelled(nu);
        const Quantity taken{name, "taken by fracture", "J/m2", "given fracture energy"};
        if (gradual) {
          // The dilatation of the two blocks goes at once when the decohesion starts: an error
          // that is first order in their size.
          report.relative(taken, torn.fracture, toughness, size > 0.2 ? 0.05 : 0.02);
        } else {
          report.measured(taken, torn.fracture);
        }
        report.at_most({name, "energy account, change over the start", "", "0"}, torn.account,
                       0.005);
        curve.points.emplace_back(size, torn.fracture);
      }
      report.curve(kTorn, curve);
    }
  }
  for (const double size : {1.0 / 32.0, 0.25}) given.points.emplace_back(size, kToughness);
  report.curve(kTorn, given);
}

const Cases kCases = {{"shear_box", shear_box}, {"tension", tension}, {"decohesion", decohesion}};

}  // namespace
}  // namespace muckpile::verification

int main(int argc, char** argv) {
  return muckpile::verification::run_case("strength", muckpile::verification::kCases, argc, argv);
}
