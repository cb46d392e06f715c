// SPDX-License-Identifier: GPL-2.0-or-later
// The bench that the measures of `profile` are made for, and whether a run is one.
// Scope: see the header; docs/post/profile.md gives the tolerances.
#include "report/bench_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "draw/axes.h"
#include "measure/broken_out.h"
#include "measure/columns.h"
#include "measure/free_face.h"
#include "measure/start_extent.h"
#include "report/degrees.h"
#include "report/hole_frames_of.h"
#include "report/not_measurable.h"

namespace muckpile {
namespace {

// Far above what rounding leaves of a cut along x = 0, far below what a face must lean for the
// measures to feel it.
constexpr double kFaceOff = 0.05;    // from the plane, of the mean block size
constexpr double kFaceShare = 0.01;  // of an upright face's area that may lie farther off
// Of a leaning one: cuts of coarse blocks round the edges of a region that is no box.
constexpr double kLeaningShare = 0.05;
constexpr double kHoleOff = 0.05;  // of a hole from where it is taken to be, of the burden

constexpr const char* kInstead =
    "; throw, face velocity, swell and the section through a hole are not measured (section, over, "
    "trough, fragments, energy, render and series hold for any bench)";

[[noreturn]] void refuse(const std::string& what) {
  throw NotMeasurable("profile: " + what + kInstead);
}

std::string to_mm(double metres) { return spelled(1e-3 * std::round(1e3 * metres)); }

// How far the face runs back per height, or its map where it is no plane.
void set_face(BenchScene& bench, const std::vector<StartBlock>& blocks) {
  const double size = mean_block_size(blocks, std::vector<char>(blocks.size(), 1));
  const FreeFace face = free_face(blocks, kFaceOff * size);
  if (face.off_plane <= (face.back > 0.0 ? kLeaningShare : kFaceShare)) {
    bench.planes.face_back = face.back;
    return;
  }
  bench.planes.face = face_map(blocks);
  if (bench.planes.face == nullptr) refuse("there is no rock above the pit floor z = 0");
  bench.face_note = "no plane: rock begins between x = " + to_mm(face.x_low) + " and " +
                    to_mm(face.x_high) + " m and stands at " + spelled(degrees(face.slope)) +
                    "° to the horizontal; measured behind the face as it was cut";
}

// Muck in front of the face, or a face that is somewhere else, is not what is measured.
void require_burden(const BenchScene& bench) {
  if (bench.planes.face == nullptr) return;
  const double hole = bench.burden + 0.5 * bench.planes.hole_back * bench.height;
  const double behind = bench.planes.face->middle() + hole;
  if (behind > 0.0 && behind < 2.0 * bench.burden) return;
  refuse(
      "the free face must lie in front of the front row of holes by less than twice burden_m of "
      "scene.json, " +
      spelled(bench.burden) + " m, got " + to_mm(behind) + " m in its middle (" + bench.face_note +
      ")");
}

// Way of the axis along x and y per height.
Vec2 lean_of(const Charge& charge) {
  const Vec3 along = charge.collar - charge.toe;
  return along.head<2>() / along.z();
}

// A hole that is not as the others, or leans sideways.
const Charge* odd_hole(const BenchScene& bench) {
  const Charge& first = bench.charges.front();
  for (const Charge& charge : bench.charges) {
    const Vec3 along = charge.collar - charge.toe;
    const Vec2 off = along.head<2>() - along.z() * Vec2(lean_of(first).x(), 0.0);
    const bool as_first = off.norm() <= kHoleOff * bench.burden;
    if (!(as_first && along.x() <= kHoleOff * bench.burden)) return &charge;  // NaN: level
  }
  return nullptr;
}

[[noreturn]] void refuse_hole(const Charge& charge, const std::string& missing) {
  refuse("holes must be parallel and upright, or lean straight back, got one from x = " +
         spelled(charge.toe.x()) + ", y = " + spelled(charge.toe.y()) + " m at its toe to x = " +
         spelled(charge.collar.x()) + ", y = " + spelled(charge.collar.y()) +
         " m at its upper end (others are measured by their burdens, but " + missing + ")");
}

double depth_of(const Charge& charge) { return -foot_of(charge).x(); }

// Half a spacing beside the outermost holes.
void set_width(BenchScene& bench, double spacing) {
  const auto y = [](const Charge& charge) { return foot_of(charge).y(); };
  const auto [low, high] = std::ranges::minmax(bench.charges, {}, y);
  bench.planes.spacing = spacing;
  bench.planes.y_low = y(low) - 0.5 * spacing;
  bench.planes.y_high = y(high) + 0.5 * spacing;
}

constexpr double kToOneSide = 0.25 * std::numbers::pi;  // a normal so far off x is of another face

// Each hole by the normal of its burden.
void measure_by_holes(BenchScene& bench, std::shared_ptr<const HoleFrames> frames) {
  const auto& holes = frames->holes();
  for (size_t h = 0; h < holes.size(); ++h) {
    const double burden = frames->burden_at_floor(h);
    if (holes[h].row > 0 || (burden > 0.0 && burden < 2.0 * bench.burden)) continue;
    refuse(
        "the free face must lie in front of the first holes by less than twice burden_m of "
        "scene.json, " +
        spelled(bench.burden) + " m, got " + to_mm(burden) + " m at the floor for hole " +
        holes[h].name);
  }
  const double turn = frames->largest_turn();
  bench.several_sides = turn > kToOneSide;
  if (!bench.several_sides) set_width(bench, frames->plan().spacing);
  bench.depth = frames->depth();
  bench.one_row = frames->rows() == 1;
  bench.face_note = "throw, velocity and rock of each hole along the normal of its burden, up to " +
                    spelled(std::round(degrees(turn))) + "° off x";
  if (bench.several_sides)
    bench.face_note +=
        "; no height, toe, slope and swell along x, as rock goes to several sides: see heights and "
        "section";
  bench.planes.frames = std::move(frames);
}

// A row, or rows, that throw along x.
void measure_along_x(BenchScene& bench, const ResultFolder& folder) {
  bench.planes.hole_back = std::max(-lean_of(bench.charges.front()).x(), 0.0);
  const auto [front, last] = std::ranges::minmax(bench.charges, {}, depth_of);
  bench.depth = depth_of(last);
  if (!(std::abs(depth_of(front) - bench.burden) <= kHoleOff * bench.burden)) {
    refuse("the front row of holes must stand at x = " + spelled(-bench.burden) +
           " m, the burden_m of scene.json, got x = " + spelled(-depth_of(front)) + " m");
  }
  require_burden(bench);
  if (std::filesystem::exists(folder.dump("holes.csv")) && folder.scene_has("spacing_m"))
    set_width(bench, folder.scene_number("spacing_m"));
  bench.one_row = bench.depth < 1.5 * bench.burden;
}

// How well a section along x shows the hole: 0: of the front row, thrown along x; 1: of the front
// row, thrown to another side; 2: of another row.
int section_rank(const BenchScene& bench, const Charge& charge) {
  if (bench.planes.frames == nullptr) return depth_of(charge) > 1.5 * bench.burden ? 2 : 0;
  const HoleFrames& frames = *bench.planes.frames;
  const HoleFrame& hole = frames.holes()[frames.hole_at(charge.toe)];
  if (hole.row > 0) return 2;
  return hole.direction.x() >= std::cos(kToOneSide) ? 0 : 1;
}

std::shared_ptr<const HoleFrames> frames_of(const ResultFolder& folder, double burden,
                                            std::string& missing) {
  missing = "spacing_m of scene.json is missing";
  if (!folder.scene_has("spacing_m")) return nullptr;
  return hole_frames_of(folder, {burden, folder.scene_number("spacing_m")}, missing);
}

}  // namespace

Vec2 foot_of(const Charge& charge) {
  return charge.toe.head<2>() - charge.toe.z() * lean_of(charge);
}

BenchScene bench_scene(const ResultFolder& folder, const std::vector<StartBlock>& blocks) {
  BenchScene bench{};
  set_face(bench, blocks);
  bench.height = folder.scene_number("bench_height_m");
  bench.burden = folder.scene_number("burden_m");
  bench.charge_top = bench.height - folder.scene_number("stemming_m");
  bench.charge_bottom = bench.charge_top - folder.scene_number("charge_length_m");
  bench.hole_radius = 0.5 * folder.scene_number("hole_diameter_m");
  bench.charges = charges_of(folder);
  std::string missing;
  auto frames = frames_of(folder, bench.burden, missing);
  const Charge* odd = odd_hole(bench);
  if (odd != nullptr && frames == nullptr) refuse_hole(*odd, missing);
  if (odd != nullptr || (frames != nullptr && frames->largest_turn() > kToOneSide))
    measure_by_holes(bench, std::move(frames));
  else
    measure_along_x(bench, folder);
  return bench;
}

BenchScene bench_or_take_back(const ResultFolder& folder, const std::vector<StartBlock>& blocks,
                              const std::string& report, const nlohmann::ordered_json& own_keys) {
  try {
    return bench_scene(folder, blocks);
  } catch (const NotMeasurable& refusal) {
    take_back(folder, report, own_keys, refusal);
    throw;
  }
}

BenchPlanes bounded_by_rock(BenchPlanes planes, const std::vector<StartBlock>& blocks) {
  const Extent rock = extent_at_start(blocks);
  planes.y_low = std::max(planes.y_low, rock.low.y());
  planes.y_high = std::min(planes.y_high, rock.high.y());
  return planes;
}

std::vector<Vec2> face_line(const BenchScene& bench, double y) {
  if (bench.several_sides) return {};  // the map is of the face that looks along x
  if (bench.planes.face == nullptr)
    return {{-bench.planes.face_back * bench.height, bench.height}, {0.0, 0.0}};
  std::vector<Vec2> line = bench.planes.face->section(y);
  std::ranges::reverse(line);
  return line;
}

std::vector<Vec2> face_at_height(const BenchScene& bench, double z, double y_low, double y_high) {
  constexpr int kPieces = 200;
  if (bench.several_sides) return {};
  if (bench.planes.face == nullptr) {
    const double x = -bench.planes.face_back * z;
    return {{x, y_low}, {x, y_high}};
  }
  const FaceMap& face = *bench.planes.face;
  const double from = std::max(y_low, face.y_low()), to = std::min(y_high, face.y_high());
  std::vector<Vec2> line;
  for (int k = 0; k <= kPieces; ++k) {
    const double y = from + (to - from) * k / kPieces;
    line.emplace_back(face.x(y, z), y);
  }
  return line;
}

double y_of_middle_hole(const BenchScene& bench, const std::vector<StartBlock>& blocks) {
  const Extent rock = extent_at_start(blocks);
  const double middle = 0.5 * (rock.low.y() + rock.high.y());
  const auto rank = [&bench](const Charge& charge) { return section_rank(bench, charge); };
  const int best = rank(*std::ranges::min_element(bench.charges, {}, rank));
  double nearest = std::nan("");
  for (const Charge& charge : bench.charges) {
    if (rank(charge) != best) continue;
    const double y = charge.toe.y();
    // Of two that are as near the one at the larger y.
    const double nearer = std::abs(nearest - middle) - std::abs(y - middle);
    if (std::isnan(nearest) || nearer > 1e-9 || (nearer > -1e-9 && y > nearest)) nearest = y;
  }
  return nearest;
}

std::vector<SectionBar> hole_bars(const BenchScene& bench, double y) {
  std::vector<SectionBar> charges, stemming;
  for (const Charge& charge : bench.charges) {
    if (std::abs(charge.toe.y() - y) > charge.radius) continue;
    const double half = std::isnan(charge.hole_radius) ? bench.hole_radius : charge.hole_radius;
    const Vec2 toe(charge.toe.x(), charge.toe.z()), collar(charge.collar.x(), charge.collar.z());
    charges.push_back({toe, collar, half, kSignal, charges.empty() ? "charge before" : ""});
    const bool highest = std::ranges::none_of(bench.charges, [&](const Charge& other) {
      return (foot_of(other) - foot_of(charge)).norm() < charge.radius &&
             other.collar.z() > charge.collar.z();
    });
    if (!highest || collar.y() >= bench.height) continue;
    const Vec2 mouth(collar.x() + lean_of(charge).x() * (bench.height - collar.y()), bench.height);
    stemming.push_back({collar, mouth, half, kGrey, stemming.empty() ? "stemming before" : ""});
  }
  charges.insert(charges.end(), stemming.begin(), stemming.end());
  return charges;
}

}  // namespace muckpile
