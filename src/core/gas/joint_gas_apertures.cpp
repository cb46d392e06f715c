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
    gives_[c] = seen_points_[f] == open.points[c] ? give - seen_gives_[f] : 0.0;
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

/// How easily gas passes each crack, and the film that it makes there. The friction is in the
/// passage against a resistance X = f L/(2w): f = 2 X w/L, on the wall A = pi L^2/4 of a crack with
/// the area w L across the flow.
void JointGas::find_passages() {
  const CrackFlow flow = flow_;
  const double film_by_resistance = 0.5 * M_PI * heat_.film(1.0, 1.0, heat_capacity());
  const double* const __restrict aperture = aperture_.data();
  const double* const __restrict wall = openings_.area.data(), * const __restrict many =
                                                                   many_.data();
  double *const __restrict area = area_.data(), *const __restrict passage = passage_.data(),
                           *const __restrict film = film_.data();
  for (std::size_t c = 0, count = cracks_.size(); c < count; ++c) {
    const double width = M_2_SQRTPI * std::sqrt(wall[c]);
    const double resistance = flow.resistance(aperture[c], width);
    area[c] = many[c] * aperture[c] * width;
    passage[c] = CrackFlow::passage_against(resistance);
    film[c] = film_by_resistance * resistance;
  }
}

void JointGas::clear_rooms() {
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    Rooms& rooms = rooms_[b];
    if (!left_out(b)) rooms = {0.0, 0.0, 0.0, 0.0, rooms.gives};
  }
  std::fill(ways_now_.begin(), ways_now_.end(), 0.0);
}

/// To its blocks' volumes, walls and ways, and to the ways out of its hole. A block that is left
/// out keeps what it has, but has no less ways than are open now, so that none is emptied. The way
/// to an image has its share of the room, too, though nothing goes along it.
void JointGas::count_crack(std::size_t c) {
  const Crack& crack = cracks_[c];
  const double volume = room_of(c), broken = closed_room_of(c), gives = crack.half() * gives_[c];
  const double end = end_of(c), ways = (crack.joint || crack.mirror ? way_of(c) : 0.0) +
                                       (crack.hole >= 0 ? end : 0.0) + (crack.surfaces ? end : 0.0);
  each_block(crack, [&](std::size_t b) {
    if (crack.hole >= 0 && owned(b)) chamber_ways_[static_cast<std::size_t>(crack.hole)] += end;
    Rooms& rooms = rooms_[b];
    rooms.gives += gives;
    if (left_out(b)) {
      ways_now_[b] += ways;
      return;
    }
    rooms.volume += volume;
    rooms.broken += broken;
    rooms.walls += wall_[c];
    rooms.ways += ways;
  });
}

void JointGas::take_rooms() {
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    cells_[b].volume = rooms_[b].volume;
    cells_[b].ways = std::max(rooms_[b].ways, ways_now_[b]);
  }
}

void JointGas::measure(const JointRooms& rooms, const std::vector<char>& fed) {
  find_calm(fed);
  if (!list_holds(rooms, fed)) list_cracks(rooms);
  wide_.clear();
  clear_rooms();
  chamber_ways_.assign(fed.size(), 0.0);
  find_apertures(rooms);
  find_passages();
  for (std::size_t c = 0; c < cracks_.size(); ++c) count_crack(c);
  take_rooms();
  expand();
}

}  // namespace muckpile
