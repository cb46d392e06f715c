// SPDX-License-Identifier: GPL-2.0-or-later
// Kirra's CSV of holes, converted; see the header.
#include "explosive/kirra_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/numbers.h"
#include "explosive/hole_table.h"
#include "explosive/table_text.h"

namespace muckpile {
namespace {

// What the files without a line of names hold.
constexpr std::string_view kTwelve =
    "holeID,startXLocation,startYLocation,startZLocation,endXLocation,endYLocation,endZLocation,"
    "holeDiameter,holeType,fromHoleID,timingDelayMilliseconds,colorHexDecimal";
constexpr std::string_view kFourteen =
    "entityName,entityType,holeID,startXLocation,startYLocation,startZLocation,endXLocation,"
    "endYLocation,endZLocation,holeDiameter,holeType,fromHoleID,timingDelayMilliseconds,"
    "colorHexDecimal";
constexpr std::string_view kBetween = ":::";  // blast and hole in fromHoleID

struct KirraHole {
  std::string blast, name, from, from_blast, from_name;  // from: as it stands in the file
  Vec3 collar, toe;
  double diameter, delay;          // [m], [s]
  std::optional<double> subdrill;  // [m]
  std::size_t row;
};

CsvTable rows_of(const std::string& text, const std::string& name) {
  const std::string first = text.substr(0, text.find_first_of("\r\n"));
  if (first.find("startXLocation") != std::string::npos) return CsvTable::parse(text, name);
  const auto columns = 1 + std::count(first.begin(), first.end(), ',');
  if (columns == 12) return CsvTable::parse(text, name, kTwelve);
  if (columns == 14) return CsvTable::parse(text, name, kFourteen);
  if (columns == 1) (void)CsvTable::parse(text, name);  // says what else than commas it found
  throw InputError(name +
                   ":1: must have 12 or 14 columns, or a first line that names them as Kirra does, "
                   "got '" +
                   std::to_string(columns) + "' columns");
}

[[noreturn]] void refuse_remark(const std::string& where, std::string_view column,
                                const std::string& name) {
  throw InputError(where + std::string(column) + " must not begin with '#', got '" + name + "'");
}

double number(const CsvTable& csv, std::size_t row, std::string_view column, const char* unit,
              const Range& range) {
  return csv.real(row, csv.column(column), unit, range);
}

Vec3 point(const CsvTable& csv, std::size_t row, const std::string& end) {
  Vec3 at;
  for (int c = 0; c < 3; ++c) {
    const std::string column = end + "XYZ"[c] + "Location";
    at[c] = number(csv, row, column, "m", place_range());
  }
  return at;
}

/// In the table of ours a line that begins with # is a remark.
std::string name_in(const CsvTable& csv, std::size_t row, std::size_t column) {
  const std::string name(csv.word(row, column));
  if (name.rfind('#', 0) == 0) refuse_remark(csv.where(row), csv.header()[column], name);
  return name;
}

/// A hole whose first field begins with # has been read as a remark.
void refuse_holes_in_remarks(const CsvTable& csv, const std::string& file) {
  for (const std::string_view remark : csv.remarks()) {
    const auto fields = 1 + std::count(remark.begin(), remark.end(), ',');
    if (static_cast<std::size_t>(fields) != csv.header().size()) continue;
    const auto line = 1 + std::count(csv.text().data(), remark.data(), '\n');
    refuse_remark(file + ":" + std::to_string(line) + ": ", csv.header().front(),
                  std::string(1, '#').append(remark.substr(0, remark.find(','))));
  }
}

KirraHole hole_of(const CsvTable& csv, std::size_t row) {
  KirraHole hole;
  hole.row = row;
  const auto blast = csv.find_column("entityName");
  hole.blast = blast ? name_in(csv, row, *blast) : "";
  hole.name = name_in(csv, row, csv.column("holeID"));
  if (hole.name.empty()) throw InputError(csv.where(row) + "holeID is missing");
  hole.collar = point(csv, row, "start");
  hole.toe = point(csv, row, "end");
  const Range millimetres = Range::closed(5.0, 1000.0);
  hole.diameter = 1e-3 * number(csv, row, "holeDiameter", "mm", millimetres);
  const Range milliseconds = Range::closed(0.0, 60000.0);
  hole.delay = 1e-3 * number(csv, row, "timingDelayMilliseconds", "ms", milliseconds);
  const auto subdrill = csv.find_column("subdrillAmount");
  if (subdrill && !csv.word(row, *subdrill).empty())
    hole.subdrill = number(csv, row, "subdrillAmount", "m", Range::closed(-50.0, 50.0));
  const std::string from(csv.word(row, csv.column("fromHoleID")));
  hole.from = from;
  const std::size_t cut = from.find(kBetween);
  hole.from_blast = cut == std::string::npos ? hole.blast : from.substr(0, cut);
  hole.from_name = cut == std::string::npos ? from : from.substr(cut + kBetween.size());
  return hole;
}

/// Names of our table, by blast and hole: those of the file where it has one blast.
using Names = std::map<std::pair<std::string, std::string>, std::string>;

Names names_of(const CsvTable& csv, const std::vector<KirraHole>& holes) {
  const bool one_blast = std::all_of(holes.begin(), holes.end(), [&](const KirraHole& hole) {
    return hole.blast == holes.front().blast;
  });
  Names names;
  for (const KirraHole& hole : holes) {
    const std::string name = one_blast ? hole.name : hole.blast + "." + hole.name;
    if (!names.emplace(std::pair(hole.blast, hole.name), name).second)
      throw InputError(csv.where(hole.row) + "hole '" + name + "' is there twice");
  }
  return names;
}

/// The hole that the signal comes from; "" where it comes from the hole itself, or from nowhere:
/// there it starts. A file of 12 columns has no blasts, but its fromHoleID may name one.
std::string signal_from(const CsvTable& csv, const KirraHole& hole, const Names& names) {
  if (hole.from_name.empty()) return "";
  const std::string blast = csv.find_column("entityName") ? hole.from_blast : hole.blast;
  if (blast == hole.blast && hole.from_name == hole.name) return "";
  const auto from = names.find({blast, hole.from_name});
  if (from != names.end()) return from->second;
  throw InputError(csv.where(hole.row) + "fromHoleID must be a hole of the file, got '" +
                   hole.from + "'");
}

/// Turns x to the bearing that the face looks to.
Vec3 turned(const Vec3& p, double bearing) {
  const double s = std::sin(bearing), c = std::cos(bearing);
  return {s * p.x() + c * p.y(), -c * p.x() + s * p.y(), p.z()};
}

Vec3 turned_back(const Vec3& p, double bearing) {
  const double s = std::sin(bearing), c = std::cos(bearing);
  return {s * p.x() - c * p.y(), c * p.x() + s * p.y(), p.z()};
}

/// In the mine's coordinates, to a millimetre: the floor is the mean of the holes' lower ends and
/// their subdrill, y = 0 the middle of the collars.
Vec3 origin_by_holes(const std::vector<KirraHole>& holes, const KirraFrame& frame) {
  double floor = 0.0;
  for (const KirraHole& hole : holes)
    floor +=
        (hole.toe.z() + hole.subdrill.value_or(frame.subdrill)) / static_cast<double>(holes.size());
  double front = -std::numeric_limits<double>::infinity(), low = -front, high = front;
  for (const KirraHole& hole : holes) {
    const Vec3 collar = turned(hole.collar, frame.throw_bearing),
               toe = turned(hole.toe, frame.throw_bearing);
    const double height = collar.z() - toe.z();
    const double share = height > 0.0 ? (floor - toe.z()) / height : 0.0;
    front = std::max(front, toe.x() + share * (collar.x() - toe.x()));
    low = std::min(low, collar.y());
    high = std::max(high, collar.y());
  }
  const Vec3 origin(front + frame.burden, 0.5 * (low + high), floor);
  const Vec3 millimetres = 1e3 * turned_back(origin, frame.throw_bearing);
  return millimetres.array().round() / 1e3;
}

/// To a micrometre: Kirra writes a tenth of a millimetre.
std::string short_text(double value) { return stepped_text(value, 1e-6); }

std::string place_text(const Vec3& at) {
  return short_text(at.x()) + ',' + short_text(at.y()) + ',' + short_text(at.z());
}

}  // namespace

void require_origin_near(const std::vector<Vec3>& collars, const Vec3& origin,
                         const std::string& name) {
  constexpr double kFarthest = 1000.0;  // [m]
  double nearest = std::numeric_limits<double>::infinity();
  Vec3 middle = Vec3::Zero();
  for (const Vec3& collar : collars) {
    nearest = std::min(nearest, (collar - origin).norm());
    middle += collar / static_cast<double>(collars.size());
  }
  if (nearest <= kFarthest) return;
  const auto text = [](const Vec3& at) {
    return short_text(at.x()) + ' ' + short_text(at.y()) + ' ' + short_text(at.z());
  };
  throw InputError(name + ": origin must be within " + number_text(kFarthest) +
                   " m of a hole, got '" + text(origin) + "'; the middle of the collars is at " +
                   text(middle));
}

ConvertedHoles convert_kirra(const std::string& text, const std::string& name,
                             const KirraFrame& frame, const KirraCharge& charge) {
  const CsvTable csv = rows_of(text, name);
  refuse_holes_in_remarks(csv, name);
  std::vector<KirraHole> holes;
  for (std::size_t row = 0; row < csv.rows(); ++row) holes.push_back(hole_of(csv, row));
  if (holes.empty()) throw InputError(name + ": has no hole");
  const Names names = names_of(csv, holes);
  ConvertedHoles converted{"", holes.size(),
                           frame.origin ? *frame.origin : origin_by_holes(holes, frame)};
  std::vector<Vec3> collars;
  for (const KirraHole& hole : holes) collars.push_back(hole.collar);
  require_origin_near(collars, converted.origin, name);
  const Vec3 origin = turned(converted.origin, frame.throw_bearing);
  std::ostringstream table;
  table << "# holes of Kirra's file " << name << "; origin in its coordinates "
        << place_text(converted.origin) << " m\n"
        << "hole,collar_x_m,collar_y_m,collar_z_m,toe_x_m,toe_y_m,toe_z_m,diameter_m,from_m,after,"
           "surface_delay_s,in_hole_delay_s\n";
  for (const KirraHole& hole : holes) {
    const double length = (hole.toe - hole.collar).norm();
    if (!(length > charge.stemming)) {
      throw InputError(csv.where(hole.row) + "hole '" + hole.name + "' must be longer than " +
                       number_text(charge.stemming) + " m, its stemming, got '" +
                       short_text(length) + "'");
    }
    converted.collar_height +=
        (hole.collar.z() - converted.origin.z()) / static_cast<double>(holes.size());
    table << names.at({hole.blast, hole.name}) << ','
          << place_text(turned(hole.collar, frame.throw_bearing) - origin) << ','
          << place_text(turned(hole.toe, frame.throw_bearing) - origin) << ','
          << short_text(hole.diameter) << ',' << short_text(charge.stemming) << ','
          << signal_from(csv, hole, names) << ',' << short_text(hole.delay) << ','
          << short_text(charge.in_hole_delay) << '\n';
  }
  converted.table = table.str();
  return converted;
}

}  // namespace muckpile
