// SPDX-License-Identifier: GPL-2.0-or-later
// Colours and the few colour maps of our pictures.
// Scope: linear mixing of sRGB values, which is enough for flat drawings.
#pragma once

#include <vector>

namespace muckpile {

struct Colour {
  float red, green, blue;  // 0 to 1
};

Colour mix(const Colour& a, const Colour& b, double share_of_b);
inline Colour scaled(const Colour& c, double f) {
  const auto g = static_cast<float>(f);
  return {c.red * g, c.green * g, c.blue * g};
}

// Anchors at equal steps over [low, high]; values outside take the end colours.
class ColourMap {
 public:
  ColourMap(double low, double high, std::vector<Colour> anchors)
      : low_(low), high_(high), anchors_(std::move(anchors)) {}
  [[nodiscard]] Colour at(double value) const;
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }

 private:
  double low_, high_;
  std::vector<Colour> anchors_;
};

// Dark to light, rising evenly in lightness (after matplotlib's viridis), for amounts.
ColourMap amount_map(double low, double high);
// Earth tones from deep brown to pale sand, for where rock came from.
ColourMap strata_map(double low, double high);
// Blue for less than 0, nearly white at 0, red for more; both ends as far from 0.
ColourMap difference_map(double reach);
// One of many well separated colours for a number that only names something.
Colour colour_of_name(int number);

inline constexpr Colour kWhite{1.0F, 1.0F, 1.0F};
inline constexpr Colour kInk{0.13F, 0.14F, 0.16F};
inline constexpr Colour kGrey{0.55F, 0.57F, 0.60F};
inline constexpr Colour kRockInPlace{0.80F, 0.81F, 0.82F};
inline constexpr Colour kSignal{0.80F, 0.13F, 0.13F};
inline constexpr Colour kBench{0.12F, 0.35F, 0.62F};

}  // namespace muckpile
