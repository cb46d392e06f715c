// SPDX-License-Identifier: GPL-2.0-or-later
// Cells of a block model.
// Scope: see the header.
#include "rock/rock_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/small_letters.h"
#include "args/suggestion.h"
#include "rock/gauge_points.h"

namespace muckpile {
namespace {

constexpr int kMostInALeaf = 4;
const std::string kBeside = "rock";  // name of the rock beside the zones

using Names = std::vector<std::string>;

/// What programs call the columns, in small letters.
const std::array<Names, 6>& length_columns() {
  static const std::array<Names, 6> names{{{"x", "x_m", "xc", "centroid_x", "easting"},
                                           {"y", "y_m", "yc", "centroid_y", "northing"},
                                           {"z", "z_m", "zc", "centroid_z", "elevation"},
                                           {"dx", "dx_m", "xinc", "dim_x", "x_length"},
                                           {"dy", "dy_m", "yinc", "dim_y", "y_length"},
                                           {"dz", "dz_m", "zinc", "dim_z", "z_length"}}};
  return names;
}

/// Throws InputError where two columns may be meant.
std::optional<std::size_t> find_column(const CsvTable& table, const std::string& file,
                                       const Names& names) {
  std::optional<std::size_t> found;
  for (std::size_t c = 0; c < table.header().size(); ++c) {
    if (std::ranges::find(names, in_small_letters(table.header()[c])) == names.end()) continue;
    if (found)
      refuse(file, "a block model must have one alone of the columns " + joined(names) +
                       ", got both '" + std::string(table.header()[*found]) + "' and '" +
                       std::string(table.header()[c]) + "'; rename the one that is not meant");
    found = c;
  }
  return found;
}

/// One row after the other.
class CellReader {
 public:
  CellReader(const std::string& file, const RockNames& names, double unit)
      : file_(file), table_(CsvTable::read(file)), names_(names), unit_(unit) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      const auto found = find_column(table_, file_, length_columns()[k]);
      if (!found)
        refuse(file_, "a block model must have one of the columns " + joined(length_columns()[k]) +
                          ", got '" + header() + "'");
      columns_[k] = *found;
    }
    rock_ = find_column(table_, file_, {"rock", "rock_type", "lithology"});
    zone_ = find_column(table_, file_, {"zone"});
    if (rock_.has_value() == zone_.has_value())
      refuse(file_,
             "a block model must have either a column rock (also rock_type, lithology), with "
             "names, or a column zone, with numbers, got '" +
                 header() + "'");
  }

  [[nodiscard]] std::vector<RockCell> cells() const {
    if (table_.rows() == 0) refuse(file_, "must have a cell, got none");
    std::vector<RockCell> cells;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      RockCell cell;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<Eigen::Index>(axis);
        cell.middle[a] = unit_ * table_.number(row, columns_[axis]);
        cell.size[a] = unit_ * table_.real(row, columns_[axis + 3], "", Range::left_open(0.0, 1e9));
      }
      cell.zone = rock_ ? zone_of_name(row) : zone_of_number(row);
      cell.row = row;
      cells.push_back(cell);
    }
    return cells;
  }

 private:
  [[nodiscard]] std::string header() const {
    return joined(Names(table_.header().begin(), table_.header().end()));
  }
  [[nodiscard]] Names known() const {
    Names known;
    for (std::size_t z = 0; z < names_.zones.size(); ++z)
      if (names_.of_model[z]) known.push_back(names_.zones[z]);
    if (std::ranges::find(known, kBeside) == known.end()) known.push_back(kBeside);
    return known;
  }
  [[nodiscard]] std::uint8_t zone_of_name(std::size_t row) const {
    const std::string name(table_.word(row, *rock_));
    for (std::size_t z = 0; z < names_.zones.size(); ++z)
      if (names_.of_model[z] && names_.zones[z] == name) return static_cast<std::uint8_t>(z + 1);
    if (name == kBeside) return 0;
    throw InputError(table_.where(row) + "rock must be a 'zone NAME DENSITY model' (" +
                     joined(known()) + "; rock: that beside the zones), got '" + name + "'" +
                     did_you_mean(name, known()));
  }
  [[nodiscard]] std::uint8_t zone_of_number(std::size_t row) const {
    const int number = table_.whole(row, *zone_);
    const auto zones = static_cast<int>(names_.zones.size());
    const bool is_zone = number >= 1 && number <= zones;
    if (number == 0 || (is_zone && names_.of_model[static_cast<std::size_t>(number - 1)]))
      return static_cast<std::uint8_t>(number);
    throw InputError(
        table_.where(row) +
        "zone must be 0 (the rock beside the zones) or the number of a 'zone NAME DENSITY model' "
        "among the " +
        std::to_string(zones) + " zones, got '" + std::to_string(number) + "'");
  }

  std::string file_;
  CsvTable table_;
  const RockNames& names_;
  double unit_;
  std::array<std::size_t, 6> columns_{};
  std::optional<std::size_t> rock_, zone_;
};

std::vector<BoxTree::Item> boxes_of(const std::vector<RockCell>& cells) {
  std::vector<BoxTree::Item> items;
  items.reserve(cells.size());
  for (const RockCell& cell : cells) items.push_back({cell.lo(), cell.hi(), cell.middle});
  return items;
}

double rounding_of(const RockCell& cell) { return kCellRounding * cell.size.minCoeff(); }

}  // namespace

std::vector<RockCell> read_rock_cells(const std::string& file, const RockNames& names,
                                      double unit) {
  return CellReader(file, names, unit).cells();
}

RockCells::RockCells(std::vector<RockCell> cells, const std::string& where)
    : cells_(std::move(cells)), tree_(boxes_of(cells_), kMostInALeaf) {
  refuse_overlaps(where);
}

std::optional<std::uint8_t> RockCells::zone_at(const Vec3& place) const {
  std::optional<std::uint8_t> zone;
  const auto off = [&](const Vec3& lo, const Vec3& hi) {
    return (lo - place).cwiseMax(place - hi).maxCoeff();
  };
  double least = kCellRounding;  // of the edge
  tree_.any(
      [&](const BoxTree::Node& node) {
        return off(node.lo, node.hi) <= kCellRounding * (node.hi - node.lo).maxCoeff();
      },
      [&](std::size_t k) {
        const RockCell& cell = cells_[k];
        const double miss = off(cell.lo(), cell.hi()) / cell.size.minCoeff();
        if (miss < least) {
          least = miss;
          zone = cell.zone;
        }
        return least < 0.0;
      });
  return zone;
}

void RockCells::refuse_overlaps(const std::string& where) const {
  for (std::size_t a = 0; a < cells_.size(); ++a) {
    const Vec3 lo = cells_[a].lo(), hi = cells_[a].hi();
    const auto depth = [&](const Vec3& other_lo, const Vec3& other_hi) {
      return (hi.cwiseMin(other_hi) - lo.cwiseMax(other_lo)).minCoeff();
    };
    tree_.any([&](const BoxTree::Node& node) { return depth(node.lo, node.hi) > 0.0; },
              [&](std::size_t b) {
                const double most = 2.0 * std::max(rounding_of(cells_[a]), rounding_of(cells_[b]));
                if (b <= a || depth(cells_[b].lo(), cells_[b].hi()) <= most) return false;
                refuse(where, "must have one cell at each place, got two that overlap, around " +
                                  place_text(cells_[a].middle) + " and " +
                                  place_text(cells_[b].middle) +
                                  " m; are sizes whole edges, and parent cells left out where "
                                  "there are smaller ones?");
              });
  }
}

}  // namespace muckpile
