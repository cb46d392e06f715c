// SPDX-License-Identifier: GPL-2.0-or-later
// A framed plot area with ticks, grid and labels, and the map from data to pixels.
// Scope: straight or logarithmic axes.
#pragma once

#include <string>
#include <vector>

#include "draw/canvas.h"

namespace muckpile {

struct AxisRange {
  double low, high;
};

enum class Scale { kStraight, kLogarithmic };

class Axes {
 public:
  // The plot area lies between two corners [px]; `x` and `y` are the data ranges.
  Axes(Vec2 upper_left, Vec2 lower_right, AxisRange x, AxisRange y,
       Scale x_scale = Scale::kStraight, Scale y_scale = Scale::kStraight);

  [[nodiscard]] Vec2 place(double x, double y) const;  // [px]
  [[nodiscard]] std::vector<Vec2> places(const std::vector<Vec2>& points) const;

  // The x axis has these words at 1, 2, 3 ... in place of numbers.
  void name_x(std::vector<std::string> words) { x_words_ = std::move(words); }

  void draw_grid(Canvas& canvas) const;
  void draw_frame(Canvas& canvas, const std::string& x_label, const std::string& y_label) const;

 private:
  [[nodiscard]] std::vector<double> x_ticks() const;
  [[nodiscard]] std::vector<double> y_ticks() const;
  [[nodiscard]] std::string x_text(double x) const;

  Vec2 upper_left_, lower_right_;
  AxisRange x_, y_;
  Scale x_scale_, y_scale_;
  std::vector<std::string> x_words_;
};

// Multiples of 1, 2 or 5 times a power of ten inside the range, about `wanted` of them.
std::vector<double> straight_ticks(AxisRange range, int wanted);
// Whole multiples of powers of ten inside the range; 1, 2 and 5 times only where it is wider
// than 20.
std::vector<double> logarithmic_ticks(AxisRange range);

// The shortest usual spelling of a number: at most `digits` significant ones.
std::string spelled(double value, int digits = 3);

}  // namespace muckpile
