// SPDX-License-Identifier: GPL-2.0-or-later
// The free face of a bench before the blast.
// Scope: tops_through on rock that has been turned, so that its free face is its top.
#include "measure/free_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "measure/broken_out.h"
#include "measure/columns.h"

namespace muckpile {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLinesPerBlock = 4.0;

// Half a turn about the bisector of x and z: (x, y, z) becomes (z, -y, x).
std::vector<BlockState> turned(const std::vector<StartBlock>& blocks) {
  const Quat turn(Eigen::AngleAxisd(std::numbers::pi, Vec3(1.0, 0.0, 1.0).normalized()));
  std::vector<BlockState> states = start_snapshot(blocks).states;
  for (BlockState& state : states) {
    state.centre = {state.centre.z(), -state.centre.y(), state.centre.x()};
    state.rotation = turn;
  }
  return states;
}

// Least squares of the face's x over height; upright for fewer than two heights.
class Plane {
 public:
  void add(double x, double z) { ++n_, x_ += x, z_ += z, zz_ += z * z, xz_ += x * z; }
  [[nodiscard]] double slope() const {
    const double spread = n_ * zz_ - z_ * z_;
    return std::atan2(1.0, spread > 0.0 ? -(n_ * xz_ - x_ * z_) / spread : 0.0);
  }

 private:
  double n_ = 0.0, x_ = 0.0, z_ = 0.0, zz_ = 0.0, xz_ = 0.0;
};

// Share of the lines along which the rock begins farther from the plane than the tolerance.
double off_plane(const Columns& lines, double back, double tolerance) {
  double off = 0.0;
  for (size_t k = 0; k < lines.grid.cells(); ++k) {
    const double height = lines.grid.x(static_cast<int>(k % static_cast<size_t>(lines.grid.nx)));
    if (!(std::abs(lines.top[k] + back * height) <= tolerance)) off += 1.0;
  }
  return off / static_cast<double>(lines.grid.cells());
}

// The middle one of all lines' ways back per height, which a few blocks that stand out do not move.
double middle_back(const Columns& lines) {
  std::vector<double> back;
  for (size_t k = 0; k < lines.grid.cells(); ++k) {
    const double height = lines.grid.x(static_cast<int>(k % static_cast<size_t>(lines.grid.nx)));
    if (lines.top[k] != kNoRock) back.push_back(-lines.top[k] / height);
  }
  if (back.empty()) return 0.0;
  const auto middle = back.begin() + static_cast<std::ptrdiff_t>(back.size() / 2);
  std::ranges::nth_element(back, middle);
  return std::max(*middle, 0.0);
}

// None for rock that does not reach above the floor.
std::optional<Columns> lines_through(const std::vector<StartBlock>& blocks) {
  const std::vector<char> all(blocks.size(), 1);
  const std::vector<BlockState> states = turned(blocks);
  const Extent extent = extent_of(blocks, states);
  const double top = extent.high.x(), cell = mean_block_size(blocks, all) / kLinesPerBlock;
  if (!(top > cell)) return std::nullopt;
  // Whole cells only: the centre of a last one might lie above the rock.
  const double rows = std::floor(top / cell);
  return tops_through(
      column_grid(0.0, rows * cell * (1.0 - 1e-9), extent.low.y(), extent.high.y(), cell), blocks,
      states, all);
}

}  // namespace

std::shared_ptr<const FaceMap> face_map(const std::vector<StartBlock>& blocks) {
  const std::optional<Columns> lines = lines_through(blocks);
  const auto is_rock = [](double x) { return x != kNoRock; };
  if (!lines || std::ranges::none_of(lines->top, is_rock)) return nullptr;
  return std::make_shared<const FaceMap>(*lines, blocks.size());
}

FreeFace free_face(const std::vector<StartBlock>& blocks, double tolerance) {
  FreeFace face{kNan, kNan, kNan, 0.0, 1.0};
  const std::optional<Columns> through = lines_through(blocks);
  if (!through) return face;
  const Columns& lines = *through;
  Plane plane;
  for (int j = 0; j < lines.grid.ny; ++j) {
    for (int i = 0; i < lines.grid.nx; ++i) {
      const double x = lines.top[lines.grid.at(i, j)];
      if (x == kNoRock) continue;
      plane.add(x, lines.grid.x(i));
      face.x_low = std::fmin(face.x_low, x);
      face.x_high = std::fmax(face.x_high, x);
    }
  }
  face.slope = plane.slope();
  face.off_plane = off_plane(lines, 0.0, tolerance);
  const double back = middle_back(lines), off = off_plane(lines, back, tolerance);
  if (off < face.off_plane) {
    face.back = back;
    face.off_plane = off;
  }
  return face;
}

}  // namespace muckpile
