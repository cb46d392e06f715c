// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/ground: finds the spheres behind faces, and shows them to LIGGGHTS before them.
// Scope: see the header and docs/styles/fix_muckpile_ground.md.
#include "fixes/contact/fix_muckpile_ground.h"

#include <atom.h>
#include <fix_mesh_surface.h>
#include <fix_neighlist_mesh.h>
#include <modify.h>
#include <tri_mesh.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "fixes/engine/registry.h"
#include "fixes/engine/single_fix.h"
#include "fixes/engine/style_args.h"
#include "fixes/engine/style_name.h"
#include "fixes/engine/walls.h"

namespace muckpile {
namespace {

using LAMMPS_NS::FixConst::POST_FORCE;
using LAMMPS_NS::FixConst::PRE_FORCE;
using LAMMPS_NS::FixConst::PRE_NEIGHBOR;

/// Over or under the face, not beside it.
bool over_face(LAMMPS_NS::TriMesh& mesh, int face, int sphere, double radius, double* centre) {
  constexpr int kInside = 7;  // LIGGGHTS: all three barycentric coordinates are positive
  double to_face[3], barycentric[3];
  int sign = 0;
  mesh.resolveTriSphereContactBary(sphere, face, radius, centre, to_face, barycentric, sign);
  return sign == kInside;
}

}  // namespace

FixMuckpileGround::FixMuckpileGround(LAMMPS_NS::LAMMPS* engine, int narg, char** arg)
    : Fix(engine, narg, arg) {
  const std::string where = engine::name_of(*this);
  engine::refuse_second_fix(*lmp, where, "muckpile/ground");
  const std::vector<char*> words(arg, arg + narg);
  const auto mesh = std::ranges::find(words, std::string_view("meshes"));
  if (mesh == words.end())
    engine::stop(*lmp, where +
                           ": needs 'mesh n_meshes N meshes ID ...', got none; planes have no "
                           "back side, fix wall/gran has those");
  wall_ = engine::make_fix(*lmp, "wall/gran", words);  // checks its words
  for (auto word = mesh + 1; word != words.end(); ++word) {
    LAMMPS_NS::Fix* const found = modify->find_fix_id(*word);
    if (auto* const surface = dynamic_cast<LAMMPS_NS::FixMeshSurface*>(found); surface != nullptr)
      meshes_.push_back(surface);
    else
      break;
  }
}

/// LIGGGHTS refuses two walls on one mesh, but does not know of the wall in here.
void FixMuckpileGround::init() {
  for (LAMMPS_NS::FixMeshSurface* const mesh : meshes_) {
    const std::string other = engine::wall_on_mesh(*lmp, *mesh);
    if (!other.empty())
      engine::stop(*lmp, engine::name_of(*this) + ": mesh '" + mesh->id +
                             "' must have one wall only, got fix wall/gran '" + other + "' too");
  }
  wall_->init();
}

int FixMuckpileGround::setmask() { return PRE_NEIGHBOR | PRE_FORCE | POST_FORCE; }

void FixMuckpileGround::setup(int vflag) {
  with_spheres_shown([&] { wall_->setup(vflag); });
}

void FixMuckpileGround::post_force(int vflag) {
  with_spheres_shown([&] { wall_->post_force(vflag); });
}

void FixMuckpileGround::with_spheres_shown(const std::function<void()>& compute) const {
  const SpheresBehind behind = spheres_behind();
  if (behind.empty()) {
    compute();
    return;
  }
  std::map<int, Ball> shown;
  for (const auto& [sphere, way] : behind)
    shown[sphere] = way.before_face({Vec3::Map(atom->x[sphere]), atom->radius[sphere]});
  const std::map<int, Ball> hidden = exchange(shown);
  compute();
  exchange(hidden);
}

std::map<int, Ball> FixMuckpileGround::exchange(const std::map<int, Ball>& balls) const {
  std::map<int, Ball> before;
  for (const auto& [sphere, ball] : balls) {
    before[sphere] = {Vec3::Map(atom->x[sphere]), atom->radius[sphere]};
    Vec3::Map(atom->x[sphere]) = ball.centre;
    atom->radius[sphere] = ball.radius;
  }
  return before;
}

FixMuckpileGround::SpheresBehind FixMuckpileGround::spheres_behind() const {
  SpheresBehind behind;
  for (LAMMPS_NS::FixMeshSurface* const surface : meshes_) {
    LAMMPS_NS::TriMesh& mesh = *surface->triMesh();
    const int faces = mesh.sizeLocal() + mesh.sizeGhost();
    for (int face = 0; face < faces; ++face)
      look_behind(mesh, face, surface->meshNeighlist()->get_contact_list(face), behind);
  }
  return behind;
}

/// Up to a radius deep: so far the list of near spheres is sure to reach.
void FixMuckpileGround::look_behind(LAMMPS_NS::TriMesh& mesh, int face,
                                    const std::vector<int>& near, SpheresBehind& behind) const {
  Vec3 on_face, normal;
  mesh.center(face, on_face.data());
  mesh.surfaceNorm(face, normal.data());
  for (const int sphere : near) {
    if (sphere >= atom->nlocal) continue;
    const double radius = atom->radius[sphere];
    const double depth = normal.dot(on_face - Vec3::Map(atom->x[sphere]));
    if (depth <= 0.0 || depth > radius) continue;
    if (over_face(mesh, face, sphere, radius, atom->x[sphere]))
      behind[sphere].consider(depth, normal);
  }
}

}  // namespace muckpile
