// SPDX-License-Identifier: GPL-2.0-or-later
// A picture to draw on in memory: filled polygons, lines and text, smoothed by supersampling.
// Scope: software only.
#include "draw/canvas.h"

#include <algorithm>
#include <cmath>

#include "draw/text.h"
#include "parallel/in_parallel.h"

namespace muckpile {

Canvas::Canvas(int width, int height, Colour background)
    : width_(width),
      height_(height),
      samples_(std::make_unique_for_overwrite<Colour[]>(static_cast<size_t>(kSamples * width) *
                                                        static_cast<size_t>(kSamples * height))) {
  // On all cores, as it is the new memory that takes the time.
  in_parallel(static_cast<size_t>(sample_height()), [&](size_t row) {
    std::fill_n(samples_.get() + index(0, static_cast<int>(row)), sample_width(), background);
  });
}

void Canvas::fill(std::span<const Vec2> polygon, Colour colour, double opacity) {
  std::vector<Vec2> points;
  for (const Vec2& p : polygon) points.push_back(p * kSamples);
  scan_polygon(points, sample_width(), sample_height(), crossings_, [&](int y, int begin, int end) {
    for (int x = begin; x < end; ++x) blend(x, y, colour, opacity);
  });
}

void Canvas::line(const Vec2& from, const Vec2& to, double thickness, Colour colour,
                  double opacity) {
  const Vec2 along = (to - from).norm() > 0.0 ? Vec2((to - from).normalized()) : Vec2(1.0, 0.0);
  const Vec2 side = 0.5 * thickness * Vec2(-along.y(), along.x());
  const Vec2 cap = 0.5 * thickness * along;  // square ends close the corners of a polyline
  const Vec2 corners[] = {from - cap - side, from - cap + side, to + cap + side, to + cap - side};
  fill(corners, colour, opacity);
}

void Canvas::polyline(std::span<const Vec2> points, double thickness, Colour colour) {
  for (size_t i = 0; i + 1 < points.size(); ++i) line(points[i], points[i + 1], thickness, colour);
}

void Canvas::dashes(std::span<const Vec2> points, double thickness, double dash, Colour colour) {
  double walked = 0.0;  // along the whole line [px]
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 step = points[i + 1] - points[i];
    const double length = step.norm();
    for (double at = 0.0; at < length;) {
      const double phase = std::fmod(walked + at, 2.0 * dash);
      const double next = std::min(length, at + (phase < dash ? dash : 2.0 * dash) - phase);
      if (next <= at) break;  // rounding at the end of a dash
      if (phase < dash) {
        line(points[i] + step * (at / length), points[i] + step * (next / length), thickness,
             colour);
      }
      at = next;
    }
    walked += length;
  }
}

void Canvas::rectangle(const Vec2& corner, const Vec2& opposite, Colour colour, double opacity) {
  const Vec2 corners[] = {corner, {opposite.x(), corner.y()}, opposite, {corner.x(), opposite.y()}};
  fill(corners, colour, opacity);
}

void Canvas::text(const Vec2& place, const std::string& words, double size, Colour colour,
                  Anchor anchor, double degrees) {
  const TextMask mask = text_mask(words, size * kSamples, degrees);
  const double share = anchor == Anchor::kLeft ? 0.0 : anchor == Anchor::kCentre ? 0.5 : 1.0;
  const Vec2 begin = place * kSamples - share * mask.advance;
  const int left = static_cast<int>(std::lround(begin.x() + mask.left));
  const int top = static_cast<int>(std::lround(begin.y() + mask.top));
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const double cover = mask.at(x, y);
      const bool inside =
          left + x >= 0 && left + x < sample_width() && top + y >= 0 && top + y < sample_height();
      if (cover > 0.0 && inside) blend(left + x, top + y, colour, cover);
    }
  }
}

std::vector<unsigned char> Canvas::bytes() const {
  std::vector<unsigned char> out(3 * static_cast<size_t>(width_) * static_cast<size_t>(height_));
  in_parallel(static_cast<size_t>(height_), [&](size_t row) {
    const int y = static_cast<int>(row);
    unsigned char* to = out.data() + 3 * static_cast<size_t>(width_) * row;
    for (int x = 0; x < width_; ++x) {
      Colour sum{0.0F, 0.0F, 0.0F};
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const Colour& s = samples_[index(kSamples * x + k % kSamples, kSamples * y + k / kSamples)];
        sum = {sum.red + s.red, sum.green + s.green, sum.blue + s.blue};
      }
      for (const float channel : {sum.red, sum.green, sum.blue}) {
        const double mean = static_cast<double>(channel) / (kSamples * kSamples);
        *to++ = static_cast<unsigned char>(255.0 * std::clamp(mean, 0.0, 1.0) + 0.5);
      }
    }
  });
  return out;
}

}  // namespace muckpile
