// SPDX-License-Identifier: GPL-2.0-or-later
// Where every block is at one instant, from a run's dump/blocks_<step>.csv or .bin.
// Scope: reading and rigid motion only.
#include "io/snapshot.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "io/file_text.h"
#include "io/images.h"
#include "io/plain_snapshot.h"
#include "io/posed_block.h"
#include "io/remarks.h"
#include "io/snapshot_reader.h"
#include "provenance/run_files.h"
#include "state/packed_rows.h"

namespace muckpile {
namespace {

// Nine digits of text leave a unit quaternion within 1e-8; a wrong column is off by far more.
constexpr double kUnitTolerance = 1e-4;

struct Columns {
  explicit Columns(const CsvTable& t)
      : id(t.column("id")),
        place{t.column("x_m"), t.column("y_m"), t.column("z_m")},
        rotation{t.column("qw"), t.column("qx"), t.column("qy"), t.column("qz")},
        velocity{t.column("vx_m_s"), t.column("vy_m_s"), t.column("vz_m_s")},
        spin{t.column("wx_rad_s"), t.column("wy_rad_s"), t.column("wz_rad_s")},
        fragment(t.column("fragment_id")),
        broken(t.column("broken_fraction")) {}
  size_t id, place[3], rotation[4], velocity[3], spin[3], fragment, broken;
};

Vec3 vector_of(const CsvTable& table, size_t row, const size_t (&column)[3]) {
  return {table.number(row, column[0]), table.number(row, column[1]), table.number(row, column[2])};
}

BlockState state_of(const CsvTable& table, size_t row, const Columns& column) {
  const auto& q = column.rotation;
  const Quat rotation(table.number(row, q[0]), table.number(row, q[1]), table.number(row, q[2]),
                      table.number(row, q[3]));
  if (std::abs(rotation.norm() - 1.0) > kUnitTolerance) {
    throw InputError(table.where(row) + "qw, qx, qy, qz must be a unit quaternion, got length '" +
                     std::to_string(rotation.norm()) + "'");
  }
  return {vector_of(table, row, column.place),    rotation.normalized(),
          vector_of(table, row, column.velocity), vector_of(table, row, column.spin),
          table.whole(row, column.fragment),      table.number(row, column.broken)};
}

// The first line of a text, with its end.
std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n') + 1); }

// Any order of rows and columns, and what is wrong with a faulty file.
void read_table(const CsvTable& table, const std::string& file,
                const std::vector<StartBlock>& blocks, std::vector<BlockState>& states) {
  const Columns column(table);
  const auto images = blocks.begin() + static_cast<std::ptrdiff_t>(modelled(blocks));
  std::vector<char> seen(modelled(blocks), 0);
  for (size_t row = 0; row < table.rows(); ++row) {
    const int id = table.whole(row, column.id);
    const auto found = std::ranges::lower_bound(blocks.begin(), images, id, {}, &StartBlock::id);
    if (found == images || found->id != id) {
      throw InputError(table.where(row) + "id " + std::to_string(id) +
                       " is not a block of blocks.vtk");
    }
    const auto index = static_cast<size_t>(found - blocks.begin());
    if (seen[index])
      throw InputError(table.where(row) + "id " + std::to_string(id) + " occurs twice");
    seen[index] = 1;
    states[index] = state_of(table, row, column);
  }
  const auto missing = std::ranges::find(seen, 0);
  if (missing != seen.end()) {
    throw InputError(file + ": block " +
                     std::to_string(blocks[static_cast<size_t>(missing - seen.begin())].id) +
                     " has no row");
  }
}

}  // namespace

std::vector<std::filesystem::path> snapshot_files(const std::filesystem::path& dump) {
  std::vector<std::pair<long long, std::filesystem::path>> found;
  for (const auto& entry : std::filesystem::directory_iterator(dump)) {
    const long long step = snapshot_step(entry.path().filename().string());
    if (step >= 0) found.emplace_back(step, entry.path());
  }
  std::ranges::sort(found);
  std::vector<std::filesystem::path> files;
  for (auto& [step, path] : found) files.push_back(std::move(path));
  return files;
}

namespace {

// Of the blocks of the model.
std::vector<int> ids_of(const std::vector<StartBlock>& blocks) {
  std::vector<int> ids;
  for (size_t b = 0; b < modelled(blocks); ++b) ids.push_back(blocks[b].id);
  return ids;
}

// Rows in any order.
void read_packed(const PackedRows& rows, const std::string& file, const std::vector<int>& ids,
                 std::vector<BlockState>& states) {
  std::vector<char> seen(ids.size(), 0);
  for (size_t row = 0; row < rows.count(); ++row) {
    const BlockRow block = rows.at(row);
    const auto found = std::ranges::lower_bound(ids, block.id);
    if (found == ids.end() || *found != block.id)
      throw InputError(rows.where(row) + "id " + std::to_string(block.id) +
                       " is not a block of blocks.vtk");
    const auto index = static_cast<size_t>(found - ids.begin());
    if (std::exchange(seen[index], 1) != 0)
      throw InputError(rows.where(row) + "id " + std::to_string(block.id) + " occurs twice");
    states[index] = {block.centre, block.turn,     block.velocity,
                     block.spin,   block.fragment, block.broken_share};
  }
  const auto missing = std::ranges::find(seen, 0);
  if (missing != seen.end())
    throw InputError(file + ": block " +
                     std::to_string(ids[static_cast<size_t>(missing - seen.begin())]) +
                     " has no row");
}

void read_into(const std::filesystem::path& path, const std::vector<StartBlock>& blocks,
               const std::vector<int>& ids, const WantedStates& wanted, const std::string& text,
               Snapshot& snapshot) {
  const std::string file = path.string();
  const std::string_view remark = first_line(text);
  const std::string_view behind = std::string_view(text).substr(remark.size());
  const CsvTable head =
      CsvTable::parse(std::string(remark) + std::string(first_line(behind)), file);
  snapshot.step = std::lround(remark_number(head, file, "step"));
  snapshot.time = remark_number(head, file, "time_s");
  snapshot.states.resize(blocks.size());
  if (snapshot_form(file) == SnapshotForm::packed)
    read_packed(PackedRows(behind, file), file, ids, snapshot.states);
  else if (!read_plain_rows(behind, ids, kUnitTolerance, wanted, snapshot.states))
    read_table(CsvTable::parse(text, file), file, blocks, snapshot.states);
  add_image_states(blocks, snapshot.states);
}

}  // namespace

Snapshot read_snapshot(const std::filesystem::path& path, const std::vector<StartBlock>& blocks) {
  Snapshot snapshot;
  std::string text;
  read_text(path, text);
  read_into(path, blocks, ids_of(blocks), {{}, StateParts::kAll}, text, snapshot);
  return snapshot;
}

SnapshotReader::SnapshotReader(const std::vector<StartBlock>& blocks, std::vector<char> wanted,
                               StateParts parts)
    : blocks_(blocks), ids_(ids_of(blocks)), wanted_(std::move(wanted)), parts_(parts) {
  const size_t count = ids_.size();
  for (size_t b = count; b < wanted_.size(); ++b)  // an image is made of its original
    if (wanted_[b] != 0) wanted_[b % count] = 1;
}

const Snapshot& SnapshotReader::read(const std::filesystem::path& path) {
  read_text(path, text_);
  read_into(path, blocks_, ids_, {wanted_, parts_}, text_, snapshot_);
  return snapshot_;
}

std::vector<Vec3> moved_vertices(const StartBlock& block, const BlockState& state) {
  std::vector<Vec3> moved;
  move_vertices(block, state, moved);
  return moved;
}

Snapshot start_snapshot(const std::vector<StartBlock>& blocks) {
  Snapshot start;
  start.states.reserve(blocks.size());
  for (const StartBlock& block : blocks) start.states.push_back(start_state(block));
  return start;
}

}  // namespace muckpile
