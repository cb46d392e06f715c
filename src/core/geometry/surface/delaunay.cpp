// SPDX-License-Identifier: GPL-2.0-or-later
// Delaunay triangulation by insertion and flips.
// Scope: see the header; points are put in along a snake of cells, so that the walk to the next is
// short.
#include "geometry/surface/delaunay.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace muckpile {
namespace {

constexpr int kNone = -1;
constexpr double kInCircle = 1e-12;  // relative: four corners of a square need no flip
constexpr double kSame = 1e-9;       // of the extent: two places that are one

struct Triangle {
  std::array<int, 3> corner;
  std::array<int, 3> behind{kNone, kNone, kNone};  // across the edge from corner k to k + 1
};

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const Vec2 u = a - p, v = b - p, w = c - p;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
  const double value = u.x() * (v.y() * ww - vv * w.y()) - u.y() * (v.x() * ww - vv * w.x()) +
                       uu * (v.x() * w.y() - v.y() * w.x());
  const double u1 = std::sqrt(uu), v1 = std::sqrt(vv), w1 = std::sqrt(ww);
  return value > kInCircle * u1 * v1 * w1 * (u1 + v1 + w1);
}

class Mesh {
 public:
  /// The points are scaled to 0 to 1; a triangle far around them holds all.
  explicit Mesh(std::vector<Vec2> scaled) : points_(std::move(scaled)), inner_(points_.size()) {
    constexpr double kFar = 1e4;
    for (const auto& [x, y] : {std::pair{-3.0, -2.0}, std::pair{3.0, -2.0}, std::pair{0.0, 3.0}})
      points_.emplace_back(kFar * x, kFar * y);
    const int first = static_cast<int>(inner_);
    triangles_.push_back({{first, first + 1, first + 2}});
  }

  void insert(int p) {
    const int t = find(at(p));
    for (const int c : triangle(t).corner)
      if ((at(c) - at(p)).norm() < kSame) return;
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = edge(t, k);
      const bool on_edge = turn(at(a), at(b), at(p)) <= kSame * kSame;
      if (on_edge && triangle(t).behind[static_cast<std::size_t>(k)] != kNone)
        return split_edge(t, k, p);
    }
    split(t, p);
  }

  [[nodiscard]] std::vector<std::array<std::size_t, 3>> found() const {
    std::vector<std::array<std::size_t, 3>> all;
    for (const Triangle& t : triangles_) {
      const auto& c = t.corner;
      if (std::ranges::all_of(c, [&](int v) { return v < static_cast<int>(inner_); }))
        all.push_back({static_cast<std::size_t>(c[0]), static_cast<std::size_t>(c[1]),
                       static_cast<std::size_t>(c[2])});
    }
    return all;
  }

 private:
  [[nodiscard]] const Vec2& at(int p) const { return points_[static_cast<std::size_t>(p)]; }
  Triangle& triangle(int t) { return triangles_[static_cast<std::size_t>(t)]; }
  [[nodiscard]] std::pair<int, int> edge(int t, int k) {
    const auto& c = triangle(t).corner;
    return {c[static_cast<std::size_t>(k)], c[static_cast<std::size_t>((k + 1) % 3)]};
  }
  /// Which edge of `t` has `other` behind it.
  int edge_to(int t, int other) {
    const auto& behind = triangle(t).behind;
    return static_cast<int>(std::ranges::find(behind, other) - behind.begin());
  }
  void relink(int t, int from, int to) {
    if (t != kNone) triangle(t).behind[static_cast<std::size_t>(edge_to(t, from))] = to;
  }

  int find(const Vec2& p) {
    int t = last_;
    for (std::size_t steps = 0; steps < 4 * triangles_.size() + 16; ++steps) {
      int next = kNone;
      for (int k = 0; k < 3 && next == kNone; ++k) {
        // The edge to begin with changes, so that the walk does not go round for ever.
        const int e = (k + static_cast<int>(steps)) % 3;
        const auto [a, b] = edge(t, e);
        if (turn(at(a), at(b), p) < 0.0) next = triangle(t).behind[static_cast<std::size_t>(e)];
      }
      if (next == kNone) break;
      t = next;
    }
    return last_ = t;
  }

  void split(int t, int p) {
    const Triangle old = triangle(t);
    const int second = static_cast<int>(triangles_.size()), third = second + 1;
    const auto& c = old.corner;
    const auto& b = old.behind;
    triangle(t) = {{c[0], c[1], p}, {b[0], second, third}};
    triangles_.push_back({{c[1], c[2], p}, {b[1], third, t}});
    triangles_.push_back({{c[2], c[0], p}, {b[2], t, second}});
    relink(b[1], t, second);
    relink(b[2], t, third);
    for (const int each : {t, second, third}) legalise(each, 0);
  }

  /// Splits the edge k of t and the triangle behind it.
  void split_edge(int t, int k, int p) {
    const Triangle a = triangle(t);
    const auto i = static_cast<std::size_t>(k);
    const int u = a.behind[i];
    const Triangle b = triangle(u);
    const auto j = static_cast<std::size_t>(edge_to(u, t));
    const int v0 = a.corner[i], v1 = a.corner[(i + 1) % 3], v2 = a.corner[(i + 2) % 3];
    const int w = b.corner[(j + 2) % 3];
    const int a1 = a.behind[(i + 1) % 3], a2 = a.behind[(i + 2) % 3];
    const int b1 = b.behind[(j + 1) % 3], b2 = b.behind[(j + 2) % 3];  // v0-w and w-v1
    const int s = static_cast<int>(triangles_.size()), q = s + 1;
    triangle(t) = {{v2, v0, p}, {a2, u, s}};
    triangle(u) = {{v0, w, p}, {b1, q, t}};
    triangles_.push_back({{v1, v2, p}, {a1, t, q}});
    triangles_.push_back({{w, v1, p}, {b2, s, u}});
    relink(a1, t, s);
    relink(b2, u, q);
    for (const int each : {t, u, s, q}) legalise(each, 0);
  }

  /// The new point is the corner across the edge k of t.
  void legalise(int first, int first_edge) {
    std::vector<std::pair<int, int>> open{{first, first_edge}};
    while (!open.empty()) {
      const auto [t, k] = open.back();
      open.pop_back();
      const auto i = static_cast<std::size_t>(k);
      const Triangle a = triangle(t);
      const int u = a.behind[i];
      if (u == kNone) continue;
      const Triangle b = triangle(u);
      const auto j = static_cast<std::size_t>(edge_to(u, t));
      const int v0 = a.corner[i], v1 = a.corner[(i + 1) % 3], p = a.corner[(i + 2) % 3];
      const int w = b.corner[(j + 2) % 3];
      if (!in_circle(at(v0), at(v1), at(p), at(w))) continue;
      if (turn(at(p), at(v0), at(w)) <= 0.0 || turn(at(p), at(w), at(v1)) <= 0.0) continue;
      const int a1 = a.behind[(i + 1) % 3], a2 = a.behind[(i + 2) % 3];
      const int b1 = b.behind[(j + 1) % 3], b2 = b.behind[(j + 2) % 3];
      triangle(t) = {{v0, w, p}, {b1, u, a2}};
      triangle(u) = {{w, v1, p}, {b2, a1, t}};
      relink(b1, u, t);
      relink(a1, t, u);
      open.emplace_back(t, 0);
      open.emplace_back(u, 0);
    }
  }

  std::vector<Vec2> points_;
  std::size_t inner_;
  std::vector<Triangle> triangles_;
  int last_ = 0;
};

/// Row by row of cells, there and back, some three points in a cell.
std::vector<int> in_snake(const std::vector<Vec2>& scaled) {
  const double cells = std::max(1.0, std::floor(std::sqrt(static_cast<double>(scaled.size()) / 3)));
  const auto key = [&](int n) {
    const Vec2& p = scaled[static_cast<std::size_t>(n)];
    const double row = std::min(std::floor(p.y() * cells), cells - 1.0);
    const double column = std::min(std::floor(p.x() * cells), cells - 1.0);
    const bool back = std::fmod(row, 2.0) != 0.0;
    return std::pair(row * cells + (back ? cells - 1.0 - column : column), n);
  };
  std::vector<int> order(scaled.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, key);
  return order;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> delaunay(const std::vector<Vec2>& points) {
  if (points.size() < 3) return {};
  Vec2 lo = points.front(), hi = lo;
  for (const Vec2& p : points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  const double extent = (hi - lo).maxCoeff();
  if (!(extent > 0.0)) return {};
  std::vector<Vec2> scaled;
  for (const Vec2& p : points) scaled.emplace_back((p - lo) / extent);
  Mesh mesh(scaled);
  for (const int p : in_snake(scaled)) mesh.insert(p);
  return mesh.found();
}

}  // namespace muckpile
