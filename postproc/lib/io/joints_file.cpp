// SPDX-License-Identifier: GPL-2.0-or-later
// Which joints still hold at the end of a run.
// Scope: see the header.
#include "io/joints_file.h"

#include <algorithm>
#include <cmath>

#include "args/csv_table.h"
#include "args/input_error.h"
#include "io/remarks.h"

namespace muckpile {
namespace {

/// What is not listed has broken: a file that ends too early is another rock.
void require_whole(const CsvTable& table, const std::string& file) {
  const auto rows = find_remark_number(table, file, "rows");
  if (!rows || std::lround(*rows) == static_cast<long>(table.rows())) return;
  const std::string last = table.rows() == 0 ? file + ": " : table.where(table.rows() - 1);
  throw InputError(last + "the table must have " + std::to_string(std::lround(*rows)) +
                   " rows, as its first line says, but ends here behind " +
                   std::to_string(table.rows()) + ": it has been cut short, or written on");
}

}  // namespace

bool HoldingJoints::has(int id, int face) const {
  return std::ranges::binary_search(joints, Joint{id, face});
}

HoldingJoints read_joints(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  HoldingJoints holding{std::lround(remark_number(table, path.string(), "step")),
                        remark_number(table, path.string(), "time_s"),
                        {}};
  require_whole(table, path.string());
  const size_t id = table.column("id"), face = table.column("face");
  for (size_t row = 0; row < table.rows(); ++row)
    holding.joints.push_back({table.whole(row, id), table.whole(row, face)});
  std::ranges::sort(holding.joints);
  const auto twin = std::ranges::adjacent_find(holding.joints);
  if (twin != holding.joints.end())
    throw InputError(path.string() + ": face " + std::to_string(twin->face) + " of block " +
                     std::to_string(twin->id) + " occurs twice");
  return holding;
}

}  // namespace muckpile
