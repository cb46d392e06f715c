// SPDX-License-Identifier: GPL-2.0-or-later
// Charges of holes, and where the holes are; see the header.
#include "explosive/charge_plan.h"

#include <charconv>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "args/input_error.h"
#include "args/suggestion.h"
#include "explosive/hole_table.h"
#include "explosive/kirra_table.h"
#include "explosive/table_text.h"

namespace muckpile {
namespace {

const std::vector<std::string> kChargeColumns = {"hole",
                                                 "from_m",
                                                 "to_m",
                                                 "explosive",
                                                 "explosive_density_kg_m3",
                                                 "vod_m_s",
                                                 "coupling",
                                                 "charge_diameter_m",
                                                 "charge_length_m",
                                                 "primer",
                                                 "crushed_radius_m",
                                                 "in_hole_delay_s"};

using Rows = std::map<std::string, std::vector<std::size_t>>;

Rows rows_by_hole(const CsvTable& csv) {
  Rows rows;
  const std::size_t column = csv.column("hole");
  for (std::size_t row = 0; row < csv.rows(); ++row)
    rows[std::string(csv.word(row, column))].push_back(row);
  return rows;
}

void require_known_holes(const CsvTable& charges, const Rows& holes) {
  std::vector<std::string> names;
  for (const auto& entry : holes) names.push_back(entry.first);
  for (const auto& [hole, rows] : rows_by_hole(charges)) {
    if (holes.count(hole) != 0) continue;
    throw InputError(charges.where(rows.front()) + "hole must be one of the plan, got '" + hole +
                     "'" + did_you_mean(hole, names));
  }
}

std::string_view field(const CsvTable& csv, std::size_t row, std::string_view column) {
  const auto at = csv.find_column(column);
  return at ? csv.word(row, *at) : std::string_view();
}

/// A row without depths has those of the only deck of its hole.
void require_depths(const CsvTable& charges, const Rows& holes) {
  for (std::size_t row = 0; row < charges.rows(); ++row) {
    const std::string hole(field(charges, row, "hole"));
    const std::size_t decks = holes.at(hole).size();
    if (decks == 1) continue;
    for (const char* depth : {"from_m", "to_m"}) {
      if (!field(charges, row, depth).empty()) continue;
      throw InputError(charges.where(row) + depth + " must be given: hole '" + hole + "' has " +
                       std::to_string(decks) + " decks in the plan");
    }
  }
}

std::vector<std::string_view> all_columns(const CsvTable& plan, const CsvTable& charges) {
  std::vector<std::string_view> columns = plan.header();
  for (const std::string_view name : charges.header()) {
    if (!plan.find_column(name)) columns.push_back(name);
  }
  return columns;
}

/// Where each row of a made table is from: "FILE:LINE: ".
using Sources = std::vector<std::string>;

/// A fault of the made table, told of the file that its row is from.
void check_made(const std::string& text, const std::string& name, std::size_t rows_from,
                const Sources& sources) {
  const std::string made = name + " with its charges", prefix = made + ":";
  try {
    (void)HoleTable(CsvTable::parse(text, made));
  } catch (const InputError& error) {
    const std::string fault = error.what();
    const std::size_t end = fault.find(": ", prefix.size());
    std::size_t line = 0;
    if (fault.starts_with(prefix) && end != std::string::npos)
      std::from_chars(fault.data() + prefix.size(), fault.data() + end, line);
    if (line < rows_from || line - rows_from >= sources.size()) throw;
    throw InputError(sources[line - rows_from] + fault.substr(end + 2));
  }
}

}  // namespace

std::string with_charges(const std::string& text, const std::string& name,
                         const CsvTable& charges) {
  charges.require_known_columns(kChargeColumns);
  const CsvTable plan = CsvTable::parse(text, name);
  const Rows holes = rows_by_hole(plan);
  require_known_holes(charges, holes);
  require_depths(charges, holes);
  const Rows own = rows_by_hole(charges);
  const std::vector<std::string_view> columns = all_columns(plan, charges);
  std::ostringstream out;
  for (const std::string_view remark : plan.remarks()) out << '#' << remark << '\n';
  for (std::size_t k = 0; k < columns.size(); ++k) out << (k > 0 ? "," : "") << columns[k];
  out << '\n';
  const std::size_t rows_from = plan.remarks().size() + 2;  // the line of the first row
  Sources sources;
  std::set<std::string_view> done;
  for (std::size_t row = 0; row < plan.rows(); ++row) {
    const std::string_view hole = field(plan, row, "hole");
    const auto with = own.find(std::string(hole));
    if (with != own.end() && !done.insert(hole).second) continue;
    const std::size_t decks = with == own.end() ? 1 : with->second.size();
    for (std::size_t d = 0; d < decks; ++d) {
      sources.push_back(with == own.end() ? plan.where(row) : charges.where(with->second[d]));
      for (std::size_t k = 0; k < columns.size(); ++k) {
        const std::string_view typed =
            with == own.end() ? std::string_view() : field(charges, with->second[d], columns[k]);
        // Another charge has another crushed zone.
        const bool none = with != own.end() && is_same_column(columns[k], "crushed_radius_m");
        out << (k > 0 ? "," : "")
            << (typed.empty() && !none ? field(plan, row, columns[k]) : typed);
      }
      out << '\n';
    }
  }
  const std::string made = out.str();
  check_made(made, name, rows_from, sources);
  return made;
}

std::string placed_table(const CsvTable& csv, const std::string& name, const MineFrame& frame) {
  constexpr double kMicrometre = 1e-6;
  const HoleTable table(csv);
  std::vector<Vec3> collars;
  for (const Deck& deck : table.decks()) collars.push_back(deck.hole_collar);
  require_origin_near(collars, frame.origin, name);
  std::vector<NewColumn> columns;
  for (const char* end : {"collar", "toe"}) {
    for (int c = 0; c < 3; ++c) {
      NewColumn column{std::string(end) + "_" + "xyz"[c] + "_m", {}};
      for (const Deck& deck : table.decks()) {
        const bool toe = end[0] == 't';
        const Vec3 at = frame.to_run(toe ? deck.hole_toe : deck.hole_collar);
        column.second.push_back(stepped_text(at[c], kMicrometre));
      }
      columns.push_back(std::move(column));
    }
  }
  return with_columns(csv, columns);
}

}  // namespace muckpile
