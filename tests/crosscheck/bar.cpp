// SPDX-License-Identifier: GPL-2.0-or-later
// A free bar of joined cubes in Muckpile and in LAMMPS: the frequencies of the same vibrations.
// Scope: crosscheck_bar start CELLS ACROSS FILE writes LAMMPS' bar, crosscheck_bar compare CELLS
// ACROSS MUCKPILE LAMMPS FOLDER SECONDS reads both dumps. The constants are those of bar_*.in.
#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "cpu_time.h"
#include "framework/frequency_fit.h"
#include "framework/report.h"
#include "math/types.h"
#include "text_dump.h"

namespace muckpile::crosscheck {
namespace {

using verification::fitted_frequency;
using verification::PlotFrame;
using verification::Quantity;
using verification::Report;
using verification::Sample;

constexpr double kEdge = 0.1;                             // [m], of a cube
constexpr double kYoungsModulus = 50e9, kDensity = 2600;  // [Pa], [kg/m3]
constexpr double kTimeStep = 4e-6;                        // [s]
constexpr long kPushSteps = 10;
constexpr double kPi = std::numbers::pi;

/// Cubes along x from x = 0, and along y and z about the axis.
struct Shape {
  int cells, across;

  [[nodiscard]] int count() const { return cells * across * across; }
  [[nodiscard]] double length() const { return cells * kEdge; }  // [m]
  [[nodiscard]] double depth() const { return across * kEdge; }  // [m]
  [[nodiscard]] Vec3 centre(const Eigen::Array3i& cell) const {
    return kEdge * (cell.cast<double>() + 0.5).matrix() - 0.5 * depth() * Vec3(0.0, 1.0, 1.0);
  }
  /// From 1.
  [[nodiscard]] int number(const Eigen::Array3i& cell) const {
    return 1 + (cell[0] * across + cell[1]) * across + cell[2];
  }
  [[nodiscard]] bool has(const Eigen::Array3i& cell) const {
    return (cell >= 0).all() && (cell < Eigen::Array3i(cells, across, across)).all();
  }
};

// The bar for LAMMPS

enum PointType { kMass = 1, kJoint = 2, kCentre = 3 };

struct Point {
  int cube;  // from 1
  PointType type;
  Vec3 at;
};

struct Bar {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 2>> springs;  // indices of points
};

/// Four springs on the Gauss points of a face have its area and second moments.
void join(Bar& bar, int first, int second, const Vec3& face, int axis) {
  const double gauss = kEdge / std::sqrt(12.0);
  for (const double a : {-gauss, gauss}) {
    for (const double b : {-gauss, gauss}) {
      Vec3 at = face;
      at[(axis + 1) % 3] += a;
      at[(axis + 2) % 3] += b;
      bar.springs.push_back({bar.points.size(), bar.points.size() + 1});
      bar.points.push_back({first, kJoint, at});
      bar.points.push_back({second, kJoint, at});
    }
  }
}

void put_cube(Bar& bar, const Shape& shape, const Eigen::Array3i& cell) {
  const double gauss = kEdge / std::sqrt(12.0);
  const Vec3 centre = shape.centre(cell);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 side((corner & 1) != 0 ? gauss : -gauss, (corner & 2) != 0 ? gauss : -gauss,
                    (corner & 4) != 0 ? gauss : -gauss);
    bar.points.push_back({shape.number(cell), kMass, centre + side});
  }
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Array3i next = cell;
    ++next[axis];
    if (!shape.has(next)) continue;
    join(bar, shape.number(cell), shape.number(next), centre + 0.5 * kEdge * Vec3::Unit(axis),
         axis);
  }
}

Bar lammps_bar(const Shape& shape) {
  Bar bar;
  std::vector<Eigen::Array3i> cells;
  for (int i = 0; i < shape.cells; ++i)
    for (int j = 0; j < shape.across; ++j)
      for (int k = 0; k < shape.across; ++k) cells.emplace_back(i, j, k);
  for (const auto& cell : cells)
    bar.points.push_back({shape.number(cell), kCentre, shape.centre(cell)});
  for (const auto& cell : cells) put_cube(bar, shape, cell);
  return bar;
}

void write_start(const Shape& shape, const std::string& path) {
  const Bar bar = lammps_bar(shape);
  std::FILE* out = std::fopen(path.c_str(), "w");
  if (out == nullptr) throw std::runtime_error(path + ": cannot be written");
  std::fprintf(out, "bar of cubes\n\n%zu atoms\n3 atom types\n%zu bonds\n1 bond types\n",
               bar.points.size(), bar.springs.size());
  std::fprintf(out, "1 extra bond per atom\n-1 %g xlo xhi\n-1 1 ylo yhi\n-1 1 zlo zhi\n",
               shape.length() + 1.0);
  std::fprintf(out, "\nAtoms\n\n");
  for (std::size_t p = 0; p < bar.points.size(); ++p) {
    const Point& point = bar.points[p];
    std::fprintf(out, "%zu %d %d %.17g %.17g %.17g\n", p + 1, point.cube, point.type, point.at.x(),
                 point.at.y(), point.at.z());
  }
  std::fprintf(out, "\nBonds\n\n");
  for (std::size_t s = 0; s < bar.springs.size(); ++s)
    std::fprintf(out, "%zu 1 %zu %zu\n", s + 1, bar.springs[s][0] + 1, bar.springs[s][1] + 1);
  if (std::fclose(out) != 0) throw std::runtime_error(path + ": cannot be written");
}

// The vibrations

struct Vibration {
  std::string name;
  double expected;  // of the continuum, or of a beam or shaft [Hz]
  std::function<double(const Vec3& start, const Vec3& moved)> part;
};

/// First vibration of a free Euler-Bernoulli beam, cos(a) cosh(a) = 1, over its half length.
double beam_shape(double x, double length) {
  constexpr double kHalf = 4.730040745 / 2.0;
  const double s = (2.0 * x / length - 1.0) * kHalf;
  return std::cos(s) / std::cos(kHalf) + std::cosh(s) / std::cosh(kHalf);
}

std::vector<Vibration> vibrations(const Shape& shape) {
  const double speed = std::sqrt(kYoungsModulus / kDensity), length = shape.length();
  std::vector<Vibration> all;
  for (int n = 1; n <= 3; ++n) {
    all.push_back({"axial " + std::to_string(n), n * speed / (2.0 * length),
                   [n, length](const Vec3& x, const Vec3& u) {
                     return u.x() * std::cos(n * kPi * x.x() / length);
                   }});
  }
  const double turning = shape.depth() / std::sqrt(12.0);  // radius of gyration of the section [m]
  all.push_back(
      {"bending", std::pow(4.730040745 / length, 2) * speed * turning / (2.0 * kPi),
       [length](const Vec3& x, const Vec3& u) { return u.y() * beam_shape(x.x(), length); }});
  if (shape.across == 1) return all;  // the push on the centres does not twist it
  const double shaft = std::sqrt(0.5 * 6.0 * 0.140577);  // square, G = E/2 (Saint-Venant)
  all.push_back({"torsion", shaft * speed / (2.0 * length), [length](const Vec3& x, const Vec3& u) {
                   return (x.y() * u.z() - x.z() * u.y()) * std::cos(kPi * x.x() / length);
                 }});
  return all;
}

Vec3 position(const std::vector<double>& row) { return {row[1], row[2], row[3]}; }

std::vector<Sample> samples_of(const Vibration& vibration, const std::vector<Frame>& frames) {
  constexpr double kPeriods = 2.0;
  std::vector<Sample> samples;
  for (const Frame& frame : frames) {
    const double time = kTimeStep * static_cast<double>(frame.step - kPushSteps);
    if (time < 0.0 || time > kPeriods / vibration.expected) continue;
    double sum = 0.0;
    for (std::size_t r = 0; r < frame.rows.size(); ++r) {
      const Vec3 start = position(frames.front().rows[r]);
      sum += vibration.part(start, position(frame.rows[r]) - start);
    }
    samples.push_back({time, sum});
  }
  return samples;
}

/// Every cube must be where the lattice has one, whatever its number.
std::vector<Frame> frames_of(const Shape& shape, const std::string& path) {
  std::vector<Frame> frames = read_dump(path, 4);
  const auto& rows = frames.front().rows;
  std::set<int> found;
  for (const auto& row : rows) {
    const Vec3 at = position(row) + 0.5 * shape.depth() * Vec3(0.0, 1.0, 1.0);
    const Eigen::Array3i cell = (at / kEdge).array().floor().cast<int>();
    if (shape.has(cell) && (position(row) - shape.centre(cell)).norm() < 1e-6 * kEdge)
      found.insert(shape.number(cell));
  }
  if (found.size() != rows.size() || rows.size() != static_cast<std::size_t>(shape.count()))
    throw std::runtime_error(path + ": " + std::to_string(found.size()) + " of " +
                             std::to_string(rows.size()) + " cubes are in place, must be " +
                             std::to_string(shape.count()));
  return frames;
}

double frequency(const Vibration& vibration, const std::vector<Frame>& frames) {
  const double guess = 2.0 * kPi * vibration.expected;
  return fitted_frequency(samples_of(vibration, frames), 0.7 * guess, 1.3 * guess) / (2.0 * kPi);
}

std::string name_of(const Shape& shape) {
  return "bar of " + std::to_string(shape.cells) + " x " + std::to_string(shape.across) + " x " +
         std::to_string(shape.across) + " cubes";
}

void compare(const Shape& shape, const std::vector<Frame>& here, const std::vector<Frame>& there,
             Report& report) {
  constexpr double kAllowed = 0.01;
  const std::string bar = name_of(shape) + ", ";
  for (const Vibration& vibration : vibrations(shape)) {
    const double found = frequency(vibration, here);
    report.relative({bar + vibration.name, "Muckpile against LAMMPS", "Hz", "LAMMPS"}, found,
                    frequency(vibration, there), kAllowed);
    if (vibration.name.starts_with("axial"))
      report.relative({bar + vibration.name, "Muckpile against n c / 2 L", "Hz", "bar wave"}, found,
                      vibration.expected, kAllowed);
  }
}

/// Errors grow with the square of the cubes' edge, and the cost of a bar with its inverse fourth
/// power: three for the cubes, one for the steps.
void compare_cost(const Shape& shape, const std::vector<Frame>& here,
                  const std::vector<Frame>& there, double seconds_here, double seconds_there,
                  Report& report) {
  const double ratio = seconds_there / seconds_here;
  report.measured({name_of(shape), "CPU time of the run, Muckpile", "s", ""}, seconds_here);
  report.measured({name_of(shape), "CPU time of the run, LAMMPS over Muckpile", "-", ""}, ratio);
  if (shape.across == 1) return;
  const Vibration axial_3 = vibrations(shape)[2];
  const auto error = [&](const std::vector<Frame>& frames) {
    return std::abs(frequency(axial_3, frames) / axial_3.expected - 1.0);
  };
  report.measured(
      {name_of(shape), "the same with so many cubes that axial 3 is equally wrong", "-", ""},
      ratio * std::pow(error(there) / error(here), 2));
}

int run(const std::vector<std::string>& words) {
  const std::string job = words.empty() ? "" : words[0];
  const bool start = job == "start" && words.size() == 4;
  if (!start && !(job == "compare" && words.size() == 7)) {
    std::fprintf(stderr,
                 "usage: crosscheck_bar start CELLS ACROSS FILE\n"
                 "       crosscheck_bar compare CELLS ACROSS MUCKPILE LAMMPS FOLDER SECONDS\n");
    return 2;
  }
  const Shape shape{std::stoi(words[1]), std::stoi(words[2])};
  if (start) {
    write_start(shape, words[3]);
    return 0;
  }
  Report report("crosscheck.bar_" + words[2]);
  const std::vector<Frame> here = frames_of(shape, words[3]), there = frames_of(shape, words[4]);
  const auto seconds = [](const std::filesystem::path& frames) {
    return cpu_seconds(frames.parent_path());
  };
  compare(shape, here, there, report);
  compare_cost(shape, here, there, seconds(words[3]), seconds(words[4]), report);
  report.write(words[5], std::stod(words[6]));
  return report.acceptable() ? 0 : 1;
}

}  // namespace
}  // namespace muckpile::crosscheck

int main(int argc, char** argv) {
  try {
    return muckpile::crosscheck::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crosscheck_bar: %s\n", error.what());
    return 2;
  }
}
