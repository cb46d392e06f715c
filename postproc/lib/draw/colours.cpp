// SPDX-License-Identifier: GPL-2.0-or-later
// Colours and the few colour maps of our pictures.
// Scope: linear mixing of sRGB values, which is enough for flat drawings.
#include "draw/colours.h"

#include <algorithm>
#include <cmath>

namespace muckpile {
namespace {

Colour from_hue(double hue, double saturation, double value) {
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + 6.0 * hue, 6.0);
    return static_cast<float>(value *
                              (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0)));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

}  // namespace

Colour mix(const Colour& a, const Colour& b, double share_of_b) {
  const auto t = static_cast<float>(std::clamp(share_of_b, 0.0, 1.0));
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue)};
}

Colour ColourMap::at(double value) const {
  const double unit = high_ > low_ ? std::clamp((value - low_) / (high_ - low_), 0.0, 1.0) : 0.0;
  const double place = unit * static_cast<double>(anchors_.size() - 1);
  const size_t i = std::min(static_cast<size_t>(place), anchors_.size() - 2);
  return mix(anchors_[i], anchors_[i + 1], place - static_cast<double>(i));
}

ColourMap amount_map(double low, double high) {
  return {low,
          high,
          {{0.267F, 0.005F, 0.329F},
           {0.254F, 0.265F, 0.530F},
           {0.164F, 0.471F, 0.558F},
           {0.135F, 0.659F, 0.518F},
           {0.478F, 0.821F, 0.318F},
           {0.993F, 0.906F, 0.144F}}};
}

ColourMap strata_map(double low, double high) {
  return {low,
          high,
          {{0.31F, 0.19F, 0.16F},
           {0.55F, 0.30F, 0.20F},
           {0.76F, 0.47F, 0.25F},
           {0.89F, 0.68F, 0.39F},
           {0.96F, 0.86F, 0.62F}}};
}

ColourMap difference_map(double reach) {
  return {-reach,
          reach,
          {{0.02F, 0.19F, 0.38F},
           {0.26F, 0.58F, 0.76F},
           {0.93F, 0.93F, 0.92F},
           {0.90F, 0.53F, 0.40F},
           {0.50F, 0.05F, 0.12F}}};
}

Colour colour_of_name(int number) {
  constexpr double kGolden =
      0.6180339887498949;  // steps by the golden ratio never come close to an earlier hue
  const double hue = std::fmod(kGolden * number, 1.0);
  return from_hue(hue, 0.45 + 0.15 * (number % 3), 0.92 - 0.10 * (number % 2));
}

}  // namespace muckpile
