// SPDX-License-Identifier: GPL-2.0-or-later
// Spheres whose body another rank moves: plan by sphere tag, messages by BlockHalo.
// Scope: see the header.
#include "fixes/engine/border_spheres.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace muckpile::engine {
namespace {

BlockHalo halo_between(const std::vector<int>& from, const std::vector<int>& to, const int* tags,
                       MPI_Comm world) {
  const auto named = [tags](const std::vector<int>& spheres) {
    std::vector<int> names;
    names.reserve(spheres.size());
    for (const int sphere : spheres) names.push_back(tags[sphere]);
    return names;
  };
  const std::vector<int> senders = named(from);
  return {senders, named(to), BlockDirectory(senders, world), world};
}

}  // namespace

BorderSpheres::BorderSpheres(std::vector<int> lent, std::vector<int> strange, const int* tags,
                             MPI_Comm world)
    : lent_(std::move(lent)),
      strange_(std::move(strange)),
      outward_(halo_between(lent_, strange_, tags, world)),
      homeward_(halo_between(strange_, lent_, tags, world)) {}

void BorderSpheres::carry(const BlockHalo& halo, const std::vector<int>& from,
                          const std::vector<int>& to, std::initializer_list<double**> arrays) {
  const std::size_t width = 3 * arrays.size();
  values_.resize(halo.size() * width);
  double* number = values_.data();
  for (const int sphere : from)
    for (double** const array : arrays) number = std::copy_n(array[sphere], 3, number);
  double* const received = number;
  // A sphere for which no rank sends keeps what it has.
  for (const int sphere : to)
    for (double** const array : arrays) number = std::copy_n(array[sphere], 3, number);
  halo.forward(values_, width);
  number = received;
  for (const int sphere : to)
    for (double** const array : arrays) {
      std::copy_n(number, 3, array[sphere]);
      number += 3;
    }
}

}  // namespace muckpile::engine
