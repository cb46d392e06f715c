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
#include <cmath>

#include "fixes/blocks/fix_muckpile_balance.h"
#include "fixes/blocks/fix_muckpile_blocks.h"
#include "fixes/engine/bodies.h"
#include "fixes/engine/exchange.h"
#include "fixes/engine/find_view.h"
#include "fixes/engine/over_ranks.h"
#include "fixes/engine/style_args.h"
#include "fixes/interfaces/block_shapes.h"

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

/// Bodies of the rock, then of the muck.
std::vector<const RigidBody*> all_bodies(const RockModel& model) {
  std::vector<const RigidBody*> all;
  for (const auto* bodies : {&model.bodies, &model.muck.bodies})
    for (const RigidBody& body : *bodies) all.push_back(&body);
  return all;
}

/// What goes along with each block, by block number: its boundary faces, and its facets. A joint
/// between two blocks of one rank goes along with the first of them alone.
struct FacesOfBlocks {
  std::vector<std::size_t> owners;  // ranks
  std::vector<std::vector<const Facet*>> facets;
  std::vector<std::vector<BoundaryFace>> faces;
};

FacesOfBlocks faces_of_blocks(const RockModel& model, const RankBoxes& boxes, int first_tag) {
  FacesOfBlocks of;
  for (const RigidBody* body : all_bodies(model)) of.owners.push_back(boxes.owner(body->centre));
  of.facets.resize(of.owners.size());
  of.faces.resize(of.owners.size());
  const auto place = [&](int tag) { return static_cast<std::size_t>(tag - first_tag); };
  for (const Facet& facet : model.facets.facets) {
    const std::size_t i = place(facet.tag_i);
    of.facets[i].push_back(&facet);
    if (facet.tag_j == kGroundTag) continue;
    const std::size_t j = place(facet.tag_j);
    if (of.owners[j] != of.owners[i]) of.facets[j].push_back(&facet);
  }
  for (const auto* faces : {&model.facets.faces, &model.muck.faces})
    for (const BoundaryFace& face : *faces) of.faces[place(face.tag)].push_back(face);
  return of;
}

int joints_of(const RockModel& model) {
  return static_cast<int>(std::ranges::count(model.facets.facets, FacetKind::joint, &Facet::kind));
}

/// So many blocks are sent at once; messages of all would take twice what the blocks do.
constexpr std::size_t kBlocksAtOnce = 20000;

}  // namespace

BlockPlacement::BlockPlacement(LAMMPS_NS::LAMMPS* engine, int type, const CutOptions& options)
    : Pointers(engine),
      multisphere_(engine::find_multisphere(*engine)),
      type_(type),
      densities_(options.densities()) {
  for (const RockZone& zone : options.zones) zones_.push_back(zone.name);
  first_tag_ = multisphere_->tag_max_body() + 1;
  int mine = 0;
  for (int i = 0; i < atom->nlocal; ++i) mine = std::max(mine, static_cast<int>(atom->tag[i]));
  first_atom_tag_ = engine::greatest_over_ranks(mine, world) + 1;
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
  const int blocks = engine::of_first_rank(
      static_cast<int>(model.rock.blocks.size() + model.muck.blocks.size()), world);
  if (FixMuckpileBalance* balance = FixMuckpileBalance::find(*lmp)) {
    std::vector<Vec3> centres;
    for (const RigidBody* body : all_bodies(model)) centres.push_back(body->centre);
    balance->cut_for(centres);
  }
  BlocksShare share = hand_out(model, static_cast<std::size_t>(blocks));
  finish(std::move(share), holes, blocks, engine::of_first_rank(joints_of(model), world));
  if (auto* shapes = engine::find_view<BlockShapes>(*lmp)) shapes->share(shapes_of(model));
}

/// Of rock and muck, for contact; none on other ranks than rank 0.
std::vector<BlockShape> BlockPlacement::shapes_of(const RockModel& model) const {
  std::vector<BlockShape> shapes;
  const std::vector<const RigidBody*> bodies = all_bodies(model);
  int atom_tag = first_atom_tag_;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const RigidBody& body = *bodies[b];
    const std::size_t rock = model.rock.blocks.size();
    const Polyhedron& block = (b < rock ? model.rock.blocks[b] : model.muck.blocks[b - rock]).shape;
    BlockShape shape{first_tag_ + static_cast<int>(b), 0, Vec3::Zero(), {}, block.faces};
    for (const Vec3& vertex : block.vertices)
      shape.corners.emplace_back(body.axes.transpose() * (vertex - body.centre));
    const auto key = std::min_element(
        body.spheres.begin(), body.spheres.end(), [&](const Sphere& a, const Sphere& c) {
          return (a.centre - body.centre).norm() < (c.centre - body.centre).norm();
        });
    shape.key = atom_tag + static_cast<int>(key - body.spheres.begin());
    shape.key_offset = body.axes.transpose() * (key->centre - body.centre);
    shapes.push_back(std::move(shape));
    atom_tag += static_cast<int>(body.spheres.size());
  }
  return shapes;
}

/// Makes the bodies of all blocks, from rank 0 to the ranks that own them; what belongs to those of
/// this one.
BlocksShare BlockPlacement::hand_out(const RockModel& model, std::size_t blocks) {
  const RankBoxes boxes(*lmp);
  const FacesOfBlocks of = faces_of_blocks(model, boxes, first_tag_);
  const std::vector<const RigidBody*> bodies = all_bodies(model);
  BlocksShare share;
  int atom_tag = first_atom_tag_;
  for (std::size_t first = 0; first < blocks; first += kBlocksAtOnce) {
    std::vector<ByteWriter> outgoing(boxes.count());
    for (std::size_t b = first; b < std::min(first + kBlocksAtOnce, bodies.size()); ++b) {
      const std::uint8_t zone = b < model.zone_of.size() ? model.zone_of[b] : std::uint8_t{0};
      PlacedBlock placed{
          first_tag_ + static_cast<int>(b), atom_tag, zone, *bodies[b], of.faces[b], {}};
      for (const Facet* facet : of.facets[b]) placed.facets.push_back(*facet);
      outgoing[of.owners[b]].put(placed);
      atom_tag += static_cast<int>(bodies[b]->spheres.size());
    }
    engine::or_engine_error(*lmp, "create_blocks", [&] {
      engine::exchange_messages(outgoing, world, [&](ByteReader& in, std::size_t) {
        while (!in.empty()) take(in.get<PlacedBlock>(), share);
      });
    });
  }
  return share;
}

void BlockPlacement::take(const PlacedBlock& placed, BlocksShare& share) {
  const RigidBody& body = placed.body;
  create_body(placed);
  share.records.push_back(
      {placed.tag, body.volume, body.mass, body.centre, body.axes, {}, placed.zone});
  share.faces.insert(share.faces.end(), placed.faces.begin(), placed.faces.end());
  for (const Facet& facet : placed.facets) share.facets.push_back({facet, FacetMemory{}});
}

void BlockPlacement::finish(BlocksShare share, const std::vector<Hole>& holes, int blocks,
                            int joints) {
  count_atoms();
  multisphere_->add_body_finalize();
  FixMuckpileBlocks& store = FixMuckpileBlocks::find_or_make(*lmp);
  const std::vector<std::uint8_t> numbers =
      engine::or_engine_error(*lmp, [&] { return store.zone_numbers(zones_); });
  for (BlockRecord& record : share.records) record.zone = numbers[record.zone];
  for (FacetEntry& entry : share.facets) {
    entry.facet.zone_i = numbers[entry.facet.zone_i];
    entry.facet.zone_j = numbers[entry.facet.zone_j];
  }
  store.add(std::move(share), holes, blocks, joints);
}

/// Muck has the density of the run that it comes from.
double BlockPlacement::density_of(const PlacedBlock& placed) const {
  constexpr double kRounding = 1e-9;
  const double own = placed.body.mass / placed.body.volume, rock = densities_[placed.zone];
  return std::abs(own - rock) < kRounding * rock ? rock : own;
}

void BlockPlacement::count_atoms() {
  const double all = engine::sum_over_ranks(static_cast<double>(atom->nlocal), world);
  atom->natoms = static_cast<LAMMPS_NS::bigint>(all);
  if (atom->map_style == 0) return;
  atom->nghost = 0;
  atom->map_init();
  atom->map_set();
}

/// `displace`: of each sphere from the centre, in the body's axes [m].
void BlockPlacement::create_spheres(const PlacedBlock& placed,
                                    const std::vector<double*>& displace) {
  const RigidBody& body = placed.body;
  const auto count = static_cast<double>(body.spheres.size());
  for (std::size_t k = 0; k < body.spheres.size(); ++k) {
    const Sphere& sphere = body.spheres[k];
    Vec3 at = sphere.centre;
    atom->avec->create_atom(type_, at.data());
    const int m = atom->nlocal - 1;
    atom->tag[m] = placed.first_atom_tag + static_cast<int>(k);
    atom->mask[m] = 1;
    atom->radius[m] = sphere.radius;
    atom->density[m] = density_of(placed);
    atom->rmass[m] = body.mass;
    for (int f = 0; f < modify->nfix; ++f) {
      if (modify->fix[f]->create_attribute != 0) modify->fix[f]->set_arrays(m);
    }
    multisphere_->set_body_displace(m, displace[k], placed.tag, 1.0 / count);
  }
}

void BlockPlacement::create_body(const PlacedBlock& placed) {
  const RigidBody& body = placed.body;
  double reach = 0.0;
  std::vector<Vec3> displace;
  std::vector<double*> rows;
  displace.reserve(body.spheres.size());
  for (const Sphere& sphere : body.spheres) {
    displace.emplace_back(body.axes.transpose() * (sphere.centre - body.centre));
    rows.push_back(displace.back().data());
    reach = std::max(reach, displace.back().norm() + sphere.radius);
  }
  create_spheres(placed, rows);
  Vec3 centre = body.centre, zero = Vec3::Zero(), inertia = body.inertia;
  Mat3 axes = body.axes;
  std::array<bool, 3> free{true, true, true};
  multisphere_->data().add_body(static_cast<int>(rows.size()), centre.data(), zero.data(), reach,
                                zero.data(), zero.data(), body.mass, density_of(placed), type_, 1,
                                inertia.data(), axes.col(0).data(), axes.col(1).data(),
                                axes.col(2).data(), rows.data(), free.data(), free.data());
  auto* ids = multisphere_->data().prop().getElementProperty<LAMMPS_NS::ScalarContainer<int>>(
      "id_multisphere");
  ids->set(multisphere_->n_body() - 1, placed.tag);
}

}  // namespace muckpile
