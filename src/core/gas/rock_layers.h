// SPDX-License-Identifier: GPL-2.0-or-later
// Conduction of heat from a face into rock: layers, thin at the face, a step at a time, implicit.
// Scope: one dimension, constant properties, linear: rock that was heated gives heat back to what
// is colder. Temperatures are the excess over that of the rock before. Against exact solutions of
// the half space and the sphere the heat is 2 to 5 % low from ten steps on, 8 to 10 % at three; the
// half space ends where heat comes in 0.2 s (tests/unit/gas).
#pragma once

#include <array>
#include <cstddef>

namespace muckpile {

class RockLayers {
 public:
  static constexpr std::size_t kLayers = 9;
  using Excess = std::array<double, kLayers>;  ///< from the face inwards [K]

  /// Of effusivity e > 0 [W s^(1/2)/(m2 K)], with layers for times of a step of 10 us to 0.1 s.
  [[nodiscard]] static RockLayers half_space(double effusivity);
  /// Of a diameter [m], conductivity [W/(m K)] and heat capacity [J/(m3 K)]; per area of its
  /// surface.
  [[nodiscard]] static RockLayers sphere(double diameter, double conductivity,
                                         double heat_capacity);

  /// Held by the layers [J/m2].
  [[nodiscard]] double heat(const Excess& excess) const;

  /// A step of one length, for any number of faces.
  class Step {
   public:
    Step() = default;
    Step(const RockLayers& rock, double length);
    [[nodiscard]] double length() const { return length_; }  ///< [s]
    /// A flux q into the face [W/m2] leaves it an excess temperature free() + q resistance().
    [[nodiscard]] double free(const Excess& excess) const {
      return from_inside(excess)[0];
    }                                                          ///< [K]
    [[nodiscard]] double resistance() const { return face_; }  ///< [m2 K/W]
    void take(double flux, Excess& excess) const { pass(from_inside(excess), flux, excess); }
    /// From what is warmer by `warmer` than the rock was [K], behind a resistance [m2 K/W]; returns
    /// the flux.
    double take_from(double warmer, double before, Excess& excess) const {
      const Excess from = from_inside(excess);
      const double flux = (warmer - from[0]) / (before + face_);
      pass(from, flux, excess);
      return flux;
    }

   private:
    // Of the layers eliminated from the inside outwards: T_k = of_outer_k T_(k-1) + from_inside_k,
    // from_inside_k = of_before_k T_k(before) + of_inner_k from_inside_(k+1).
    [[nodiscard]] Excess from_inside(const Excess& excess) const {
      Excess from;
      double within = 0.0;
      for (std::size_t k = kLayers; k-- > 0;) {
        within = of_before_[k] * excess[k] + of_inner_[k] * within;
        from[k] = within;
      }
      return from;
    }
    void pass(const Excess& from, double flux, Excess& excess) const {
      excess[0] = from[0] + flux * first_;
      for (std::size_t k = 1; k < kLayers; ++k) excess[k] = from[k] + of_outer_[k] * excess[k - 1];
    }

    double length_ = 0.0;
    Excess of_outer_{}, of_before_{}, of_inner_{};
    double first_ = 0.0, face_ = 0.0;  // warmer per flux: the first layer, the face [m2 K/W]
  };

 private:
  Excess capacity_{};     // per area of the face [J/(m2 K)]
  Excess between_{};      // conductance from each layer to the next; of the last none [W/(m2 K)]
  double to_face_ = 0.0;  // from the middle of the first layer [m2 K/W]
};

}  // namespace muckpile
