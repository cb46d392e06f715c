// SPDX-License-Identifier: GPL-2.0-or-later
// The facet network: what is summed over facets and blocks, and which blocks facets join.
// Scope: reads only; see the header.
#include "bond/network/facet_energy.h"
#include "bond/network/facet_network.h"

namespace muckpile {

void FacetNetwork::mark_joined(std::span<const int> moves, std::span<int> disturbed) const {
  each_facet(schedule_.active(), [&](std::size_t f) {
    if (history_.state(f) == FacetState::retired) return;
    const auto [i, j] = tables_.blocks_of(f);
    if (moves[i] != 0) disturbed[j] = 1;
    if (moves[j] != 0) disturbed[i] = 1;
  });
  if (!ground_) return;
  for (const std::size_t f : ground_->supports())
    disturbed[static_cast<std::size_t>(tables_.i_of(f))] = 1;
}

void FacetNetwork::mark_jointed(std::span<char> jointed) const {
  const auto mark = [&](std::size_t b) {
    if (b < jointed.size()) jointed[b] = 1;
  };
  each_facet(schedule_.active(), [&](std::size_t f) {
    if (history_.state(f) == FacetState::retired) return;
    const auto [i, j] = tables_.blocks_of(f);
    mark(i);
    mark(j);
  });
}

double FacetNetwork::elastic_energy() const {
  double energy = faces_.energy();
  const FacetKinematics facets = kinematics();
  each_facet(schedule_.active(), [&](std::size_t f) {
    if (history_.state(f) != FacetState::retired && !history_.traces(f).open)
      energy += tables_.name(f).weight * facet_energy(facets, f);
  });
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!blocks_.owned(b)) continue;
    const BlockSums& sums = blocks_.sums[b];
    const double leaning = slanted() ? leaning_->energy(b, blocks_) : 0.0;
    energy += blocks_.potential(b, sums) - blocks_.bulk_stress[b] * sums.loaded + leaning;
  }
  return energy;
}

double FacetNetwork::broken_count() const {
  double count = 0.0;
  for (const BlockConstants& block : blocks()) {
    if (block.owned) count += 0.5 * block.retired.count;  // each of the two blocks remembers it
  }
  for (std::size_t f = 0; f < facet_count(); ++f) {
    if (tables_.is_joint(f) && history_.state(f) != FacetState::intact)
      count += tables_.name(f).weight;
  }
  return count;
}

double FacetNetwork::broken_area(bool all) const {
  double sum = 0.0;
  for (const BlockConstants& block : blocks()) {
    if (block.owned) sum += 0.5 * block.retired.area;
  }
  for (std::size_t f = 0; f < facet_count(); ++f) {
    if (!tables_.is_joint(f)) continue;
    const double share = all ? 1.0 : history_.traces(f).broken.count() / double{kFacetPoints};
    sum += share * tables_.name(f).weight * area(f);
  }
  return sum;
}

std::vector<FacetNetwork::TableSize> FacetNetwork::table_sizes() const {
  const auto bytes = [](const auto&... table) {
    return (static_cast<double>(table.capacity() * sizeof(table[0])) + ...);
  };
  return {
      {"facet_groups", tables_.bytes_of_groups()},
      {"facet_names", tables_.bytes_of_names()},
      {"facet_traces", history_.bytes_of_traces()},
      {"facet_lists", schedule_.bytes_of_lists() + (ground_ ? bytes(ground_->supports()) : 0.0)},
      {"contact", history_.bytes_of_contacts()},
      {"softening_and_ground", history_.bytes_of_extra()},
      {"slant", leaning_ ? leaning_->bytes() : 0.0},
      {"block_constants", bytes(blocks_.constants)},
      {"block_states", bytes(blocks_.state)},
      {"block_sums", bytes(blocks_.sums, blocks_.theta, blocks_.bulk_stress, books_.dropped)},
      {"block_forces", bytes(blocks_.force, blocks_.torque)},
      {"block_rest", schedule_.bytes_of_rest()},
      {"gas", gas_ ? gas_->bytes() : 0.0},
      {"faces", faces_.bytes_of_faces()},
      {"walls", faces_.bytes_of_walls()}};
}

double FacetNetwork::memory_usage() const {
  double bytes = 0.0;
  for (const TableSize& size : table_sizes()) bytes += size.bytes;
  return bytes;
}

}  // namespace muckpile
