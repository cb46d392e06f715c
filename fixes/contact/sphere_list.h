// SPDX-License-Identifier: GPL-2.0-or-later
// A list of stored values that travels with a sphere, between ranks and through restart files.
// Scope: as numbers of the engine. The first says how many they are, itself included, as
// Fix::pack_restart() asks for.
#pragma once

#include <atom.h>
#include <error.h>

#include <span>
#include <string>
#include <vector>

#include "state/number_list.h"

namespace muckpile::engine {

/// How many numbers a list of so many values takes.
template <class T>
[[nodiscard]] constexpr int numbers_of_sphere_list(std::size_t count) {
  return 1 + numbers_of_list<T>(count);
}

/// Returns how many numbers it has written.
template <class T>
int put_sphere_list(std::span<const T> values, double* numbers) {
  const int taken = 1 + put_list(values, numbers + 1);
  numbers[0] = taken;
  return taken;
}

/// Adds the values of the list that `numbers` begin with; returns how many numbers it has. Not
/// collective: a list that is not as long as it says stops all ranks, and `where` starts the
/// message.
template <class T>
int get_sphere_list(std::vector<T>& values, std::span<const double> numbers,
                    const std::string& where, LAMMPS_NS::Error& error) {
  const double said = numbers.empty() ? 0.0 : numbers[0];
  try {
    if (!(said >= 1.0 && said <= static_cast<double>(numbers.size())))
      throw StateError("a sphere has " + std::to_string(numbers.size()) +
                       " numbers, its list says " + std::to_string(said));
    const int taken = 1 + get_list(values, numbers.subspan(1, static_cast<std::size_t>(said) - 1));
    if (taken != said)
      throw StateError("a sphere's list takes " + std::to_string(taken) + " numbers, says " +
                       std::to_string(said));
    return taken;
  } catch (const StateError& fault) {
    error.one(FLERR, (where + ": " + fault.what()).c_str());
  }
  return 0;
}

/// The numbers of a message between ranks. The engine does not say how long its buffer is: they are
/// as many as the list says.
[[nodiscard]] inline std::span<const double> sent_with_sphere(const double* buffer) {
  return {buffer, buffer[0] >= 1.0 ? static_cast<std::size_t>(buffer[0]) : 0};
}

/// The numbers that a restart file holds of a sphere, from those of the nth fix on.
[[nodiscard]] inline std::span<const double> stored_with_sphere(const LAMMPS_NS::Atom& atom,
                                                                int index, int nth) {
  std::span<const double> left(atom.extra[index], static_cast<std::size_t>(atom.nextra_store));
  for (int k = 0; k < nth && !left.empty(); ++k) {
    const bool sound = left[0] >= 1.0 && left[0] <= static_cast<double>(left.size());
    left = left.subspan(sound ? static_cast<std::size_t>(left[0]) : left.size());
  }
  return left;
}

}  // namespace muckpile::engine
