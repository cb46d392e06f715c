// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in broken joints: how wide they are, how easily gas passes them, and what room blocks have.
// Scope: see joint_gas.h. Number by number over all cracks, so that the loops are vectorised.
#include <algorithm>
#include <cmath>

#include "gas/joint_gas.h"

namespace muckpile {

void JointGas::find_apertures(const JointRooms& rooms) {
  rooms.open(crack_facets_, openings_);
  OpenJoints& open = openings_;
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    // A void is no bundle of cracks.
    many_[c] = open.parted_squared[c] > 1.0 ? 1.0 : cracks_[c].many;
    wall_[c] = many_[c] * open.area[c];
    closed_[c] = open.pressure[c];
    mechanical_[c] = open.opening[c] / many_[c];
  }
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    const double parted = open.parted_squared[c];
    if (parted > 1.0)
      wide_.push_back({static_cast<std::uint32_t>(c), parted > p_.open_gas * p_.open_gas});
  }
  close_joints();
  for (const auto& [c, law] : open.by_law) {
    closed_[c] = law.at_break;
    mechanical_[c] = law.mechanical;
    aperture_[c] = law.hydraulic;
    open.opening[c] = law.mechanical - law.at_break;  // what the joint gives way by is room there
  }
  note_gives();
}

/// The pressure works on the blocks as they part, whether their faces touch or not.
void JointGas::note_gives() {
  const OpenJoints& open = openings_;
  for (std::size_t c = 0; c < cracks_.size(); ++c) {
    const std::uint32_t f = cracks_[c].facet;
    const double give = open.area[c] * (open.apart[c] - open.opening[c]);
    cracks_[c].gives = seen_points_[f] == open.points[c] ? give - seen_gives_[f] : 0.0;
    seen_gives_[f] = give;
    seen_points_[f] = open.points[c];
  }
}

/// Of stress and opening in closed_ and mechanical_; in a form that the compiler vectorises.
void JointGas::close_joints() {
  const ClosedJoint joint = joint_;  // which no store can change
  double* const __restrict closed = closed_.data(), * const __restrict mechanical =
                                                        mechanical_.data();
  double* const __restrict aperture = aperture_.data();
  for (std::size_t c = 0, count = cracks_.size(); c < count; ++c) {
    closed[c] = joint.closed(closed[c]);
    mechanical[c] += closed[c];
    aperture[c] = joint.hydraulic(mechanical[c]);
  }
}

/// How easily gas passes each crack, and the film that it makes there: the friction is in the
/// passage, (1 + f L/(2w))^(-1/2).
void JointGas::find_passages() {
  const CrackFlow flow = flow_;
  const WallHeat heat = heat_;
  const double capacity = heat_capacity();
  const double* const __restrict aperture = aperture_.data();
  const double* const __restrict wall = wall_.data(), * const __restrict many = many_.data();
  double *const __restrict area = area_.data(), *const __restrict passage = passage_.data(),
                           *const __restrict film = film_.data();
  for (std::size_t c = 0, count = cracks_.size(); c < count; ++c) {
    const double width = 2.0 * std::sqrt(wall[c] / many[c] / M_PI);
    area[c] = many[c] * aperture[c] * width;
    passage[c] = flow.passage(aperture[c], width);
    const double friction = 2.0 * (1.0 / (passage[c] * passage[c]) - 1.0) * aperture[c] / width;
    film[c] = heat.film(friction, 1.0 / area[c], capacity) * wall[c];
  }
}

/// To its blocks' volumes, walls and ways, and to the ways out of its hole. A block that is left
/// out keeps what it has, but has no less ways than are open now, so that none is emptied. The way
/// to an image has its share of the room, too, though nothing goes along it.
void JointGas::count_crack(std::size_t c) {
  Crack& crack = cracks_[c];
  // A joint's room belongs to two blocks; that at a mirror to the block and its image.
  const double half = crack.joint || crack.mirror ? 0.5 : 1.0;
  crack.volume = half * wall_[c] * mechanical_[c];
  crack.broken = half * wall_[c] * closed_[c];
  crack.gives *= half;
  crack.area = area_[c];
  crack.way = area_[c] * passage_[c];
  const double ways = (crack.joint || crack.mirror ? crack.way : 0.0) +
                      (crack.hole >= 0 ? crack.end() : 0.0) + (crack.surfaces ? crack.end() : 0.0);
  each_block(crack, [&](std::size_t b) {
    if (crack.hole >= 0 && owned(b))
      chamber_ways_[static_cast<std::size_t>(crack.hole)] += crack.end();
    if (owned(b)) gives_[b] += crack.gives;
    if (left_out(b)) {
      ways_now_[b] += ways;
      return;
    }
    walls_[b] += wall_[c];
    rooms_[b] += crack.broken;
    cells_[b].volume += crack.volume;
    cells_[b].ways += ways;
  });
}

void JointGas::measure(const JointRooms& rooms, const std::vector<char>& fed) {
  find_calm(fed);
  if (!list_holds(rooms, fed)) list_cracks(rooms);
  wide_.clear();
  for (std::size_t b = 0; b < cells_.size(); ++b)
    if (!left_out(b)) walls_[b] = rooms_[b] = cells_[b].volume = cells_[b].ways = 0.0;
  std::fill(ways_now_.begin(), ways_now_.end(), 0.0);
  chamber_ways_.assign(fed.size(), 0.0);
  find_apertures(rooms);
  find_passages();
  for (std::size_t c = 0; c < cracks_.size(); ++c) count_crack(c);
  for (std::size_t b = 0; b < cells_.size(); ++b)
    cells_[b].ways = std::max(cells_[b].ways, ways_now_[b]);
  expand();
}

}  // namespace muckpile
