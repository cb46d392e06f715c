// SPDX-License-Identifier: GPL-2.0-or-later
// What create_blocks prints about the rock it has cut; see rock_model.h.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "args/first_lines.h"
#include "args/numbers.h"
#include "args/rounded_text.h"
#include "geometry/cut/open_planes.h"
#include "geometry/spheres/filling_quality.h"
#include "rock/rock_model.h"

namespace muckpile {
namespace {

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// Size below which `share` of the rock's volume lies [m].
double size_by_volume(std::vector<double> sizes, double share) {
  std::sort(sizes.begin(), sizes.end());
  double all = 0.0, below = 0.0;
  for (double size : sizes) all += size * size * size;
  for (double size : sizes) {
    below += size * size * size;
    if (below >= share * all) return size;
  }
  return sizes.back();
}

struct BlockSizes {
  std::vector<double> sizes, over_target;
  double volume = 0.0;  // [m3]
};

BlockSizes sizes_of(const std::vector<Block>& blocks) {
  BlockSizes all;
  for (const Block& block : blocks) {
    all.sizes.push_back(std::cbrt(block.mass.volume));
    all.over_target.push_back(all.sizes.back() / block.target_size);
    all.volume += block.mass.volume;
  }
  return all;
}

std::string describe_blocks(const RockModel& model, double seconds) {
  const auto [sizes, ratios, volume] = sizes_of(model.rock.blocks);
  std::size_t spheres = 0, joints = 0;
  for (const RigidBody& body : model.bodies) spheres += body.spheres.size();
  for (const Facet& facet : model.facets.facets) joints += facet.kind == FacetKind::joint ? 1 : 0;
  std::ostringstream text;
  text.precision(4);
  text << "create_blocks: " << sizes.size() << " blocks, " << spheres << " spheres, " << joints
       << " joints, " << model.facets.facets.size() - joints << " supported and "
       << model.facets.faces.size() << " free or loaded faces\n"
       << "  block size by number: smallest " << quantile(sizes, 0.0) << ", 10 % "
       << quantile(sizes, 0.1) << ", 50 % " << quantile(sizes, 0.5) << ", 90 % "
       << quantile(sizes, 0.9) << ", largest " << quantile(sizes, 1.0) << " m; by mass: 20 % "
       << size_by_volume(sizes, 0.2) << ", 50 % " << size_by_volume(sizes, 0.5) << ", 80 % "
       << size_by_volume(sizes, 0.8) << " m; over target " << quantile(ratios, 0.1) << " .. "
       << quantile(ratios, 0.9) << " (10 and 90 %)\n"
       << "  volume " << std::setprecision(9) << volume << std::setprecision(4) << " m3 in blocks, "
       << model.rock.statistics.void_volume << " m3 removed; largest initial sphere overlap "
       << model.largest_overlap << " of a radius; " << std::fixed << std::setprecision(2) << seconds
       << " s\n";
  return text.str();
}

/// Edge of a cube of the mean volume [m].
double mean_size(double volume, std::size_t blocks) {
  return blocks == 0 ? 0.0 : std::cbrt(volume / static_cast<double>(blocks));
}

std::string describe_zones(const RockModel& model) {
  if (model.zones.empty()) return "";
  std::vector<double> volume(model.zones.size() + 1, 0.0);
  std::vector<std::size_t> count(volume.size(), 0);
  for (std::size_t b = 0; b < model.zone_of.size(); ++b) {
    volume[model.zone_of[b]] += model.rock.blocks[b].mass.volume;
    ++count[model.zone_of[b]];
  }
  std::ostringstream text;
  text.precision(4);
  text << "  zones:";
  for (std::size_t k = 0; k < volume.size(); ++k)
    text << ' ' << (k == 0 ? "rock" : model.zones[k - 1]) << ' ' << count[k] << " blocks, "
         << volume[k] << " m3, " << mean_size(volume[k], count[k])
         << (k + 1 < volume.size() ? " m in the mean;" : " m in the mean\n");
  for (std::size_t k = 1; k < count.size(); ++k)
    if (count[k] == 0)
      text << "WARNING: create_blocks: zone '" << model.zones[k - 1]
           << "' holds the centroid of no block; is it where the rock is, not within a zone before "
              "it, and not thinner than the blocks?\n";
  return text.str();
}

/// How much of the rock's facets is natural joint and no fault, as a survey gives it: area per
/// volume (P32).
std::string describe_natural_joints(const RockModel& model) {
  if (model.natural_planes == 0) return "";
  double area = 0.0, volume = 0.0;
  for (const Facet& facet : model.facets.facets)
    area += facet.kind == FacetKind::joint && facet.joint_class > 0 ? facet.area : 0.0;
  for (const FaultFacets& fault : model.faults) area -= fault.joint_class > 0 ? fault.area : 0.0;
  for (const Block& block : model.rock.blocks) volume += block.mass.volume;
  std::ostringstream text;
  text.precision(4);
  text << "  natural joints: " << model.natural_planes << " planes, " << area
       << " m2 of facets with a joint class, " << area / volume << " m2 per m3 of blocks"
       << (model.faults.empty() ? "\n" : ", without those of faults\n");
  return text.str();
}

std::string describe_parts(const TessellationStatistics& statistics) {
  std::string text;
  if (statistics.merged_parts > 0) {
    text += "  " + std::to_string(statistics.merged_parts) +
            " parts between joint planes are too thin for a block: they stay with the rock beside "
            "them, where the joint ends\n";
  }
  if (statistics.lost_parts > 0) {
    text += "WARNING: create_blocks: " + std::to_string(statistics.lost_parts) +
            " parts between joint planes are left out, since no seed fell into their " +
            rounded_text(statistics.lost_volume, 3) + " m3 of rock: take smaller blocks\n";
  }
  return text;
}

/// Void over cylinder of each hole, and which differ so much that the load is another hole's.
std::string describe_voids(const TessellationStatistics& cut) {
  constexpr double kLeast = 0.9, kMost = 1.1;
  constexpr std::size_t kEach = 12;  // of more holes the range
  std::vector<double> ratios;
  std::string each;
  std::vector<std::string> warnings;
  for (std::size_t h = 0; h < std::min(cut.hole_volume.size(), cut.cylinder_volume.size()); ++h) {
    if (!(cut.cylinder_volume[h] > 0.0)) continue;
    ratios.push_back(cut.hole_volume[h] / cut.cylinder_volume[h]);
    const std::string hole = "hole " + std::to_string(h + 1),
                      ratio = rounded_text(ratios.back(), 3);
    each += (each.empty() ? " " : ", ") + hole + ' ' + ratio;
    if (ratios.back() >= kLeast && ratios.back() <= kMost) continue;
    warnings.push_back(
        "WARNING: create_blocks: the void of " + hole + " is " + ratio +
        " times its crushed zone's cylinder, beyond 0.9 to 1.1: its load is that of a " +
        (ratios.back() > 1.0 ? "wider" : "narrower") +
        " hole; take smaller blocks at it, move a plane that crosses it, or, where blocks are 1.5 "
        "radii wide or more, take rings_from 1.5\n");
  }
  if (ratios.empty()) return "";
  if (ratios.size() > kEach)
    each = std::string(" ") + rounded_text(quantile(ratios, 0.0), 3) + " to " +
           rounded_text(quantile(ratios, 1.0), 3) + " for " + std::to_string(ratios.size()) +
           " holes";
  return "  void over the cylinder of its crushed zone:" + each + '\n' +
         first_lines(warnings, "WARNING: create_blocks: ", "voids beyond 0.9 to 1.1");
}

/// Means over some blocks, evenly chosen.
std::string describe_filling(const RockModel& model) {
  constexpr std::size_t kBlocks = 200;
  const std::size_t step = std::max<std::size_t>(1, model.bodies.size() / kBlocks);
  FillingQuality mean;
  double count = 0.0;
  for (std::size_t b = 0; b < model.bodies.size(); b += step, count += 1.0) {
    const FillingQuality one = filling_quality(model.rock.blocks[b].shape, model.bodies[b].spheres);
    mean.coverage += one.coverage;
    mean.surface_deviation += one.surface_deviation;
  }
  const auto [fewest, most] = std::ranges::minmax(
      model.bodies, {}, [](const RigidBody& body) { return body.spheres.size(); });
  std::ostringstream text;
  text.precision(3);
  text << "  " << fewest.spheres.size();
  if (most.spheres.size() > fewest.spheres.size()) text << " to " << most.spheres.size();
  text << " spheres cover " << 100.0 * mean.coverage / count
       << " % of their block; its surface lies " << 100.0 * mean.surface_deviation / count
       << " % of V^(1/3) off theirs (means of " << count << " blocks)\n";
  return text.str();
}

std::string describe_target(const SizeComparison& sizes, const std::string& why) {
  std::ostringstream text;
  text.precision(4);
  text << "  size curve by mass, target and achieved [m]:";
  for (const SizeComparison::Point& point : sizes.points) {
    text << "\n    P" << std::lround(100.0 * point.share) << ' ' << point.target << ' '
         << point.achieved;
  }
  text << "\n  greatest difference between block_min and block_max: "
       << 100.0 * sizes.greatest_difference << " % of the mass";
  text << (sizes.good()
               ? "\n"
               : "; the target is missed (allowed: 3 %, and 5 % for P20, P50, P80): " + why + "\n");
  return text.str();
}

}  // namespace

std::string describe_open_planes(const CutOptions& options, const Tessellation& cut) {
  constexpr double kMany = 0.01;  // of the area of all faces in the planes
  const OpenPlanes open = open_planes(options.rock, cut.blocks);
  if (open.faces == 0) return "";
  const double share = open.area / open.all;
  const std::string told = std::to_string(open.faces) + " faces in planes, " +
                           rounded_text(open.area, 3) + " m2 or " + rounded_text(100.0 * share, 3) +
                           " % of those in them, have nothing behind them and are free";
  if (share <= kMany) return "  " + told + '\n';
  return "WARNING: create_blocks: " + told + ": take smaller blocks\n";
}

std::string describe(const RockModel& model, double seconds) {
  std::string text = describe_blocks(model, seconds) + describe_zones(model) +
                     describe_natural_joints(model) + describe_parts(model.rock.statistics) +
                     describe_voids(model.rock.statistics) + describe_filling(model);
  if (!model.burdens.empty()) text += describe_burdens(model.burdens, model.plan_burden);
  if (model.sizes) text += describe_target(*model.sizes, model.why_missed);
  return text;
}

}  // namespace muckpile
