// SPDX-License-Identifier: GPL-2.0-or-later
// Block size by place: the law of distance times a factor that zones of rock have.
// Scope: factors at the nodes of a grid over the box, linear between them. The layer of coarser
// rock at finer rock has the factor of that, as seeds mirrored in a plane between them need it;
// from there on sizes grow by at most kGrowth metres per metre. Around holes the factor is 1, so
// that their rings are those of the law alone. Deterministic; lengths in metres.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "geometry/cut/tessellation.h"

namespace muckpile {

class SizeFactor {
 public:
  static constexpr double kGrowth = 0.5;  // of the size along the way [-]
  static constexpr double kLayer = 1.5;   // [blocks of the finer rock]

  // `wanted`: the factor at a place, > 0, by the zone there. Everything else of `options` is set.
  SizeFactor(const TessellationOptions& options, const SizeLimits& limits,
             const std::function<double(const Vec3&)>& wanted);

  // Size [m] at a point where the law has `law` [m], so far from the nearest axis [m].
  [[nodiscard]] double size(const Vec3& point, double law, double charge_distance) const;
  // Lower bound of the size within `reach` [m], where the law is `law` [m] or more, and
  // `law_beyond` [m] or more a cell of the grid farther.
  [[nodiscard]] double least_size(const Vec3& point, double reach, double law,
                                  double law_beyond) const;
  [[nodiscard]] double cell_diagonal() const { return step_.norm(); }  // [m]
  // Bounds of all sizes.
  [[nodiscard]] const SizeLimits& limits() const { return limits_; }

 private:
  using Node = Eigen::Vector3i;
  struct Law;

  [[nodiscard]] std::size_t number(const Node& node) const;
  [[nodiscard]] Node node(std::size_t number) const;
  [[nodiscard]] Vec3 place(std::size_t number) const;
  // Calls visit(number, distance [m]) for the nodes around one.
  template <class Visit>
  void around(std::size_t number, const Visit& visit) const;
  // Takes values at nodes down to what comes from others through the rock: that of a neighbour and
  // what `way` [law's blocks] adds to it.
  template <class Step>
  void spread(const Law& law, const Step& step, std::vector<double>& values) const;
  void widen(const Law& law);
  void limit_growth(const Law& law);
  void fill_air(const Law& law);
  [[nodiscard]] double at(const Vec3& point) const;  // between the nodes

  SizeLimits limits_;
  double clear_ = 0.0;  // from an axis on the factor may differ from 1 [m]
  Vec3 lo_, step_;
  Node counts_;
  std::vector<double> factors_;  // of the nodes, x fastest
  double least_ = 1.0;           // of all factors
};

// Nowhere are blocks larger [m].
[[nodiscard]] double largest_block(const TessellationOptions& options);

}  // namespace muckpile
