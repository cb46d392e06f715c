// SPDX-License-Identifier: GPL-2.0-or-later
// From where a picture of the rock is seen, and what it is to show.
// Scope: see the header.
#include "report/picture_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/axes.h"
#include "draw/text.h"
#include "measure/broken_out.h"
#include "measure/places.h"
#include "measure/start_extent.h"

namespace muckpile {
namespace {

constexpr double kOpening = 30.0 * std::numbers::pi / 180.0;  // vertical angle of view [rad]

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

void add_circle(double radius, double z, std::vector<Vec3>& points) {
  constexpr int kPoints = 24;
  for (int k = 0; k < kPoints; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kPoints;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
}

}  // namespace

Extent framed_box(const std::vector<StartBlock>& blocks, const Snapshot& last) {
  constexpr double kRoom = 1.0;   // [m]
  constexpr double kFew = 0.005;  // of the blocks, to each side
  Extent box = extent_at_start(blocks);
  for (const Eigen::Index axis : {0, 1, 2}) {
    if (axis < 2) box.low[axis] = std::min(box.low[axis], place_of_share(last, axis, kFew) - kRoom);
    box.high[axis] = std::max(box.high[axis], place_of_share(last, axis, 1.0 - kFew) + kRoom);
  }
  return box;
}

std::vector<Vec3> framed_crater(const std::vector<StartBlock>& blocks, const Snapshot& last) {
  constexpr double kMost = 0.95;                 // of the blocks that were broken out
  constexpr double kEjecta = 0.75;               // of them, by where they lie
  constexpr double kRim = 1.5, kFarthest = 2.5;  // of the crater's radius
  const std::vector<char> moved = broken_out(blocks, last.states, 0.0);
  const std::vector<char> flying = on_the_move(last.states);
  std::vector<double> start, end, height;
  for (size_t b = 0; b < blocks.size(); ++b) {
    if (moved[b] == 0) continue;
    start.push_back(blocks[b].centroid.head<2>().norm());
    if (flying[b] != 0) continue;
    end.push_back(last.states[b].centre.head<2>().norm());
    height.push_back(last.states[b].centre.z());
  }
  if (start.empty()) return {};
  const double radius = value_of_share(start, kMost);
  const double lies = end.empty() ? 0.0 : value_of_share(end, kEjecta);
  const double top = height.empty() ? 0.0 : value_of_share(height, kMost);
  const double reach = std::clamp(lies, kRim * radius, kFarthest * radius);
  std::vector<Vec3> points;
  add_circle(reach, 0.0, points);
  add_circle(0.5 * radius, std::clamp(top, 0.0, radius), points);
  return points;
}

Vec3 direction_of_eye(double azimuth_deg, double elevation_deg) {
  const double azimuth = radians(azimuth_deg), rise = radians(elevation_deg);
  return {std::cos(rise) * std::cos(azimuth), -std::cos(rise) * std::sin(azimuth), std::sin(rise)};
}

View framing_view(const std::vector<Vec3>& points, const Vec3& to_eye,
                  const PictureOptions& options, const Canvas& canvas) {
  const Vec2 size(canvas.sample_width(), canvas.sample_height());
  Vec3 target = points.front();
  double distance = 0.0;
  for (const Vec3& p : points) distance = std::max(distance, 6.0 * (p - target).norm());
  const auto camera = [&] {
    return Camera::perspective(target + distance * to_eye, target, kOpening, canvas.sample_width(),
                               canvas.sample_height());
  };
  constexpr int kRounds = 12;  // each halves what is left of the error or better
  for (int round = 0; round < kRounds; ++round) {
    const Camera view = camera();
    Vec2 low = size, high = Vec2::Zero();
    for (const Vec3& p : points) {
      low = low.cwiseMin(view.place(p));
      high = high.cwiseMax(view.place(p));
    }
    const Vec2 filled = (high - low).cwiseQuotient(Vec2(0.90 * size.x(), 0.80 * size.y()));
    target = view.point(0.5 * (low + high), view.nearness(target));
    distance *= std::clamp(filled.maxCoeff(), 0.5, 2.0);
  }
  distance /= options.zoom;
  if (options.focus) target = {(*options.focus)[0], (*options.focus)[1], (*options.focus)[2]};
  return {camera(), target};
}

void draw_scale_bar(const View& view, Canvas& canvas) {
  constexpr double kWanted = 200.0, kMargin = 30.0, kCap = 6.0, kTextSize = 18.0;  // [px]
  const double per_metre =
      view.camera.samples_per_metre(view.camera.depth(view.target)) / Canvas::kSamples;
  const double longest = std::min(kWanted, canvas.width() - 2.0 * kMargin) / per_metre;  // [m]
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  const double length = longest >= 5.0 * power   ? 5.0 * power
                        : longest >= 2.0 * power ? 2.0 * power
                                                 : power;
  const Vec2 right(canvas.width() - kMargin, canvas.height() - kMargin);
  const Vec2 left = right - Vec2(length * per_metre, 0.0), cap(0.0, kCap);
  canvas.line(left, right, 3.0, kInk);
  canvas.line(left - cap, left + cap, 3.0, kInk);
  canvas.line(right - cap, right + cap, 3.0, kInk);
  const std::string words = spelled(length) + " m in the middle of the view";
  canvas.text(right - Vec2(0.0, kCap + 0.5 * kTextSize), words,
              fitting_size(words, kTextSize, canvas.width() - 2.0 * kMargin), kInk, Anchor::kRight);
}

}  // namespace muckpile
