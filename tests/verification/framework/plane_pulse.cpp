// SPDX-License-Identifier: GPL-2.0-or-later
// Plane waves that run along x through a column of blocks.
// Scope: see the header.
#include "framework/plane_pulse.h"

#include <cmath>
#include <numbers>

namespace muckpile::verification {

PlanePulse gaussian_pulse(Polarisation kind, double speed, double wavelength, double deviation,
                          double centre, double amplitude) {
  const double k = 2.0 * std::numbers::pi / wavelength;
  return {kind, speed, wavelength, [=](double x) {
            const double from = x - centre, share = from / deviation;
            return amplitude * std::exp(-0.5 * share * share) * std::cos(k * from);
          }};
}

WallRule column_walls(Polarisation kind, const Vec3& box) {
  return [=](const Vec3& at) {
    const auto on_wall = [&](int a) { return at[a] < 1e-6 || at[a] > box[a] - 1e-6; };
    if (on_wall(1)) return kind == Polarisation::p ? Wall::even : Wall::odd;
    return on_wall(2) ? Wall::even : Wall::free;
  };
}

void launch(BlockRun& run, const PlanePulse& pulse) {
  const double step = 1e-3 * pulse.wavelength;
  const auto& u = pulse.displacement;
  for (std::size_t b = 0; b < run.size(); ++b) {
    const double x = run.start(b).x(), here = u(x), before = u(x - step), after = u(x + step);
    const double gradient = (after - before) / (2.0 * step);
    const double curvature = (after - 2.0 * here + before) / (step * step);
    const Vec3 along = pulse.kind == Polarisation::p ? Vec3::UnitX() : Vec3::UnitY();
    // Half the curl: of u(x) along y it points along z.
    const Vec3 turned = pulse.kind == Polarisation::p ? Vec3::Zero() : Vec3(0.5 * Vec3::UnitZ());
    run.place(b, run.displacement(b) + here * along, gradient * turned);
    run.set_motion(b, -pulse.speed * gradient * along, -pulse.speed * curvature * turned);
  }
}

Station::Station(const BlockRun& run, Polarisation kind, double x, double reach)
    : axis_(kind == Polarisation::p ? 0 : 1) {
  for (std::size_t b = 0; b < run.size(); ++b) {
    if (std::abs(run.start(b).x() - x) > reach) continue;
    blocks_.push_back(b);
    mass_ += run.mass(b);
  }
}

void Station::record(const BlockRun& run) {
  double sum = 0.0;
  for (const std::size_t b : blocks_) sum += run.mass(b) * run.block(b).velocity[axis_];
  velocity_.push_back(sum / mass_);
}

std::complex<double> spectrum(const std::vector<double>& values, double dt, double omega) {
  std::complex<double> sum = 0.0;
  for (std::size_t n = 0; n < values.size(); ++n)
    sum += values[n] * dt * std::polar(1.0, -omega * dt * static_cast<double>(n));
  return sum;
}

}  // namespace muckpile::verification
