// SPDX-License-Identifier: GPL-2.0-or-later
// Largest eigenvalue of the mass-scaled stiffness by Lanczos' method, and the step from it.
// Scope: see the header.
#include "bond/linear/stable_step.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>

#include "math/random.h"

namespace muckpile {
namespace {

/// A number in (0, 1) from a block's tag and a counter: the same on any number of ranks.
double random_unit(std::uint64_t tag, std::uint64_t count) {
  const std::uint64_t bits = random_bits(0, tag * 64 + count);
  return (static_cast<double>(bits >> 11) + 0.5) * 0x1.0p-53;
}

/// Normal deviate by Box and Muller: the start must favour no direction.
double random_normal(std::uint64_t tag, std::uint64_t count) {
  return std::sqrt(-2.0 * std::log(random_unit(tag, 2 * count))) *
         std::cos(2.0 * std::numbers::pi * random_unit(tag, 2 * count + 1));
}

constexpr double kLanczosDoubt = 0.8 * kStepDoubt, kDashpotDoubt = 0.2 * kStepDoubt;

int products_needed(double unknowns) {
  const double missing =
      1.0 - (1.0 - kLanczosDoubt) * (1.0 - kLanczosDoubt);  // share of the eigenvalue
  const double exponent = std::log(1.648 * std::sqrt(unknowns) / kStepRisk);
  return static_cast<int>(std::ceil(0.5 * (exponent / std::sqrt(missing) + 1.0)));
}

/// M^(-1/2) K M^(-1/2) of the owned blocks.
class ScaledStiffness {
 public:
  ScaledStiffness(const FacetNetwork& network, std::span<const Mat3> inertia, const RankTeam& team)
      : team_(team) {
    for (std::size_t b = 0; b < inertia.size(); ++b) {
      const double mass = network.blocks()[b].mass;
      light_.push_back(mass > 0.0 ? 1.0 / std::sqrt(mass) : 0.0);  // 0: no block of ours
      agile_.push_back(Eigen::SelfAdjointEigenSolver<Mat3>(inertia[b]).operatorInverseSqrt());
      tags_.push_back(static_cast<std::uint64_t>(network.blocks()[b].tag));
    }
    motion_.resize(6 * static_cast<std::size_t>(std::max(network.ground(), 0)));
  }
  [[nodiscard]] std::size_t size() const { return 6 * light_.size(); }
  [[nodiscard]] const RankTeam& team() const { return team_; }

  [[nodiscard]] Eigen::VectorXd random() const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(size()));
    for (std::size_t k = 0; k < size(); ++k)
      x[static_cast<Eigen::Index>(k)] = random_normal(tags_[k / 6], k % 6);
    return x;
  }
  [[nodiscard]] double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return team_.sum(std::inner_product(a.begin(), a.end(), b.begin(), 0.0));
  }
  void apply(LinearNetwork& stiffness, const Eigen::VectorXd& x, Eigen::VectorXd& out) {
    scale(x.data(), motion_.data());
    out.resize(x.size());
    stiffness.balance(motion_, {out.data(), size()}, team_);
    scale(out.data(), out.data());
  }

 private:
  void scale(const double* from, double* to) const {
    for (std::size_t b = 0; b < light_.size(); ++b, from += 6, to += 6) {
      const Vec3 shift = light_[b] * Vec3(from), turn = agile_[b] * Vec3(from + 3);
      std::copy_n(shift.data(), 3, to);
      std::copy_n(turn.data(), 3, to + 3);
    }
  }

  const RankTeam& team_;
  std::vector<double> light_;  // m^(-1/2)
  std::vector<Mat3> agile_;    // I^(-1/2)
  std::vector<std::uint64_t> tags_;
  std::vector<double> motion_;
};

/// Largest eigenvalue [1/s2]; adds the products that it took.
double largest_eigenvalue(ScaledStiffness& scaled, LinearNetwork&& stiffness, int most,
                          int& products) {
  Eigen::VectorXd now = scaled.random(), before = Eigen::VectorXd::Zero(now.size()), next;
  now /= std::sqrt(scaled.dot(now, now));
  std::vector<double> diagonal, beside;
  for (int k = 0; k < most; ++k) {
    scaled.apply(stiffness, now, next);
    diagonal.push_back(scaled.dot(now, next));
    next -= diagonal.back() * now;
    if (k > 0) next -= beside.back() * before;
    const double length = std::sqrt(scaled.dot(next, next));
    if (k + 1 == most || length <= 1e-12 * diagonal.front()) break;  // all that the start contains
    beside.push_back(length);
    before.swap(now);
    now = next / length;
  }
  products += static_cast<int>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> small;
  small.computeFromTridiagonal(
      Eigen::Map<Eigen::VectorXd>(diagonal.data(), static_cast<Eigen::Index>(diagonal.size())),
      Eigen::Map<Eigen::VectorXd>(beside.data(), static_cast<Eigen::Index>(diagonal.size()) - 1),
      Eigen::EigenvaluesOnly);
  return *(small.eigenvalues().end() - 1);  // in rising order
}

class StepSearch {
 public:
  StepSearch(const FacetNetwork& network, std::span<const Mat3> inertia, const RankTeam& team)
      : network_(network), scaled_(network, inertia, team) {
    const double unknowns = team.sum(static_cast<double>(scaled_.size()));
    if (unknowns > 0.0)
      most_ = static_cast<int>(std::min<double>(products_needed(unknowns), unknowns));
    // A dashpot of share d of rho c_P is at most 2 d of its facet's stiffness at the limit, and the
    // step goes with the square root: an error in the step assumed for the dashpots shrinks by d.
    const JointLaws& laws = network.tables().laws();
    for (std::size_t zone = 0; zone < laws.zones(); ++zone) {
      const JointParameters& p = laws.rock(zone).parameters();
      shrink_ = std::max(shrink_, std::min(1.0, 2.0 * std::max(p.damping, p.contact_damping)));
    }
  }

  [[nodiscard]] double longest(BreakView view, double guess) {
    constexpr int kGuessProducts = 4, kMostRounds = 50;
    if (most_ == 0) return std::numeric_limits<double>::infinity();  // no block anywhere
    if (shrink_ == 0.0) return step_of(view, 0.0, most_);
    double step = guess > 0.0 && std::isfinite(guess) ? guess : step_of(view, 0.0, kGuessProducts);
    for (int round = 0; round < kMostRounds && std::isfinite(step); ++round) {
      const double before = step;
      step = step_of(view, 2.0 / before, most_);
      if (shrink_ * std::abs(step - before) <= kDashpotDoubt * step) break;
    }
    return step;
  }
  [[nodiscard]] int products() const { return products_; }

 private:
  double step_of(BreakView view, double damping_rate, int products) {
    const double eigenvalue = largest_eigenvalue(
        scaled_, LinearNetwork(network_, view, damping_rate), std::min(products, most_), products_);
    return eigenvalue > 0.0 ? 2.0 / std::sqrt(eigenvalue) : std::numeric_limits<double>::infinity();
  }

  const FacetNetwork& network_;
  ScaledStiffness scaled_;
  int most_ = 0, products_ = 0;
  double shrink_ = 0.0;
};

}  // namespace

StepBound stable_step(const FacetNetwork& network, std::span<const Mat3> inertia, Breaking breaking,
                      const RankTeam& team, double guess) {
  StepSearch search(network, inertia, team);
  double step = search.longest(BreakView::as_it_is, guess);
  if (breaking == Breaking::possible)
    step = std::min(step, search.longest(BreakView::all_broken, guess));
  return {(1.0 - kStepDoubt) * step, search.products()};
}

}  // namespace muckpile
