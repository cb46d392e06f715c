// SPDX-License-Identifier: GPL-2.0-or-later
// Facets between two rocks whose dilatations differ.
// Scope: see the header.
#include "bond/network/border_relief.h"

namespace muckpile {
namespace {

using Border = FacetTables::Border;

bool acts(const FacetKinematics& facets, const Border& border) {
  return border.give > 0.0 && facets.history.state(border.facet) == FacetState::intact;
}

/// D of the header [Pa].
double difference(const FacetKinematics& facets, const Border& border,
                  std::span<const double> theta) {
  const FacetMotion motion = facets.motion(border.facet);
  const auto [i, j] = facets.tables.blocks_of(border.facet);
  return border.push * motion.normal.dot(motion.mean_jump()) + border.pull_i * theta[i] -
         border.pull_j * theta[j];
}

double energy(const FacetKinematics& facets, const Border& border, std::span<const double> theta) {
  const double by = difference(facets, border, theta);
  return -0.5 * facets.tables.area(border.facet) * border.give * by * by;
}

}  // namespace

void relieve_borders(const FacetKinematics& facets, BlockFields& blocks) {
  const std::vector<Border>& borders = facets.tables.borders();
  blocks.border_traction.assign(borders.size(), 0.0);
  for (std::size_t k = 0; k < borders.size(); ++k) {
    const Border& border = borders[k];
    if (!acts(facets, border)) continue;
    const double shift = border.give * difference(facets, border, blocks.theta);  // -q [m]
    blocks.border_traction[k] = -border.push * shift;
    const auto [i, j] = facets.tables.blocks_of(border.facet);
    const double area = facets.tables.area(border.facet);
    blocks.sums[i].uneven -= area * border.pull_i * shift;
    blocks.sums[j].uneven += area * border.pull_j * shift;
  }
}

double border_traction(const FacetKinematics& facets, std::size_t f) {
  const std::vector<double>& tractions = facets.blocks.border_traction;
  if (tractions.empty() || !facets.tables.is_border(f)) return 0.0;
  return tractions[facets.tables.border_of(f)];
}

double border_energy(const FacetKinematics& facets, std::size_t f) {
  if (facets.tables.borders().empty() || !facets.tables.is_border(f)) return 0.0;
  const Border& border = facets.tables.borders()[facets.tables.border_of(f)];
  return acts(facets, border) ? energy(facets, border, facets.blocks.theta) : 0.0;
}

void book_borders(const FacetKinematics& facets, std::span<const double> theta_before,
                  JointLosses& losses) {
  for (const Border& border : facets.tables.borders()) {
    if (!acts(facets, border)) continue;
    losses.fracture +=
        energy(facets, border, theta_before) - energy(facets, border, facets.blocks.theta);
  }
}

void book_shared_borders(const FacetKinematics& facets,
                         const std::function<double(std::size_t)>& product, JointLosses& losses) {
  for (const Border& border : facets.tables.borders()) {
    if (!acts(facets, border)) continue;
    losses.fracture -= facets.tables.area(border.facet) * border.give * border.pull_i *
                       border.pull_j * product(border.facet);
  }
}

}  // namespace muckpile
