// SPDX-License-Identifier: GPL-2.0-or-later
// The blocks of an earlier run as its last snapshot has them.
// Scope: see the header.
#include "rock/saved_pile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "args/numbers.h"
#include "geometry/files/cell_data.h"
#include "geometry/files/cell_file.h"
#include "geometry/shape/shape_fault.h"
#include "provenance/run_files.h"
#include "state/packed_rows.h"

namespace muckpile {
namespace {

namespace fs = std::filesystem;

fs::path dump_of(const std::string& folder) {
  std::error_code unheeded;
  for (const fs::path& each : {fs::path(folder) / "dump", fs::path(folder)})
    if (fs::is_regular_file(each / "blocks.vtk", unheeded)) return each;
  throw InputError(
      "muck must be a folder of results with dump/blocks.vtk, other than the one of this run, got "
      "'" +
      folder + "'");
}

/// The id in one of the first two lines: of a snapshot, or of the title of blocks.vtk.
std::string id_of(const fs::path& file) {
  std::ifstream in(file);
  std::array<char, 200> line{};  // of whatever file has such a name
  std::string id;
  for (int k = 0; k < 2 && id.empty() && in.getline(line.data(), line.size()); ++k)
    id = run_id_in(line.data());
  return id;
}

/// The folder may hold snapshots of earlier runs, too.
fs::path last_snapshot(const fs::path& dump) {
  const std::string id = id_of(dump / "blocks.vtk");
  std::vector<std::pair<long long, fs::path>> found;
  for (const auto& entry : fs::directory_iterator(dump)) {
    const long long step = snapshot_step(entry.path().filename().string());
    if (step >= 0) found.emplace_back(step, entry.path());
  }
  std::ranges::sort(found);
  while (!found.empty() && id_of(found.back().second) != id) found.pop_back();
  if (found.empty())
    throw InputError("muck: '" + dump.string() +
                     "' has no snapshot blocks_<step>.csv or .bin of the run of its blocks.vtk");
  return found.back().second;
}

std::vector<SavedBlock> blocks_at_start(const std::string& file) {
  TextWords text(whole_file(file));
  const CellTable cells = read_cell_table(text, file);
  const CellData data = read_cell_data(text, cells.cells(), file);
  const auto &id = cell_array(data, "id", file), &mass = cell_array(data, "mass_kg", file);
  std::vector<SavedBlock> blocks(cells.cells());
  std::unordered_set<int> known;
  for (std::size_t c = 0; c < blocks.size(); ++c) {
    SavedBlock& block = blocks[c];
    if (!(id[c] >= 1.0 && id[c] <= std::numeric_limits<int>::max()))
      throw InputError(file + ": id must be a whole number >= 1, got '" + number_text(id[c]) + "'");
    block.id = static_cast<int>(id[c]);
    block.kg = mass[c];
    block.shape = cell_of(cells, c, file);
    block.mass = mass_properties(block.shape);
    if (!(block.kg > 0.0) || !(block.mass.volume > 0.0))
      throw InputError(file + ": block " + std::to_string(block.id) +
                       ": mass_kg must be > 0 kg and the volume > 0 m3, got '" +
                       number_text(block.kg) + "' and '" + number_text(block.mass.volume) + "'");
    const std::string fault = shape_fault(block.shape, block.mass);
    if (!fault.empty())
      throw InputError(file + ": block " + std::to_string(block.id) + ' ' + fault);
    if (!known.insert(block.id).second)
      throw InputError(file + ": block " + std::to_string(block.id) + " is there twice");
  }
  return blocks;
}

double time_in(std::string_view remark) {
  constexpr std::string_view kTime = "time_s=";
  const std::size_t at = remark.find(kTime);
  if (at == std::string_view::npos) return 0.0;
  const std::string_view value = remark.substr(at + kTime.size());
  return parse_number(value.substr(0, value.find_first_of(" \n")), "time_s");
}

/// Columns of a snapshot that a pile needs.
class Columns {
 public:
  explicit Columns(const CsvTable& table)
      : table_(table),
        id_(table.column("id")),
        place_(three("x_m", "y_m", "z_m")),
        turn_(three("qx", "qy", "qz")),
        qw_(table.column("qw")),
        velocity_(three("vx_m_s", "vy_m_s", "vz_m_s")) {}

  [[nodiscard]] BlockRow at(std::size_t row) const {
    constexpr double kUnit = 1e-4;  // nine digits leave a unit quaternion within 1e-8
    const Vec3 q = vector(row, turn_);
    const Quat turn(table_.number(row, qw_), q.x(), q.y(), q.z());
    if (std::abs(turn.norm() - 1.0) > kUnit)
      throw InputError(table_.where(row) + "qw, qx, qy, qz must be a unit quaternion");
    return {.id = table_.whole(row, id_),
            .centre = vector(row, place_),
            .turn = turn.normalized(),
            .velocity = vector(row, velocity_),
            .spin = Vec3::Zero(),
            .fragment = 0,
            .broken_share = 0.0};
  }

 private:
  using Three = std::array<std::size_t, 3>;
  [[nodiscard]] Three three(const char* a, const char* b, const char* c) const {
    return {table_.column(a), table_.column(b), table_.column(c)};
  }
  [[nodiscard]] Vec3 vector(std::size_t row, const Three& c) const {
    return {table_.number(row, c[0]), table_.number(row, c[1]), table_.number(row, c[2])};
  }

  const CsvTable& table_;
  std::size_t id_;
  Three place_, turn_;
  std::size_t qw_;
  Three velocity_;
};

using RowOfId = std::unordered_map<int, BlockRow>;

void add_row(RowOfId& rows, const BlockRow& row, const std::string& where) {
  if (!rows.emplace(row.id, row).second)
    throw InputError(where + "block " + std::to_string(row.id) + " has a second row");
}

/// Of a snapshot in either form.
RowOfId rows_of(const std::string& text, const std::string& file) {
  RowOfId rows;
  if (snapshot_form(file) == SnapshotForm::packed) {
    const PackedRows packed(std::string_view(text).substr(text.find('\n') + 1), file);
    for (std::size_t k = 0; k < packed.count(); ++k) add_row(rows, packed.at(k), packed.where(k));
    return rows;
  }
  const CsvTable table = CsvTable::parse(text, file);
  const Columns columns(table);
  for (std::size_t k = 0; k < table.rows(); ++k) add_row(rows, columns.at(k), table.where(k));
  return rows;
}

}  // namespace

SavedPile read_saved_pile(const std::string& folder) {
  const fs::path dump = dump_of(folder), snapshot = last_snapshot(dump);
  SavedPile pile{blocks_at_start((dump / "blocks.vtk").string()), 0.0};
  const std::string file = snapshot.string(), text = whole_file(file);
  pile.time = time_in(std::string_view(text).substr(0, text.find('\n')));
  const RowOfId row_of = rows_of(text, file);
  for (SavedBlock& block : pile.blocks) {
    const auto found = row_of.find(block.id);
    if (found == row_of.end())
      throw InputError(file + ": block " + std::to_string(block.id) + " has no row");
    block.centre = found->second.centre;
    block.turn = found->second.turn;
    block.speed = found->second.velocity.norm();
  }
  return pile;
}

}  // namespace muckpile
