// SPDX-License-Identifier: GPL-2.0-or-later
// Picture of the cracks around the charges, in a level plane.
// Scope: where the faces were before the blast; see cracks_of_run.h.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "draw/axes.h"
#include "draw/title.h"
#include "report/cracks_of_run.h"

namespace muckpile {
namespace {

constexpr double kLeft = 105.0, kRight = 30.0, kAbove = 150.0, kBelow = 85.0;  // margins [px]
constexpr double kMostSide = 1300.0;                                           // of the frame [px]
constexpr double kTextSize = 20.0;
constexpr Colour kHoldsColour{0.87F, 0.88F, 0.89F}, kApartColour{0.33F, 0.47F, 0.67F};

struct Trace {
  Vec2 from, to;  // [m]
  enum class Kind { kHolding, kApart, kConnected } kind;
};

std::vector<Trace> traces_of(const CracksOfRun& cracks, double level) {
  std::vector<Trace> traces;
  for (size_t f = 0; f < cracks.faces.size(); ++f) {
    const auto cut = cut_of(cracks.faces[f], Vec3::UnitZ(), level);
    if (!cracks.faces[f].other || !cut) continue;
    traces.push_back({cut->first.head<2>(), cut->second.head<2>(),
                      cracks.connected(f)     ? Trace::Kind::kConnected
                      : cracks.broken[f] != 0 ? Trace::Kind::kApart
                                              : Trace::Kind::kHolding});
  }
  return traces;
}

// All that has broken, and the zones of the charges.
std::pair<AxisRange, AxisRange> frame_of(const CracksOfRun& cracks,
                                         const std::vector<Trace>& traces) {
  constexpr double kRoom = 4.0;  // beside a charge [its radii]
  Vec2 low = Vec2::Constant(1e300), high = -low;
  const auto add = [&](const Vec2& p, double room) {
    low = low.cwiseMin(p - Vec2::Constant(room));
    high = high.cwiseMax(p + Vec2::Constant(room));
  };
  for (const Charge& charge : cracks.charges)
    add(0.5 * (charge.toe + charge.collar).head<2>(), kRoom * charge.radius);
  for (const Trace& trace : traces) {
    if (trace.kind == Trace::Kind::kHolding) continue;
    add(trace.from, 0.0);
    add(trace.to, 0.0);
  }
  return {{low.x(), high.x()}, {low.y(), high.y()}};
}

bool within(const std::pair<AxisRange, AxisRange>& frame, const Vec2& p) {
  return p.x() >= frame.first.low && p.x() <= frame.first.high && p.y() >= frame.second.low &&
         p.y() <= frame.second.high;
}

void draw_circle(const Vec2& centre, double radius, const std::pair<AxisRange, AxisRange>& frame,
                 const Axes& axes, Canvas& canvas) {
  constexpr int kCorners = 240;
  std::vector<Vec2> piece;
  const auto draw = [&] {
    if (piece.size() > 1) canvas.dashes(piece, 1.5, 8.0, kInk);
    piece.clear();
  };
  for (int k = 0; k <= kCorners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kCorners;
    const Vec2 at = centre + radius * Vec2(std::cos(angle), std::sin(angle));
    if (within(frame, at)) piece.push_back(axes.place(at.x(), at.y()));
    if (!within(frame, at)) draw();
  }
  draw();
}

// The crushed zone, and 30 and 50 hole radii, where radial cracks of practice end.
void draw_charges(const CracksOfRun& cracks, const std::pair<AxisRange, AxisRange>& frame,
                  const Axes& axes, Canvas& canvas) {
  for (const Charge& charge : cracks.charges) {
    const Vec2 centre = 0.5 * (charge.toe + charge.collar).head<2>();
    draw_circle(centre, charge.radius, frame, axes, canvas);
    if (std::isnan(cracks.hole_radius)) continue;
    for (const double radii : {30.0, 50.0}) {
      draw_circle(centre, radii * cracks.hole_radius, frame, axes, canvas);
      const Vec2 at = centre + Vec2(0.0, radii * cracks.hole_radius);
      if (within(frame, at))
        canvas.text(axes.place(at.x(), at.y()) - Vec2(0.0, 6.0), spelled(radii), kTextSize, kInk,
                    Anchor::kCentre);
    }
  }
}

void draw_traces(const std::vector<Trace>& traces, const std::pair<AxisRange, AxisRange>& frame,
                 const Axes& axes, Canvas& canvas) {
  for (const auto& [kind, colour, thickness] :
       {std::tuple(Trace::Kind::kHolding, kHoldsColour, 1.0),
        std::tuple(Trace::Kind::kApart, kApartColour, 2.0),
        std::tuple(Trace::Kind::kConnected, kSignal, 2.5)}) {
    for (const Trace& trace : traces) {
      if (trace.kind != kind || !within(frame, trace.from) || !within(frame, trace.to)) continue;
      canvas.line(axes.place(trace.from.x(), trace.from.y()),
                  axes.place(trace.to.x(), trace.to.y()), thickness, colour);
    }
  }
}

void draw_words(double level, Canvas& canvas) {
  draw_title({kLeft, 40.0}, "Cracks at z = " + spelled(level) + " m", "", 30.0, canvas);
  double right = kLeft;
  for (const auto& [words, colour] : {std::pair("hang together with a hole", kSignal),
                                      std::pair("other broken joints", kApartColour)}) {
    canvas.line({right, 70.0}, {right + 40.0, 70.0}, 4.0, colour);
    canvas.text({right + 50.0, 77.0}, words, kTextSize, kInk);
    right += 330.0;
  }
  canvas.text({kLeft, 110.0}, "dashed: crushed zone, 30 and 50 hole radii", kTextSize, kInk);
}

}  // namespace

Canvas draw_cracks(const CracksOfRun& cracks) {
  const double level = 0.5 * (cracks.charges.front().toe + cracks.charges.front().collar).z();
  const std::vector<Trace> traces = traces_of(cracks, level);
  const auto frame = frame_of(cracks, traces);
  const double x = frame.first.high - frame.first.low, y = frame.second.high - frame.second.low;
  const double scale = kMostSide / std::max(x, y);
  const double width = std::max(620.0, scale * x), height = scale * y;
  const double more = 0.5 * (width / scale - x);
  Canvas canvas(static_cast<int>(kLeft + width + kRight),
                static_cast<int>(kAbove + height + kBelow), kWhite);
  const Axes axes({kLeft, kAbove}, {kLeft + width, kAbove + height},
                  {frame.first.low - more, frame.first.high + more}, frame.second);
  draw_traces(traces, frame, axes, canvas);
  draw_charges(cracks, frame, axes, canvas);
  axes.draw_frame(canvas, "x [m]", "y [m]");
  draw_words(level, canvas);
  return canvas;
}

}  // namespace muckpile
