// SPDX-License-Identifier: GPL-2.0-or-later
// The terms of a facet that the line between the centres of its blocks does not cross at a right
// angle: what its jump adds to gradient and stress of its blocks, and how these pull at it.
// Scope: pure functions of one facet, one per lane; what they come from stands in leaning_faces.h,
// and so do the letters. Number: double or a simd type; Vector and Matrix: Vec3 and Mat3, or
// VectorOf and MatrixOf of it. SI units.
#pragma once

#include "math/vectors.h"

namespace muckpile {

/// By the transposed matrix.
[[nodiscard]] inline Vec3 turned_back(const Mat3& m, const Vec3& v) { return m.transpose() * v; }
template <class Number>
[[nodiscard, gnu::always_inline]] inline VectorOf<Number> turned_back(const MatrixOf<Number>& m,
                                                                      const VectorOf<Number>& v) {
  return m.back(v);
}

/// m and g of a block at a facet, in the present pose [-].
template <class Vector>
struct LeaningSide {
  Vector opening, lean;
};

/// The part of a jump that strains rock, over its share along the normal; of the traction that
/// comes of it, the same.
template <class Number, class Vector>
struct StrainedPart {
  Number shear_share;  ///< see FacetLean [-]
  Vector normal;

  [[nodiscard, gnu::always_inline]] Vector of(const Vector& v) const {
    return shear_share * v + (1.0 - shear_share) * dot(normal, v) * normal;
  }
};

/// The u of a block that is multiplied by m to its gradient F and by g to E, per volume [-].
/// `area`: of the facet, or of a point, times the share of u that strains the block [m2].
template <class Number, class Vector>
[[nodiscard, gnu::always_inline]] inline Vector opened(const Number& area, const Number& volume,
                                                       const Vector& strained) {
  return area / volume * strained;
}

/// Adds what a facet has opened on its side to F and E of the block.
[[gnu::always_inline]] inline void add_opened(const Vec3& opened, const LeaningSide<Vec3>& side,
                                              Mat3& gradient, Mat3& excess) {
  gradient.noalias() += opened * side.opening.transpose();
  excess.noalias() += opened * side.lean.transpose();
}

/// T of a block [Pa]. `moment`: Q in the present pose, a Mat3 or an expression of one [-].
template <class Moment>
[[nodiscard]] Mat3 leaning_stress(double two_g, const Mat3& gradient, const Moment& moment,
                                  const Mat3& excess) {
  return two_g * (gradient * moment - excess);
}

/// What a block does to a facet: F, and T [Pa], and its 2G [Pa].
template <class Number, class Matrix>
struct LeaningBlock {
  Number two_g;
  Matrix stress, gradient;

  /// Of the whole traction on one side, T m - 2G F g, before its strained part is taken [Pa].
  template <class Vector>
  [[nodiscard, gnu::always_inline]] Vector traction(const LeaningSide<Vector>& side) const {
    const Vector lean = two_g * side.lean;
    return stress * side.opening - gradient * lean;
  }
  /// By which m and g of the facet turn against `jump`, as strained [N/m].
  template <class Vector>
  [[nodiscard, gnu::always_inline]] Vector turning(const LeaningSide<Vector>& side,
                                                   const Vector& jump) const {
    const Vector lean = two_g * side.lean;
    return cross(side.opening, turned_back(stress, jump)) -
           cross(lean, turned_back(gradient, jump));
  }
};
template <class Number, class Matrix>
LeaningBlock(Number, Matrix, Matrix)
    -> LeaningBlock<Number, Matrix>;  // Clang 14 does not deduce it

/// Of both blocks of a facet on it.
template <class Number, class Vector>
class LeaningPull {
 public:
  [[gnu::always_inline]] LeaningPull(const StrainedPart<Number, Vector>& part, const Vector& jump)
      : part_(part), jump_(jump) {}

  /// `share`: of the jump that strains the block [-].
  template <class Matrix>
  [[gnu::always_inline]] void add(const Number& share, const LeaningSide<Vector>& side,
                                  const LeaningBlock<Number, Matrix>& block) {
    traction_ += share * block.traction(side);
    turning_ += share * block.turning(side, jump_);
  }
  /// [Pa]
  [[nodiscard, gnu::always_inline]] Vector traction() const { return part_.of(traction_); }
  /// On each of the two blocks [N m].
  [[nodiscard, gnu::always_inline]] Vector torque(const Number& area) const {
    return Number(-0.5) * area * (turning_ + cross(jump_, traction_));
  }

 private:
  StrainedPart<Number, Vector> part_;
  Vector jump_;  // as strained [m]
  Vector traction_{Vec3(0.0, 0.0, 0.0)}, turning_{Vec3(0.0, 0.0, 0.0)};
};

}  // namespace muckpile
