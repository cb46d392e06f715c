// SPDX-License-Identifier: GPL-2.0-or-later
// A picture as it was drawn, read back.
// Scope: see the header.
#include "drawn_picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace muckpile::testing {
namespace {

std::array<int, 3> levels_of(Colour colour) {
  const auto level = [](float share) { return static_cast<int>(std::lround(255.0F * share)); };
  return {level(colour.red), level(colour.green), level(colour.blue)};
}

int darkness(const std::array<int, 3>& colour) { return 765 - colour[0] - colour[1] - colour[2]; }

/// The next higher and the next lower digit in each place.
std::vector<std::string> with_one_other_digit(const std::string& words) {
  std::vector<std::string> others;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (words[k] < '0' || words[k] > '9') continue;
    for (const int step : {1, 9}) {
      others.push_back(words);
      others.back()[k] = static_cast<char>('0' + (words[k] - '0' + step) % 10);
    }
  }
  return others;
}

}  // namespace

DrawnPicture::DrawnPicture(const std::filesystem::path& png) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(png.c_str());
  reader->Update();
  vtkImageData& image = *reader->GetOutput();
  width_ = image.GetDimensions()[0];
  height_ = image.GetDimensions()[1];
  if (image.GetNumberOfScalarComponents() != 3)
    throw std::runtime_error(png.string() + ": colours");
  for (int y = height_ - 1; y >= 0; --y) {  // VTK counts from below
    const auto* row = static_cast<const unsigned char*>(image.GetScalarPointer(0, y, 0));
    bytes_.insert(bytes_.end(), row, row + 3 * static_cast<std::ptrdiff_t>(width_));
  }
}

DrawnPicture::DrawnPicture(const Canvas& canvas)
    : width_(canvas.width()), height_(canvas.height()), bytes_(canvas.bytes()) {}

std::array<int, 3> DrawnPicture::at(int x, int y) const {
  const size_t first =
      3 * (static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x));
  return {bytes_.at(first), bytes_.at(first + 1), bytes_.at(first + 2)};
}

bool DrawnPicture::shows(Colour colour, int x, int y) const {
  constexpr int kRounding = 2;
  const std::array<int, 3> here = at(x, y), wanted = levels_of(colour);
  return std::ranges::equal(here, wanted,
                            [](int a, int b) { return std::abs(a - b) <= kRounding; });
}

bool DrawnPicture::shows(Colour colour, const Vec2& place) const {
  return shows(colour, static_cast<int>(std::floor(place.x())),
               static_cast<int>(std::floor(place.y())));
}

int DrawnPicture::count(Colour colour, const Box& within) const {
  int found = 0;
  for (int y = within.y0; y < within.y1; ++y)
    for (int x = within.x0; x < within.x1; ++x) found += shows(colour, x, y) ? 1 : 0;
  return found;
}

Box DrawnPicture::extent(Colour colour, const Box& within) const {
  Box box{within.x1, within.y1, within.x1, within.y1};
  bool any = false;
  for (int y = within.y0; y < within.y1; ++y) {
    for (int x = within.x0; x < within.x1; ++x) {
      if (!shows(colour, x, y)) continue;
      box = any ? Box{std::min(box.x0, x), box.y0, std::max(box.x1, x + 1), y + 1}
                : Box{x, y, x + 1, y + 1};
      any = true;
    }
  }
  return box;
}

std::vector<double> DrawnPicture::lines_across(int row, int from, int to) const {
  std::vector<double> middles;
  double weight = 0.0, moment = 0.0;
  for (int x = from; x <= to; ++x) {
    const double dark = x < to ? darkness(at(x, row)) : 0.0;
    if (dark > 0.0) {
      weight += dark;
      moment += dark * (x + 0.5);
    } else if (weight > 0.0) {
      middles.push_back(moment / weight);
      weight = moment = 0.0;
    }
  }
  return middles;
}

double DrawnPicture::share_off(const DrawnPicture& words, int left, int top, int beside) const {
  double off = 0.0, ink = 0.0;
  const Box rows = words.dark();
  for (int y = rows.y0; y < rows.y1; ++y) {
    for (int x = rows.x0 - beside; x < rows.x1 + beside; ++x) {
      if (left + x < 0 || left + x >= width_ || top + y < 0 || top + y >= height_) continue;
      const bool inside = x >= 0 && x < words.width();
      const int wanted = inside ? darkness(words.at(x, y)) : 0;
      const int there = darkness(at(left + x, top + y));
      ink += wanted + there;
      off += std::abs(wanted - there);
    }
  }
  return off / std::max(1.0, ink);
}

Box DrawnPicture::dark() const {
  Box box{width_, height_, 0, 0};
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x)
      if (darkness(at(x, y)) > 0)
        box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1), y + 1};
  return box;
}

double DrawnPicture::misfit(const std::string& words, double size, const Vec2& place,
                            Anchor anchor) const {
  constexpr double kThird = 1.0 / Canvas::kSamples;  // the step in which words are set [px]
  const int reach = static_cast<int>(size * static_cast<double>(words.size() + 1));  // of them [px]
  const int left = static_cast<int>(std::floor(place.x())) - reach,
            top = static_cast<int>(std::floor(place.y() - 2.0 * size));
  double best = 1.0;
  for (int k = 0; k < 25; ++k) {
    Canvas alone(2 * reach, static_cast<int>(3.0 * size), kWhite);
    const Vec2 shift((k % 5 - 2) * kThird, (k / 5 - 2) * kThird);
    alone.text(place + shift - Vec2(left, top), words, size, kInk, anchor);
    best = std::min(best, share_off(DrawnPicture(alone), left, top, static_cast<int>(0.6 * size)));
  }
  return best;
}

bool DrawnPicture::reads(const std::string& words, double size, const Vec2& place,
                         Anchor anchor) const {
  constexpr double kMostOff = 0.4;  // letters of VTK differ by what was set before them
  const double off = misfit(words, size, place, anchor);
  const std::vector<std::string> others = with_one_other_digit(words);
  return off < kMostOff && std::ranges::all_of(others, [&](const std::string& other) {
           return misfit(other, size, place, anchor) > off;
         });
}

}  // namespace muckpile::testing
