// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/blocks (internal, made by create_blocks): what Muckpile knows of each block beyond
// the multisphere body, and the facets between blocks, kept on the ranks that own the blocks.
// Scope: bookkeeping only. A facet lives on every rank that owns one of its blocks; the copies stay
// equal because both ranks do the same arithmetic on the same numbers.
#pragma once

#include <fix.h>

#include <cstdint>
#include <cstdio>
#include <functional>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "bond/facet.h"
#include "bond/network/facet_memory.h"
#include "bond/network/network_block.h"
#include "bond/network/stored_network.h"
#include "fixes/interfaces/facet_store.h"
#include "fixes/interfaces/given_energy.h"
#include "fixes/interfaces/known_blocks.h"
#include "fixes/interfaces/recorded_run_holder.h"
#include "geometry/block_model.h"

namespace LAMMPS_NS {
class FixMultisphere;
}

namespace muckpile {

/// A facet with all that it remembers.
struct FacetEntry {
  Facet facet;
  FacetMemory memory;
};
template <>
struct Stored<FacetEntry> {
  static constexpr std::string_view kName = "facet_entry";
  static constexpr int kVersion = 3;
  static auto fields(auto& entry) { return std::tie(entry.facet, entry.memory); }
};

/// Blocks on their way to another rank, or into a restart file, with what is on them.
struct BlocksShare {
  std::vector<BlockRecord> records;
  std::vector<BoundaryFace> faces;
  std::vector<FacetEntry> facets;
};
template <>
struct Stored<BlocksShare> {
  static constexpr std::string_view kName = "blocks_share";
  static constexpr int kVersion = 1;
  static auto fields(auto& share) { return std::tie(share.records, share.faces, share.facets); }
};

/// What a restart file holds of the fix that is the same on all ranks.
struct BlocksState {
  double time = 0.0;  ///< of the engine, which does not keep it [s]
  int highest_joint_class = 0;
  std::vector<Hole> holes;
  std::vector<std::string> zones;
  int blocks_created = 0, facets_created = 0;
  RecordedRun run;
  RockSoftness softness;
};
template <>
struct Stored<BlocksState> {
  static constexpr std::string_view kName = "blocks_state";
  static constexpr int kVersion = 3;
  static auto fields(auto& state) {
    return std::tie(state.time, state.highest_joint_class, state.holes, state.zones,
                    state.blocks_created, state.facets_created, state.run, state.softness);
  }
};

class FixMuckpileBlocks : public LAMMPS_NS::Fix,
                          public KnownBlocks,
                          public FacetStore,
                          public GivenEnergy,
                          public RecordedRunHolder {
 public:
  FixMuckpileBlocks(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);
  ~FixMuckpileBlocks() override;

  int setmask() override;
  void init() override;
  void setup_pre_neighbor() override { synchronise(); }
  void pre_neighbor() override { synchronise(); }
  void setup(int vflag) override;
  double memory_usage() override;
  void write_restart(FILE* file) override;
  void write_restart_file(char* file) override;  ///< once LIGGGHTS has closed it
  void restart(char* state) override;

  /// The store of this run, nullptr before create_blocks.
  [[nodiscard]] static FixMuckpileBlocks* find(LAMMPS_NS::LAMMPS& lmp);
  static FixMuckpileBlocks& find_or_make(LAMMPS_NS::LAMMPS& lmp);

  /// Takes the blocks that this rank creates, with every facet that one of them has; `blocks_all`
  /// and `joints_all` are created on all ranks.
  void add(BlocksShare share, const std::vector<Hole>& holes, int blocks_all, int joints_all);

  [[nodiscard]] const std::vector<BlockRecord>& records() const override { return records_; }
  [[nodiscard]] const std::vector<Hole>& holes() const override { return holes_; }
  [[nodiscard]] const std::string& run_id() const override { return record_.id(); }
  [[nodiscard]] int blocks_created() const override { return blocks_created_; }
  [[nodiscard]] int blocks_lost_before() const override { return lost_before_; }
  [[nodiscard]] int facets_created() const override { return facets_created_; }

  void set_keeper(FacetKeeper* keeper) override;
  [[nodiscard]] FacetLists hand_over() override;
  [[nodiscard]] RockSoftness softness() const override {
    return keeper_ != nullptr ? keeper_->softness() : softness_;
  }
  [[nodiscard]] std::uint64_t version() const override { return version_; }
  [[nodiscard]] int highest_joint_class() const override { return highest_joint_class_; }
  [[nodiscard]] const std::vector<std::string>& zones() const override { return zones_; }
  /// Numbers of the rock beside the zones (0) and of these zones; new names get the next ones.
  [[nodiscard]] std::vector<std::uint8_t> zone_numbers(const std::vector<std::string>& names);
  [[nodiscard]] const std::vector<int>& copy_tags() const override { return copy_tags_; }
  [[nodiscard]] const engine::BlockHalo& halo() const override { return halo_; }
  [[nodiscard]] bool restored() const override { return restored_; }
  [[nodiscard]] engine::Bodies bodies() override;

  void keep_given(double energy) override { given_ += energy; }
  [[nodiscard]] double take_given() override { return std::exchange(given_, 0.0); }
  [[nodiscard]] RunRecord& record() override { return record_; }

 private:
  void keep_needed(BlocksShare&& share, const std::unordered_set<int>& here,
                   std::vector<FacetEntry>& facets);
  void check_bodies();

  void synchronise();
  [[nodiscard]] std::vector<int> body_tags();
  void take_back();
  void drop_retired();
  void drop_orphans(const std::vector<int>& tags, const engine::BlockDirectory& directory);
  void retire_into_record(const Facet& facet, int end);
  void migrate(const std::vector<int>& tags, const engine::BlockDirectory& directory);
  [[nodiscard]] std::vector<ByteWriter> pack_leaving(const std::vector<int>& tags,
                                                     const engine::BlockDirectory& directory);
  void keep_facets(const std::function<bool(std::size_t)>& needed);
  void add_facets(std::vector<FacetEntry> added);
  void merge(const std::vector<int>& tags, std::vector<BlocksShare>& arrived);
  void index(const std::vector<int>& tags, const engine::BlockDirectory& directory);

  LAMMPS_NS::FixMultisphere* multisphere_;
  FacetKeeper* keeper_ = nullptr;
  RockSoftness softness_;  // while there is no keeper
  std::vector<BlockRecord> records_;
  std::vector<Facet> facets_;
  std::vector<FacetMemory> memory_;
  std::vector<BoundaryFace> faces_;
  std::vector<Hole> holes_;
  RunRecord record_;
  std::vector<int> tags_, copy_tags_;
  engine::BlockHalo halo_;
  std::uint64_t version_ = 0;
  bool handed_over_ = false, restored_ = false, contact_warned_ = false;
  std::set<std::string> holders_told_;  // fixes that were warned of
  double given_ = 0.0;                  // [J]
  std::vector<std::string> zones_;
  int blocks_created_ = 0, lost_before_ = 0, facets_created_ = 0, highest_joint_class_ = 0;
};

}  // namespace muckpile
