// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of a step between the spheres of near blocks: candidates are sifted, and those that touch
// are worked on side by side.
// Scope: one rank's spheres; SI units. Forces are added in the order of the candidates, and those
// of a contact do not depend on what shares its vector instructions.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/block_contact_list.h"
#include "contact/contact_law.h"

namespace muckpile {

/// What the contacts of a block's own spheres do to it; moments about the origin. The second half
/// is the part of the dashpots.
struct alignas(64) ContactLoad {
  std::array<double, 12> numbers{};
  bool listed = false;  ///< among ContactForces::loaded()

  [[nodiscard]] Vec3 force() const { return Vec3(numbers.data()); }               ///< [N]
  [[nodiscard]] Vec3 moment() const { return Vec3(numbers.data() + 3); }          ///< [N m]
  [[nodiscard]] Vec3 dashpot_force() const { return Vec3(numbers.data() + 6); }   ///< [N]
  [[nodiscard]] Vec3 dashpot_moment() const { return Vec3(numbers.data() + 9); }  ///< [N m]
};

/// How one rank's spheres move, and what acts on them; nothing is owned. Three numbers per sphere
/// each, but for radii and masses.
struct MovingSpheres {
  const double *positions, *velocities, *spins;  ///< [m], [m/s], [rad/s]
  const double *radii, *masses;                  ///< [m]; of its block [kg]
  double *forces, *torques;                      ///< to be added to, of own spheres [N], [N m]
  int owned;                                     ///< the first `owned` are this rank's
  const int* blocks = nullptr;                   ///< per sphere: whose of `loads` it is
  ContactLoad* loads = nullptr;                  ///< to be added to; null: they are not summed
};

/// Of a step. A contact between two ranks counts half on each, largest_overlap apart.
struct ContactSums {
  double contacts = 0.0;
  double elastic = 0.0;                ///< stored [J]
  double friction = 0.0;               ///< lost in the step [J]
  double damping = 0.0;                ///< lost in the step [J]
  double largest_overlap_ratio = 0.0;  ///< over the smaller radius [-]
};

/// Memory of all contacts; places are used again.
class ContactStates {
 public:
  void clear() {
    states_.clear();
    free_.clear();
  }
  [[nodiscard]] int add(const ContactState& state);
  /// Places that are free; append those whose contact is over.
  [[nodiscard]] std::vector<int>& free() { return free_; }
  [[nodiscard]] ContactState& operator[](int place) {
    return states_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] const ContactState& operator[](int place) const {
    return states_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] double bytes() const {
    return static_cast<double>(states_.capacity() * sizeof(ContactState) +
                               free_.capacity() * sizeof(int));
  }

 private:
  std::vector<ContactState> states_;
  std::vector<int> free_;
};

/// Use: begin(), then add() the candidates of each block pair, then finish().
class ContactForces {
 public:
  /// `time_step` of the run [s]; with `memory_step` 0 [s], else the same, contacts stay as they
  /// are.
  void begin(const ContactLaw& law, const MovingSpheres& spheres, ContactStates& contacts,
             double time_step, double memory_step);
  /// Candidates that touch get a contact, others lose theirs. They stay where they are until
  /// finish(). False: none touches, and none did.
  bool add(std::span<SpherePair> candidates);
  [[nodiscard]] ContactSums finish();
  /// Blocks whose load is no longer zero, since the last forget_loads().
  [[nodiscard]] const std::vector<int>& loaded() const { return loaded_; }
  void forget_loads() { loaded_.clear(); }

  /// For tests of the energy account: from now on forces are too large by this share, while
  /// energies and losses stay those of the law.
  void spoil(double share) { factor_ = 1.0 + share; }

 private:
  static constexpr std::size_t kLanes = kNativeLanes;
  static constexpr std::size_t kRoom = 64;  ///< contacts, whose numbers the fastest cache holds
  using Lanes =
      std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, kLanes>>;
  using Vectors = VectorOf<Lanes>;
  struct Row {
    alignas(64) std::array<double, kRoom> values;
  };
  using Rows = std::array<Row, 3>;
  /// One of the two spheres.
  struct Side {
    Rows velocity, spin;
    Row radius, mass;
    Row owned;  ///< 1 or 0
  };
  /// A candidate that touches, or did.
  struct Near {
    SpherePair* pair;
    double x, y, z;  ///< to the second centre [m]
    double squared;  ///< distance of the centres [m2]
  };

  void admit();
  void call_loads(std::size_t k);
  void work();
  void gather();
  void work_on(std::size_t at);
  void keep_load(std::size_t at, const ContactResponseOf<Lanes>& response, const Vectors& normal,
                 const Lanes& arm);
  void scatter();
  void scatter_loads();
  [[nodiscard]] std::array<int, 2> load_key(std::size_t k) const;

  const ContactLaw* law_ = nullptr;
  ContactStates* contacts_ = nullptr;
  MovingSpheres spheres_{};
  double time_step_ = 0.0, memory_step_ = 0.0;
  double factor_ = 1.0;  ///< see spoil()
  ContactSums sums_;

  std::size_t count_ = 0;
  std::array<Near, kRoom> near_;
  std::array<Side, 2> side_;
  Rows to_second_, slide_, roll_;
  Row squared_, is_new_, offset_, stiffness_;
  Rows first_;                                   ///< centre of the first sphere; only for loads
  std::array<std::array<int, kRoom>, 2> block_;  ///< of its two spheres; only for loads
  std::vector<int> loaded_;
  std::array<Row, 12> load_;    ///< on the first sphere's block, see ContactLoad
  Rows force_;                  ///< on the first sphere
  std::array<Rows, 2> torque_;  ///< on either
};

}  // namespace muckpile
