// SPDX-License-Identifier: GPL-2.0-or-later
// A picture as it was drawn, read back: its colours, where they are, and its words.
// Scope: tests only; places are in pixels, x to the right, y down.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "draw/canvas.h"

namespace muckpile::testing {

// From the upper left pixel to the one behind the lower right.
struct Box {
  int x0, y0, x1, y1;
  [[nodiscard]] int width() const { return x1 - x0; }
  [[nodiscard]] int height() const { return y1 - y0; }
  [[nodiscard]] Vec2 middle() const { return {0.5 * (x0 + x1), 0.5 * (y0 + y1)}; }
};

class DrawnPicture {
 public:
  explicit DrawnPicture(const std::filesystem::path& png);
  explicit DrawnPicture(const Canvas& canvas);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Box all() const { return {0, 0, width_, height_}; }

  // Red, green and blue, 0 to 255.
  [[nodiscard]] std::array<int, 3> at(int x, int y) const;
  // Within two steps in each of them: rounding twice.
  [[nodiscard]] bool shows(Colour colour, int x, int y) const;
  [[nodiscard]] bool shows(Colour colour, const Vec2& place) const;
  [[nodiscard]] int count(Colour colour, const Box& within) const;
  // Around all pixels of a colour; without any, of no width.
  [[nodiscard]] Box extent(Colour colour, const Box& within) const;
  // Middles of the lines that a row crosses: stretches that are not white.
  [[nodiscard]] std::vector<double> lines_across(int row, int from, int to) const;
  // How far words within a pixel of the place are from these, as Canvas::text sets them in the
  // colour kInk on white: 0 for the same, 1 where there are none.
  [[nodiscard]] double misfit(const std::string& words, double size, const Vec2& place,
                              Anchor anchor) const;
  // Whether they are these, rather than the same with another digit, or a part of them.
  [[nodiscard]] bool reads(const std::string& words, double size, const Vec2& place,
                           Anchor anchor) const;

 private:
  // By how much of the ink of both a picture of words differs from what is here, with its corner at
  // a pixel: around the words, and so much beside them.
  [[nodiscard]] double share_off(const DrawnPicture& words, int left, int top, int beside) const;
  // Around all that is not white.
  [[nodiscard]] Box dark() const;

  int width_, height_;
  std::vector<unsigned char> bytes_;  // row by row from the top, 3 per pixel
};

}  // namespace muckpile::testing
