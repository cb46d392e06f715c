// SPDX-License-Identifier: GPL-2.0-or-later
// Fines of the rock around charges by a law.
// Scope: see the header.
#include "measure/fines_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "measure/block_finder.h"

namespace muckpile {
namespace {

constexpr int kDirections = 48, kRings = 12;
constexpr double kVoid = 2.0;  // zones of the cut are prisms: rock begins within this many radii

// Directions square to the axis of a charge.
struct Across {
  explicit Across(const Charge& charge) : along((charge.collar - charge.toe).normalized()) {
    a = along.unitOrthogonal();
    b = along.cross(a);
  }
  [[nodiscard]] Vec3 direction(int k) const {
    const double angle = 2.0 * std::numbers::pi * (k + 0.5) / kDirections;
    return std::cos(angle) * a + std::sin(angle) * b;
  }
  Vec3 along, a, b;
};

// Half of the difference of squares: the area of a ring per radian.
double ring(double inner, double outer) { return 0.5 * (outer * outer - inner * inner); }

// What lies in one direction from one place of an axis.
class Ray {
 public:
  Ray(const BlockFinder& finder, const Vec3& from, const Vec3& way, double zone)
      : finder_(finder), from_(from), way_(way) {
    constexpr int kSteps = 32;
    for (int k = 1; !first_ && k <= kSteps; ++k) {
      start_ = zone * (1.0 + (kVoid - 1.0) * k / kSteps);
      first_ = at(start_);
    }
  }
  // The block nearest to the axis; none where the model ends.
  [[nodiscard]] std::optional<size_t> first() const { return first_; }
  [[nodiscard]] std::optional<size_t> block(double radius) const {
    return radius < start_ ? first_ : at(radius);
  }

 private:
  [[nodiscard]] std::optional<size_t> at(double radius) const {
    return finder_.at(from_ + radius * way_);
  }
  const BlockFinder& finder_;
  Vec3 from_, way_;
  double start_ = 0.0;  // of the first block [m]
  std::optional<size_t> first_;
};

}  // namespace

double FinesLaw::passing(double size) const {
  constexpr double kCoarser = 0.01;  // share above the top size
  return 1.0 - std::pow(kCoarser, std::pow(size / top, exponent));
}

double CrushedRock::mass() const {
  return std::accumulate(of_block.begin(), of_block.end(), without_blocks);
}

CrushedRock crushed_rock(const FinesLaw& law, const std::vector<ChargedHole>& holes,
                         const std::vector<StartBlock>& blocks, const std::vector<char>& moved) {
  CrushedRock rock{0.0, std::vector<double>(blocks.size(), 0.0)};
  const BlockFinder finder(blocks);
  const auto density = [&](size_t b) { return blocks[b].mass / blocks[b].volume; };
  for (const auto& [charge, hole] : holes) {
    const double length = (charge.collar - charge.toe).norm(), outer = law.radius * hole;
    if (!(length > 0.0)) continue;
    const int places = std::clamp(static_cast<int>(std::ceil(length / charge.radius)), 16, 256);
    const double slice = length / places * 2.0 * std::numbers::pi / kDirections;  // [m rad]
    const double zone = std::clamp(charge.radius, hole, outer);
    const Across across(charge);
    for (int place = 0; place < places; ++place) {
      const Vec3 from = charge.toe + (place + 0.5) / places * length * across.along;
      for (int k = 0; k < kDirections; ++k) {
        const Ray ray(finder, from, across.direction(k), charge.radius);
        const auto first = ray.first();
        if (first && moved[*first] != 0)
          rock.without_blocks += density(*first) * slice * ring(hole, zone);
        for (int r = 0; r < kRings && outer > zone; ++r) {
          const double inner = zone + (outer - zone) * r / kRings, wide = (outer - zone) / kRings;
          const auto b = ray.block(inner + 0.5 * wide);
          if (b && moved[*b] != 0)
            rock.of_block[*b] += density(*b) * slice * ring(inner, inner + wide);
        }
      }
    }
  }
  for (size_t b = 0; b < blocks.size(); ++b)
    rock.of_block[b] = std::min(rock.of_block[b], blocks[b].mass);
  return rock;
}

}  // namespace muckpile
