// proto
#pragma once
#include <span>
#include <vector>
#include "bond/build/facet_builder.h"
namespace muckpile {
void fit_walls(const std::vector<Block>& blocks, int first_tag, std::span<const Hole> holes, FacetSet& set);
}
