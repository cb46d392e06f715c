// SPDX-License-Identifier: GPL-2.0-or-later
// A picture to draw on in memory: filled polygons, lines and text, smoothed by supersampling.
// Scope: software only, so it needs neither a display nor a graphics card and gives the same pixels
// everywhere.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "draw/colours.h"
#include "measure/scan_polygon.h"

namespace muckpile {

enum class Anchor { kLeft, kCentre, kRight };

// Places and sizes are in pixels of the finished picture, x to the right, y down, (0, 0) the upper
// left corner.
class Canvas {
 public:
  Canvas(int width, int height, Colour background);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  void fill(std::span<const Vec2> polygon, Colour colour, double opacity = 1.0);
  void line(const Vec2& from, const Vec2& to, double thickness, Colour colour,
            double opacity = 1.0);
  void polyline(std::span<const Vec2> points, double thickness, Colour colour);
  // Dashes of this length and as long gaps, running on around the corners.
  void dashes(std::span<const Vec2> points, double thickness, double dash, Colour colour);
  void rectangle(const Vec2& corner, const Vec2& opposite, Colour colour, double opacity = 1.0);
  // `place` is the anchor on the text's base line. `degrees` counter-clockwise.
  void text(const Vec2& place, const std::string& words, double size, Colour colour,
            Anchor anchor = Anchor::kLeft, double degrees = 0.0);

  // One sample of the supersampled picture: kSamples x kSamples of them make a pixel.
  void set_sample(int x, int y, Colour colour) { samples_[index(x, y)] = colour; }
  [[nodiscard]] int sample_width() const { return kSamples * width_; }
  [[nodiscard]] int sample_height() const { return kSamples * height_; }

  // The finished picture, row by row from the top, 3 bytes per pixel.
  [[nodiscard]] std::vector<unsigned char> bytes() const;

  static constexpr int kSamples = 3;

 private:
  [[nodiscard]] size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(sample_width()) + static_cast<size_t>(x);
  }
  void blend(int x, int y, Colour colour, double opacity) {
    Colour& under = samples_[index(x, y)];
    under = mix(under, colour, opacity);
  }

  int width_, height_;
  std::unique_ptr<Colour[]> samples_;
  std::vector<double> crossings_;
};

}  // namespace muckpile
