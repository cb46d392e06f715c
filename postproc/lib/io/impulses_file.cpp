// SPDX-License-Identifier: GPL-2.0-or-later
// What has pushed each block up to a snapshot.
// Scope: see the header.
#include "io/impulses_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "io/images.h"
#include "provenance/run_files.h"

namespace muckpile {
namespace {

struct ImpulseColumns {
  explicit ImpulseColumns(const CsvTable& table) : id(table.column("id")) {
    for (size_t k = 0; k < kImpulseParts; ++k) {
      const std::string part(kImpulseNames[k]);
      parts[k] = {table.column(part + "_x_N_s"), table.column(part + "_y_N_s"),
                  table.column(part + "_z_N_s")};
    }
  }
  size_t id;
  std::array<std::array<size_t, 3>, kImpulseParts> parts;
};

void require_run(const CsvTable& table, const std::string& run_id) {
  std::string found;
  for (const std::string_view remark : table.remarks())
    if (found.empty()) found = run_id_in(remark);
  if (run_id.empty() || found == run_id) return;
  throw InputError(table.name() + " is of run " + (found.empty() ? "none" : found) +
                   ", but the other files are of run " + run_id);
}

size_t place_of(const CsvTable& table, size_t row, const ImpulseColumns& columns,
                const std::vector<StartBlock>& blocks) {
  const auto end = blocks.begin() + static_cast<std::ptrdiff_t>(modelled(blocks));
  const int id = table.whole(row, columns.id);
  const auto found = std::ranges::lower_bound(blocks.begin(), end, id, {}, &StartBlock::id);
  if (found == end || found->id != id)
    throw InputError(table.where(row) + "id " + std::to_string(id) +
                     " is not a block of blocks.vtk");
  return static_cast<size_t>(found - blocks.begin());
}

}  // namespace

std::vector<ByPart> read_impulses(const std::filesystem::path& path,
                                  const std::vector<StartBlock>& blocks,
                                  const std::string& run_id) {
  const CsvTable table = CsvTable::read(path);
  require_run(table, run_id);
  const ImpulseColumns columns(table);
  std::vector<ByPart> impulses(modelled(blocks));
  std::vector<char> seen(impulses.size(), 0);
  for (size_t row = 0; row < table.rows(); ++row) {
    const size_t b = place_of(table, row, columns, blocks);
    if (std::exchange(seen[b], 1) != 0)
      throw InputError(table.where(row) + "id " + std::to_string(blocks[b].id) + " occurs twice");
    for (size_t k = 0; k < kImpulseParts; ++k)
      for (size_t axis = 0; axis < 3; ++axis)
        impulses[b].parts[k][static_cast<Eigen::Index>(axis)] =
            table.number(row, columns.parts[k][axis]);
  }
  const auto missing = std::ranges::find(seen, 0);
  if (missing != seen.end())
    throw InputError(path.string() + ": block " +
                     std::to_string(blocks[static_cast<size_t>(missing - seen.begin())].id) +
                     " has no row");
  return impulses;
}

}  // namespace muckpile
