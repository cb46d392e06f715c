// SPDX-License-Identifier: GPL-2.0-or-later
// Equilibrium of a block run under its average strain and the pressures on its faces.
// Scope: see the header.
#include "framework/static_solver.h"

#include <algorithm>
#include <cmath>

namespace muckpile::verification {
namespace {

using Vector = Eigen::VectorXd;

/// Unknowns: displacement and rotation of every block, in turn.
class LinearRock {
 public:
  LinearRock(BlockRun& run, double strain) : run_(run), strain_(strain), diagonal_(unknowns()) {
    load_ = forces(Vector::Zero(unknowns()));
    add_diagonal();
  }

  [[nodiscard]] Eigen::Index unknowns() const { return 6 * static_cast<Eigen::Index>(run_.size()); }
  [[nodiscard]] const Vector& load() const { return load_; }
  [[nodiscard]] Vector precondition(const Vector& r) const { return r.cwiseQuotient(diagonal_); }

  /// Stiffness times x. Forces are linear only for short displacements.
  [[nodiscard]] Vector times(const Vector& x) {
    double longest = 0.0;
    for (std::size_t b = 0; b < run_.size(); ++b) {
      const auto at = 6 * static_cast<Eigen::Index>(b);
      const double size = std::cbrt(run_.volume(b));
      longest = std::max({longest, x.segment<3>(at).norm() / size, x.segment<3>(at + 3).norm()});
    }
    if (longest == 0.0) return Vector::Zero(unknowns());
    const double scale = strain_ / longest;
    return (load_ - forces(scale * x)) / scale;
  }

  [[nodiscard]] Vector forces(const Vector& x) {
    for (std::size_t b = 0; b < run_.size(); ++b) {
      const auto at = 6 * static_cast<Eigen::Index>(b);
      run_.place(b, x.segment<3>(at), x.segment<3>(at + 3));
    }
    run_.compute();
    Vector out(unknowns());
    for (std::size_t b = 0; b < run_.size(); ++b) {
      const auto at = 6 * static_cast<Eigen::Index>(b);
      out.segment<3>(at) = run_.force(b);
      out.segment<3>(at + 3) = run_.torque(b);
    }
    return out;
  }

 private:
  void add_diagonal() {
    diagonal_.setZero();
    const FacetNetwork& network = run_.network();
    for (const Facet& facet : network.facets()) {
      const bool grounded = facet.kind != FacetKind::joint;
      const double h =
          facet.normal.dot(facet.arm_i) - (grounded ? 0.0 : facet.normal.dot(facet.arm_j));
      const JointMaterial& rock = network.material();  // along the normal, of joint and rock
      const double k = facet.area * rock.facet_stiffness(h).rock_share * rock.p_wave_modulus() / h;
      add(facet.i, k, facet.arm_i);
      if (!grounded) add(facet.j, k, facet.arm_j);
    }
  }

  void add(int block, double k, const Vec3& arm) {
    if (block >= static_cast<int>(run_.size())) return;  // an image
    const Eigen::Index at = 6 * block;
    diagonal_.segment<3>(at).array() += k;
    diagonal_.segment<3>(at + 3).array() += k * arm.squaredNorm();
  }

  BlockRun& run_;
  double strain_;
  Vector load_, diagonal_;
};

}  // namespace

Equilibrium settle(BlockRun& run, double strain, double tolerance) {
  constexpr int kMostIterations = 5000;
  LinearRock rock(run, strain);
  Vector x = Vector::Zero(rock.unknowns()), residual = rock.load();
  Vector preconditioned = rock.precondition(residual), direction = preconditioned;
  const double first = residual.lpNorm<Eigen::Infinity>();
  double size = residual.dot(preconditioned);
  int k = 0;
  while (k < kMostIterations && residual.lpNorm<Eigen::Infinity>() > tolerance * first) {
    const Vector stiff = rock.times(direction);
    const double step = size / direction.dot(stiff);
    x += step * direction;
    residual -= step * stiff;
    preconditioned = rock.precondition(residual);
    const double next = residual.dot(preconditioned);
    direction = preconditioned + next / size * direction;
    size = next;
    ++k;
  }
  const double left = rock.forces(x).lpNorm<Eigen::Infinity>();
  return {k, left / first};
}

}  // namespace muckpile::verification
