// SPDX-License-Identifier: GPL-2.0-or-later
// The facets of a network as a list to read.
// Scope: the network keeps them in tables (facet_group.h); none stands anywhere as a Facet.
#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

#include "bond/facet.h"

namespace muckpile {

class FacetNetwork;

/// The facets of a network in their order, each assembled from the tables on access.
class FacetList {
 public:
  explicit FacetList(const FacetNetwork& network) : network_(&network) {}
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] Facet operator[](std::size_t f) const;
  operator std::vector<Facet>() const { return {begin(), end()}; }

  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Facet;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = Facet;
    Iterator(const FacetNetwork* network, std::size_t f) : network_(network), f_(f) {}
    Facet operator*() const;
    Iterator& operator++() {
      ++f_;
      return *this;
    }
    Iterator operator++(int) { return {network_, f_++}; }
    bool operator==(const Iterator& other) const = default;

   private:
    const FacetNetwork* network_;
    std::size_t f_;
  };
  [[nodiscard]] Iterator begin() const { return {network_, 0}; }
  [[nodiscard]] Iterator end() const { return {network_, size()}; }

 private:
  const FacetNetwork* network_;
};

}  // namespace muckpile
