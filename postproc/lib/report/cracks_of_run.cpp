// SPDX-License-Identifier: GPL-2.0-or-later
// The cracks of a run that hang together with its holes.
// Scope: see the header; the picture is cracks_plot.cpp.
#include "report/cracks_of_run.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "args/input_error.h"
#include "io/csv_writer.h"
#include "io/joints_file.h"
#include "provenance/run_files.h"

namespace muckpile {
namespace {

// Adds the area of a joint to both of its blocks.
void add_area(const RockFace& face, std::vector<double>& areas) {
  areas[face.block] += face.area;
  areas[*face.other] += face.area;
}

// Mean and largest reach in a direction [m]; NaN where the model has no rock.
std::pair<double, double> over_sections(const Reaches& reaches, size_t direction) {
  double sum = 0.0, farthest = std::nan("");
  int count = 0;
  for (size_t k = direction; k < reaches.size(); k += kDirections) {
    if (std::isnan(reaches[k])) continue;
    sum += reaches[k];
    farthest = std::fmax(farthest, reaches[k]);
    ++count;
  }
  return {sum / count, farthest};
}

// A row that is of no joint would otherwise count as a joint that has broken, somewhere else.
void require_joints(const std::string& file, const HoldingJoints& holding,
                    const std::vector<RockFace>& faces, const std::vector<StartBlock>& rock) {
  std::vector<HoldingJoints::Joint> joints, strays;
  for (const RockFace& face : faces)
    if (face.other) joints.push_back({rock[face.block].id, face.face});
  std::ranges::sort(joints);
  std::ranges::set_difference(holding.joints, joints, std::back_inserter(strays));
  if (strays.empty()) return;
  throw InputError(
      file + ": " + std::to_string(strays.size()) + " of " + std::to_string(holding.joints.size()) +
      " rows are of no joint of blocks.vtk, the first of face " +
      std::to_string(strays.front().face) + " of block " + std::to_string(strays.front().id));
}

}  // namespace

double CracksOfRun::connected_share() const {
  double all = 0.0, mine = 0.0;
  for (size_t f = 0; f < faces.size(); ++f) {
    if (broken[f] == 0) continue;
    all += faces[f].area;
    if (connected(f)) mine += faces[f].area;
  }
  return mine / all;
}

std::vector<double> CracksOfRun::connected_of_blocks(size_t blocks) const {
  std::vector<double> all(blocks, 0.0), mine(blocks, 0.0);
  for (size_t f = 0; f < faces.size(); ++f) {
    if (!faces[f].other) continue;
    add_area(faces[f], all);
    if (connected(f)) add_area(faces[f], mine);
  }
  for (size_t b = 0; b < blocks; ++b) mine[b] = all[b] > 0.0 ? mine[b] / all[b] : 0.0;
  return mine;
}

std::optional<CracksOfRun> cracks_of_run(const ResultFolder& folder,
                                         const std::vector<StartBlock>& rock, long step,
                                         double hole_radius) {
  if (!std::filesystem::exists(folder.dump(kJointsFile))) return std::nullopt;
  const HoldingJoints holding = read_joints(folder.dump(kJointsFile));
  if (holding.step != step) return std::nullopt;
  CracksOfRun cracks{faces_of_rock(rock), {}, charges_of(folder), {}, {}, hole_radius};
  require_joints(folder.dump(kJointsFile).string(), holding, cracks.faces, rock);
  for (const RockFace& face : cracks.faces)
    cracks.broken.push_back(face.other && !holding.has(rock[face.block].id, face.face) ? 1 : 0);
  cracks.holes = crack_holes(cracks.faces, cracks.broken, cracks.charges);
  for (size_t h = 0; h < cracks.charges.size(); ++h)
    cracks.reaches.push_back(crack_reaches(cracks.faces, cracks.holes, cracks.charges[h], h));
  return cracks;
}

void write_crack_table(const CracksOfRun& cracks, const std::filesystem::path& path) {
  CsvWriter csv(path, "charge,direction_deg,reach_m,reach_hole_radii,farthest_m");
  constexpr double kWidth = 360.0 / kDirections;  // [degrees]
  for (size_t h = 0; h < cracks.reaches.size(); ++h) {
    for (size_t d = 0; d < kDirections; ++d) {
      const auto [mean, farthest] = over_sections(cracks.reaches[h], d);
      csv.row({static_cast<double>(h + 1), (static_cast<double>(d) + 0.5) * kWidth, mean,
               mean / cracks.hole_radius, farthest});
    }
  }
}

}  // namespace muckpile
