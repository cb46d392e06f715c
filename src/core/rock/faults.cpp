// SPDX-License-Identifier: GPL-2.0-or-later
// Faults.
// Scope: see the header.
#include "rock/faults.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "args/input_error.h"
#include "geometry/surface/surface_checks.h"
#include "rock/cut_table.h"
#include "rock/rock_surfaces.h"

namespace muckpile {
namespace {

using Triangles = std::vector<StlTriangle>;

std::string name_of(const Fault& fault) { return "fault " + fault.file; }

Vec3 twice_area(const StlTriangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

bool reaches(const StlTriangle& t, const Vec3& lo, const Vec3& hi) {
  const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
  return (low.array() <= hi.array()).all() && (high.array() >= lo.array()).all();
}

Triangles at_region(const Fault& fault, const CutOptions& options) {
  Triangles here;
  for (const StlTriangle& t : fault.index->triangles())
    if (reaches(t, options.rock.lo, options.rock.hi)) here.push_back(t);
  return here;
}

/// Through the corners by least squares, each with the area of its triangles.
CutPlane fitted_plane(const Triangles& triangles) {
  Vec3 middle = Vec3::Zero();
  double weight = 0.0;
  for (const StlTriangle& t : triangles) {
    const double area = twice_area(t).norm();
    middle += area / 3.0 * (t[0] + t[1] + t[2]);
    weight += area;
  }
  middle /= weight;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const StlTriangle& t : triangles)
    for (const Vec3& corner : t)
      spread += twice_area(t).norm() * (corner - middle) * (corner - middle).transpose();
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return {middle, normal.z() < 0.0 ? Vec3(-normal) : normal};
}

double farthest(const Triangles& triangles, const CutPlane& plane) {
  double most = 0.0;
  for (const StlTriangle& t : triangles)
    for (const Vec3& corner : t)
      most = std::max(most, std::abs(plane.normal.dot(corner - plane.point)));
  return most;
}

/// Of what lies in the rock, by pieces with edges of at most `edge` [m2].
double area_in_rock(const StlTriangle& t, const CutOptions& options, double edge) {
  if (!reaches(t, options.rock.lo, options.rock.hi)) return 0.0;
  std::size_t longest = 0;
  const auto length = [&](std::size_t k) { return (t[(k + 1) % 3] - t[k]).norm(); };
  for (const std::size_t k : {1, 2})
    if (length(k) > length(longest)) longest = k;
  if (length(longest) <= edge) {
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    const bool in_box = ((middle - options.rock.lo).array() >= 0.0).all() &&
                        ((options.rock.hi - middle).array() >= 0.0).all();
    const auto& inside = options.rock.region.inside;
    return in_box && (!inside || inside(middle)) ? 0.5 * twice_area(t).norm() : 0.0;
  }
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  const Vec3 half = 0.5 * (a + b);
  return area_in_rock({a, half, c}, options, edge) + area_in_rock({half, b, c}, options, edge);
}

double area_in_rock(const Fault& fault, const CutOptions& options) {
  constexpr double kPiece = 0.02;  // of the region's diagonal
  const double edge = kPiece * (options.rock.hi - options.rock.lo).norm();
  double area = 0.0;
  for (const StlTriangle& t : at_region(fault, options)) area += area_in_rock(t, options, edge);
  return area;
}

/// Cosine between a facet and the triangle of the fault nearest to it.
double along(const Fault& fault, const Vec3& middle, const Vec3& normal) {
  const std::size_t triangle = fault.index->closest(middle).triangle;
  return std::min(1.0, std::abs(fault.index->unit_normal(triangle).dot(normal)));
}

}  // namespace

void read_faults(CutOptions& options, const ArgValues& args) {
  for (const std::vector<std::string>& words : args.groups("fault")) {
    Fault fault{words[0]};
    fault.joint_class =
        static_cast<std::uint8_t>(cut_whole(name_of(fault), words[1], Range::closed(0, 255)));
    Triangles triangles = read_placed(fault.file, options).triangles;
    if (triangles.empty())
      refuse(name_of(fault), "must be triangles, as .stl or .dxf has, got points");
    fault.index = std::make_shared<const SurfaceIndex>(std::move(triangles));
    options.faults.push_back(std::move(fault));
  }
}

void lay_faults(CutOptions& options) {
  for (Fault& fault : options.faults) {
    const SurfaceIndex& index = *fault.index;
    require_at_box(index.lo(), index.hi(), options.rock.lo, options.rock.hi,
                   std::string(kCreateBlocks) + ": " + name_of(fault),
                   "it crosses no rock of the region");
    const Triangles here = at_region(fault, options);
    if (here.empty()) continue;
    const CutPlane plane = fitted_plane(here);
    fault.off_plane = farthest(here, plane);
    fault.flat = fault.off_plane <= kFlatFault * options.limits.smallest;
    if (fault.flat) cut_along(options.rock, plane);
  }
}

void assign_fault_classes(const CutOptions& options, int first_tag, RockModel& model) {
  for (const Fault& fault : options.faults) model.faults.push_back({0.0, 0.0, fault.joint_class});
  const auto centroid = [&](int tag) {
    return model.rock.blocks[static_cast<std::size_t>(tag - first_tag)].mass.centroid;
  };
  for (Facet& facet : model.facets.facets) {
    if (facet.kind != FacetKind::joint) continue;
    const Vec3 from = centroid(facet.tag_i), to = centroid(facet.tag_j);
    for (std::size_t f = 0; f < options.faults.size(); ++f) {
      const Fault& fault = options.faults[f];
      if (!fault.index->parts(from, to)) continue;
      facet.joint_class = fault.joint_class;
      model.faults[f].area += facet.area;
      model.faults[f].along += facet.area * along(fault, from + facet.arm_i, facet.normal);
      break;
    }
  }
}

std::string describe_faults(const CutOptions& options, const RockModel& model) {
  std::ostringstream text;
  text.precision(4);
  for (std::size_t f = 0; f < options.faults.size(); ++f) {
    const Fault& fault = options.faults[f];
    const FaultFacets& made = model.faults[f];
    const double share = made.area > 0.0 ? std::min(1.0, made.along / made.area) : 1.0;
    const double angle = std::acos(share) * 180.0 / M_PI;
    text << "  " << name_of(fault) << ": " << fault.index->triangles().size() << " triangles, "
         << area_in_rock(fault, options) << " m2 in the rock, " << made.area << " m2 of facets; "
         << (options.import_file ? "the blocks are imported: facets are where those have them"
             : fault.flat        ? "plane: the cut follows it"
                                 : "not plane: facets are steps of a block")
         << ", they stand at " << std::round(angle) << " degrees to it\n";
    if (!(made.area > 0.0))
      text << "WARNING: create_blocks: " << name_of(fault)
           << " parts no two blocks; does it reach into the rock?\n";
  }
  return text.str();
}

}  // namespace muckpile
