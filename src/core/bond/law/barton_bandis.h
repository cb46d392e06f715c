// SPDX-License-Identifier: GPL-2.0-or-later
// Natural joints by Barton and Bandis: hyperbolic closure with first-cycle hysteresis, strength by
// roughness and wall strength, friction that wears off with slip, and the aperture for flow.
// Scope: a value type of parameters, pure functions of one point, one per lane. Formulas and
// sources are in docs/styles/fix_muckpile_joint.md.
//
// Closure: Bandis, Lumsden & Barton (1983), Int. J. Rock Mech. Min. Sci. 20:249-268,
//     pressure = k c / (1 - c/V),
// first loading from c = 0 with k = k_ni, V = V_m; unloading and loading again up to the largest
// closure c_r so far along the hyperbola to the same V_m that starts at what is not recovered, s
// c_r, and meets first loading at c_r:
//     k = k_ni V_m / ((V_m - s c_r)(1 - s)),   V = V_m - s c_r,   from c = s c_r.
// Pulled open, the joint keeps the stiffness k until it breaks.
// In series with rock of stiffness U, squeezed together by w: k x/(1 - x/V) = U (w - x) has
//     x = 2 w V / (b + sqrt(b^2 - 4 w V)),   b = V + w + k V/U.
#pragma once

#include <cmath>
#include <numbers>

#include "bond/law/joint_law.h"

namespace muckpile {

struct JointLawEntry;

struct BartonBandis {
  double initial_stiffness = 0.0;  ///< k_ni [Pa/m]
  double closure_limit = 0.0;      ///< V_m [m]
  double irrecoverable = 0.0;      ///< s, share of the largest closure that stays [-]
  double roughness = 0.0;          ///< JRC [-]
  double wall_strength = 0.0;      ///< JCS [Pa]
  double residual_angle = 0.0;     ///< phi_r [rad]
  double largest_angle = 0.0;      ///< cap of the whole angle [rad]
  double tension = 0.0;            ///< cut-off [Pa]
  double peak_slip = 0.0;          ///< at which shear is at its peak [m]; 0: falls at once
  double initial_aperture = 0.0;   ///< E_0, mechanical, without pressure [m]

  /// A hyperbola: where it starts, its stiffness there, and how far its asymptote is.
  template <class Number>
  struct Branch {
    Number start, stiffness, reach;

    [[nodiscard]] Number pressure(const Number& x) const;
    [[nodiscard]] Number tangent(const Number& x) const;
    [[nodiscard]] Number energy(const Number& x) const;
    /// x where the joint in series with rock is squeezed by w.
    [[nodiscard]] Number share(const Number& w, double rock) const;
  };
  template <class Number>
  [[nodiscard]] Branch<Number> loading() const {
    return {0.0, initial_stiffness, closure_limit};
  }
  template <class Number>
  [[nodiscard]] Branch<Number> unloading(const Number& largest) const {
    const Number start = irrecoverable * largest, reach = closure_limit - start;
    return {start, initial_stiffness * closure_limit / (reach * (1.0 - irrecoverable)), reach};
  }

  // As JointLaw has them.
  template <class Number>
  [[nodiscard]] JointClosure<Number> close(const Number& jump, double rock,
                                           const Number& largest) const;
  template <class Number>
  [[nodiscard]] Number jump_at(const Number& pressure, double rock, const Number& largest) const;
  template <class Number>
  [[nodiscard]] Number stored(const Number& closure, const Number& largest) const {
    const Branch<Number> branch = unloading(largest);
    return branch.energy(closure - branch.start);
  }
  template <class Number>
  [[nodiscard]] Number taken(const Number& largest) const {
    return loading<Number>().energy(largest) - stored(largest, largest);
  }
  /// tau = s tan(JRC log10(JCS/s) + phi_r), s = the pressure, and beside it the tension that the
  /// joint can bear.
  template <class Number>
  [[nodiscard]] auto fails(const Number& normal, const Number& shear_squared,
                           const StrengthFactors<Number>& factors = {}) const {
    using std::max;
    const Number bears = factors.tension * tension;
    const Number pressed = max(bears - normal, Number(0.0));
    const Number shear = pressed * tan_angle(pressed, Number(roughness));
    return normal > bears || shear_squared > shear * shear;
  }
  template <class Number>
  [[nodiscard]] Number friction(const Number& pressure, const Number& slip) const {
    return tan_angle(pressure, mobilised(slip));
  }
  /// JRC after slip beyond the peak: JRC (peak / (peak + slip))^0.381, Asadollahi & Tonon (2010).
  template <class Number>
  [[nodiscard]] Number mobilised(const Number& slip) const;
  /// Of the whole angle under that pressure with that roughness.
  template <class Number>
  [[nodiscard]] Number tan_angle(const Number& pressure, const Number& rough) const;
  /// E = E_0 - closure, and e = E^2 / JRC^2.5 in um, at most E (Barton, Bandis & Bakhtar 1985).
  [[nodiscard]] JointApertures apertures(double closure) const;
  [[nodiscard]] BartonBandis softened(double factor) const;
};

/// The class of a joint with that law; `shear_stiffness` of the joint alone [Pa/m; infinite:
/// rigid].
[[nodiscard]] JointClass barton_bandis_class(const BartonBandis& law, double shear_stiffness);
[[nodiscard]] JointLawEntry barton_bandis_entry();

/// E_0 = JRC/5 (0.2 UCS/JCS - 0.1) mm (Bandis, Lumsden & Barton 1983) [m].
[[nodiscard]] double barton_bandis_aperture(double roughness, double wall_strength,
                                            double compressive_strength);

template <class Number>
Number BartonBandis::Branch<Number>::pressure(const Number& x) const {
  using std::max;
  return stiffness * x * reach / (reach - max(x, Number(0.0)));
}

template <class Number>
Number BartonBandis::Branch<Number>::tangent(const Number& x) const {
  using std::max;
  const Number left = reach / (reach - max(x, Number(0.0)));
  return stiffness * left * left;
}

template <class Number>
Number BartonBandis::Branch<Number>::energy(const Number& x) const {
  using std::log;
  using std::max;
  constexpr double kSmall = 1e-3;  // the difference of the two terms below is lost in rounding
  const Number y = max(x, Number(0.0)) / reach;
  const Number series = y * y * (1.0 / 2 + y * (1.0 / 3 + y * (1.0 / 4 + y * (1.0 / 5 + y / 6.0))));
  const Number whole = -y - log(1.0 - y);
  const auto small = y < kSmall;
  const Number squeezed = stiffness * reach * reach * choose(small, series, whole);
  return choose(x < 0.0, Number(0.5 * stiffness * x * x), squeezed);
}

template <class Number>
Number BartonBandis::Branch<Number>::share(const Number& w, double rock) const {
  using std::max;
  using std::sqrt;
  const Number squeezed = max(w, Number(0.0));
  const Number b = reach + squeezed + stiffness * reach / rock;
  const Number root = sqrt(max(b * b - 4.0 * squeezed * reach, Number(0.0)));
  const Number pulled = rock / (rock + stiffness) * w;
  return choose(w < 0.0, pulled, Number(2.0 * squeezed * reach / (b + root)));
}

template <class Number>
JointClosure<Number> BartonBandis::close(const Number& jump, double rock,
                                         const Number& largest) const {
  const Branch<Number> first = loading<Number>(), again = unloading(largest);
  const Number back = again.share(jump - again.start, rock), on = first.share(jump, rock);
  const auto further = back + again.start > largest;
  const Number tangent = choose(further, first.tangent(on), again.tangent(back));
  return {choose(further, on, Number(back + again.start)),
          choose(further, first.pressure(on), again.pressure(back)), rock / (rock + tangent)};
}

template <class Number>
Number BartonBandis::jump_at(const Number& pressure, double rock, const Number& largest) const {
  const Branch<Number> first = loading<Number>(), again = unloading(largest);
  using std::max;
  const Number squeezed = max(pressure, Number(0.0));
  const auto closure = [&](const Branch<Number>& branch) {
    return Number(branch.start +
                  pressure * branch.reach / (branch.stiffness * branch.reach + squeezed));
  };
  const auto further = closure(again) > largest;
  return choose(further, closure(first), closure(again)) + pressure / rock;
}

template <class Number>
Number BartonBandis::mobilised(const Number& slip) const {
  using std::pow;
  constexpr double kWear = 0.381;
  if (peak_slip == 0.0) return 0.0;
  return roughness * pow(peak_slip / (peak_slip + slip), Number(kWear));
}

template <class Number>
Number BartonBandis::tan_angle(const Number& pressure, const Number& rough) const {
  using std::log10;
  using std::max;
  using std::min;
  using std::tan;
  constexpr double kDegree = std::numbers::pi / 180.0, kLeast = 1e-300;
  const Number ratio = max(wall_strength / max(pressure, Number(kLeast)), Number(1.0));
  return tan(min(residual_angle + kDegree * rough * log10(ratio), Number(largest_angle)));
}

}  // namespace muckpile
