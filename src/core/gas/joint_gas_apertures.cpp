// SPDX-License-Identifier: GPL-2.0-or-later
// Gas in broken joints: how wide they are, how easily gas passes them, and what room blocks have.
// Scope: see joint_gas.h. Number by number over many cracks, so that the loops are vectorised.
#include <algorithm>
#include <cmath>

#include "gas/joint_gas.h"

namespace muckpile {

void JointGas::Batch::resize(std::size_t cracks) {
  count = cracks;
  for (auto* numbers : {&many, &wall, &closed, &mechanical, &aperture, &gives})
    numbers->resize(cracks);
}

/// Cracks from `first` on.
void JointGas::measure_cracks(const JointRooms& rooms, std::span<const LaneSet> facets,
                              std::size_t first) {
  rooms.open(facets, batch_.open);
  batch_.first = first;
  batch_.resize(batch_.open.area.size());
  find_apertures();
  note_gives();
  note_wide();
  find_passages();
  for (std::size_t k = 0; k < batch_.count; ++k) count_crack(k);
}

void JointGas::find_apertures() {
  Batch& all = batch_;
  for (std::size_t k = 0; k < all.count; ++k) {
    // A void is no bundle of cracks.
    all.many[k] = all.open.parted_squared[k] > 1.0 ? 1.0 : bundles_[cracks_[all.first + k].facet];
    all.wall[k] = all.many[k] * all.open.area[k];
    all.closed[k] = all.open.pressure[k];
    all.mechanical[k] = all.open.opening[k] / all.many[k];
  }
  close_joints();
  for (const auto& [k, law] : all.open.by_law) {
    all.closed[k] = law.at_break;
    all.mechanical[k] = law.mechanical;
    all.aperture[k] = law.hydraulic;
    // What the joint gives way by is room there.
    all.open.opening[k] = law.mechanical - law.at_break;
  }
}

/// Of stress and opening in `closed` and `mechanical`; in a form that the compiler vectorises.
void JointGas::close_joints() {
  const ClosedJoint joint = joint_;  // which no store can change
  double* const __restrict closed = batch_.closed.data();
  double* const __restrict mechanical = batch_.mechanical.data();
  double* const __restrict aperture = batch_.aperture.data();
  for (std::size_t k = 0, count = batch_.count; k < count; ++k) {
    closed[k] = joint.closed(closed[k]);
    mechanical[k] += closed[k];
    aperture[k] = joint.hydraulic(mechanical[k]);
  }
}

/// The pressure works on the blocks as they part, whether their faces touch or not.
void JointGas::note_gives() {
  const OpenJoints& open = batch_.open;
  for (std::size_t k = 0; k < batch_.count; ++k) {
    const Crack& crack = cracks_[batch_.first + k];
    const double give = open.area[k] * (open.apart[k] - open.opening[k]);
    const bool same = seen_points_[crack.facet] == open.points[k];
    batch_.gives[k] = same ? crack.half() * (give - seen_gives_[crack.facet]) : 0.0;
    seen_gives_[crack.facet] = give;
    seen_points_[crack.facet] = open.points[k];
  }
}

void JointGas::note_wide() {
  const Batch& all = batch_;
  for (std::size_t k = 0; k < all.count; ++k) {
    const double parted = all.open.parted_squared[k];
    if (!(parted > 1.0)) continue;
    const double half = cracks_[all.first + k].half();
    wide_.push_back({static_cast<std::uint32_t>(all.first + k), parted > p_.open_gas * p_.open_gas,
                     half * all.wall[k] * all.mechanical[k], half * all.wall[k] * all.closed[k]});
  }
}

/// How easily gas passes each crack, and the film that it makes there. The friction is in the
/// passage against a resistance X = f L/(2w): f = 2 X w/L, on the wall A = pi L^2/4 of a crack with
/// the area w L across the flow.
void JointGas::find_passages() {
  const CrackFlow flow = flow_;
  const double film_by_resistance = 0.5 * M_PI * heat_.film(1.0, 1.0, heat_capacity());
  const double* const __restrict aperture = batch_.aperture.data();
  const double* const __restrict wall = batch_.open.area.data();
  const double* const __restrict many = batch_.many.data();
  double* const __restrict area = area_.data() + batch_.first;
  double* const __restrict passage = passage_.data() + batch_.first;
  double* const __restrict film = film_.data() + batch_.first;
  for (std::size_t k = 0, count = batch_.count; k < count; ++k) {
    const double width = M_2_SQRTPI * std::sqrt(wall[k]);
    const double resistance = flow.resistance(aperture[k], width);
    area[k] = many[k] * aperture[k] * width;
    passage[k] = CrackFlow::passage_against(resistance);
    film[k] = film_by_resistance * resistance;
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
void JointGas::count_crack(std::size_t k) {
  const std::size_t c = batch_.first + k;
  const Crack& crack = cracks_[c];
  const double wall = batch_.wall[k], half_wall = crack.half() * wall;
  const double volume = half_wall * batch_.mechanical[k], broken = half_wall * batch_.closed[k];
  const double end = end_of(c), ways = (crack.joint || crack.mirror ? way_of(c) : 0.0) +
                                       (crack.hole >= 0 ? end : 0.0) + (crack.surfaces ? end : 0.0);
  each_block(crack, [&](std::size_t b) {
    if (crack.hole >= 0 && owned(b)) chamber_ways_[static_cast<std::size_t>(crack.hole)] += end;
    Rooms& rooms = rooms_[b];
    rooms.gives += batch_.gives[k];
    if (left_out(b)) {
      ways_now_[b] += ways;
      return;
    }
    rooms.volume += volume;
    rooms.broken += broken;
    rooms.walls += wall;
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
  constexpr std::size_t kAtOnce = 64;  // groups of facets
  const std::span<const LaneSet> facets(crack_facets_);
  for (std::size_t g = 0, measured = 0; g < facets.size(); g += kAtOnce) {
    measure_cracks(rooms, facets.subspan(g, std::min(kAtOnce, facets.size() - g)), measured);
    measured += batch_.count;
  }
  take_rooms();
  expand();
}

}  // namespace muckpile
