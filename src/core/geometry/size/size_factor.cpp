// SPDX-License-Identifier: GPL-2.0-or-later
// Block size by place.
// Scope: see the header.
#include "geometry/size/size_factor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>
#include <utility>

#include "geometry/cut/ground.h"

namespace muckpile {
namespace {

constexpr double kMostNodes = 4e5;
constexpr double kFinest = 0.5;  // step of the grid, of the smallest block

/// As far from the axis as the rings of a hole look for their size: seeds at 1.48 blocks from its
/// wall at most (hole_rings.cpp), of the size there.
double clear_of_rings(const TessellationOptions& options) {
  constexpr double kBlocks = 1.5;
  constexpr int kRounds = 8;  // sizes grow with distance
  double farthest = 0.0;
  for (const Hole& hole : options.holes) {
    double reach = hole.radius;
    for (int k = 0; k < kRounds; ++k) reach = hole.radius + kBlocks * options.size.at(reach);
    farthest = std::max(farthest, reach);
  }
  return farthest;
}

}  // namespace

/// Of the nodes: size without the factor [m]; 0 outside of the rock.
struct SizeFactor::Law {
  std::vector<double> size;
};

SizeFactor::SizeFactor(const TessellationOptions& options, const SizeLimits& limits,
                       const std::function<double(const Vec3&)>& wanted)
    : limits_(limits), clear_(clear_of_rings(options)), lo_(options.lo) {
  const Vec3 edge = options.hi - options.lo;
  const double step = std::max(kFinest * limits.smallest, std::cbrt(edge.prod() / kMostNodes));
  counts_ = (edge / step).array().ceil().cast<int>() + 1;
  step_ = edge.cwiseQuotient((counts_.array() - 1).matrix().cast<double>());
  TessellationOptions plain = options;
  plain.factor = nullptr;
  const Ground ground(plain);
  Law law;
  const auto nodes = static_cast<std::size_t>(counts_.cast<double>().prod());
  for (std::size_t n = 0; n < nodes; ++n) {
    const Vec3 at = place(n);
    factors_.push_back(wanted(at));
    law.size.push_back(ground.in_region(at) ? ground.size(at) : 0.0);
  }
  widen(law);
  limit_growth(law);
  fill_air(law);
  least_ = std::min(1.0, *std::ranges::min_element(factors_));
}

std::size_t SizeFactor::number(const Node& node) const {
  return static_cast<std::size_t>(node.x()) +
         static_cast<std::size_t>(counts_.x()) *
             (static_cast<std::size_t>(node.y()) +
              static_cast<std::size_t>(counts_.y()) * static_cast<std::size_t>(node.z()));
}

SizeFactor::Node SizeFactor::node(std::size_t number) const {
  const auto x = static_cast<std::size_t>(counts_.x()), y = static_cast<std::size_t>(counts_.y());
  return {static_cast<int>(number % x), static_cast<int>(number / x % y),
          static_cast<int>(number / (x * y))};
}

Vec3 SizeFactor::place(std::size_t number) const {
  return lo_ + node(number).cast<double>().cwiseProduct(step_);
}

template <class Visit>
void SizeFactor::around(std::size_t number, const Visit& visit) const {
  const Node middle = node(number);
  for (int k = 0; k < 27; ++k) {
    const Node shift(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), other = middle + shift;
    const bool there = (other.array() >= 0).all() && (other.array() < counts_.array()).all();
    if (k == 13 || !there) continue;
    visit(this->number(other), shift.cast<double>().cwiseProduct(step_).norm());
  }
}

template <class Step>
void SizeFactor::spread(const Law& law, const Step& step, std::vector<double>& values) const {
  using Entry = std::pair<double, std::size_t>;  // value, node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto go_on = [&](std::size_t n) {
    around(n, [&](std::size_t other, double way) {
      if (law.size[other] == 0.0) return;
      const double value = step(values[n], way / std::max(law.size[n], law.size[other]));
      if (value >= values[other]) return;
      values[other] = value;
      open.emplace(value, other);
    });
  };
  for (std::size_t n = 0; n < values.size(); ++n)
    if (law.size[n] > 0.0 && std::isfinite(values[n])) go_on(n);
  while (!open.empty()) {
    const auto [value, n] = open.top();
    open.pop();
    if (value == values[n]) go_on(n);
  }
}

/// Finer rock first, so that no layer ends at another zone.
void SizeFactor::widen(const Law& law) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const std::set<double> all(factors_.begin(), factors_.end());
  const double longest = step_.maxCoeff();
  for (const double factor : all) {
    std::vector<double> ways(factors_.size(), kFar);  // from rock of that factor [law's blocks]
    for (std::size_t n = 0; n < ways.size(); ++n)
      if (factors_[n] == factor) ways[n] = 0.0;
    const auto within = [&](double from, double way) {
      return from + way > 2.0 * kLayer * factor ? kFar : from + way;
    };
    spread(law, within, ways);
    for (std::size_t n = 0; n < ways.size(); ++n) {  // a border is up to a step from the nodes
      if (law.size[n] > 0.0 && ways[n] <= kLayer * factor + longest / law.size[n])
        factors_[n] = std::min(factors_[n], factor);
    }
  }
}

void SizeFactor::limit_growth(const Law& law) {
  spread(
      law, [](double from, double way) { return from + kGrowth * way; }, factors_);
}

/// Nodes outside of the rock are corners of cells with rock in them: they get the mean of the rock
/// beside them.
void SizeFactor::fill_air(const Law& law) {
  for (std::size_t n = 0; n < factors_.size(); ++n) {
    if (law.size[n] > 0.0) continue;
    double sum = 0.0, count = 0.0;
    around(n, [&](std::size_t other, double) {
      if (law.size[other] == 0.0) return;
      sum += factors_[other];
      count += 1.0;
    });
    if (count > 0.0) factors_[n] = sum / count;
  }
}

double SizeFactor::at(const Vec3& point) const {
  const Vec3 most = (counts_.array() - 1).matrix().cast<double>();
  const Vec3 where = (point - lo_).cwiseQuotient(step_).cwiseMax(0.0).cwiseMin(most);
  const Node low = where.array().floor().cast<int>().min(counts_.array() - 2).matrix();
  const Vec3 share = where - low.cast<double>();
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) {
    const Node corner(k & 1, k >> 1 & 1, k >> 2);
    double weight = 1.0;
    for (int c = 0; c < 3; ++c) weight *= corner[c] == 1 ? share[c] : 1.0 - share[c];
    sum += weight * factors_[number(low + corner)];
  }
  return sum;
}

double SizeFactor::size(const Vec3& point, double law, double charge_distance) const {
  const double most = kGrowth * std::max(0.0, charge_distance - clear_) / law;
  if (most == 0.0) return law;
  const double factor = std::clamp(at(point), 1.0 - most, 1.0 + most);
  return std::clamp(law * factor, limits_.smallest, limits_.largest);
}

double SizeFactor::least_size(const Vec3& point, double reach, double law,
                              double law_beyond) const {
  constexpr double kSteepest = 2.0;  // in all three directions, at nodes of the air too
  const double here = at(point) - kSteepest * kGrowth * reach / law_beyond;
  return std::max(limits_.smallest, law * std::clamp(here, least_, 1.0));
}

double largest_block(const TessellationOptions& options) {
  return options.factor ? options.factor->limits().largest : options.size.limits().largest;
}

}  // namespace muckpile
