// SPDX-License-Identifier: GPL-2.0-or-later
// Packed snapshots of a run: measured as those of text are, and refused where they are faulty.
// Scope: io/snapshot on packed rows.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "args/text_words.h"
#include "input_error_of.h"
#include "io/result_folder.h"
#include "io/snapshot_reader.h"
#include "report/reports.h"
#include "state/packed_rows.h"
#include "synthetic_run.h"

namespace muckpile {
namespace {

using namespace testing;

class PackedSnapshots : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bench(folder_.path());
    blocks_ = read_blocks(dump("blocks.vtk"));
  }
  std::filesystem::path dump(const std::string& name) { return folder_.path() / "dump" / name; }

  // The first line of a snapshot of text, and its rows packed.
  std::string packed(const std::string& name, size_t left_out = 0) {
    const std::string text = text_of(dump(name));
    std::string rows = text.substr(0, text.find('\n') + 1) + std::string(packed_header());
    const Snapshot snapshot = read_snapshot(dump(name), blocks_);
    for (size_t b = left_out; b < blocks_.size(); ++b) {
      const BlockState& s = snapshot.states[b];
      pack({blocks_[b].id, s.centre, s.rotation, s.velocity, s.spin, s.fragment, s.broken_fraction},
           rows);
    }
    return rows;
  }
  void pack_all() {
    for (const char* step : {"blocks_000000000", "blocks_000001000", "blocks_000002000"}) {
      const std::string name(step), rows = packed(name + ".csv");
      write_text(dump(name + ".bin"), rows);
      std::filesystem::remove(dump(name + ".csv"));
    }
  }
  std::string message_of(const std::string& text) {
    write_text(dump("blocks_000002000.bin"), text);
    return input_error_of([&] { read_snapshot(dump("blocks_000002000.bin"), blocks_); });
  }

  TemporaryFolder folder_;
  std::vector<StartBlock> blocks_;
};

TEST_F(PackedSnapshots, AreMeasuredAsThoseOfText) {
  report_profile(ResultFolder(folder_.path()), {}, {});
  const auto text = read_json_object(folder_.path() / "summary.json");
  pack_all();
  std::filesystem::remove(folder_.path() / "summary.json");
  report_profile(ResultFolder(folder_.path()), {}, {});
  const auto packed = read_json_object(folder_.path() / "summary.json");
  int compared = 0;
  for (const auto& [key, value] : text.items()) {
    if (!value.is_number()) continue;
    EXPECT_NEAR(packed[key].get<double>(), value.get<double>(),
                1e-5 * (1.0 + std::abs(value.get<double>())))
        << key;
    ++compared;
  }
  EXPECT_GT(compared, 10);
}

TEST_F(PackedSnapshots, ReaderHasTheStatesOfTheText) {
  const Snapshot text = read_snapshot(dump("blocks_000001000.csv"), blocks_);
  write_text(dump("blocks_000001000.bin"), packed("blocks_000001000.csv"));
  SnapshotReader reader(blocks_, {}, StateParts::kVelocity);
  const Snapshot& now = reader.read(dump("blocks_000001000.bin"));
  EXPECT_EQ(now.step, 1000);
  EXPECT_EQ(now.time, text.time);
  for (size_t b = 0; b < blocks_.size(); ++b)
    EXPECT_LT((now.states[b].velocity - text.states[b].velocity).norm(), 1e-5);
}

TEST_F(PackedSnapshots, FaultsAreToldWithTheirRow) {
  const std::string whole = packed("blocks_000002000.csv");
  const std::string id = std::to_string(blocks_.front().id);
  EXPECT_NE(message_of(packed("blocks_000002000.csv", 1)).find("block " + id + " has no row"),
            std::string::npos);
  const size_t row = 76, rows = blocks_.size();
  EXPECT_NE(message_of(whole + whole.substr(whole.size() - rows * row, row))
                .find("row " + std::to_string(rows + 1) + ": id " + id + " occurs twice"),
            std::string::npos);
  EXPECT_NE(message_of(whole.substr(0, whole.size() - 3)).find("cut short"), std::string::npos);
  std::string stranger = whole;
  pack({999999, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3::Zero(), 1, 0.0}, stranger);
  EXPECT_NE(message_of(stranger).find("id 999999 is not a block of blocks.vtk"), std::string::npos);
}

}  // namespace
}  // namespace muckpile
