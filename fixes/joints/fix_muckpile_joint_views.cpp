// SPDX-License-Identifier: GPL-2.0-or-later
// fix muckpile/joint as other styles see it: joints, faces under pressure, supports, neighbours.
// Scope: the interfaces that the class implements; nothing here runs unless another style asks.

#include <algorithm>
#include <cmath>

#include "fixes/engine/bodies.h"
#include "fixes/engine/find_view.h"
#include "fixes/joints/fix_muckpile_joint.h"
#include "fixes/joints/fragments.h"

namespace muckpile {

int FixMuckpileJoint::facet_between(int block_tag_a, int block_tag_b) const {
  const auto [lower, upper] = std::minmax(block_tag_a, block_tag_b);
  const auto found = std::lower_bound(lower_tags_.begin(), lower_tags_.end(), lower);
  if (found == lower_tags_.end() || *found != lower) return -1;
  const auto k = static_cast<std::size_t>(found - lower_tags_.begin());
  for (std::size_t f = first_of_[k]; f < first_of_[k + 1]; ++f) {
    if (upper_tags_[f] == upper) return static_cast<int>(f);
  }
  return -1;
}

void FixMuckpileJoint::joined_pairs(const std::vector<int>& blocks,
                                    std::vector<double>& tags) const {
  const auto asked = [&](int tag) { return std::binary_search(blocks.begin(), blocks.end(), tag); };
  for (std::size_t k = 0; k < lower_tags_.size(); ++k)
    for (std::size_t f = first_of_[k]; f < first_of_[k + 1]; ++f) {
      if (upper_tags_[f] == kGroundTag || facet_states()[f] >= FacetState::fading) continue;
      if (asked(lower_tags_[k]) || asked(upper_tags_[f]))
        tags.insert(tags.end(), {1.0 * lower_tags_[k], 1.0 * upper_tags_[f]});
    }
}

bool FixMuckpileJoint::enclosed(int block_tag) const {
  return std::binary_search(enclosed_tags_.begin(), enclosed_tags_.end(), block_tag);
}

int FixMuckpileJoint::hole_count() const {
  const auto* store = engine::find_view<FacetStore>(*lmp);
  return store == nullptr ? 0 : static_cast<int>(store->holes().size());
}

const Hole& FixMuckpileJoint::hole(int index) const {
  return engine::find_view<FacetStore>(*lmp)->holes()[static_cast<std::size_t>(index)];
}

void FixMuckpileJoint::set_pressure(std::span<const double> pressure,
                                    std::span<const double> wave_share) {
  for (std::size_t k = 0; k < loaded_faces_.size(); ++k)
    network_.press(loaded_faces_[k], pressure[k], wave_share[k]);
}

void FixMuckpileJoint::expect_pressure(bool expected) { network_.expect_pressure(expected); }

/// Where there are zones, what a run must heed of all of them: the lightest blocks, the softest
/// rock, that which is least compressible, and extremes of waves.
RockConstants FixMuckpileJoint::rock() const {
  const JointLaws& laws = network_.tables().laws();
  const JointParameters& first = network_.material().parameters();
  RockConstants all{first.density, first.youngs_modulus / softened(), first.poisson_ratio};
  const double stiffer = 1.0 / std::sqrt(softened());  // so were waves before
  all.fastest_wave = stiffer * laws.rock().p_wave_speed();
  all.impedance = first.density * all.fastest_wave;
  if (!laws.zoned()) return all;
  for (std::size_t zone = 1; zone < laws.zones(); ++zone) {
    const JointParameters& rock = laws.rock(zone).parameters();
    all.density = std::min(all.density, rock.density);
    all.poisson_ratio = std::max(all.poisson_ratio, rock.poisson_ratio);
    const double speed = stiffer * laws.rock(zone).p_wave_speed();
    all.fastest_wave = std::max(all.fastest_wave, speed);
    all.impedance = std::min(all.impedance, rock.density * speed);
  }
  all.youngs_modulus = 2.0 * (1.0 + all.poisson_ratio) * shear_modulus() / softened();
  return all;
}

/// Of the softest.
double FixMuckpileJoint::shear_modulus() const {
  const JointLaws& laws = network_.tables().laws();
  double least = laws.rock().shear_modulus();
  for (std::size_t zone = 1; zone < laws.zones(); ++zone)
    least = std::min(least, laws.rock(zone).shear_modulus());
  return least;
}

void FixMuckpileJoint::unload_softened() { network_.take_off_pressures(false); }

void FixMuckpileJoint::swept_volume(std::span<double> per_hole) const {
  std::fill(per_hole.begin(), per_hole.end(), 0.0);
  for (std::size_t k : loaded_faces_) {
    const BoundaryFace& face = network_.faces()[k];
    per_hole[static_cast<std::size_t>(face.hole)] += network_.volume_swept(face);
  }
}

void FixMuckpileJoint::work_of_step(std::span<double> per_hole) const {
  std::fill(per_hole.begin(), per_hole.end(), 0.0);
  std::ranges::copy(network_.work_per_hole(), per_hole.begin());
}

YieldingSupports::Chosen FixMuckpileJoint::let_ground_yield(
    const std::function<bool(const Vec3&)>& chosen, double rock_behind) {
  network_.let_ground_yield(QuietGround(network_.material(), rock_behind), chosen);
  Chosen yielding;
  for (std::size_t f = 0; f < network_.facet_count(); ++f) {
    if (!network_.ground_memory(f).yields) continue;
    yielding.count += 1.0;
    yielding.area += network_.area(f);
  }
  return yielding;
}

StepBound FixMuckpileJoint::stable_step(Breaking breaking, double guess) const {
  const engine::Bodies bodies = store_->bodies();
  std::vector<Mat3> inertia;
  for (int b = 0; b < bodies.count(); ++b) inertia.push_back(bodies.inertia_in_space(b));
  return muckpile::stable_step(network_, inertia, breaking, team(), guess);
}

/// Into of_blocks_, of copies too; the ground's is 0.
void FixMuckpileJoint::gather_flags(std::span<const char> of_bodies) {
  of_blocks_.assign(network_.blocks().size(), 0);
  std::copy(of_bodies.begin(), of_bodies.end(), of_blocks_.begin());
  store_->halo().forward(std::span(of_blocks_).first(store_->halo().size()));
}

void FixMuckpileJoint::mark_joined(std::span<const char> moves, std::span<char> disturbed) {
  gather_flags(moves);
  std::vector<int> all(of_blocks_.size(), 0);
  network_.mark_joined(of_blocks_, all);
  for (std::size_t b = 0; b < disturbed.size(); ++b)
    disturbed[b] = disturbed[b] != 0 || all[b] != 0 ? 1 : 0;
}

void FixMuckpileJoint::let_rest(std::span<const char> rests) {
  gather_flags(rests);
  of_blocks_.back() = 1;  // the ground
  network_.let_rest(of_blocks_);
}

double FixMuckpileJoint::joints_broken() const { return sum(network_.broken_count()); }

std::vector<int> FixMuckpileJoint::fragment_ids() const {
  return muckpile::fragment_ids(network_, store_->halo(), world);
}

std::vector<double> FixMuckpileJoint::broken_share() const {
  return muckpile::broken_share(network_, store_->halo().owned());
}

std::vector<HoldingJoint> FixMuckpileJoint::holding_joints() const {
  return muckpile::holding_joints(network_, store_->halo().owned());
}

void FixMuckpileJoint::add_cost_of_joints(std::span<double> costs, double cost) const {
  for (std::size_t f = 0; f < network_.facet_count(); ++f) {
    if (network_.states()[f] == FacetState::retired || network_.traces()[f].open) continue;
    const FacetEnds ends = network_.ends(f);
    for (const int block : {ends.i, ends.j})
      if (block < static_cast<int>(costs.size())) costs[static_cast<std::size_t>(block)] += cost;
  }
}

JointEnergySums FixMuckpileJoint::energies() const {
  const JointLosses& losses = network_.losses();
  return {.elastic = network_.elastic_energy(),
          .fracture = losses.fracture,
          .friction = losses.friction,
          .damping = losses.damping,
          .crushing = losses.crushing,
          .quiet = losses.quiet,
          .pressure_work = network_.pressure_work()};
}

void FixMuckpileJoint::forces_by_part(std::span<ByPart> forces) {
  wave_forces_.assign(network_.blocks().size(), Vec3::Zero());
  gas_forces_.assign(network_.blocks().size(), Vec3::Zero());
  network_.add_wall_forces(wave_forces_, gas_forces_);
  const std::span<const Vec3> all = network_.force(), gas = network_.gas_force();
  for (std::size_t b = 0; b < forces.size(); ++b) {
    ByPart& on = forces[b];
    on[ImpulsePart::wave] = wave_forces_[b];
    on[ImpulsePart::hole_gas] = gas_forces_[b];
    on[ImpulsePart::joint_gas] = gas.empty() ? Vec3(Vec3::Zero()) : gas[b];
    on[ImpulsePart::joints] =
        all[b] - wave_forces_[b] - gas_forces_[b] - on[ImpulsePart::joint_gas];
  }
}

std::vector<int> FixMuckpileJoint::block_tags() const {
  std::vector<int> tags;
  for (const BlockRecord& record : store_->records()) tags.push_back(record.tag);
  return tags;
}

void FixMuckpileJoint::release_gas(std::span<const std::uint32_t> joints) {
  for (const std::uint32_t joint : joints) network_.release_gas(joint);
}

/// With full-step velocities force x velocity x dt is exactly the work that the integrator lets the
/// force do.
double FixMuckpileJoint::gas_power() const {
  const engine::Bodies bodies = store_->bodies();
  double rate = 0.0;
  if (network_.gas_force().empty()) return rate;
  for (int b = 0; b < bodies.count(); ++b) {
    const auto k = static_cast<std::size_t>(b);
    rate += network_.gas_force()[k].dot(bodies.velocity(b)) +
            network_.gas_torque()[k].dot(bodies.spin(b));
  }
  return rate;
}

}  // namespace muckpile
