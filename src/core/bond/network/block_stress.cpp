// SPDX-License-Identifier: GPL-2.0-or-later
// Mean stress of single blocks of a facet network.
// Scope: see the header.
#include "bond/network/block_stress.h"

#include <algorithm>
#include <cmath>

#include "bond/network/broken_contact.h"
#include "bond/network/softening_points.h"

namespace muckpile {
namespace {

/// What the points of a facet carry on block i, without dashpots [Pa].
LaneVec tractions(const FacetNetwork& network, std::size_t f, const FacetMotion& motion) {
  const FacetKinematics facets = network.kinematics();
  const int bonded = facets.history.bonded_points(f);
  LaneVec carried;
  if (bonded > 0) {
    const LaneMask holds = is_point() && !where_contact(facets.history.traces(f));
    carried =
        choose(holds, Lanes(1.0), 0.0) * bonded_tractions(facets, network.leaning(), f, motion);
  }
  if (facets.history.state(f) == FacetState::retired) return carried;
  if (bonded < kFacetPoints) carried += contact_tractions(facets, f, motion);
  if (facets.tables.laws().softens()) carried += cohesion_tractions(facets, f, motion);
  return carried;
}

/// Of the gas in the joint, at its broken points [Pa].
LaneVec gas_tractions(const FacetNetwork& network, std::size_t f, const FacetMotion& motion) {
  const FacetTraces& traces = network.history().traces(f);
  if (!traces.broken.any() || traces.over()) return {};
  const double pressure = network.gas_pressure(f);
  return choose(where_broken(traces), Lanes(-pressure), 0.0) * LaneVec(motion.normal);
}

class StressSums {
 public:
  StressSums(const FacetNetwork& network, std::span<const int> blocks)
      : network_(network), place_(network.blocks().size(), -1), sums_(blocks.size(), Mat3::Zero()) {
    for (std::size_t k = 0; k < blocks.size(); ++k)
      place_[static_cast<std::size_t>(blocks[k])] = static_cast<int>(k);
  }

  void add_facet(std::size_t f) {
    const auto [i, j] = network_.tables().blocks_of(f);
    if (place_[i] < 0 && place_[j] < 0) return;
    const FacetKinematics facets = network_.kinematics();
    const FacetMotion motion = facets.motion(f);
    const FacetPull pull(motion);
    const LaneVec traction = tractions(network_, f, motion) + gas_tractions(network_, f, motion);
    const Vec3 between = facets.blocks.state[i].centre - facets.blocks.state[j].centre;
    const double area = network_.area(f) / kFacetPoints;
    for (int p = 0; p < kFacetPoints; ++p) {
      const Vec3 force = area * traction.at(p), arm = pull.arm.at(p);
      add(i, force, arm);
      if (facets.tables.is_joint(f)) add(j, -force, arm + between);
    }
  }

  void add_face(const BoundaryFace& face) {
    const auto b = static_cast<std::size_t>(face.block);
    if (place_[b] < 0 || face.pressure == 0.0) return;
    const Mat3& turned = network_.block_fields().state[b].rotation;
    add(b, -face.pressure * face.area * (turned * face.normal), turned * face.arm);
  }

  [[nodiscard]] std::vector<Mat3> stresses() const {
    std::vector<Mat3> all = sums_;
    for (std::size_t b = 0; b < place_.size(); ++b) {
      if (place_[b] < 0) continue;
      Mat3& stress = all[static_cast<std::size_t>(place_[b])];
      stress = Mat3(0.5 / network_.blocks()[b].volume * (stress + stress.transpose()));
    }
    return all;
  }

 private:
  void add(std::size_t block, const Vec3& force, const Vec3& arm) {
    if (place_[block] >= 0)
      sums_[static_cast<std::size_t>(place_[block])] += force * arm.transpose();
  }

  const FacetNetwork& network_;
  std::vector<int> place_;  // of each block among those asked for, -1: not asked for
  std::vector<Mat3> sums_;  // [N m]
};

}  // namespace

std::vector<Mat3> block_stresses(const FacetNetwork& network, std::span<const int> blocks) {
  StressSums sums(network, blocks);
  for (std::size_t f = 0; f < network.facet_count(); ++f) sums.add_facet(f);
  for (const BoundaryFace& face : network.faces()) sums.add_face(face);
  return sums.stresses();
}

std::vector<double> distances_from_blocks(const FacetNetwork& network, const Vec3& point) {
  constexpr double kReach = 2.0;  // block sizes; of a block whose faces are not all known any more
  std::vector<double> outside;
  for (std::size_t b = 0; b < network.blocks().size() && network.blocks()[b].owned; ++b)
    outside.push_back((point - network.block_fields().state[b].centre).norm() -
                      kReach * std::cbrt(network.blocks()[b].volume));
  const auto cut = [&](int block, const Vec3& arm, const Vec3& normal) {
    const auto b = static_cast<std::size_t>(block);
    if (b >= outside.size()) return;
    const BlockState& at = network.block_fields().state[b];
    outside[b] =
        std::max(outside[b], (at.rotation * normal).dot(point - at.centre - at.rotation * arm));
  };
  const FacetTables& tables = network.tables();
  for (std::size_t f = 0; f < network.facet_count(); ++f) {
    cut(tables.i_of(f), tables.arm_i(f), tables.normal(f));
    if (tables.is_joint(f)) cut(tables.j_of(f), tables.arm_j(f), -tables.normal(f));
  }
  for (const BoundaryFace& face : network.faces()) cut(face.block, face.arm, face.normal);
  return outside;
}

}  // namespace muckpile
