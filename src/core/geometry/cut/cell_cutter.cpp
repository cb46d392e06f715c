// SPDX-License-Identifier: GPL-2.0-or-later
// Cuts single Voronoi cells out of a box: voro++ cuts planes, our k-d tree finds the neighbours.
// Scope: planes are offered nearest first until no farther point can reach the cell.
#include "geometry/cut/cell_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <voro++/voro++.hh>

#include "geometry/index/point_index.h"

namespace muckpile {
namespace {

constexpr int kBound = -7;  // -1 to -6 are the walls of the box

constexpr std::size_t kBatch = 8;   // planes that are looked at together
constexpr double kOnPlane = 1e-10;  // above voro++'s tolerance [m2]

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
  [[nodiscard]] bool cut_at_found(int point);
  [[nodiscard]] std::array<bool, kBatch> crossing(std::size_t first, std::size_t count) const;

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

/// Of some of the points found, whether their planes reach the present cell: voro++ would take
/// longer to see that most do not.
std::array<bool, kBatch> CellCutter::Impl::crossing(std::size_t first, std::size_t count) const {
  std::array<double, kBatch> x{}, y{}, z{}, beyond;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 d = points[static_cast<std::size_t>(found[first + k].second)] - centre;
    x[k] = d.x(), y[k] = d.y(), z[k] = d.z();
  }
  beyond.fill(-std::numeric_limits<double>::infinity());
  for (const double *v = cell.pts, *end = v + 3 * cell.p; v != end; v += 3) {
    for (std::size_t k = 0; k < kBatch; ++k) {
      const double along = v[0] * x[k] + v[1] * y[k] + v[2] * z[k];
      beyond[k] = along > beyond[k] ? along : beyond[k];
    }
  }
  std::array<bool, kBatch> crosses{};
  for (std::size_t k = 0; k < count; ++k)
    crosses[k] = beyond[k] > found[first + k].first - kOnPlane;
  return crosses;
}

/// Nearest first; a cell only shrinks, so what does not reach it now never will.
bool CellCutter::Impl::cut_at_found(int point) {
  for (std::size_t first = 0; first < found.size(); first += kBatch) {
    const double needed = reach_of(cell);
    if (found[first].first > needed * needed) break;
    const std::size_t count = std::min(kBatch, found.size() - first);
    const std::array<bool, kBatch> crosses = crossing(first, count);
    for (std::size_t k = 0; k < count; ++k) {
      const auto [distance2, other] = found[first + k];
      if (!crosses[k] || other == point) continue;
      const Vec3 d = points[static_cast<std::size_t>(other)] - centre;
      highest_met = std::max(highest_met, other);
      if (!cell.nplane(d.x(), d.y(), d.z(), distance2, other)) return false;
    }
  }
  return true;
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
    if (!m.cut_at_found(point)) return false;
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
