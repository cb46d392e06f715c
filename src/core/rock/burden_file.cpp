// SPDX-License-Identifier: GPL-2.0-or-later
// Burdens along charges as a CSV file.
// Scope: see the header.
#include "rock/burden_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

constexpr const char* kHeader =
    "hole,along_m,x_m,y_m,z_m,burden_m,face_x_m,face_y_m,face_z_m,in_front,to_front_m,plan_m,run_"
    "id";

std::string table_of(const BurdenFile& burdens, const std::string& run_id) {
  std::ostringstream text;
  text.precision(9);
  const auto place = [&](const Vec3& p) { text << p.x() << ',' << p.y() << ',' << p.z() << ','; };
  text << kHeader << '\n';
  for (std::size_t h = 0; h < burdens.holes.size(); ++h) {
    const HoleBurden& hole = burdens.holes[h];
    for (const BurdenPiece& piece : hole.pieces) {
      text << h + 1 << ',' << piece.along << ',';
      place(piece.at);
      if (piece.burden) {
        text << *piece.burden << ',';
        place(piece.face);
      } else {
        text << ",,,,";
      }
      if (hole.in_front) text << *hole.in_front + 1 << ',' << hole.to_front << ',';
      if (!hole.in_front) text << ",,";
      text << burdens.plan << ',' << run_id << '\n';
    }
  }
  return text.str();
}

struct Columns {
  explicit Columns(const CsvTable& table)
      : hole(table.column("hole")),
        along(table.column("along_m")),
        burden(table.column("burden_m")),
        in_front(table.column("in_front")),
        to_front(table.column("to_front_m")),
        plan(table.column("plan_m")),
        at{table.column("x_m"), table.column("y_m"), table.column("z_m")},
        face{table.column("face_x_m"), table.column("face_y_m"), table.column("face_z_m")} {}
  std::size_t hole, along, burden, in_front, to_front, plan;
  std::array<std::size_t, 3> at, face;
};

Vec3 place_in(const CsvTable& table, std::size_t row, const std::array<std::size_t, 3>& columns) {
  return {table.number(row, columns[0]), table.number(row, columns[1]),
          table.number(row, columns[2])};
}

void add_piece(const CsvTable& table, std::size_t row, const Columns& columns,
               BurdenFile& burdens) {
  const int number = table.whole(row, columns.hole);
  const auto known = static_cast<int>(burdens.holes.size());
  if (number != known && number != known + 1)
    throw InputError(table.where(row) + "hole must be " + std::to_string(known) + " or " +
                     std::to_string(known + 1) + ", got '" + std::to_string(number) + "'");
  if (number > known) burdens.holes.emplace_back();
  HoleBurden& hole = burdens.holes.back();
  BurdenPiece piece{table.number(row, columns.along), place_in(table, row, columns.at),
                    std::nullopt, Vec3::Zero()};
  if (!table.word(row, columns.burden).empty()) {
    piece.burden = table.number(row, columns.burden);
    piece.face = place_in(table, row, columns.face);
  }
  if (!table.word(row, columns.in_front).empty()) {
    hole.in_front = static_cast<std::size_t>(table.whole(row, columns.in_front) - 1);
    hole.to_front = table.number(row, columns.to_front);
  }
  hole.pieces.push_back(piece);
  burdens.plan = table.number(row, columns.plan);
}

}  // namespace

void write_burdens(const std::string& path, const BurdenFile& burdens, const std::string& run_id) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  errno = 0;
  std::ofstream out(path);
  out << table_of(burdens, run_id);
  if (!out.flush()) throw InputError("cannot write '" + path + "': " + std::strerror(errno));
}

BurdenFile read_burdens(const std::filesystem::path& path) {
  const CsvTable table = CsvTable::read(path);
  const Columns columns(table);
  BurdenFile burdens;
  for (std::size_t row = 0; row < table.rows(); ++row) add_piece(table, row, columns, burdens);
  for (const HoleBurden& hole : burdens.holes) {
    if (hole.in_front && *hole.in_front >= burdens.holes.size())
      throw InputError(path.string() + ": in_front must be a hole of the file, got '" +
                       std::to_string(*hole.in_front + 1) + "'");
  }
  return burdens;
}

}  // namespace muckpile
