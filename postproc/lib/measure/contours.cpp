// SPDX-License-Identifier: GPL-2.0-or-later
// Contours over a triangulation by VTK; see the header.
#include "measure/contours.h"

#include <vtkCellArray.h>
#include <vtkDelaunay2D.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace muckpile {

namespace {

// VTK complains loudly about points that span no triangle.
bool on_a_line(const std::vector<Vec2>& points) {
  constexpr double kFlat = 1e-9;  // height over length
  if (points.size() < 3) return true;
  const auto far = std::ranges::max_element(
      points, {}, [&](const Vec2& p) { return (p - points.front()).norm(); });
  const Vec2 along = *far - points.front();
  return std::ranges::all_of(points, [&](const Vec2& p) {
    const Vec2 to = p - points.front();
    return std::abs(along.x() * to.y() - along.y() * to.x()) <= kFlat * along.squaredNorm();
  });
}

}  // namespace

std::vector<Triangle> triangulate(const std::vector<Vec2>& points) {
  if (on_a_line(points)) return {};
  vtkNew<vtkPoints> places;
  for (const Vec2& p : points) places->InsertNextPoint(p.x(), p.y(), 0.0);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(places);
  vtkNew<vtkDelaunay2D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  std::vector<Triangle> triangles;
  vtkNew<vtkIdList> corners;
  vtkCellArray* cells = delaunay->GetOutput()->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(corners) != 0;) {
    const auto corner = [&](vtkIdType k) { return static_cast<size_t>(corners->GetId(k)); };
    triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return triangles;
}

std::vector<std::pair<Vec2, Vec2>> contour(const std::vector<Vec2>& points,
                                           const std::vector<double>& values,
                                           const std::vector<Triangle>& triangles, double level) {
  std::vector<std::pair<Vec2, Vec2>> pieces;
  for (const Triangle& triangle : triangles) {
    std::vector<Vec2> crossings;
    for (size_t k = 0; k < 3; ++k) {
      const size_t a = triangle[k], b = triangle[(k + 1) % 3];
      if ((values[a] < level) == (values[b] < level)) continue;
      const double share = (level - values[a]) / (values[b] - values[a]);
      crossings.push_back(points[a] + share * (points[b] - points[a]));
    }
    if (crossings.size() == 2) pieces.emplace_back(crossings[0], crossings[1]);
  }
  return pieces;
}

}  // namespace muckpile
