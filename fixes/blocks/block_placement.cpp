// SPDX-License-Identifier: GPL-2.0-or-later
// From blocks on rank 0 to bodies and facets on their ranks; see the header.
#include "fixes/blocks/block_placement.h"

#include <atom.h>
#include <atom_vec.h>
#include <comm.h>
#include <domain.h>
#include <fix_multisphere.h>
#include <modify.h>
#include <multisphere.h>

#include <algorithm>
#include <array>

#include "fixes/blocks/fix_muckpile_balance.h"
#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/exchange.h"

namespace muckpile {
namespace {

/// Boxes of all ranks, on rank 0.
class RankBoxes {
 public:
  explicit RankBoxes(LAMMPS_NS::LAMMPS& lmp) : boxes_(static_cast<std::size_t>(lmp.comm->nprocs)) {
    std::array<double, 6> mine{};
    std::copy_n(lmp.domain->sublo, 3, mine.begin());
    std::copy_n(lmp.domain->subhi, 3, mine.begin() + 3);
    MPI_Gather(mine.data(), 6, MPI_DOUBLE, boxes_.data(), 6, MPI_DOUBLE, 0, lmp.world);
  }

  [[nodiscard]] std::size_t count() const { return boxes_.size(); }
  [[nodiscard]] std::size_t owner(const Vec3& at) const {
    for (std::size_t rank = 0; rank < boxes_.size(); ++rank) {
      const Vec3 lo(boxes_[rank].data()), hi(boxes_[rank].data() + 3);
      if ((at.array() >= lo.array()).all() && (at.array() < hi.array()).all()) return rank;
    }
    return 0;
  }

 private:
  std::vector<std::array<double, 6>> boxes_;
};

/// The facets and boundary faces of each block, by block number.
struct FacesOfBlocks {
  std::vector<std::vector<const Facet*>> facets;
  std::vector<std::vector<BoundaryFace>> faces;
};

FacesOfBlocks faces_of_blocks(const RockModel& model, int first_tag) {
  FacesOfBlocks of{std::vector<std::vector<const Facet*>>(model.bodies.size()),
                   std::vector<std::vector<BoundaryFace>>(model.bodies.size())};
  const auto place = [&](int tag) { return static_cast<std::size_t>(tag - first_tag); };
  for (const Facet& facet : model.facets.facets) {
    of.facets[place(facet.tag_i)].push_back(&facet);
    if (facet.tag_j != kGroundTag) of.facets[place(facet.tag_j)].push_back(&facet);
  }
  for (const BoundaryFace& face : model.facets.faces) of.faces[place(face.tag)].push_back(face);
  return of;
}

void put(engine::ByteWriter& out, const RigidBody& body) {
  out.put(body.mass);
  out.put(body.volume);
  out.put(body.centre);
  out.put(body.inertia);
  out.put(body.axes);
  out.put_all(body.spheres);
}

RigidBody get_body(engine::ByteReader& in) {
  RigidBody body;
  body.mass = in.get<double>();
  body.volume = in.get<double>();
  body.centre = in.get<Vec3>();
  body.inertia = in.get<Vec3>();
  body.axes = in.get<Mat3>();
  body.spheres = in.get_all<Sphere>();
  return body;
}

}  // namespace

BlockPlacement::BlockPlacement(LAMMPS_NS::LAMMPS* engine, int type, double density)
    : Pointers(engine),
      multisphere_(engine::find_multisphere(*engine)),
      type_(type),
      density_(density) {
  first_tag_ = multisphere_->tag_max_body() + 1;
  int mine = 0, all = 0;
  for (int i = 0; i < atom->nlocal; ++i) mine = std::max(mine, static_cast<int>(atom->tag[i]));
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  first_atom_tag_ = all + 1;
  settle_new_fixes();
}

/// The engine sets the per-atom arrays of a new fix at the start of the first run, and would wipe
/// what create_spheres writes: do it now instead.
void BlockPlacement::settle_new_fixes() {
  for (int f = 0; f < modify->nfix; ++f) {
    LAMMPS_NS::Fix& fix = *modify->fix[f];
    if (fix.just_created == 0 || fix.create_attribute == 0) continue;
    fix.just_created = 0;
    fix.pre_set_arrays();
    for (int i = 0; i < atom->nlocal; ++i) fix.set_arrays(i);
  }
}

void BlockPlacement::place(const RockModel& model, const std::vector<Hole>& holes) {
  int blocks = static_cast<int>(model.rock.blocks.size());
  MPI_Bcast(&blocks, 1, MPI_INT, 0, world);
  if (FixMuckpileBalance* balance = FixMuckpileBalance::find(*lmp)) {
    std::vector<Vec3> centres;
    for (const RigidBody& body : model.bodies) centres.push_back(body.centre);
    balance->cut_for(centres);
  }
  create(hand_out(model), holes, blocks);
}

std::vector<char> BlockPlacement::hand_out(const RockModel& model) const {
  const RankBoxes boxes(*lmp);
  const FacesOfBlocks of = faces_of_blocks(model, first_tag_);
  std::vector<engine::ByteWriter> outgoing(boxes.count());
  int atom_tag = first_atom_tag_;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const RigidBody& body = model.bodies[b];
    engine::ByteWriter& out = outgoing[boxes.owner(body.centre)];
    out.put(first_tag_ + static_cast<int>(b));
    out.put(atom_tag);
    put(out, body);
    out.put_all(of.faces[b]);
    out.put(of.facets[b].size());
    for (const Facet* facet : of.facets[b]) out.put(*facet);
    atom_tag += static_cast<int>(body.spheres.size());
  }
  return engine::exchange_bytes(engine::bytes_of(outgoing), world).front();
}

void BlockPlacement::create(const std::vector<char>& mine, const std::vector<Hole>& holes,
                            int blocks) {
  std::vector<BlockRecord> records;
  std::vector<Facet> facets;
  std::vector<BoundaryFace> faces;
  for (engine::ByteReader in(mine); !in.empty();) {
    const int tag = in.get<int>(), atom_tag = in.get<int>();
    const RigidBody body = get_body(in);
    create_body(body, tag, atom_tag);
    records.push_back({tag, body.volume, body.mass, body.centre, body.axes, {}});
    for (const BoundaryFace& face : in.get_all<BoundaryFace>()) faces.push_back(face);
    for (const Facet& facet : in.get_all<Facet>()) facets.push_back(facet);
  }
  count_atoms();
  multisphere_->add_body_finalize();
  FixMuckpileBlocks::find_or_make(*lmp).add(records, facets, faces, holes, blocks);
}

void BlockPlacement::count_atoms() {
  double local = atom->nlocal, all = 0.0;
  MPI_Allreduce(&local, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  atom->natoms = static_cast<LAMMPS_NS::bigint>(all);
  if (atom->map_style == 0) return;
  atom->nghost = 0;
  atom->map_init();
  atom->map_set();
}

/// `displace`: of each sphere from the centre, in the body's axes [m].
void BlockPlacement::create_spheres(const RigidBody& body, const std::vector<double*>& displace,
                                    int tag, int first_atom_tag) {
  const auto count = static_cast<double>(body.spheres.size());
  for (std::size_t k = 0; k < body.spheres.size(); ++k) {
    const Sphere& sphere = body.spheres[k];
    Vec3 at = sphere.centre;
    atom->avec->create_atom(type_, at.data());
    const int m = atom->nlocal - 1;
    atom->tag[m] = first_atom_tag + static_cast<int>(k);
    atom->mask[m] = 1;
    atom->radius[m] = sphere.radius;
    atom->density[m] = density_;
    atom->rmass[m] = body.mass;
    for (int f = 0; f < modify->nfix; ++f) {
      if (modify->fix[f]->create_attribute != 0) modify->fix[f]->set_arrays(m);
    }
    multisphere_->set_body_displace(m, displace[k], tag, 1.0 / count);
  }
}

void BlockPlacement::create_body(const RigidBody& body, int tag, int first_atom_tag) {
  double reach = 0.0;
  std::vector<Vec3> displace;
  std::vector<double*> rows;
  displace.reserve(body.spheres.size());
  for (const Sphere& sphere : body.spheres) {
    displace.emplace_back(body.axes.transpose() * (sphere.centre - body.centre));
    rows.push_back(displace.back().data());
    reach = std::max(reach, displace.back().norm() + sphere.radius);
  }
  create_spheres(body, rows, tag, first_atom_tag);
  Vec3 centre = body.centre, zero = Vec3::Zero(), inertia = body.inertia;
  Mat3 axes = body.axes;
  std::array<bool, 3> free{true, true, true};
  multisphere_->data().add_body(static_cast<int>(rows.size()), centre.data(), zero.data(), reach,
                                zero.data(), zero.data(), body.mass, density_, type_, 1,
                                inertia.data(), axes.col(0).data(), axes.col(1).data(),
                                axes.col(2).data(), rows.data(), free.data(), free.data());
  auto* ids = multisphere_->data().prop().getElementProperty<LAMMPS_NS::ScalarContainer<int>>(
      "id_multisphere");
  ids->set(multisphere_->n_body() - 1, tag);
}

}  // namespace muckpile
