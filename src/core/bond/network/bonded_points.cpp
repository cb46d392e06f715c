// SPDX-License-Identifier: GPL-2.0-or-later
// The points of a facet that are in the dilatations.
// Scope: see the header; formulas are in facet_network.h.
#include "bond/network/bonded_points.h"

#include <cmath>

#include "bond/law/giving_way.h"
#include "bond/network/border_relief.h"
#include "bond/network/broken_contact.h"
#include "bond/network/joint_points.h"

namespace muckpile {

Vec3 bulk_traction(const FacetKinematics& facets, const LeaningFaces* leaning, std::size_t f,
                   const FacetOpenings& openings) {
  const BondConstants bond = facets.tables.bond(f);
  const std::vector<double>& stress = facets.blocks.bulk_stress;
  const auto [i, j] = facets.tables.blocks_of(f);
  Vec3 bulk = bond.bulk_i * stress[i] * openings.i + bond.bulk_j * stress[j] * openings.j;
  if (!facets.tables.borders().empty())
    bulk += border_traction(facets, f) * facets.motion(f).normal;
  return leaning != nullptr ? Vec3(bulk + leaning->traction(f)) : bulk;
}

[[gnu::always_inline]] inline FacetPull pull_of(const FacetKinematics& facets,
                                                const LeaningFaces* leaning, std::size_t f,
                                                const FacetMotion& motion) {
  FacetPull pull(motion);
  const LaneVec jump = facets.elastic_jump(f, motion);
  const LaneVec bulk(bulk_traction(facets, leaning, f, facets.openings(f, motion.scale)));
  pull.traction = of_bonded(
      facets, f, [&](const auto& points) { return points.traction(pull.normal, jump, bulk); });
  return pull;
}

LaneVec bonded_tractions(const FacetKinematics& facets, const LeaningFaces* leaning, std::size_t f,
                         const FacetMotion& motion) {
  return pull_of(facets, leaning, f, motion).traction;
}

Vec3 mean_traction(const FacetKinematics& facets, const LeaningFaces* leaning, std::size_t f) {
  const FacetMotion motion = facets.motion(f);
  if (facets.tables.alone(f)) return mean_at_points(pull_of(facets, leaning, f, motion).traction);
  return facets.tables.bond(f).traction(motion.normal, motion.mean_jump()) +
         bulk_traction(facets, leaning, f, facets.openings(f, motion.scale));
}

/// Which points fail if they are bonded, at the speed at which their sides part; those that slip as
/// they open.
static LaneMask failing(const FacetKinematics& facets, std::size_t f, const FacetPull& pull,
                        const LaneMask& slipping) {
  PointLoad<Lanes> load(pull.normal, pull.traction);
  load.shear_squared = choose(slipping, Lanes(0.0), load.shear_squared);
  const JointLaw& joint = facets.tables.joint(f);
  const Lanes unless_slipping = choose(slipping, Lanes(0.0), 1.0);
  const LaneMask slowly = is_point() && load.breaks(joint, {unless_slipping, unless_slipping});
  const JointLaws& laws = facets.tables.laws();
  if (!laws.depends_on_rate() || none_of(slowly)) return slowly;
  const auto [depth_i, depth_j] = facets.tables.depths(f);
  const Lanes rate = sqrt(dot(pull.rate, pull.rate)) / (depth_i + depth_j);
  const JointParameters& p = facets.tables.parameters(f);
  const auto faster = [&](double reference_rate) {
    return Lanes(
        [&](auto lane) { return rate_factor(rate[lane], reference_rate, p.rate_exponent); });
  };
  return slowly && (slipping ||
                    load.breaks(joint, {faster(p.reference_rate), faster(p.reference_rate_shear)}));
}

FacetPull BondedPoints::pull(std::size_t f, const FacetMotion& motion) const {
  return pull_of(facets_, parts_.leaning, f, motion);
}

void BondedPoints::work(std::size_t f, const FacetMotion& motion, const ContactConstants& contact,
                        FacetPull& pull, double dt) {
  const FacetTraces& traces = facets_.history.traces(f);
  const bool smooth = contact.shear == 0.0;  // a mirror: see slid_along()
  const bool away = (smooth || traces.slipping.any()) && parting_of(motion, contact).slid_away();
  const bool torn = motion.turn().exceeds(kTurnStart) || (smooth && away);
  const LaneMask slipping = where_slipping(traces);
  const LaneMask fails =
      torn ? is_point() : failing(facets_, f, pull, slipping) || (slipping && LaneMask(away));
  for (int p = 0; p < kFacetPoints; ++p) {
    const auto q = static_cast<std::size_t>(p);
    if (traces.is_contact(q) || !fails[q]) continue;
    const Vec3 traction = pull.traction.at(p);
    const PointBreak broken = {p,
                               motion.normal,
                               pull.jump.at(p),
                               facets_.elastic_jump(f, motion).at(p),
                               traction,
                               pull.rate.at(p),
                               facets_.openings(f, motion.scale),
                               motion.axes(),
                               torn};
    pull.add(p, -breaking_.break_point(f, broken, dt));
  }
  const double damping = facets_.tables.damping(f);
  if (damping != 0.0 && !facets_.history.ground(f).yields) {  // it has a dashpot itself
    const LaneMask bonded = is_point() && !where_broken(traces);
    const LaneVec rate = choose(bonded, Lanes(1.0), 0.0) * pull.rate;
    pull.traction += Lanes(damping) * rate;
    parts_.books.losses.damping +=
        contact.weight * contact.point_area * damping * dt * sum(dot(rate, rate));
  }
  if (!traces.slipping.any()) return;
  if (facets_.tables.laws().crushes()) crush(f, motion, contact, pull, dt);
  rub(f, motion, contact, pull, dt);
}

/// How much of the slip by which the spring alone would shed what friction cannot hold (`over`) is
/// taken in this step: all, but where shear works through the blocks, too. There the facets of a
/// block that slip would overshoot together. So all that the sides have moved in the step, which
/// leaves the traction as it is, and of the rest what is stable if three facets do so at once, one
/// in each direction.
static Lanes slip_share(double through, const ContactConstants& contact, const LaneVec& over,
                        const LaneVec& rate, double dt) {
  constexpr double kHardly = 0.1, kAtOnce = 3.0;  // [-]
  if (through < kHardly) return 1.0;
  if (dt == 0.0) return 0.0;  // the pose of the last step, looked at again as a run goes on
  const double eased = 1.0 / (1.0 + kAtOnce * through);
  const Lanes moved = contact.shear * dt * dot(over, rate);
  const Lanes whole = max(dot(over, over), Lanes(1e-300));  // 0 at points that stick
  return eased + (1.0 - eased) * min(max(moved / whole, Lanes(0.0)), Lanes(1.0));
}

/// How stiff a facet is along its normal through the dilatations of its blocks, free faces left out
/// [Pa/m].
static double pressed_through_blocks(const FacetKinematics& facets, std::size_t f) {
  const BondConstants bond = facets.tables.bond(f);
  const Vec3 normal = facets.tables.normal(f);
  const auto part = [&](int block, double area, const Vec3& opening) {
    const auto b = static_cast<std::size_t>(block);
    const double through = area * normal.dot(opening);
    return facets.blocks.rock[b].lame_lambda * through * through / facets.blocks.volume(b);
  };
  return (part(facets.tables.i_of(f), bond.area_i, bond.opening_i) +
          part(facets.tables.j_of(f), bond.area_j, bond.opening_j)) /
         facets.tables.area(f);
}

/// How much of the way by which its spring alone would shed what it cannot carry a point crushes in
/// a step. If all faces of a block do so alike, the sum of A h/2 over them is 3 V, and the block's
/// dilatation sheds 3 lambda/2G as much as their springs: together just what is over then. Where
/// fewer do, the rest follows in the next steps.
static double crush_share(const FacetKinematics& facets, const LeaningFaces* leaning,
                          std::size_t f) {
  const auto [i, j] = facets.tables.blocks_of(f);
  const auto through = [&](std::size_t b) {
    return 3.0 * facets.blocks.rock[b].lame_lambda / facets.blocks.rock[b].two_g;
  };
  const double slanted = leaning != nullptr ? slip_through_blocks(facets, leaning, f).leaning : 0.0;
  return 1.0 / (1.0 + std::max(through(i), through(j)) + slanted);
}

/// Takes what crushing takes out of the elastic jump from the sums of the two blocks; returns what
/// their dilatation gives up, where this rank owns them [J]. What its becoming uneven and leaning
/// faces give up is booked with what breaks.
double BondedPoints::crush_blocks(std::size_t f, const FacetMotion& motion, double closer) {
  const BondConstants bond = facets_.tables.bond(f);
  const FacetOpenings openings = facets_.openings(f, motion.scale);
  BlockFields& blocks = parts_.blocks;
  double taken = 0.0;
  const auto shed = [&](std::size_t b, double area, const Vec3& opening) {
    const BlockSums before = blocks.sums[b];
    blocks.sums[b].bonded -= area * opening.dot(motion.normal) * closer;
    if (blocks.owned(b)) taken += blocks.potential(b, before) - blocks.potential(b, blocks.sums[b]);
    parts_.books.dropped.push_back({b, 0.0, 0.0});  // its dilatation is no longer what it was
  };
  const auto [i, j] = facets_.tables.blocks_of(f);
  shed(i, bond.area_i, openings.i);
  shed(j, bond.area_j, openings.j);
  if (parts_.leaning != nullptr)
    parts_.leaning->drop(facets_, f, {kFacetPoints * closer * motion.normal, true});
  parts_.books.newly_cracked = true;
  return taken;
}

/// Walls of points that slip, which stay in the dilatations, crush under a pressure beyond their
/// strength: the two sides come closer for good. What is taken is what the springs and the blocks
/// give up, one facet after the other, less the work that the limited force has not taken from the
/// blocks (giving_way.h).
void BondedPoints::crush(std::size_t f, const FacetMotion& motion, const ContactConstants& contact,
                         FacetPull& pull, double dt) {
  const CrushingWalls<Lanes> walls{facets_.tables.wall_strength(f)};
  const Lanes along = dot(pull.normal, pull.traction), rate = dot(pull.normal, pull.rate);
  const LaneMask slipping = where_slipping(facets_.history.traces(f));
  const Lanes over = choose(slipping, along - walls.bear(along), 0.0);
  const LaneMask crushes = over < 0.0;
  if (none_of(crushes)) return;
  pull.traction = pull.traction - over * pull.normal;
  if (dt == 0.0) return;  // the pose of the last step, looked at again as a run goes on
  const double spring = facets_.tables.bond(f).normal();
  const Lanes elastic = dot(pull.normal, facets_.elastic_jump(f, motion));
  const Lanes closer = Lanes(crush_share(facets_, parts_.leaning, f) / spring) * over;
  const LaneVec in_axes = rotated_back(motion.axes(), closer * pull.normal);
  ContactRows& contacts = parts_.history.contacts();
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (crushes[p])
      contacts.set_offset(f, p, contacts.offset(f, p) + in_axes.at(static_cast<int>(p)));
  const double mean_closer = sum(closer) / kFacetPoints;
  const Lanes by_blocks = 0.5 * pressed_through_blocks(facets_, f) * mean_closer;
  const Lanes by_springs =
      taken_for_good<Lanes>(spring, spring * elastic, over - by_blocks, closer, dt * rate);
  parts_.books.losses.crush(contact.weight * contact.point_area *
                                sum(choose(crushes, by_springs, 0.0)) +
                            crush_blocks(f, motion, mean_closer));
}

/// Friction and the dashpot of the points that slip, which stay in the dilatations: their normal
/// law is that of the bonded point. What friction takes is that of a spring as stiff as the facet
/// and its dilatations (giving_way.h).
void BondedPoints::rub(std::size_t f, const FacetMotion& motion, const ContactConstants& contact,
                       FacetPull& pull, double dt) {
  ContactRows& contacts = parts_.history.contacts();
  JointLosses& losses = parts_.books.losses;
  const LaneMask slipping = where_slipping(facets_.history.traces(f));
  const Lanes rate = dot(pull.normal, pull.rate);
  const Lanes elastic = choose(slipping, dot(pull.normal, pull.traction), 0.0);
  const Lanes damped = elastic + choose(slipping, facets_.tables.contact_damping(f) * rate, 0.0);
  const CrushingWalls<Lanes> walls{facets_.tables.wall_strength(f)};
  const Lanes normal = walls.bear(min(damped, Lanes(0.0)));
  const LaneVec shear = choose(slipping, Lanes(1.0), 0.0) * pull.traction - elastic * pull.normal;
  const LaneVec slip = pull.rate - rate * pull.normal;
  const auto [slips, kept] =
      Slide<Lanes>(shear, friction_of(facets_, f).limit(normal, dot(slip, slip)));
  pull.traction = choose(slipping, normal * pull.normal + kept * shear, pull.traction);

  const double booked = contact.weight * contact.point_area;
  losses.damping += booked * dt * sum((normal - elastic) * rate);
  if (none_of(slips)) return;
  const LaneVec over = (1.0 - kept) * shear;
  const SlipThroughBlocks through = slip_through_blocks(facets_, parts_.leaning, f);
  const LaneVec slid = slip_share(through.most(), contact, over, pull.rate, dt) * (1.0 - kept) /
                       contact.shear * shear;
  const LaneVec in_axes = rotated_back(motion.axes(), slid);
  for (std::size_t p = 0; p < kFacetPoints; ++p)
    if (slips[p])
      contacts.set_offset(f, p, contacts.offset(f, p) + in_axes.at(static_cast<int>(p)));
  remember_slip(facets_.tables, parts_.history, f, slips, slid, 1.0);
  const Lanes stiffness = contact.shear * (1.0 + through.dilatations);
  losses.friction +=
      booked * sum(taken_for_good(stiffness, shear, over, slid, Lanes(dt) * pull.rate));
}

}  // namespace muckpile
