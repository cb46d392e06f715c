// SPDX-License-Identifier: GPL-2.0-or-later
// What gave parts of the rock their speed, in a crater and a bench of cubes; faulty files.
// Scope: measure/momentum, io/impulses_file, the report.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "args/csv_table.h"
#include "input_error_of.h"
#include "io/impulses_file.h"
#include "measure/momentum.h"
#include "report/not_measurable.h"
#include "report/reports.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

Vec3 outward_at(const Vec3& place) { return Vec3(place.x(), place.y(), 0.0).normalized(); }

// Each block has 3 m/s outward and 2 m/s up from the wave, 1 m/s inward from its joints, and a
// speed that is 0.25 m/s upward more than that.
struct PushedRock {
  BenchRun run = crater_run();
  std::vector<ByPart> impulses;

  PushedRock() {
    for (size_t b = 0; b < run.blocks.size(); ++b) {
      const Vec3 outward = outward_at(run.blocks[b].centroid);
      ByPart& of = impulses.emplace_back();
      of[ImpulsePart::wave] = run.blocks[b].mass * (3.0 * outward + 2.0 * Vec3::UnitZ());
      of[ImpulsePart::joints] = -run.blocks[b].mass * outward;
      run.last.states[b].velocity = 2.0 * outward + 2.25 * Vec3::UnitZ();
    }
  }
};

// Cubes whose centres lie in a cone with a level top of this radius, layer by layer.
int cubes_in_cone(double height) {
  int count = 0;
  for (double radius = height - 0.5 * kCube; radius > 0.0; radius -= kCube)
    for (double x = 0.5 * kCube; x < radius; x += kCube)
      for (double y = 0.5 * kCube; y < radius; y += kCube)
        count += std::hypot(x, y) < radius ? 4 : 0;  // one in each quarter
  return count;
}

TEST(Momentum, IsToldByCauseAndDirection) {
  const PushedRock rock;
  const auto parts = crater_parts(rock.run.blocks, 3.0, 1.0);
  ASSERT_GT(parts.size(), 5U);
  EXPECT_EQ(parts[0].name, "cone");
  // A cone 3 m high, of cubes by their centres: 88, 60, 32, 16 and 4, layer by layer.
  EXPECT_NEAR(parts[0].mass, cubes_in_cone(3.0) * kDensity * std::pow(kCube, 3), 1e-6);
  EXPECT_EQ(parts[1].name, "surface");
  EXPECT_NEAR(parts[3].radius, 2.5, 0.2);
  for (const RockPart& part : parts) {
    const auto [outward, upward] = budget_of(part, rock.run.blocks, rock.run.last, rock.impulses);
    const auto of = [](const Budget& budget, ImpulsePart cause) {
      return budget.by_cause[static_cast<size_t>(cause)];
    };
    EXPECT_NEAR(outward.speed, 2.0, 1e-12);
    EXPECT_NEAR(of(outward, ImpulsePart::wave), 3.0, 1e-12);
    EXPECT_NEAR(of(outward, ImpulsePart::joints), -1.0, 1e-12);
    EXPECT_NEAR(outward.left(), 0.0, 1e-12);
    EXPECT_NEAR(of(upward, ImpulsePart::wave), 2.0, 1e-12);
    EXPECT_NEAR(upward.left(), 0.25, 1e-12);
  }
}

// The impulses of every block are those of its momentum along x, from gas in joints.
void write_impulses(const std::filesystem::path& file, const std::vector<StartBlock>& blocks,
                    double speed) {
  std::ofstream out(file);
  out << "# step=0 time_s=0\nid";
  for (const std::string_view part : kImpulseNames)
    for (const char* axis : {"_x_N_s", "_y_N_s", "_z_N_s"}) out << ',' << part << axis;
  out << '\n';
  for (const StartBlock& block : blocks)
    out << block.id << ",0,0,0,0,0,0,0,0,0," << block.mass * speed << ",0,0,0,0,0,0,0,0,0,0,0\n";
}

TEST(Momentum, OfABenchIsThatOfItsBurden) {
  const TemporaryFolder folder;
  write_bench(folder.path());
  const ResultFolder results(folder.path());
  EXPECT_THROW(report_momentum(results), NotMeasurable);  // no impulses
  std::string name = results.snapshots()[1].filename().string();
  name.replace(0, std::string("blocks").size(), "impulses");
  write_impulses(results.dump(name), results.blocks(), 6.0);
  report_momentum(results);
  const CsvTable table = CsvTable::read(results.file("momentum.csv"));
  ASSERT_EQ(table.rows(), 2U);  // one snapshot has impulses
  const auto of = [&](size_t row, const char* column) {
    return table.number(row, table.column(column));
  };
  EXPECT_EQ(table.word(0, table.column("part")), "burden");
  EXPECT_EQ(table.word(0, table.column("direction")), "outward");
  // A prism of 5 m by 10.5 m by 2 m, of which two layers of cubes of ten move at 14, the rest at 6.
  EXPECT_NEAR(of(0, "mass_kg") / (5.0 * 10.5 * 2.0 * kDensity), 1.0, 1e-6);
  EXPECT_NEAR(of(0, "speed_m_s"), 0.2 * 14.0 + 0.8 * 6.0, 1e-4);
  EXPECT_NEAR(of(0, "joint_gas_m_s"), 6.0, 1e-9);
  EXPECT_NEAR(of(0, "left_m_s"), 1.6, 1e-4);
  EXPECT_EQ(table.word(1, table.column("direction")), "upward");
  EXPECT_NEAR(of(1, "joint_gas_m_s"), 0.0, 1e-9);
  EXPECT_TRUE(std::filesystem::exists(results.file("momentum.png")));
}

TEST(Momentum, OfACraterIsThatOfItsConeAndSurface) {
  const TemporaryFolder folder;
  write_crater(folder.path());
  const ResultFolder results(folder.path());
  std::string name = results.snapshots().back().filename().string();
  name.replace(0, std::string("blocks").size(), "impulses");
  write_impulses(results.dump(name), results.blocks(), 6.0);
  report_momentum(results);
  const CsvTable table = CsvTable::read(results.file("momentum.csv"));
  EXPECT_EQ(table.word(0, table.column("part")), "cone");
  EXPECT_EQ(table.word(2, table.column("part")), "surface");
  // All are pushed along x: around the axis that is outward as much as inward.
  EXPECT_NEAR(table.number(0, table.column("joint_gas_m_s")), 0.0, 1e-9);
  EXPECT_TRUE(std::filesystem::exists(results.file("momentum.png")));
}

TEST(Momentum, IsNotThatOfAHeap) {
  const TemporaryFolder folder;
  write_heap(folder.path());
  EXPECT_THROW(report_momentum(ResultFolder(folder.path())), NotMeasurable);
}

TEST(Momentum, FaultyImpulsesAreNamed) {
  const TemporaryFolder folder;
  const BenchRun run = crater_run();
  const auto file = folder.path() / "impulses_000000000.csv";
  const auto error = [&] {
    return input_error_of([&] { (void)read_impulses(file, run.blocks, ""); });
  };
  write_impulses(file, {run.blocks.begin(), run.blocks.end() - 1}, 1.0);
  EXPECT_NE(error().find("has no row"), std::string::npos) << error();
  std::vector<StartBlock> twice = run.blocks;
  twice.push_back(twice.front());
  write_impulses(file, twice, 1.0);
  EXPECT_NE(error().find("occurs twice"), std::string::npos) << error();
  twice.back().id = 1000000;
  write_impulses(file, twice, 1.0);
  EXPECT_NE(error().find("is not a block of blocks.vtk"), std::string::npos) << error();
  write_impulses(file, run.blocks, 1.0);
  EXPECT_EQ(error(), "");
  const std::string other =
      input_error_of([&] { (void)read_impulses(file, run.blocks, "0123456789abcdef"); });
  EXPECT_NE(other.find("is of run none"), std::string::npos) << other;
}

}  // namespace
}  // namespace muckpile
