// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts single Voronoi cells out of a box: our k-d tree finds the neighbours, voro++ cuts the cells
// that become blocks, LaneCell those of sweeps.
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
double reach_of(const LaneCell& cell) { return 2.0 * std::sqrt(cell.farthest2()); }

// False if nothing is left. `shift`: from the centre of the cell to the point behind the plane.
bool cut_midway(voro::voronoicell_neighbor& cell, const Vec3& shift, double distance2, int other) {
  return cell.nplane(shift.x(), shift.y(), shift.z(), distance2, other);
}
bool cut_midway(LaneCell& cell, const Vec3& shift, double distance2, int other) {
  return cell.cut(shift, 0.5 * distance2, other);
}

}  // namespace

struct CellCutter::Impl {
  Impl(const std::vector<Vec3>& all, const Vec3& box_lo, const Vec3& box_hi,
       std::vector<CutPlane> ends)
      : points(all), bounds(std::move(ends)), lo(box_lo), hi(box_hi), index(all) {}

  // False if nothing is left of the cell.
  [[nodiscard]] bool cut_at(const CutPlane& bound, int number);
  template <class Cell>
  [[nodiscard]] bool cut_by_points(Cell& of, int point, double reach);
  // False if the cell is given up.
  [[nodiscard]] bool cut_in_lanes(int point, double reach);

  const std::vector<Vec3>& points;
  const std::vector<CutPlane> bounds;
  const Vec3 lo, hi;
  const PointIndex index;
  PointSearch search{index};
  voro::voronoicell_neighbor cell;
  LaneCell lane_cell;
  bool in_lanes = false;  // the present cell
  Vec3 centre = Vec3::Zero();
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

template <class Cell>
bool CellCutter::Impl::cut_by_points(Cell& of, int point, double reach) {
  constexpr std::size_t kAhead = 8;
  const auto place = static_cast<std::size_t>(point);
  search.prepare({&points[place], std::min(kAhead, points.size() - place)}, reach);
  double needed = reach_of(of);
  for (double inner = 0.0, outer = reach; inner < needed;) {
    const PointSearch::Found& found = search.shell(centre, inner, outer);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto [distance2, other] = found[k];
      if (other == point) continue;
      if (distance2 > needed * needed) break;
      const Vec3 shift = points[static_cast<std::size_t>(other)] - centre;
      if (!cut_midway(of, shift, distance2, other)) return false;
      constexpr std::size_t kPlanesBetweenUpdates = 8;
      if (k % kPlanesBetweenUpdates == 0) needed = reach_of(of);
    }
    needed = reach_of(of);
    inner = outer;
    outer = std::min(1.3 * outer, 1.0001 * needed);
  }
  return true;
}

bool CellCutter::cut(int point, double reach, const CutPlane* wall) {
  Impl& m = *impl_;
  m.in_lanes = false;
  m.centre = m.points[static_cast<std::size_t>(point)];
  const Vec3 lo = m.lo - m.centre, hi = m.hi - m.centre;
  m.cell.init(lo.x(), hi.x(), lo.y(), hi.y(), lo.z(), hi.z());
  for (const CutPlane& bound : m.bounds)
    if (!m.cut_at(bound, kBound)) return false;
  if (wall && !m.cut_at({wall->point, -wall->normal}, kOwnWall)) return false;
  return m.cut_by_points(m.cell, point, reach);
}

bool CellCutter::Impl::cut_in_lanes(int point, double reach) {
  centre = points[static_cast<std::size_t>(point)];
  lane_cell.start(lo - centre, hi - centre);
  for (const CutPlane& bound : bounds)
    if (!lane_cell.cut(bound.normal, bound.normal.dot(bound.point - centre), kBound)) return false;
  return cut_by_points(lane_cell, point, reach);
}

bool CellCutter::cut_fast(int point, double reach) {
  impl_->in_lanes = impl_->cut_in_lanes(point, reach);
  return impl_->in_lanes || cut(point, reach);
}

LaneCell::Measure CellCutter::measure() const {
  Impl& m = *impl_;
  LaneCell::Measure measure;
  if (m.in_lanes)
    measure = m.lane_cell.measure();
  else {
    measure.volume = m.cell.volume();
    m.cell.centroid(measure.centroid.x(), measure.centroid.y(), measure.centroid.z());
  }
  measure.centroid += m.centre;
  return measure;
}

bool CellCutter::any_face(const std::function<bool(int)>& condition) const {
  if (impl_->in_lanes) return impl_->lane_cell.any_face(condition);
  std::vector<int> neighbours;
  impl_->cell.neighbors(neighbours);
  return std::ranges::any_of(neighbours, condition);
}

void CellCutter::extract(Polyhedron& shape, std::vector<int>& neighbours) const {
  Impl& m = *impl_;
  if (m.in_lanes) return m.lane_cell.extract(m.centre, shape, neighbours);
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
