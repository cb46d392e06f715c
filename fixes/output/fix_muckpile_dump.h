// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/dump: snapshots of the blocks' poses, velocities and fragments, as text or packed.
// Scope: blocks made by create_blocks; their shapes are in the file that create_blocks writes.
#pragma once

#include <fix.h>

#include <string>
#include <string_view>

#include "provenance/run_files.h"

namespace muckpile {

class BlockImpulses;
class JointFragments;
class KnownBlocks;

class FixMuckpileDump : public LAMMPS_NS::Fix {
 public:
  FixMuckpileDump(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void init() override;
  void setup(int vflag) override;
  void initial_integrate(int vflag) override;
  void end_of_step() override;
  void post_run() override;
  int modify_param(int narg, char** arg) override;

 private:
  void clear_folder();
  void write();
  void write_joints() const;
  void write_impulses() const;
  [[nodiscard]] std::string rows() const;
  [[nodiscard]] std::string of_all_ranks(const std::string& mine) const;
  /// `remark`, with a blank behind it, is one more of the first line.
  void write_file(const std::string& name, std::string_view header, const std::string& mine,
                  const std::string& remark = "") const;

  KnownBlocks* blocks_ = nullptr;
  JointFragments* joints_ = nullptr;
  BlockImpulses* impulses_ = nullptr;
  std::string where_, folder_;
  SnapshotForm form_;
  int every_;                    // the engine looks up `nevery` only when a run is set up
  LAMMPS_NS::bigint last_ = -1;  // step of the last snapshot
  bool cleared_ = false;
};

}  // namespace muckpile
