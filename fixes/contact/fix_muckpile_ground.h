// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/ground: LIGGGHTS' fix wall/gran on meshes whose faces have ground behind them.
// Scope: a sphere whose centre has been pressed through a face is pushed back out instead of on
// through; all else a fix wall/gran of its own does, which the engine does not know of.
#pragma once

#include <fix.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "contact/one_sided_face.h"

namespace LAMMPS_NS {
class FixMeshSurface;
class TriMesh;
}  // namespace LAMMPS_NS

namespace muckpile {

class FixMuckpileGround : public LAMMPS_NS::Fix {
 public:
  FixMuckpileGround(LAMMPS_NS::LAMMPS* lmp, int narg, char** arg);

  void post_force(int vflag) override;

  int setmask() override;
  void post_create() override { wall_->post_create(); }
  void pre_delete(bool unfixflag) override { wall_->pre_delete(unfixflag); }
  void init() override;
  void setup(int vflag) override;
  void pre_neighbor() override { wall_->pre_neighbor(); }
  void pre_force(int vflag) override { wall_->pre_force(vflag); }
  int min_type() override { return wall_->min_type(); }
  int max_type() override { return wall_->max_type(); }

 private:
  using SpheresBehind = std::map<int, WayOut>;  ///< by local index

  /// Computes while the engine sees the spheres behind faces before them.
  void with_spheres_shown(const std::function<void()>& compute) const;
  [[nodiscard]] SpheresBehind spheres_behind() const;
  void look_behind(LAMMPS_NS::TriMesh& mesh, int face, const std::vector<int>& near,
                   SpheresBehind& behind) const;
  /// Puts the balls into the engine's arrays and returns what was there.
  std::map<int, Ball> exchange(const std::map<int, Ball>& balls) const;

  std::unique_ptr<LAMMPS_NS::Fix> wall_;
  std::vector<LAMMPS_NS::FixMeshSurface*> meshes_;
};

}  // namespace muckpile
