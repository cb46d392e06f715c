// SPDX-License-Identifier: GPL-2.0-or-later
// What fix muckpile/gauges wrote.
// Scope: see the header.
#include "io/gauges_file.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <map>

#include "args/csv_table.h"
#include "args/input_error.h"

namespace muckpile {
namespace {

struct GaugeColumns {
  explicit GaugeColumns(const CsvTable& table)
      : time(table.column("time_s")),
        gauge(table.column("gauge")),
        block(table.column("block")),
        pressure(table.column("pressure_Pa")),
        run(table.column("run_id")),
        place{table.column("x_m"), table.column("y_m"), table.column("z_m")},
        velocity{table.column("vx_m_s"), table.column("vy_m_s"), table.column("vz_m_s")},
        normal{table.column("sxx_Pa"), table.column("syy_Pa"), table.column("szz_Pa")},
        shear{table.column("sxy_Pa"), table.column("syz_Pa"), table.column("szx_Pa")} {}

  static Vec3 vector(const CsvTable& table, size_t row, const std::array<size_t, 3>& columns) {
    return {table.number(row, columns[0]), table.number(row, columns[1]),
            table.number(row, columns[2])};
  }

  size_t time, gauge, block, pressure, run;
  std::array<size_t, 3> place, velocity, normal, shear;
};

// Of a stress with tension positive, as the file has it.
Vec3 principal_compression(const Vec3& normal, const Vec3& shear) {
  Eigen::Matrix3d stress;
  stress << normal.x(), shear.x(), shear.z(), shear.x(), normal.y(), shear.y(), shear.z(),
      shear.y(), normal.z();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(stress, Eigen::EigenvaluesOnly);
  return Vec3::Zero() - solver.eigenvalues();  // which rise
}

void add_row(const CsvTable& table, const GaugeColumns& columns, size_t row,
             std::map<int, GaugeHistory>& gauges) {
  const int number = table.whole(row, columns.gauge);
  const Vec3 place = GaugeColumns::vector(table, row, columns.place);
  const double time = table.number(row, columns.time);
  const auto [found, fresh] = gauges.try_emplace(
      number, GaugeHistory{number, table.whole(row, columns.block), place, {}, {}, {}, {}});
  GaugeHistory& gauge = found->second;
  if (gauge.place != place)
    throw InputError(table.where(row) + "gauge " + std::to_string(number) +
                     " is at another place than in its rows before");
  if (!fresh && time <= gauge.time.back())
    throw InputError(table.where(row) + "gauge " + std::to_string(number) +
                     " goes back in time: time_s must rise");
  gauge.time.push_back(time);
  gauge.velocity.push_back(GaugeColumns::vector(table, row, columns.velocity));
  gauge.pressure.push_back(table.number(row, columns.pressure));
  gauge.principal.push_back(principal_compression(GaugeColumns::vector(table, row, columns.normal),
                                                  GaugeColumns::vector(table, row, columns.shear)));
}

}  // namespace

std::vector<GaugeHistory> read_gauges(const std::filesystem::path& path,
                                      const std::string& run_id) {
  const CsvTable table = CsvTable::read(path);
  if (table.rows() == 0) throw InputError(path.string() + ": holds no rows");
  const GaugeColumns columns(table);
  std::map<int, GaugeHistory> gauges;
  for (size_t row = 0; row < table.rows(); ++row) {
    const std::string_view id = table.word(row, columns.run);
    if (!run_id.empty() && id != run_id)
      throw InputError(table.where(row) + "is of run " + std::string(id) +
                       ", but the other files are of run " + run_id);
    add_row(table, columns, row, gauges);
  }
  std::vector<GaugeHistory> all;
  for (auto& [number, gauge] : gauges) all.push_back(std::move(gauge));
  return all;
}

}  // namespace muckpile
