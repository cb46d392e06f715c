// SPDX-License-Identifier: GPL-2.0-or-later
// What the facets of a network remember: taking it in, giving it out, and what changes it.
// Scope: see the header.
#include "bond/network/facet_history.h"

namespace muckpile {
namespace {

std::uint8_t points_in_dilatations(const FacetTraces& traces) {
  return static_cast<std::uint8_t>(kFacetPoints - traces.contact().count());
}

}  // namespace

void FacetHistory::reset(std::size_t count, std::size_t groups) {
  traces_.assign(count, {});
  contacts_.reset(groups);
  extra_.reset(count);
  states_.resize(count);
  bonded_points_.resize(count);
}

void FacetHistory::set(std::size_t f, const FacetMemory& memory) {
  traces_[f] = memory;
  states_[f] = memory.state;
  bonded_points_[f] = points_in_dilatations(memory);
  if (memory.contact.exists()) contacts_.set(f, memory.contact.get());
  if (memory.extra.exists()) extra_.get_or_create(f) = memory.extra.get();
}

void FacetHistory::release() { *this = {}; }

FacetMemory FacetHistory::memory(std::size_t f) const {
  FacetMemory memory{traces_[f], {}, {}};
  if (contacts_.exists(f)) memory.contact.get_or_create() = contacts_.get(f);
  if (extra_.exists(f)) memory.extra.get_or_create() = extra_.get(f);
  return memory;
}

void FacetHistory::break_point(std::size_t f, std::size_t p, bool slips, bool keeps_gas) {
  FacetTraces& traces = traces_[f];
  traces.broken.set(p);
  traces.slipping.set(p, slips);
  if (traces.state != FacetState::intact) return;
  traces.state = states_[f] = FacetState::cracked;
  traces.gas = keeps_gas;  // let go, it stays so when further points break
}

void FacetHistory::fade(std::size_t f, double matching) {
  contacts_.set_fade(f, matching);
  traces_[f].state = states_[f] = FacetState::fading;
}

void FacetHistory::retire(std::size_t f) {
  traces_[f].state = states_[f] = FacetState::retired;
  if (!traces_[f].gas) contacts_.drop(f);
}

void FacetHistory::stop_softening(std::size_t f) {
  if (!has_extra(f)) return;
  ExtraMemory& memory = extra_.get_or_create(f);
  memory.cohesion = {};
  if (std::ranges::all_of(memory.joint, &JointHistory::empty)) extra_.drop(f);
}

void FacetHistory::stop_ground() {
  extra_.each([](ExtraMemory& memory) { memory.ground.yields = false; });
}

void FacetHistory::soften(double factor) {
  extra_.each([&](ExtraMemory& memory) {
    for (Cohesion& cohesion : memory.cohesion) cohesion.strength *= factor;
  });
}

double FacetHistory::bytes_of_traces() const {
  return static_cast<double>(traces_.capacity() * sizeof(FacetTraces) +
                             states_.capacity() * sizeof(FacetState) + bonded_points_.capacity());
}

}  // namespace muckpile
