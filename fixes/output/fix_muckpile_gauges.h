// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/gauges: velocity, displacement and stress at points that ride with the rock.
// Scope: a gauge is a point of the block that it was in at the start; it costs nothing between
// samples. SI units.
#pragma once

#include <fix.h>

#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "fixes/engine/run_table.h"
#include "math/types.h"
#include "rock/gauge_points.h"
#include "state/encoding.h"

namespace muckpile {

class BlockStresses;
class KnownBlocks;

/// A gauge and the block that carries it.
struct Gauge {
  Vec3 start = Vec3::Zero();   ///< where the user put it [m]
  int block = 0;               ///< tag; 0: not yet known
  Vec3 offset = Vec3::Zero();  ///< from the block's centre, along its principal axes [m]
  bool lost = false;           ///< with its block
};
template <>
struct Stored<Gauge> {
  static constexpr std::string_view kName = "gauge";
  static constexpr int kVersion = 1;
  static auto fields(auto& gauge) {
    return std::tie(gauge.start, gauge.block, gauge.offset, gauge.lost);
  }
};

/// What a restart file holds of the fix.
struct GaugesState {
  std::vector<Gauge> gauges;
  double next = 0.0;  ///< time of the next sample, by interval [s]
};
template <>
struct Stored<GaugesState> {
  static constexpr std::string_view kName = "gauges_state";
  static constexpr int kVersion = 1;
  static auto fields(auto& state) { return std::tie(state.gauges, state.next); }
};

class FixMuckpileGauges : public LAMMPS_NS::Fix {
 public:
  FixMuckpileGauges(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void end_of_step() override;
  void write_restart(FILE* file) override;
  void restart(char* state) override;

 private:
  /// The block nearest to a point.
  struct Nearest {
    double distance = std::numeric_limits<double>::max();  // to its faces, outside [m]
    int body = -1;
    int tag = std::numeric_limits<int>::max();
  };
  [[nodiscard]] Nearest nearest_to(const Vec3& point) const;
  void refuse_shared_file() const;
  void bind();
  void require_near(std::size_t g, double distance, double size) const;
  void say_where(const std::vector<double>& distances) const;
  [[nodiscard]] double intervals() const;
  [[nodiscard]] bool due() const;
  void sample();
  [[nodiscard]] std::vector<double> rows_of_this_rank() const;
  void note_lost(const std::vector<bool>& seen);
  [[nodiscard]] std::string text(const std::vector<std::vector<double>>& rows) const;

  GaugeOptions options_;
  std::string where_;
  engine::RunTable table_;
  KnownBlocks* blocks_ = nullptr;
  BlockStresses* rock_ = nullptr;
  std::vector<Gauge> gauges_;
  std::unordered_multimap<int, std::size_t> of_block_;  // gauges by tag of their block
  double next_ = 0.0;                                   // time of the next sample, by interval [s]
  LAMMPS_NS::bigint last_ = -1;                         // step of the last sample
  LAMMPS_NS::bigint first_ = -1;                        // first step whose rows are this start's
  bool restored_ = false;
};

}  // namespace muckpile
