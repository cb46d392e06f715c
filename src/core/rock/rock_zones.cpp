// SPDX-License-Identifier: GPL-2.0-or-later
// Zones of rock.
// Scope: see the header.
#include "rock/rock_zones.h"

#include <algorithm>
#include <cmath>

#include "args/input_error.h"
#include "bond/build/joint_plane.h"
#include "rock/cut_options.h"
#include "rock/cut_table.h"
#include "rock/zone_bodies.h"
#include "rock/zone_model.h"
#include "rock/zone_sizes.h"

namespace muckpile {
namespace {

using Words = std::vector<std::string>;

constexpr double kSamePlane = 1e-6;  // of the box, and of a normal

const std::string kPlaces = "'above', 'below', 'layer', 'region', 'inside' or 'model'";

Range place_range() { return Range::closed(-1e6, 1e6); }

[[noreturn]] void refuse(const std::string& why) {
  throw InputError(std::string(kCreateBlocks) + ": " + why);
}

/// Reads the words behind `zone` from first to last.
class ZoneReader {
 public:
  explicit ZoneReader(const Words& words) : words_(words) {}

  RockZone read() {
    zone_.name = next("a name");
    zone_.density = number("kg/m3", Range::closed(100.0, 30000.0));
    read_place();
    while (at_ < words_.size()) read_option();
    if (zone_.joint_class > 0 && zone_.borders.empty())
      refuse(where() + ": class needs 'above', 'below' or 'layer': other borders are not plane");
    return std::move(zone_);
  }

 private:
  [[nodiscard]] std::string where() const { return "zone '" + zone_.name + "'"; }
  const std::string& next(const std::string& what) {
    if (at_ == words_.size()) refuse(where() + ": " + what + " is missing at the end");
    return words_[at_++];
  }
  double number(const char* unit, const Range& range) {
    return cut_real(where(), next("a number"), unit, range);
  }

  CutPlane plane() {
    CutPlane plane;
    for (int k = 0; k < 3; ++k) plane.point[k] = number("m", place_range());
    const double dip = cut_radians(where(), next("the dip"), 90.0);
    plane.normal = normal_of_dip(dip, cut_radians(where(), next("the dip direction"), 360.0));
    return plane;
  }
  void read_place() {
    const std::string& place = next(kPlaces);
    if (place == "above" || place == "below") {
      const CutPlane border = plane();
      const double side = place == "above" ? 1.0 : -1.0;
      zone_.borders = {border};
      zone_.holds = [border, side](const Vec3& p) {
        return side * border.normal.dot(p - border.point) > 0.0;
      };
    } else if (place == "layer") {
      const CutPlane base = plane();
      const double thickness = number("m", Range::left_open(0.0, 1e6));
      zone_.borders = {base, {base.point + thickness * base.normal, base.normal}};
      zone_.holds = [base, thickness](const Vec3& p) {
        const double height = base.normal.dot(p - base.point);
        return height > 0.0 && height <= thickness;
      };
    } else if (place == "region") {
      zone_.region = next("the ID of a region");
    } else if (place == "inside") {
      zone_.body = RockSurface{next("the name of a file"), SurfaceIs::body, nullptr};
    } else if (place == "model") {
      zone_.of_model = true;
    } else {
      refuse(where() + ": must be " + kPlaces + ", got '" + place + "'");
    }
  }
  void read_option() {
    const std::string option = next("");
    if (option == "class") {
      zone_.joint_class =
          static_cast<int>(cut_whole(where(), next("a number"), Range::closed(0, 255)));
    } else if (option == "size_factor") {
      zone_.size_factor =
          cut_real(where() + ": size_factor", next("a number"), "", Range::closed(0.1, 10.0));
    } else {
      refuse(where() + ": may end with 'class N' and 'size_factor F', got '" + option + "'");
    }
  }

  const Words& words_;
  std::size_t at_ = 0;
  RockZone zone_;
};

bool same_plane(const CutPlane& a, const CutPlane& b, double length) {
  const Vec3 n = a.normal.normalized();
  return n.cross(b.normal.normalized()).norm() < kSamePlane &&
         std::abs(n.dot(b.point - a.point)) < kSamePlane * length;
}

/// The box has corners on both sides of the plane.
bool crosses(const CutPlane& plane, const Vec3& lo, const Vec3& hi) {
  const Vec3 half = 0.5 * (hi - lo), middle = 0.5 * (lo + hi);
  const double reach = plane.normal.cwiseAbs().dot(half);
  return std::abs(plane.normal.dot(middle - plane.point)) < reach * (1.0 - kSamePlane);
}

void lay_borders(CutOptions& options, const RockZone& zone) {
  TessellationOptions& rock = options.rock;
  bool inside = zone.borders.empty();
  for (const CutPlane& border : zone.borders) {
    if (!crosses(border, rock.lo, rock.hi)) continue;
    inside = true;
    cut_along(rock, border);
    if (zone.joint_class > 0)
      options.zone_joints.push_back(
          {border.point, border.normal, static_cast<std::uint8_t>(zone.joint_class)});
  }
  if (!inside)
    refuse("zone '" + zone.name +
           "': its border must cut the rock, got one that lies outside of the region's box");
}

}  // namespace

bool names_a_file(const std::vector<std::string>& words) { return words[2] == "inside"; }

RockZone rock_zone_of(const std::vector<std::string>& words) { return ZoneReader(words).read(); }

void cut_along(TessellationOptions& rock, const CutPlane& plane) {
  const double length = (rock.hi - rock.lo).norm();
  const auto same = [&](const CutPlane& other) { return same_plane(other, plane, length); };
  if (std::ranges::none_of(rock.planes, same)) rock.planes.push_back(plane);
}

std::uint8_t zone_at(const std::vector<RockZone>& zones, const Vec3& point) {
  const auto first =
      std::ranges::find_if(zones, [&](const RockZone& zone) { return zone.holds(point); });
  return first == zones.end() ? std::uint8_t{0}
                              : static_cast<std::uint8_t>(1 + (first - zones.begin()));
}

void lay_zones(CutOptions& options) {
  const std::vector<RockZone>& zones = options.zones;
  if (zones.empty()) return;
  if (zones.size() > kMostZones)
    refuse("zone must be given at most " + std::to_string(kMostZones) + " times, got " +
           std::to_string(zones.size()));
  for (std::size_t k = 0; k < zones.size(); ++k) {
    for (std::size_t other = 0; other < k; ++other)
      if (zones[other].name == zones[k].name) refuse("zone '" + zones[k].name + "' is given twice");
    lay_borders(options, zones[k]);
  }
  check_zone_bodies(options);
  lay_zone_model(options);
  lay_zone_sizes(options);
}

}  // namespace muckpile
