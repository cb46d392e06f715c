// SPDX-License-Identifier: GPL-2.0-or-later
// Reading what a run dumps, and the messages when a dump is faulty.
// Scope: io/ but for the VTK series, which test_reports covers.
#include <gtest/gtest.h>

#include <cmath>

#include "args/csv_table.h"
#include "args/text_words.h"
#include "geometry/files/block_file.h"
#include "geometry/files/cell_file.h"
#include "input_error_of.h"
#include "io/energy_history.h"
#include "io/file_text.h"
#include "io/history.h"
#include "io/plain_cells.h"
#include "io/result_folder.h"
#include "io/snapshot_reader.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "message: " << text;
}

class DumpFiles : public ::testing::Test {
 protected:
  // Replaces the first occurrence in one file of dump/.
  void edit(const std::string& name, const std::string& from, const std::string& to) {
    std::string text = text_of(dump(name));
    const size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    write_text(dump(name), text.replace(place, from.size(), to));
  }
  std::filesystem::path dump(const std::string& name) { return folder_.path() / "dump" / name; }
  std::string message_of_snapshot() {
    return input_error_of(
        [&] { read_snapshot(dump("blocks_000002000.csv"), read_blocks(dump("blocks.vtk"))); });
  }
  void SetUp() override { write_bench(folder_.path()); }
  TemporaryFolder folder_;
};

TEST_F(DumpFiles, BlocksComeBackAsTheyWereWritten) {
  const BenchRun run = bench_run();
  const auto blocks = read_blocks(dump("blocks.vtk"));
  ASSERT_EQ(blocks.size(), run.blocks.size());
  for (size_t b = 0; b < blocks.size(); ++b) {
    EXPECT_EQ(blocks[b].id, run.blocks[b].id);
    EXPECT_EQ(blocks[b].shape.faces.size(), 6U);
    EXPECT_NEAR((blocks[b].centroid - run.blocks[b].centroid).norm(), 0.0, 1e-12);
    EXPECT_NEAR(mass_properties(polyhedron_of(blocks[b].shape)).volume, 0.125, 1e-12);
    EXPECT_NEAR(blocks[b].mass, 0.125 * kDensity, 1e-9);
  }
}

TEST_F(DumpFiles, SnapshotsComeBackInTheOrderOfTheBlocks) {
  const BenchRun run = bench_run();
  const Snapshot last = read_snapshot(dump("blocks_000002000.csv"), run.blocks);
  EXPECT_EQ(last.step, 2000);
  EXPECT_DOUBLE_EQ(last.time, 4.5);
  for (size_t b = 0; b < run.blocks.size(); ++b) {
    EXPECT_NEAR((last.states[b].centre - run.last.states[b].centre).norm(), 0.0,
                1e-7);  // 9 digits of text
    EXPECT_NEAR(last.states[b].rotation.angularDistance(run.last.states[b].rotation), 0.0, 1e-7);
  }
}

// Parts of 4 MiB are read on all cores.
TEST_F(DumpFiles, LargeFilesAreReadWhole) {
  std::string text(9'000'001, ' ');
  for (size_t k = 0; k < text.size(); ++k) text[k] = static_cast<char>('a' + k * k % 23);
  const std::filesystem::path path = write_text(dump("large.txt"), text);
  std::string again = "of an earlier file";
  read_text(path, again);
  EXPECT_TRUE(again == text);
  read_text(path, again, 5'000'000);
  EXPECT_TRUE(again == text.substr(5'000'000));
}

TEST_F(DumpFiles, WindowGoesOverAFileFromFrontToBack) {
  const std::string text = "the quick brown fox jumps over the lazy dog";
  FileWindow window(write_text(dump("small.txt"), text), 10);
  EXPECT_EQ(window.text(), "");
  std::string all;
  for (window.fill(); !window.text().empty(); window.fill()) {
    EXPECT_EQ(window.at(), all.size());
    EXPECT_LE(window.text().size(), 10U);
    const std::string part(window.text().substr(0, 7));
    all += part;
    window.skip(part.size());
  }
  EXPECT_EQ(all, text);
  EXPECT_EQ(window.at(), text.size());
}

// A file as the engine writes it is read by another way than one with blanks in it.
TEST_F(DumpFiles, BlanksInARowChangeNothing) {
  const auto blocks = read_blocks(dump("blocks.vtk"));
  const Snapshot plain = read_snapshot(dump("blocks_000002000.csv"), blocks);
  edit("blocks_000002000.csv", "\n1472,", "\n1472 , ");
  const Snapshot spaced = read_snapshot(dump("blocks_000002000.csv"), blocks);
  for (size_t b = 0; b < blocks.size(); ++b) {
    EXPECT_EQ(plain.states[b].centre, spaced.states[b].centre);
    EXPECT_EQ(plain.states[b].rotation.coeffs(), spaced.states[b].rotation.coeffs());
    EXPECT_EQ(plain.states[b].velocity, spaced.states[b].velocity);
    EXPECT_EQ(plain.states[b].spin, spaced.states[b].spin);
    EXPECT_EQ(plain.states[b].fragment, spaced.states[b].fragment);
    EXPECT_EQ(plain.states[b].broken_fraction, spaced.states[b].broken_fraction);
  }
}

// Of the other rows only what tells that none is missing is looked at.
TEST_F(DumpFiles, ReaderFillsTheStatesThatAreWanted) {
  const auto blocks = read_blocks(dump("blocks.vtk"));
  const Snapshot all = read_snapshot(dump("blocks_000002000.csv"), blocks);
  std::vector<char> wanted(blocks.size(), 0);
  wanted[3] = wanted.back() = 1;
  SnapshotReader some(blocks, wanted), every(blocks);
  EXPECT_EQ(some.read(dump("blocks_000000000.csv")).step, 0);
  const Snapshot& last = some.read(dump("blocks_000002000.csv"));
  EXPECT_EQ(last.step, all.step);
  EXPECT_EQ(last.time, all.time);
  for (const size_t b : {size_t{3}, blocks.size() - 1}) {
    EXPECT_EQ(last.states[b].centre, all.states[b].centre);
    EXPECT_EQ(last.states[b].velocity, all.states[b].velocity);
  }
  const Snapshot& same = every.read(dump("blocks_000002000.csv"));
  for (size_t b = 0; b < blocks.size(); ++b) EXPECT_EQ(same.states[b].centre, all.states[b].centre);
}

TEST_F(DumpFiles, ReaderOfVelocitiesHasThoseOfTheWholeStates) {
  const auto blocks = read_blocks(dump("blocks.vtk"));
  std::vector<char> wanted(blocks.size(), 0);
  wanted[3] = wanted.back() = 1;
  for (const std::vector<char>& of : {wanted, std::vector<char>()}) {
    SnapshotReader reader(blocks, of, StateParts::kVelocity);
    for (const char* name : {"blocks_000001000.csv", "blocks_000002000.csv"}) {
      const Snapshot all = read_snapshot(dump(name), blocks);
      const Snapshot& now = reader.read(dump(name));
      EXPECT_EQ(now.time, all.time);
      for (size_t b = 0; b < blocks.size(); ++b) {
        if (!of.empty() && of[b] == 0) continue;
        EXPECT_EQ(now.states[b].velocity, all.states[b].velocity);
      }
    }
  }
}

TEST_F(DumpFiles, ReaderOfSomeBlocksRefusesCutAndForeignRows) {
  const auto blocks = read_blocks(dump("blocks.vtk"));
  std::vector<char> wanted(blocks.size(), 0);
  wanted[3] = 1;
  const auto message = [&] {
    return input_error_of(
        [&] { SnapshotReader(blocks, wanted).read(dump("blocks_000002000.csv")); });
  };
  const std::string whole = text_of(dump("blocks_000002000.csv"));
  const size_t behind_id = whole.find("\n1472,") + 6;  // of a block that is not wanted
  std::string faulty = whole;
  faulty.erase(behind_id, whole.find(',', behind_id) + 1 - behind_id);
  write_text(dump("blocks_000002000.csv"), faulty);
  expect_contains(message(), ":3: expected 16 fields, got 15");
  faulty = whole;
  write_text(dump("blocks_000002000.csv"), faulty.insert(behind_id, "0,"));
  expect_contains(message(), ":3: expected 16 fields, got 17");
  write_text(dump("blocks_000002000.csv"), whole);
  edit("blocks_000002000.csv", "\n1472,", "\n1471,");
  expect_contains(message(), "id 1471 occurs twice");
  write_text(dump("blocks_000002000.csv"), whole.substr(0, whole.size() / 2));
  expect_contains(message(), "blocks_000002000.csv:");
}

void expect_same(const FlatPolyhedron& shape, const Polyhedron& other) {
  const Polyhedron own = polyhedron_of(shape);
  EXPECT_EQ(own.vertices, other.vertices);
  EXPECT_EQ(own.faces, other.faces);
}

// A file as the engine writes it is read on all cores, any other word by word.
TEST_F(DumpFiles, PlainCellsAreThoseOfTheOtherReader) {
  const std::string whole = text_of(dump("blocks.vtk"));
  TextWords words(whole);
  const std::vector<Polyhedron> shapes = read_cells(words, "blocks.vtk");
  // A window of the whole file, and one that is filled again and again.
  for (const size_t bytes : {size_t{1} << 24, size_t{5000}}) {
    FileWindow window(dump("blocks.vtk"), bytes);
    const auto plain = read_plain_cells(window);
    ASSERT_TRUE(plain);
    EXPECT_EQ(whole.substr(window.at(), 9), "CELL_DATA");
    ASSERT_EQ(plain->size(), shapes.size());
    for (size_t b = 0; b < shapes.size(); ++b) {
      expect_same((*plain)[b], shapes[b]);
    }
  }
}

bool are_plain(const std::filesystem::path& path, const std::string& text) {
  FileWindow window(write_text(path, text));
  return read_plain_cells(window).has_value();
}

TEST_F(DumpFiles, PlainCellsAreAPointOrACellALine) {
  const std::string head =
      "# vtk DataFile Version 3.0\nBlocks\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::string cells = "CELLS 1 18\n17 4 3 0 1 2 3 0 1 3 3 1 2 3 3 0 2 3\n";
  const std::string types = "CELL_TYPES 1\n42\n";
  const auto plain = [&](const std::string& text) { return are_plain(dump("cells.vtk"), text); };
  EXPECT_TRUE(plain(head + points + cells + types));
  for (const char* words : {"17 4 3 0 1 2 3 0 1 4 3 1 2 4 3 0 2 4",  // a point that is not there
                            "17 4 3 0 1 2 3 0 1 -1 3 1 2 -1 3 0 2 -1",
                            "17 4 3 0 1 2 3 0 1 2 3 1 2 0 3 0 2 1 5",  // more words than faces
                            "16 4 3 0 1 2 3 0 1 3 3 1 2 3 2 0 2",      // a face of two corners
                            "13 4 3 0 1 2 3 0 1 3 3 1 2 3",            // cut short
                            "9 2 3 0 1 3 3 0 1 3"})                    // leaves out point 2
    EXPECT_FALSE(plain(head + points + "CELLS 1 18\n" + words + "\n" + types)) << words;
  EXPECT_FALSE(plain(head + "0 0 0 1 0 0\n0 1 0\n0 0 1\n" + cells + types));
  EXPECT_FALSE(plain(head + "0 0 0\n1 0 0\n0 1 0\n0 0 1 5" + cells + types));
  EXPECT_FALSE(plain(head + "0 0 0\n1 0 0\n0 1 0\n0 0 nan\n" + cells + types));
  EXPECT_FALSE(plain(head + points + cells + "5" + types));
  EXPECT_FALSE(plain(head + points + "CELLS 1 18\n17 4 3 0 1 2\n" + types));
  EXPECT_FALSE(plain(head + points + cells + "CELL_TYPES 1\n10\n"));
  EXPECT_FALSE(plain(head + points + cells));
  EXPECT_FALSE(plain(head + points));
  EXPECT_FALSE(plain(""));
}

// As when another run begins in the same folder.
TEST_F(DumpFiles, WindowEndsWhereTheFileIsCutMeanwhile) {
  FileWindow window(dump("blocks.vtk"), 100);
  window.fill();
  EXPECT_EQ(window.text(), text_of(dump("blocks.vtk")).substr(0, 100));
  std::filesystem::resize_file(dump("blocks.vtk"), 0);
  window.skip(60);
  window.fill();
  EXPECT_EQ(window.text().size(), 40U);
  EXPECT_FALSE(read_plain_cells(window));
  FileWindow empty(dump("blocks.vtk"));
  EXPECT_FALSE(read_plain_cells(empty));
  expect_contains(input_error_of([&] { FileWindow(dump("none.vtk")); }), "cannot be opened");
  expect_contains(input_error_of([&] { FileWindow(dump("")); }), "cannot be opened");  // a folder
}

TEST_F(DumpFiles, BlanksBetweenTheNumbersOfBlocksChangeNothing) {
  const auto plain = read_blocks(dump("blocks.vtk"));
  edit("blocks.vtk", "\nCELLS ", "\n\nCELLS  ");
  EXPECT_FALSE(are_plain(dump("spaced.vtk"), text_of(dump("blocks.vtk"))));
  const auto blocks = read_blocks(dump("blocks.vtk"));
  ASSERT_EQ(blocks.size(), plain.size());
  for (size_t b = 0; b < blocks.size(); ++b) {
    expect_same(blocks[b].shape, polyhedron_of(plain[b].shape));
    EXPECT_EQ(blocks[b].centroid, plain[b].centroid);
  }
}

TEST_F(DumpFiles, MovedPointTurnsAboutTheCentroid) {
  const auto blocks = as_start_blocks({cube_at({1.0, 0.0, 0.0})});
  Snapshot s = start_snapshot(blocks);
  s.states[0].centre = {10.0, 0.0, 0.0};
  s.states[0].rotation = Quat(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitZ()));
  const Vec3 moved = moved_point(blocks[0], s.states[0], blocks[0].centroid + Vec3(0.1, 0.2, 0.3));
  EXPECT_NEAR((moved - Vec3(9.8, 0.1, 0.3)).norm(), 0.0, 1e-12);
}

// The one before it would be taken for it.
TEST_F(DumpFiles, TheSnapshotOfTheEndMustBeThere) {
  std::filesystem::remove(dump("blocks_000002000.csv"));
  expect_contains(input_error_of([&] { (void)ResultFolder(folder_.path()).snapshots(); }),
                  "blocks_000001000.csv: is the last snapshot, but the run came to rest at step "
                  "2000: that one's is missing");
  edit("run.json", "\"still\": true", "\"still\": false");
  expect_contains(input_error_of([&] { (void)ResultFolder(folder_.path()).snapshots(); }),
                  "blocks_000001000.csv: is the last snapshot, but the run ended at step 2000: "
                  "that one's is missing");
}

TEST_F(DumpFiles, SnapshotsAreListedByStep) {
  write_text(dump("blocks_10.csv"), "");  // fewer digits, smaller step
  write_text(dump("blocks_x.csv"), "");   // no step
  const auto paths = ResultFolder(folder_.path()).snapshots();
  ASSERT_EQ(paths.size(), 4U);
  EXPECT_EQ(paths[1].filename(), "blocks_10.csv");
  EXPECT_EQ(paths.back().filename(), "blocks_000002000.csv");
}

TEST_F(DumpFiles, FaultyNumberNamesFileLineAndColumn) {
  edit("blocks_000002000.csv", "\n1472,", "\n1472,1.5x");
  const std::string message = message_of_snapshot();
  expect_contains(message, "blocks_000002000.csv:3: ");
  expect_contains(message, "x_m must be a finite number, got '1.5x");
}

TEST_F(DumpFiles, NanIsRefused) {
  edit("blocks_000002000.csv", "\n1472,", "\n1472,nan,0,0,1,0,0,0,0,0,0,0,0,0,1,0\n1472,");
  expect_contains(message_of_snapshot(), ":3: x_m must be a finite number, got 'nan'");
}

TEST_F(DumpFiles, MissingFieldNamesTheLine) {
  edit("blocks_000002000.csv", "\n1472,", "\n");
  expect_contains(message_of_snapshot(), ":3: expected 16 fields, got 15");
}

TEST_F(DumpFiles, UnknownBlockIsRefused) {
  edit("blocks_000002000.csv", "\n1472,", "\n9999,");
  expect_contains(message_of_snapshot(), ":3: id 9999 is not a block of blocks.vtk");
}

TEST_F(DumpFiles, RepeatedBlockIsRefused) {
  edit("blocks_000002000.csv", "\n1472,", "\n1471,");
  expect_contains(message_of_snapshot(), ":4: id 1471 occurs twice");
}

TEST_F(DumpFiles, MissingBlockIsRefused) {
  const std::string text = text_of(dump("blocks_000002000.csv"));
  const size_t last = text.rfind('\n', text.size() - 2);
  write_text(dump("blocks_000002000.csv"), text.substr(0, last + 1));
  expect_contains(message_of_snapshot(), "block 1 has no row");
}

TEST_F(DumpFiles, RotationMustBeAUnitQuaternion) {
  const BenchRun run = bench_run();
  Snapshot bad = run.last;
  bad.states[0].rotation.coeffs() *= 1.1;
  write_snapshot(dump("blocks_000002000.csv"), run.blocks, bad);
  expect_contains(message_of_snapshot(), "must be a unit quaternion, got length '1.1");
}

TEST_F(DumpFiles, SnapshotNeedsItsTime) {
  edit("blocks_000002000.csv", "time_s=", "time=");
  expect_contains(message_of_snapshot(), "the first line must hold '# step=<n> time_s=<t>'");
}

TEST_F(DumpFiles, MissingColumnIsNamed) {
  edit("blocks_000002000.csv", "broken_fraction", "broken");
  expect_contains(message_of_snapshot(), "has no column 'broken_fraction'");
}

TEST_F(DumpFiles, BlocksFileWithoutAnArrayIsRefused) {
  edit("blocks.vtk", "mass_kg", "mass");
  expect_contains(input_error_of([&] { read_blocks(dump("blocks.vtk")); }),
                  "blocks.vtk: has no cell data 'mass_kg'");
}

TEST_F(DumpFiles, BlocksFileWithAWrongVolumeIsRefused) {
  edit("blocks.vtk", "default\n0.1", "default\n0.9");
  expect_contains(input_error_of([&] { read_blocks(dump("blocks.vtk")); }),
                  "volume_m3 must be its polyhedron's 0.125");
}

TEST_F(DumpFiles, BlocksFileWithACellCutShortIsNamed) {
  const std::string text = text_of(dump("blocks.vtk"));
  const size_t cell = text.find(" 6 4 ", text.find("CELLS"));
  ASSERT_NE(cell, std::string::npos);  // six faces, the first of four corners
  edit("blocks.vtk", text.substr(cell, 5), " 6 -4 ");
  expect_contains(input_error_of([&] { read_blocks(dump("blocks.vtk")); }),
                  "blocks.vtk: block import: the faces of cell 1 are cut short");
}

TEST_F(DumpFiles, FacesInsideOutAreTurned) {
  auto shapes = bench_run().shapes;
  for (auto& face : shapes[0].shape.faces) std::reverse(face.begin(), face.end());
  write_blocks(dump("blocks.vtk").string(), shapes, 1, kDensity);
  EXPECT_NEAR(mass_properties(polyhedron_of(read_blocks(dump("blocks.vtk"))[0].shape)).volume,
              0.125, 1e-12);
}

TEST_F(DumpFiles, BrokenVtkFileIsRefused) {
  write_text(dump("blocks.vtk"), "not a VTK file\n");
  expect_contains(input_error_of([&] { read_blocks(dump("blocks.vtk")); }),
                  "blocks.vtk' is no legacy VTK file");
}

// In a line of its own each, with what is wrong: no crash, no number made up.
TEST_F(DumpFiles, DamagedBlocksAreRefused) {
  const std::string whole = text_of(dump("blocks.vtk"));
  const struct {
    const char *from, *to, *message;
  } cases[] = {{" 6 4 0 ", " 6 4 2147483647 ", "cell 1 has a point that is not in the file"},
               {" 6 4 0 ", " 6 99 0 ", "the faces of cell 1 are cut short"},
               {" 6 4 0 ", " 99 4 0 ", "the faces of cell 1 are cut short"},
               {"\nCELLS ", " 4CELLS ", "'CELLS' expected, got '4CELLS'"},
               {"\nCELL_TYPES ", "\n5CELL_TYPES ", "'CELL_TYPES' expected, got '5CELL_TYPES'"},
               {"CELL_DATA ", "CELL_DATA 9", "expected behind the cells"},
               {"SCALARS size_m", "VECTORS size_m", "'SCALARS' and a name expected, got 'VECTORS'"},
               {"default\n1\n2\n", "default\n1\nnan\n", "id: must have a number for each of "},
               {"default\n1\n2\n", "default\n1\n2.5\n", "id must be a whole number >= 1, got '2.5"},
               {"default\n1\n2\n", "default\n1\n1\n", "id 1 occurs twice"}};
  for (const auto& [from, to, message] : cases) {
    write_text(dump("blocks.vtk"), whole);
    edit("blocks.vtk", from, to);
    expect_contains(input_error_of([&] { read_blocks(dump("blocks.vtk")); }), message);
  }
  for (const double share : {0.1, 0.4, 0.7, 0.95, 0.999}) {
    write_text(dump("blocks.vtk"),
               whole.substr(0, static_cast<size_t>(share * static_cast<double>(whole.size()))));
    expect_contains(input_error_of([&] { read_blocks(dump("blocks.vtk")); }), "blocks.vtk");
  }
}

TEST_F(DumpFiles, FolderWithoutDumpIsRefused) {
  expect_contains(input_error_of([&] { ResultFolder(folder_.path() / "dump"); }),
                  "has no folder dump/");
}

TEST_F(DumpFiles, SceneWithoutAKeyNamesIt) {
  expect_contains(
      input_error_of([&] { static_cast<void>(ResultFolder(folder_.path()).scene_number("vod")); }),
      "scene.json: vod must be a number");
}

TEST_F(DumpFiles, SceneWithALengthThatNoPlanHasIsRefused) {
  for (const char* key : {"burden_m", "hole_diameter_m"}) {
    for (const char* value : {"0", "-1", "0.0"}) {
      write_text(dump("scene.json"),
                 "{\"case\": \"bench\", \"" + std::string(key) + "\": " + value + "}");
      expect_contains(input_error_of([&] { ResultFolder{folder_.path()}; }),
                      "scene.json: " + std::string(key) + " must be > 0 m, got '" + value + "'");
    }
  }
}

TEST_F(DumpFiles, HistoryGivesTheWorstBalanceAndTheFastestBlock) {
  const History history = read_history(dump("history.csv"));
  EXPECT_DOUBLE_EQ(history.joints_broken_fraction, 0.25);  // 1000 of 4000
  EXPECT_DOUBLE_EQ(history.fastest_block, 31.5);
  EXPECT_DOUBLE_EQ(history.worst_balance_error, 0.002);
}

// Row 2 of history.csv: kinetic 5, elastic 4, contacts 3, gravity 2, blast work 1, all else 0.
TEST_F(DumpFiles, ReadsTheEnergiesInGroups) {
  const EnergyHistory history = read_energies(dump("history.csv"));
  EXPECT_EQ(history.time, (std::vector<double>{0.0, 0.01, 4.5}));
  ASSERT_EQ(history.groups.size(), 9U);  // no quiet_J in that file
  EXPECT_EQ(history.groups[0].name, "blast work");
  EXPECT_EQ(history.groups[0].energy, (std::vector<double>{0.0, 1.0, 1.0}));
  EXPECT_EQ(history.groups[4].energy, (std::vector<double>{0.0, 2.0, 2.0}));
  EXPECT_EQ(history.missing(), (std::vector<double>{0.0, -13.0, -13.0}));  // 1 - 5 - 4 - 3 - 2
}

TEST_F(DumpFiles, SummaryKeepsTheKeysOfOtherCommands) {
  const ResultFolder folder(folder_.path());
  folder.merge_into_summary({{"a_m", 1.0}, {"b_m", 2.0}});
  folder.merge_into_summary({{"b_m", 3.0}, {"c_m", std::nan("")}});
  const auto summary = read_json_object(folder.file("summary.json"));
  EXPECT_DOUBLE_EQ(summary["a_m"], 1.0);
  EXPECT_DOUBLE_EQ(summary["b_m"], 3.0);
  EXPECT_TRUE(summary["c_m"].is_null());
}

}  // namespace
}  // namespace muckpile
