// SPDX-License-Identifier: GPL-2.0-or-later
// Rosin-Rammler and Swebrec curves fitted to a passing curve.
// Scope: see the header; Eigen's Levenberg-Marquardt minimises.
#include "measure/size_fit.h"

#include <cmath>
#include <functional>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

namespace muckpile {
namespace {

using Parameters = Eigen::Vector2d;
using MakeFit = std::function<SizeFit(const Parameters&)>;

struct Sample {
  double size, passing;
};

std::vector<Sample> samples_of(const std::vector<SizePoint>& curve) {
  std::vector<Sample> samples;
  for (int percent = 5; percent < 100; percent += 5)
    samples.push_back({size_at(curve, 0.01 * percent), 0.01 * percent});
  return samples;
}

// What Eigen's minimiser asks for: differences in mass share as a function of two free parameters.
struct Differences {
  using Scalar = double;
  using InputType = Eigen::VectorXd;
  using ValueType = Eigen::VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  [[nodiscard]] int inputs() const { return 2; }
  [[nodiscard]] int values() const { return static_cast<int>(samples->size()); }
  int operator()(const InputType& x, ValueType& off) const {
    const SizeTarget target = (*make)(Parameters(x)).curve();
    for (size_t k = 0; k < samples->size(); ++k)
      off[static_cast<Eigen::Index>(k)] =
          target.passing((*samples)[k].size) - (*samples)[k].passing;
    return 0;
  }

  const std::vector<Sample>* samples;
  const MakeFit* make;
};

// Least squares give the parameters the covariance s^2 (J^T J)^-1, with J the slopes of the curve
// and s^2 the sum of squares over the samples beyond the two that two parameters take.
void add_errors(SizeFit& best, const std::vector<Sample>& samples) {
  constexpr double kStep = 1e-5;  // of a parameter, as a share of it
  const auto slopes = [&](double SizeFit::*parameter) {
    SizeFit low = best, high = best;
    low.*parameter *= 1.0 - kStep;
    high.*parameter *= 1.0 + kStep;
    const SizeTarget below = low.curve(), above = high.curve();
    Eigen::VectorXd slope(static_cast<Eigen::Index>(samples.size()));
    for (size_t k = 0; k < samples.size(); ++k)
      slope[static_cast<Eigen::Index>(k)] =
          (above.passing(samples[k].size) - below.passing(samples[k].size)) / (2.0 * kStep);
    return slope;
  };
  Eigen::MatrixXd jacobian(static_cast<Eigen::Index>(samples.size()), 2);
  jacobian << slopes(&SizeFit::x50), slopes(&SizeFit::shape);
  const auto count = static_cast<double>(samples.size());
  const Eigen::Matrix2d covariance =
      best.rms * best.rms * count / (count - 2.0) * (jacobian.transpose() * jacobian).inverse();
  best.x50_error = best.x50 * std::sqrt(covariance(0, 0));
  best.shape_error = best.shape * std::sqrt(covariance(1, 1));
}

std::optional<SizeFit> fit(const std::vector<SizePoint>& curve, const MakeFit& make,
                           Eigen::VectorXd start) {
  constexpr double kLeastBreadth = 1.01;
  const std::vector<Sample> samples = samples_of(curve);
  if (!(samples.back().size > kLeastBreadth * samples.front().size)) return std::nullopt;
  const Differences differences{&samples, &make};
  Eigen::NumericalDiff<Differences> with_slopes(differences);
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Differences>> minimiser(with_slopes);
  minimiser.minimize(start);
  Eigen::VectorXd off(differences.values());
  differences(start, off);
  SizeFit best = make(Parameters(start));
  best.rms = std::sqrt(off.squaredNorm() / static_cast<double>(off.size()));
  add_errors(best, samples);
  return best;
}

// Any number stands for a positive one, so that the minimiser cannot leave what the curves allow.
double positive(double free) { return std::exp(std::min(std::max(free, -4.0), 4.0)); }

}  // namespace

SizeTarget SizeFit::curve() const {
  return xmax > 0.0 ? SizeTarget::swebrec(x50, xmax, shape) : SizeTarget::kuz_ram(x50, shape);
}

std::optional<SizeFit> fit_rosin_rammler(const std::vector<SizePoint>& curve) {
  if (curve.empty()) return std::nullopt;
  const double median = size_at(curve, 0.5);
  const MakeFit make = [median](const Parameters& p) {
    return SizeFit{median * positive(p[0]), 0.0, positive(p[1]), 0.0};
  };
  return fit(curve, make, Eigen::Vector2d(0.0, 0.5));
}

std::optional<SizeFit> fit_swebrec(const std::vector<SizePoint>& curve) {
  if (curve.empty()) return std::nullopt;
  const double largest = curve.back().size, median = size_at(curve, 0.5);
  if (!(median < largest)) return std::nullopt;
  // ln(xmax/x50) is positive, so x50 stays below xmax.
  const double span = std::log(largest / median);
  const MakeFit make = [=](const Parameters& p) {
    return SizeFit{largest * std::exp(-span * positive(p[0])), largest, positive(p[1]), 0.0};
  };
  return fit(curve, make, Eigen::Vector2d(0.0, 0.7));
}

}  // namespace muckpile
