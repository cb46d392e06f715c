// SPDX-License-Identifier: GPL-2.0-or-later
// Fragments: the smallest tag spreads along joints that hold, within the rank by union-find and
// between ranks by halo, until nothing changes.
// Scope: see the header; rounds are bounded by the ranks that one fragment spans.
#include "fixes/joints/fragments.h"

#include <mpi.h>

#include <algorithm>
#include <limits>

#include "fixes/engine/over_ranks.h"
#include "math/union_find.h"

namespace muckpile {
namespace {

bool holds(const FacetTraces& m) { return m.broken.count() < kFacetPoints; }

}  // namespace

std::vector<int> fragment_ids(const FacetNetwork& network, const engine::BlockHalo& halo,
                              MPI_Comm world) {
  UnionFind sets(network.blocks().size());
  for (std::size_t f = 0; f < network.facet_count(); ++f) {
    const FacetEnds facet = network.ends(f);
    if (facet.kind == FacetKind::joint && holds(network.traces()[f])) {
      sets.join(static_cast<std::size_t>(facet.i), static_cast<std::size_t>(facet.j));
    }
  }
  std::vector<int> label(halo.size());
  for (std::size_t b = 0; b < label.size(); ++b) label[b] = network.blocks()[b].tag;
  for (bool changed = true; changed;) {
    std::vector<int> smallest(network.blocks().size(), std::numeric_limits<int>::max());
    for (std::size_t b = 0; b < label.size(); ++b) {
      int& s = smallest[sets.root(b)];
      s = std::min(s, label[b]);
    }
    bool mine = false;
    for (std::size_t b = 0; b < label.size(); ++b) {
      const int s = smallest[sets.root(b)];
      mine = mine || s != label[b];
      label[b] = s;
    }
    halo.forward(std::span<int>(label));
    changed = engine::on_any_rank(mine, world);
  }
  label.resize(halo.owned());
  return label;
}

std::vector<double> broken_share(const FacetNetwork& network, std::size_t owned) {
  std::vector<double> broken;
  for (const BlockConstants& block : network.blocks()) broken.push_back(block.retired.area);
  std::vector<double> all = broken;
  for (std::size_t f = 0; f < network.facet_count(); ++f) {
    const FacetEnds facet = network.ends(f);
    if (facet.kind != FacetKind::joint) continue;
    const double gone = network.area(f) * network.traces()[f].broken.count() / kFacetPoints;
    for (int b : {facet.i, facet.j}) {
      broken[static_cast<std::size_t>(b)] += gone;
      all[static_cast<std::size_t>(b)] += network.area(f);
    }
  }
  std::vector<double> share(owned, 0.0);
  for (std::size_t b = 0; b < share.size(); ++b) share[b] = all[b] > 0.0 ? broken[b] / all[b] : 0.0;
  return share;
}

std::vector<HoldingJoint> holding_joints(const FacetNetwork& network, std::size_t owned) {
  std::vector<HoldingJoint> joints;
  for (std::size_t f = 0; f < network.facet_count(); ++f) {
    const FacetEnds facet = network.ends(f);
    const auto first = static_cast<std::size_t>(facet.i);
    const FacetTraces& traces = network.traces()[f];
    if (facet.kind != FacetKind::joint || first >= owned || !holds(traces)) continue;
    joints.push_back({network.blocks()[first].tag, network.tables().name(f).face,
                      traces.broken.count() / double{kFacetPoints}});
  }
  return joints;
}

}  // namespace muckpile
