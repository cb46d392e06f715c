// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts single Voronoi cells out of a box: voro++ cuts planes, our k-d tree finds the neighbours.
// Scope: planes are offered nearest first until no farther point can reach the cell.
#include "geometry/cut/cell_cutter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <voro++/voro++.hh>

#include "geometry/index/point_index.h"

namespace muckpile {
namespace {

constexpr int kBound = -7;  // -1 to -6 are the walls of the box

// A point farther than twice the farthest vertex cannot cut the cell. voro++ keeps doubled vertex
// coordinates, and max_radius_squared is about those: the factor two is in it.
double reach_of(voro::voronoicell_neighbor& cell) { return std::sqrt(cell.max_radius_squared()); }

}  // namespace

struct CellCutter::Impl {
  Impl(const std::vector<Vec3>& all, const Vec3& box_lo, const Vec3& box_hi,
       std::vector<CutPlane> ends)
      : points(all), bounds(std::move(ends)), lo(box_lo), hi(box_hi), index(all) {}

  // False if nothing is left of the cell.
  [[nodiscard]] bool cut_at(const CutPlane& bound, int number);

  const std::vector<Vec3>& points;
  const std::vector<CutPlane> bounds;
  const Vec3 lo, hi;
  const PointIndex index;
  PointIndex::Found found;
  voro::voronoicell_neighbor cell;
  Vec3 centre = Vec3::Zero();
  int highest_met = -1;
};

// The plane's unit normal looks out of the cell.
bool CellCutter::Impl::cut_at(const CutPlane& bound, int number) {
  const Vec3& n = bound.normal;
  return cell.nplane(n.x(), n.y(), n.z(), 2.0 * n.dot(bound.point - centre), number);
}

CellCutter::CellCutter(const std::vector<Vec3>& points, const Vec3& lo, const Vec3& hi,
                       std::vector<CutPlane> bounds)
    : impl_(std::make_unique<Impl>(points, lo, hi, std::move(bounds))) {}

CellCutter::~CellCutter() = default;

bool CellCutter::cut(int point, double reach, const CutPlane* wall) {
  Impl& m = *impl_;
  m.centre = m.points[static_cast<std::size_t>(point)];
  m.highest_met = -1;
  const Vec3 lo = m.lo - m.centre, hi = m.hi - m.centre;
  m.cell.init(lo.x(), hi.x(), lo.y(), hi.y(), lo.z(), hi.z());
  for (const CutPlane& bound : m.bounds)
    if (!m.cut_at(bound, kBound)) return false;
  if (wall && !m.cut_at({wall->point, -wall->normal}, kOwnWall)) return false;
  double needed = reach_of(m.cell);
  for (double inner = 0.0, outer = reach; inner < needed;) {
    m.index.shell(m.centre, inner, outer, m.found);
    for (std::size_t k = 0; k < m.found.size(); ++k) {
      const auto [distance2, other] = m.found[k];
      if (other == point) continue;
      if (distance2 > needed * needed) break;
      const Vec3 d = m.points[static_cast<std::size_t>(other)] - m.centre;
      m.highest_met = std::max(m.highest_met, other);
      if (!m.cell.nplane(d.x(), d.y(), d.z(), distance2, other)) return false;
      constexpr std::size_t kPlanesBetweenUpdates = 8;
      if (k % kPlanesBetweenUpdates == 0) needed = reach_of(m.cell);
    }
    needed = reach_of(m.cell);
    inner = outer;
    outer = std::min(1.3 * outer, 1.0001 * needed);
  }
  return true;
}

double CellCutter::volume() const { return impl_->cell.volume(); }

Vec3 CellCutter::centroid() const {
  Vec3 local;
  impl_->cell.centroid(local.x(), local.y(), local.z());
  return impl_->centre + local;
}

bool CellCutter::met_point_from(int first) const { return impl_->highest_met >= first; }

void CellCutter::extract(Polyhedron& shape, std::vector<int>& neighbours) const {
  Impl& m = *impl_;
  std::vector<double> coordinates;
  m.cell.vertices(m.centre.x(), m.centre.y(), m.centre.z(), coordinates);
  shape.vertices.clear();
  for (std::size_t k = 0; k + 2 < coordinates.size(); k += 3) {
    shape.vertices.emplace_back(coordinates[k], coordinates[k + 1], coordinates[k + 2]);
  }
  std::vector<int> packed;  // per face: number of vertices, then the vertices, clockwise
  m.cell.face_vertices(packed);
  shape.faces.clear();
  for (auto at = packed.begin(); at != packed.end(); at += *at + 1) {
    shape.faces.emplace_back(std::reverse_iterator(at + 1 + *at), std::reverse_iterator(at + 1));
  }
  m.cell.neighbors(neighbours);
}

}  // namespace muckpile
