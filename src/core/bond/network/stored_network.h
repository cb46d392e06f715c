// SPDX-License-Identifier: GPL-2.0-or-later
// What is stored of facets, boundary faces and a network's sums, in restart files and messages.
// Scope: local indices and the share of a facet that a rank books are not stored: they are set
// anew wherever a facet arrives.
#pragma once

#include <cstdint>

#include "bond/facet.h"
#include "bond/law/joint_law.h"
#include "bond/network/facet_memory.h"
#include "bond/network/joint_books.h"
#include "bond/network/network_block.h"
#include "bond/network/sparse.h"
#include "state/encoding.h"

namespace muckpile {

template <>
struct Stored<Facet> {
  static constexpr std::string_view kName = "facet";
  static constexpr int kVersion = 3;
  static auto fields(auto& facet) {
    return std::tie(facet.tag_i, facet.tag_j, facet.face, facet.kind, facet.joint_class,
                    facet.zone_i, facet.zone_j, facet.normal, facet.arm_i, facet.arm_j,
                    facet.opening_i, facet.opening_j, facet.half_axes, facet.area, facet.stiffening,
                    facet.border_room, facet.sharpened, facet.slanted);
  }
};

template <>
struct Stored<BoundaryFace> {
  static constexpr std::string_view kName = "boundary_face";
  static constexpr int kVersion = 2;
  static auto fields(auto& face) {
    return std::tie(face.tag, face.face, face.hole, face.normal, face.arm, face.start, face.area,
                    face.depth_share, face.pressure, face.wave_share, face.load_share,
                    face.last_pressure, face.last_squeezed, face.rigid_swept, face.last_centroid,
                    face.last_normal);
  }
};

template <>
struct Stored<PointSet> {
  static constexpr std::string_view kName = "point_set";
  static constexpr int kVersion = 1;
  using Image = std::uint8_t;
  static Image image(const PointSet& points) { return static_cast<Image>(points.bits()); }
  static PointSet of(Image bits) {
    PointSet points;
    for (std::size_t p = 0; p < kFacetPoints; ++p) points.set(p, (bits >> p & 1u) != 0);
    return points;
  }
};

/// Of FacetTraces, whose flags are bit fields.
struct TracesImage {
  PointSet broken, slipping;
  FacetState state = FacetState::intact;
  bool open = false, gas = false;
};
template <>
struct Stored<TracesImage> {
  static constexpr std::string_view kName = "facet_traces_image";
  static constexpr int kVersion = 1;
  static auto fields(auto& traces) {
    return std::tie(traces.broken, traces.slipping, traces.state, traces.open, traces.gas);
  }
};
template <>
struct Stored<FacetTraces> {
  static constexpr std::string_view kName = "facet_traces";
  static constexpr int kVersion = 1;
  using Image = TracesImage;
  static Image image(const FacetTraces& traces) {
    return {traces.broken, traces.slipping, traces.state, traces.open, traces.gas};
  }
  static FacetTraces of(const Image& image) {
    return {image.broken, image.slipping, image.state, image.open, image.gas};
  }
};

template <>
struct Stored<ContactMemory> {
  static constexpr std::string_view kName = "contact_memory";
  static constexpr int kVersion = 1;
  static auto fields(auto& contact) { return std::tie(contact.offset, contact.fade); }
};

template <>
struct Stored<Cohesion> {
  static constexpr std::string_view kName = "cohesion";
  static constexpr int kVersion = 1;
  static auto fields(auto& cohesion) {
    return std::tie(cohesion.direction, cohesion.strength, cohesion.first, cohesion.end,
                    cohesion.worst, cohesion.shift);
  }
};

template <>
struct Stored<GroundMemory> {
  static constexpr std::string_view kName = "ground_memory";
  static constexpr int kVersion = 1;
  static auto fields(auto& ground) {
    return std::tie(ground.yields, ground.displacement, ground.static_traction, ground.traction,
                    ground.arm_j, ground.placed);
  }
};

template <>
struct Stored<JointHistory> {
  static constexpr std::string_view kName = "joint_history";
  static constexpr int kVersion = 2;
  static auto fields(auto& history) {
    return std::tie(history.closure, history.slip, history.broke_at);
  }
};

template <>
struct Stored<ExtraMemory> {
  static constexpr std::string_view kName = "extra_memory";
  static constexpr int kVersion = 3;
  static auto fields(auto& extra) { return std::tie(extra.cohesion, extra.ground, extra.joint); }
};

/// A value that few have lies in bytes as an optional one.
template <class T>
struct Encoding<Sparse<T>> {
  static constexpr std::size_t kLeast = 1;
  static void put(ByteWriter& out, const Sparse<T>& value) {
    out.put(value.exists());
    if (value.exists()) out.put(value.get());
  }
  static void get(ByteReader& in, Sparse<T>& value) {
    value.drop();
    if (in.get<bool>()) in.get(value.get_or_create());
  }
  static std::string layout() { return layout_of<T>() + '?'; }
  static void list(StoredTypes& types) { Encoding<T>::list(types); }
};

template <>
struct Stored<FacetMemory> {
  static constexpr std::string_view kName = "facet_memory";
  static constexpr int kVersion = 1;
  template <class Memory>
  static auto fields(Memory& memory) {
    using Traces = std::conditional_t<std::is_const_v<Memory>, const FacetTraces, FacetTraces>;
    return std::tie(static_cast<Traces&>(memory), memory.contact, memory.extra);
  }
};

template <>
struct Stored<RetiredFacets> {
  static constexpr std::string_view kName = "retired_facets";
  static constexpr int kVersion = 1;
  static auto fields(auto& retired) {
    return std::tie(retired.unbonded, retired.area, retired.count);
  }
};

template <>
struct Stored<JointLosses> {
  static constexpr std::string_view kName = "joint_losses";
  static constexpr int kVersion = 2;
  static auto fields(auto& losses) {
    return std::tie(losses.fracture, losses.friction, losses.crushing, losses.damping, losses.quiet,
                    losses.radiated);
  }
};

template <>
struct Stored<QuietGround> {
  static constexpr std::string_view kName = "quiet_ground";
  static constexpr int kVersion = 1;
  static auto fields(auto& ground) {
    return std::tie(ground.normal_impedance, ground.shear_impedance, ground.normal_stiffness,
                    ground.shear_stiffness);
  }
};

template <>
struct Stored<RockSoftness> {
  static constexpr std::string_view kName = "rock_softness";
  static constexpr int kVersion = 1;
  static auto fields(auto& softness) { return std::tie(softness.factor, softness.damping); }
};

template <>
struct Stored<NetworkTotals> {
  static constexpr std::string_view kName = "network_totals";
  static constexpr int kVersion = 2;
  static auto fields(auto& totals) {
    return std::tie(totals.losses, totals.pressure_work, totals.wave_work, totals.softened,
                    totals.damping, totals.quiet_ground, totals.moved_unseen, totals.softer_since);
  }
};

}  // namespace muckpile
