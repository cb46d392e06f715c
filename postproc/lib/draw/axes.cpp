// SPDX-License-Identifier: GPL-2.0-or-later
// A framed plot area with ticks, grid and labels, and the map from data to pixels.
// Scope: straight or logarithmic axes.
#include "draw/axes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

#include "draw/text.h"

namespace muckpile {
namespace {

constexpr double kTextSize = 19.0;   // [px]
constexpr double kTick = 6.0;        // [px]
constexpr double kTickSpace = 90.0;  // between ticks, about [px]
constexpr Colour kGridLine{0.90F, 0.91F, 0.92F};

// Share of the way from the low to the high end of a range.
double share_of(double value, const AxisRange& range, Scale scale) {
  return scale == Scale::kStraight ? (value - range.low) / (range.high - range.low)
                                   : std::log(value / range.low) / std::log(range.high / range.low);
}

// 1, 2, 5 and their powers of ten before other ticks of a logarithmic axis; straight ones in order.
int rank_of(double tick, Scale scale) {
  if (scale == Scale::kStraight) return 0;
  const double first = tick / std::pow(10.0, std::floor(std::log10(tick) + 1e-9));
  return first < 1.5 ? 0 : std::abs(first - 2.0) < 0.5 || std::abs(first - 5.0) < 0.5 ? 1 : 2;
}

// Words under the axis, each in the middle of its tick.
class WordsInARow {
 public:
  // Whether they have room beside those that were added before.
  bool add(double middle, const std::string& words) {
    const double half = 0.5 * (text_mask(words, kTextSize, 0.0).advance.x() + kBetween);
    const auto meets = [&](const std::pair<double, double>& other) {
      return std::abs(middle - other.first) < half + other.second;
    };
    if (std::ranges::any_of(taken_, meets)) return false;
    taken_.emplace_back(middle, half);
    return true;
  }

 private:
  static constexpr double kBetween = 8.0;         // [px]
  std::vector<std::pair<double, double>> taken_;  // middle and half the width [px]
};

// Ticks that get words, of those in the order of their ranks: as many as there is room for. Of a
// logarithmic axis all of a rank or none, or every second, third... power of ten: even steps.
template <class Add>
std::vector<double> ticks_with_words(const std::vector<double>& ticks, Scale scale, Add add) {
  WordsInARow words;
  std::vector<double> chosen;
  for (int rank = 0; rank < 3; ++rank) {
    std::vector<double> own;
    std::ranges::copy_if(ticks, std::back_inserter(own),
                         [&](double tick) { return rank_of(tick, scale) == rank; });
    for (size_t every = 1;; ++every) {
      WordsInARow tried = words;
      std::vector<double> fit;
      bool all = true;
      for (size_t k = 0; k < own.size(); k += every) {
        if (add(tried, own[k]))
          fit.push_back(own[k]);
        else
          all = false;
      }
      if (!all && scale == Scale::kLogarithmic) {
        if (rank == 0) continue;
        return chosen;
      }
      words = tried;
      chosen.insert(chosen.end(), fit.begin(), fit.end());
      if (every > 1) return chosen;
      break;
    }
  }
  return chosen;
}

}  // namespace

std::vector<double> straight_ticks(AxisRange range, int wanted) {
  const double rough = (range.high - range.low) / std::max(1, wanted);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough * (1.0 - 1e-9)) step = factor * power;
  }
  std::vector<double> ticks;
  const double slack = 1e-9 * step;
  for (double k = std::ceil((range.low - slack) / step); k * step <= range.high + slack; k += 1.0) {
    ticks.push_back(k * step);
  }
  return ticks;
}

std::vector<double> logarithmic_ticks(AxisRange range) {
  const bool is_wide = range.high > 20.0 * range.low;
  std::vector<double> ticks;
  for (double power = std::pow(10.0, std::floor(std::log10(range.low))); power <= range.high;
       power *= 10.0) {
    for (int factor = 1; factor < 10; ++factor) {
      if (is_wide && factor != 1 && factor != 2 && factor != 5) continue;
      const double tick = factor * power;
      if (tick >= range.low * (1.0 - 1e-9) && tick <= range.high * (1.0 + 1e-9))
        ticks.push_back(tick);
    }
  }
  return ticks;
}

std::string spelled(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value == 0.0 ? 0.0 : value);
  return text;
}

Axes::Axes(Vec2 upper_left, Vec2 lower_right, AxisRange x, AxisRange y, Scale x_scale,
           Scale y_scale)
    : upper_left_(std::move(upper_left)),
      lower_right_(std::move(lower_right)),
      x_(x),
      y_(y),
      x_scale_(x_scale),
      y_scale_(y_scale) {}

Vec2 Axes::place(double x, double y) const {
  const double across = share_of(x, x_, x_scale_), up = share_of(y, y_, y_scale_);
  return {upper_left_.x() + across * (lower_right_.x() - upper_left_.x()),
          lower_right_.y() + up * (upper_left_.y() - lower_right_.y())};
}

std::vector<Vec2> Axes::places(const std::vector<Vec2>& points) const {
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const Vec2& p : points) out.push_back(place(p.x(), p.y()));
  return out;
}

std::vector<double> Axes::x_ticks() const {
  if (!x_words_.empty()) {
    std::vector<double> places(x_words_.size());
    std::iota(places.begin(), places.end(), 1.0);
    return places;
  }
  const int wanted = static_cast<int>((lower_right_.x() - upper_left_.x()) / kTickSpace);
  return x_scale_ == Scale::kStraight ? straight_ticks(x_, wanted) : logarithmic_ticks(x_);
}

std::vector<double> Axes::y_ticks() const {
  const int wanted = static_cast<int>((lower_right_.y() - upper_left_.y()) / kTickSpace) + 1;
  if (y_scale_ == Scale::kLogarithmic) return logarithmic_ticks(y_);
  constexpr size_t kFewest = 3;  // to read values by
  const std::vector<double> ticks = straight_ticks(y_, wanted);
  return ticks.size() < kFewest ? straight_ticks(y_, 2 * wanted) : ticks;
}

std::string Axes::x_text(double x) const {
  return x_words_.empty() ? spelled(x) : x_words_.at(static_cast<size_t>(std::lround(x)) - 1);
}

void Axes::draw_grid(Canvas& canvas) const {
  for (const double x : x_ticks()) canvas.line(place(x, y_.low), place(x, y_.high), 1.0, kGridLine);
  for (const double y : y_ticks()) {
    canvas.line(place(x_.low, y), place(x_.high, y), 1.0, kGridLine);
  }
}

void Axes::draw_frame(Canvas& canvas, const std::string& x_label,
                      const std::string& y_label) const {
  const Vec2 low = place(x_.low, y_.low), high = place(x_.high, y_.high);
  const Vec2 frame[] = {low, {high.x(), low.y()}, high, {low.x(), high.y()}, low};
  canvas.polyline(frame, 1.2, kInk);
  const std::vector<double> ticks = x_ticks();
  for (const double x : ticks)
    canvas.line(place(x, y_.low), place(x, y_.low) + Vec2(0.0, kTick), 1.2, kInk);
  const auto add = [&](WordsInARow& words, double x) {
    return words.add(place(x, y_.low).x(), x_text(x));
  };
  for (const double x : ticks_with_words(ticks, x_scale_, add))
    canvas.text(place(x, y_.low) + Vec2(0.0, kTick + kTextSize), x_text(x), kTextSize, kInk,
                Anchor::kCentre);
  for (const double y : y_ticks()) {
    const Vec2 at = place(x_.low, y);
    canvas.line(at, at - Vec2(kTick, 0.0), 1.2, kInk);
    canvas.text(at + Vec2(-kTick - 5.0, 0.36 * kTextSize), spelled(y), kTextSize, kInk,
                Anchor::kRight);
  }
  canvas.text({0.5 * (low.x() + high.x()), low.y() + kTick + 2.6 * kTextSize}, x_label, kTextSize,
              kInk, Anchor::kCentre);
  canvas.text({low.x() - 3.4 * kTextSize, 0.5 * (low.y() + high.y())}, y_label, kTextSize, kInk,
              Anchor::kCentre, 90.0);
}

}  // namespace muckpile
