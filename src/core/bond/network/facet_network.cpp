// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network as a whole: set-up, the step, softening, and how a run goes on.
// Scope: see the header; each pass is in a file of its own, sums are in network_sums.cpp.
#include "bond/network/facet_network.h"

#include <algorithm>

#include "bond/network/dilatation_pass.h"
#include "bond/network/traction_pass.h"

namespace muckpile {

FacetNetwork::FacetNetwork(const JointMaterial& material, const std::vector<JointClass>& natural,
                           const std::vector<JointMaterial>& zones)
    : tables_(material, natural, zones) {}

void FacetNetwork::set(std::vector<BlockConstants> blocks, FacetLists lists, const RankTeam& team) {
  blocks_.reset(std::move(blocks), tables_.laws());
  schedule_.reset_blocks(blocks_.size());
  if (gas_) gas_->clear_pressure();
  set_facets(std::move(lists));
  if (team.sum(slanted() ? 1.0 : 0.0) > 0.0 && !leaning_)
    leaning_.emplace().reset_blocks(blocks_.size());
}

void FacetNetwork::set_facets(FacetLists lists) {
  const std::size_t count = lists.facets.size();
  tables_.reset(count);
  history_.reset(count, tables_.groups());
  lists.memory.resize(count);
  for (std::size_t f = 0; f < count; ++f) {
    history_.set(f, lists.memory[f]);
    const Vec3 arm_j = tables_.place(f, lists.facets[f]);
    tables_.set_arm_j(f, arm_j + history_.ground(f).displacement);
    if (!tables_.is_joint(f)) history_.place_ground(f, arm_j);
    tables_.derive(f, history_.bonded_points(f));
  }
  leaning_.reset();
  if (LeaningFaces::exist_in(tables_)) leaning_.emplace().set(tables_, blocks_.size());
  faces_.set(std::move(lists.faces), tables_, history_);
  list_anew();
}

FacetLists FacetNetwork::lists() const { return {facets(), memory(), faces()}; }

void FacetNetwork::derive_anew() {
  schedule_.set_resting_known(false);
  tables_.derive_all(history_.bonded_points());
  list_anew();
}

void FacetNetwork::list_anew() {
  list_facets();
  if (!ground_ && YieldingGround::exists_in(history_)) ground_.emplace(QuietGround());
  if (ground_) ground_->list(history_);
  count_unbonded();
  if (slanted()) leaning_->count_moments(tables_, history_, blocks_);
}

FacetLists FacetNetwork::give_up(const RankTeam& team) {
  settle_books(team);
  FacetLists lists{facets(), memory(), faces_.give_up()};
  tables_.release();
  history_.release();
  schedule_.release();
  leaning_.reset();
  if (ground_) ground_->release();
  return lists;
}

std::size_t FacetList::size() const { return network_->facet_count(); }
Facet FacetList::operator[](std::size_t f) const { return network_->facet(f); }
Facet FacetList::Iterator::operator*() const { return network_->facet(f_); }

Facet FacetNetwork::facet(std::size_t f) const {
  Facet facet = tables_.facet(f);
  facet.tag_i = blocks_.constants[static_cast<std::size_t>(facet.i)].tag;
  facet.tag_j = blocks_.constants[static_cast<std::size_t>(facet.j)].tag;
  const GroundMemory& ground = history_.ground(f);
  if (ground.placed) facet.arm_j = ground.arm_j;
  return facet;
}

std::vector<FacetMemory> FacetNetwork::memory() const {
  std::vector<FacetMemory> all;
  all.reserve(facet_count());
  for (std::size_t f = 0; f < facet_count(); ++f) all.push_back(memory(f));
  return all;
}

void FacetNetwork::press(std::size_t k, double pressure, double wave_share) {
  BoundaryFace& face = faces_.faces()[k];
  face.pressure = face.load_share * pressure;
  face.wave_share = wave_share;
}

void FacetNetwork::take_off_pressures(bool booked) {
  for (BoundaryFace& face : faces_.faces()) {
    face.pressure = 0.0;
    if (!booked) face.last_pressure = 0.0;
  }
}

void FacetNetwork::count_unbonded() {
  std::vector<BlockSums>& sums = blocks_.sums;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    sums[b].unbonded = blocks_.constants[b].retired.unbonded;
  for (const BoundaryFace& face : faces_.faces()) {
    const auto b = static_cast<std::size_t>(face.block);
    sums[b].unbonded +=
        face.area * face.depth_share * face.normal.dot(face.arm) / blocks_.volume(b);
  }
  for (std::size_t f = 0; f < facet_count(); ++f) {
    const auto [i, j] = tables_.blocks_of(f);
    const auto [depth_i, depth_j] = tables_.depths(f);
    for (std::size_t p = 0; p < kFacetPoints; ++p) {
      if (!history_.traces(f).is_contact(p)) continue;
      sums[i].unbonded += area(f) / kFacetPoints * depth_i / blocks_.volume(i);
      sums[j].unbonded += area(f) / kFacetPoints * depth_j / blocks_.volume(j);
    }
  }
}

FacetBreaking::Parts FacetNetwork::breaking_parts() {
  return {tables_,         history_, blocks_, schedule_, books_, slanted() ? &*leaning_ : nullptr,
          gas_.has_value()};
}

void FacetNetwork::find_stresses(double dt, const RankTeam& team) {
  if (schedule_.outdated()) list_facets();
  if (ground_) ground_->drop_broken(history_);
  DilatationPass dilatation(kinematics(), blocks_, schedule_, ground_yields());
  dilatation.sum_openings();
  if (slanted()) leaning_->stretch(kinematics(), schedule_.bonded());
  faces_.squeeze(blocks_);
  if (ground_yields())
    ground_->yield(kinematics(), {tables_, history_, blocks_.sums, books_.losses}, dt);
  dilatation.find_theta();
  const std::size_t count = blocks_.size() > 0 ? blocks_.size() - 1 : 0;  // but for the ground
  if (team.ranks == 1)
    team.fill_copies(std::span(blocks_.theta).first(count), 1);
  else
    share_thetas(count, team);
  if (leaning_) {
    team.fill_copies(leaning_->gradients(count), 9);
    team.fill_copies(leaning_->stresses(count), 9);
  }
  dilatation.find_bulk_stresses();
  team.fill_copies(std::span(blocks_.bulk_stress).first(count), 1);
}

/// With what breaking has taken from them in the last step, for the books: both in one message.
void FacetNetwork::share_thetas(std::size_t count, const RankTeam& team) {
  std::vector<double> both(2 * count);
  for (std::size_t b = 0; b < count; ++b) {
    both[2 * b] = blocks_.theta[b];
    both[2 * b + 1] = blocks_.theta_lost[b];
  }
  team.fill_copies(both, 2);
  for (std::size_t b = 0; b < count; ++b) {
    blocks_.theta[b] = both[2 * b];
    blocks_.theta_lost[b] = both[2 * b + 1];
  }
  book_shared_changes();
}

void FacetNetwork::book_shared_changes() {
  if (books_.newly_cracked) FacetBreaking(breaking_parts()).book_shared_changes();
  std::fill(blocks_.theta_lost.begin(), blocks_.theta_lost.end(), 0.0);
}

/// A rank learns a step later what breaking has cost facets whose two blocks belong to two ranks.
void FacetNetwork::settle_books(const RankTeam& team) {
  if (team.ranks == 1 || blocks_.size() == 0) return;
  team.fill_copies(std::span(blocks_.theta_lost).first(blocks_.size() - 1), 1);
  book_shared_changes();
}

void FacetNetwork::step(double dt, const RankTeam& team) {
  find_stresses(dt, team);
  std::fill(blocks_.force.begin(), blocks_.force.end(), Vec3::Zero());
  std::fill(blocks_.torque.begin(), blocks_.torque.end(), Vec3::Zero());
  books_.newly_cracked = books_.newly_let_go = false;
  if (slanted()) leaning_->pull(kinematics(), schedule_.working(), blocks_.torque);
  GasLoad* gas = gas_ && gas_->presses() ? &*gas_ : nullptr;
  TractionPass(breaking_parts(), gas, ground_yields(), dt).run();
  faces_.load(kinematics(), blocks_, books_);
  if (gas != nullptr) gas->add_forces_to(blocks_);
  if (!books_.newly_cracked) return;
  FacetBreaking(breaking_parts()).book_step();
  DilatationPass(kinematics(), blocks_, schedule_, ground_yields()).find_bulk_stresses();
}

int FacetNetwork::let_ground_yield(const QuietGround& ground,
                                   const std::function<bool(const Vec3&)>& chosen) {
  if (!ground_) ground_.emplace(ground);
  ground_->set_rock(ground);
  return ground_->let_yield(kinematics(), history_, chosen,
                            [this](std::size_t f) { return mean_traction(f); });
}

void FacetNetwork::stop_ground() {
  history_.stop_ground();
  if (ground_) ground_->list(history_);
}

void FacetNetwork::set_gas_pressure(std::span<const double> pressure) {
  keep_gas_in_joints();
  gas_->set_pressure(pressure);
}

std::span<const Vec3> FacetNetwork::gas_force() const {
  return gas_ ? gas_->force() : std::span<const Vec3>();
}

std::span<const Vec3> FacetNetwork::gas_torque() const {
  return gas_ ? gas_->torque() : std::span<const Vec3>();
}

void FacetNetwork::release_gas() {
  gas_.reset();
  history_.release_gas();
}

void FacetNetwork::let_rest(std::span<const int> rests) {
  schedule_.let_rest(rests);
  schedule_.list_working(tables_, faces_.faces(), slanted());
}

void FacetNetwork::wake_all() {
  schedule_.wake_all();
  schedule_.list_working(tables_, faces_.faces(), slanted());
}

void FacetNetwork::soften(double factor, std::optional<double> damping, const RankTeam& team) {
  find_stresses(team);
  stop_ground();  // what is behind is not softened, and no wave is left to let out
  books_.losses.fracture += (1.0 - factor) * elastic_energy();
  history_.soften(factor);
  books_.softened *= factor;
  faces_.note_softening();
  if (damping) books_.damping_given = damping;
  schedule_.set_resting_known(false);
  tables_.soften(factor, damping, history_.bonded_points());
  blocks_.find_rock(tables_.laws());
}

NetworkTotals FacetNetwork::totals(const RankTeam& team) {
  settle_books(team);
  return {books_.losses,         books_.pressure_work, books_.wave_work,
          books_.softened,       books_.damping_given, ground_ ? ground_->rock() : QuietGround(),
          faces_.moved_unseen(), faces_.softer_since()};
}

void FacetNetwork::resume(const NetworkTotals& totals) {
  books_.losses = totals.losses;
  books_.pressure_work = totals.pressure_work;
  books_.wave_work = totals.wave_work;
  books_.softened = totals.softened;
  books_.damping_given = totals.damping;
  if (totals.quiet_ground.normal_impedance > 0.0) ground_.emplace(totals.quiet_ground);
  faces_.resume(totals.moved_unseen, totals.softer_since);
  if (books_.softened == 1.0 && !totals.damping) return;
  tables_.soften(books_.softened, totals.damping, history_.bonded_points());
  blocks_.find_rock(tables_.laws());
}

}  // namespace muckpile
