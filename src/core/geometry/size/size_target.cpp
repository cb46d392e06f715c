// SPDX-License-Identifier: GPL-2.0-or-later
// Size curves and the law of distance that gives them; see the header.
#include "geometry/size/size_target.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "args/require.h"
#include "geometry/cut/ground.h"

namespace muckpile {
namespace {

/// Sizes in order with the mass share up to and including each.
std::vector<std::pair<double, double>> passing_curve(const std::vector<Block>& blocks) {
  std::vector<std::pair<double, double>> curve;
  double all = 0.0;
  for (const Block& block : blocks) {
    curve.emplace_back(std::cbrt(block.mass.volume), block.mass.volume);
    all += block.mass.volume;
  }
  std::sort(curve.begin(), curve.end());
  double below = 0.0;
  for (auto& [size, share] : curve) {
    below += share;
    share = below / all;
  }
  return curve;
}

double size_below(const std::vector<std::pair<double, double>>& curve, double share) {
  const auto at = std::lower_bound(curve.begin(), curve.end(), share,
                                   [](const auto& point, double s) { return point.second < s; });
  return at == curve.end() ? curve.back().first : at->first;
}

/// Distances of evenly spread points of the rock from the nearest charge, in order.
std::vector<double> rock_distances(const TessellationOptions& options) {
  constexpr double kPoints = 2e5;
  const Ground ground(options);
  const Vec3 edge = options.hi - options.lo;
  const double step = std::cbrt(edge.prod() / kPoints);
  const Eigen::Vector3i counts = (edge / step).array().ceil().cast<int>();
  std::vector<double> distances;
  for (int i = 0; i < counts.x(); ++i) {
    for (int j = 0; j < counts.y(); ++j) {
      for (int k = 0; k < counts.z(); ++k) {
        const Vec3 share((i + 0.5) / counts.x(), (j + 0.5) / counts.y(), (k + 0.5) / counts.z());
        const Vec3 at = options.lo + share.cwiseProduct(edge);
        if (ground.is_rock(at)) distances.push_back(ground.charge_distance(at));
      }
    }
  }
  if (distances.empty()) throw InputError("size target: the region holds no rock");
  std::sort(distances.begin(), distances.end());
  return distances;
}

constexpr std::size_t kNodes = 64;  // of the law, evenly in mass share

double node_share(std::size_t node) { return (static_cast<double>(node) + 0.5) / kNodes; }

double node_distance(const std::vector<double>& distances, std::size_t node) {
  const auto place =
      static_cast<std::size_t>(node_share(node) * static_cast<double>(distances.size()));
  return distances[std::min(place, distances.size() - 1)];
}

/// Size at each node to a table of distance; sizes are made not to fall, equal distances merged.
SizeTable table_of(const std::vector<double>& sizes, const std::vector<double>& distances) {
  SizeTable table;
  for (std::size_t node = 0; node < kNodes; ++node) {
    const double distance = node_distance(distances, node);
    double size = sizes[node];
    if (!table.empty()) size = std::max(size, table.back().second);
    if (!table.empty() && distance <= table.back().first) continue;
    table.emplace_back(distance, size);
  }
  return table;
}

/// Every size times target over achieved size, as a mean over the nodes within half a block of
/// that size: blocks average the law over themselves, so that a finer correction comes back as
/// clumps of equal blocks, and the rounds swing instead of settling.
void correct(std::vector<double>& sizes, const SizeTarget& target,
             const std::vector<std::pair<double, double>>& curve,
             const std::vector<double>& distances) {
  std::vector<double> log_ratio(kNodes), factor(kNodes);
  for (std::size_t node = 0; node < kNodes; ++node) {
    const double share = node_share(node);
    log_ratio[node] = std::log(target.size_at(share) / size_below(curve, share));
  }
  for (std::size_t node = 0; node < kNodes; ++node) {
    const double here = node_distance(distances, node);
    double sum = 0.0, count = 0.0;
    for (std::size_t other = 0; other < kNodes; ++other) {
      if (std::abs(node_distance(distances, other) - here) > 0.5 * sizes[node]) continue;
      sum += log_ratio[other];
      count += 1.0;
    }
    factor[node] = std::exp(sum / count);
  }
  for (std::size_t node = 0; node < kNodes; ++node) sizes[node] *= factor[node];
}

/// 1 where P20, P50, P80 or the curve is as far off as good() allows.
double deviation(const SizeComparison& comparison) {
  double worst = comparison.greatest_difference / 0.03;
  for (const int percent : {20, 50, 80}) {
    const auto& point = comparison.at(percent);
    worst = std::max(worst, std::abs(point.achieved / point.target - 1.0) / 0.05);
  }
  return worst;
}

}  // namespace

SizeTarget::SizeTarget(double x50, double xmax, double exponent)
    : x50_(x50), xmax_(xmax), exponent_(exponent) {
  require(std::isfinite(x50) && x50 > 0.0, "size target: x50 must be > 0 m", x50);
  require(std::isfinite(exponent) && exponent > 0.0, "size target: exponent must be > 0", exponent);
}

SizeTarget SizeTarget::kuz_ram(double x50, double n) { return {x50, 0.0, n}; }

SizeTarget SizeTarget::swebrec(double x50, double xmax, double b) {
  require(std::isfinite(xmax) && xmax > x50,
          "size target: xmax must be > x50 (" + number_text(x50) + " m)", xmax);
  return {x50, xmax, b};
}

double SizeTarget::passing(double size) const {
  if (size <= 0.0) return 0.0;
  if (xmax_ == 0.0) return 1.0 - std::exp2(-std::pow(size / x50_, exponent_));
  if (size >= xmax_) return 1.0;
  return 1.0 / (1.0 + std::pow(std::log(xmax_ / size) / std::log(xmax_ / x50_), exponent_));
}

double SizeTarget::size_at(double share) const {
  if (xmax_ == 0.0) return x50_ * std::pow(-std::log2(1.0 - share), 1.0 / exponent_);
  const double ratio = std::pow(1.0 / share - 1.0, 1.0 / exponent_);
  return xmax_ * std::exp(-ratio * std::log(xmax_ / x50_));
}

bool SizeComparison::good() const { return deviation(*this) <= 1.0; }

SizeComparison compare_sizes(const std::vector<Block>& blocks, const SizeTarget& target,
                             const SizeLimits& limits) {
  const auto curve = passing_curve(blocks);
  SizeComparison result;
  for (int percent = 10; percent <= 90; percent += 10) {
    const double share = 0.01 * percent;
    result.points.push_back({share, target.size_at(share), size_below(curve, share)});
  }
  double before = 0.0;
  for (const auto& [size, share] : curve) {
    if (size >= limits.smallest && size <= limits.largest) {
      const double wanted = target.passing(size);
      result.greatest_difference = std::max(
          {result.greatest_difference, std::abs(share - wanted), std::abs(before - wanted)});
    }
    before = share;
  }
  return result;
}

std::string why_missed(const SizeComparison& comparison, const SizeTarget& target,
                       const SizeLimits& limits, double volume) {
  if (comparison.good()) return {};
  constexpr double kShare = 0.03;  // of the mass: as much as the curve may be off
  const auto percent = [](double share) { return number_text(std::round(1e3 * share) / 10.0); };
  std::string why;
  const auto add = [&](const std::string& reason) { why += (why.empty() ? "" : "; ") + reason; };
  const double fine = target.passing(limits.smallest),
               coarse = 1.0 - target.passing(limits.largest);
  if (fine > kShare) add(percent(fine) + " % of the target is finer than block_min");
  if (coarse > kShare) add(percent(coarse) + " % of the target is coarser than block_max");
  const double one = std::pow(std::min(target.size_at(0.9), limits.largest), 3.0) / volume;
  if (one > kShare / 3.0)  // three of them are a step of the curve that is too high
    add("the rock is small: one block of the target's P90 is " + percent(one) + " % of its mass");
  const SizeComparison::Point& large = comparison.at(90);
  if (why.empty() && large.achieved < 0.97 * large.target) {
    add("the rock farthest from the charges has no room for the largest blocks: P90 is " +
        number_text(large.achieved) + " m instead of " + number_text(large.target) + " m");
  }
  if (why.empty())
    add("the sizes of single blocks scatter about the law; another seed or larger rock may do");
  return why;
}

FittedCut tessellate_to_target(TessellationOptions options, const SizeTarget& target,
                               const SizeLimits& limits, int most_rounds) {
  if (options.holes.empty() && options.fine_axes.empty()) {
    throw InputError("size target: needs a hole, from which sizes grow");
  }
  const std::vector<double> distances = rock_distances(options);
  std::vector<double> sizes(kNodes);
  for (std::size_t node = 0; node < kNodes; ++node) sizes[node] = target.size_at(node_share(node));
  FittedCut best;
  for (int round = 1; round <= most_rounds; ++round) {
    for (double& size : sizes) size = std::clamp(size, limits.smallest, limits.largest);
    const SizeTable law = table_of(sizes, distances);
    options.size = SizeLaw::table(law, limits);
    Tessellation cut = tessellate(options);
    const SizeComparison comparison = compare_sizes(cut.blocks, target, limits);
    const auto curve = passing_curve(cut.blocks);
    if (round == 1 || deviation(comparison) < deviation(best.comparison)) {
      best = {std::move(cut), comparison, {}, law, round};
    }
    constexpr double kComfortable = 0.8;  // of what is allowed, so that rounding cannot undo it
    if (deviation(best.comparison) <= kComfortable) break;
    correct(sizes, target, curve, distances);
  }
  best.why_missed = why_missed(best.comparison, target, limits, best.cut.statistics.block_volume);
  return best;
}

}  // namespace muckpile
